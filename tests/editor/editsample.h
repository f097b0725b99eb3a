// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>

#include <QPlainTextEdit>

namespace romanesco::test {

/// Texts with their cursor: | is the cursor, [ the other end of a selection.

inline QString unmarked(QString text)
{
    return text.remove(u'|').remove(u'[');
}

/// Puts a text and its cursor into an editor, without undo history.
inline void setMarked(QPlainTextEdit &editor, const QString &text)
{
    const auto position = static_cast<int>(QString(text).remove(u'[').indexOf(u'|'));
    const auto other = static_cast<int>(QString(text).remove(u'|').indexOf(u'['));
    editor.setPlainText(unmarked(text));
    QTextCursor cursor = editor.textCursor();
    cursor.setPosition(other >= 0 ? other : std::max(position, 0));
    cursor.setPosition(std::max(position, 0), QTextCursor::KeepAnchor);
    editor.setTextCursor(cursor);
}

/// The way back.
inline QString marked(const QPlainTextEdit &editor)
{
    const QTextCursor cursor = editor.textCursor();
    QString text = editor.toPlainText();
    const bool isForward = cursor.anchor() < cursor.position();
    text.insert(std::max(cursor.anchor(), cursor.position()), isForward || !cursor.hasSelection() ? u'|' : u'[');
    if (cursor.hasSelection()) {
        text.insert(std::min(cursor.anchor(), cursor.position()), isForward ? u'[' : u'|');
    }
    return text;
}

}
