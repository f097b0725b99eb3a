// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "problemmark.h"

#include <algorithm>

#include <QTextDocument>

namespace romanesco {

QColor severityColour(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return QColor(0xd6, 0x45, 0x41);
    case Severity::Warning:
        return QColor(0xc0, 0x86, 0x1a);
    case Severity::Hint:
        break;
    }
    return QColor(0x8a, 0x8a, 0x8a);
}

QTextCursor markedPlace(QTextDocument *document, int begin, int end)
{
    QTextCursor cursor(document);
    const int last = document->characterCount() - 1;
    cursor.setPosition(std::min(begin, last));
    cursor.setPosition(std::min(end, last), QTextCursor::KeepAnchor);
    if (!cursor.hasSelection() && !cursor.atBlockStart()) {
        cursor.movePosition(QTextCursor::PreviousCharacter, QTextCursor::KeepAnchor);
    } else if (!cursor.hasSelection() && !cursor.atBlockEnd()) {
        cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    }
    return cursor;
}

QTextEdit::ExtraSelection underlined(const QTextCursor &place, Severity severity)
{
    QTextEdit::ExtraSelection selection;
    selection.cursor = place;
    selection.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    selection.format.setUnderlineColor(severityColour(severity));
    return selection;
}

}
