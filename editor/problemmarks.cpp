// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "problemmarks.h"

#include <algorithm>

#include <QTextBlock>
#include <QTextDocument>

namespace romanesco {

namespace {

/// Every edit moves the marks, every movement of the cursor draws them.
constexpr std::size_t mostMarks = 1'000;

QTextCursor markedPlace(QTextDocument &document, int begin, int end)
{
    QTextCursor cursor(&document);
    const int last = document.characterCount() - 1;
    cursor.setPosition(std::min(begin, last));
    cursor.setPosition(std::min(end, last), QTextCursor::KeepAnchor);
    if (!cursor.hasSelection() && !cursor.atBlockStart()) {
        cursor.movePosition(QTextCursor::PreviousCharacter, QTextCursor::KeepAnchor);
    } else if (!cursor.hasSelection() && !cursor.atBlockEnd()) {
        cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    }
    return cursor;
}

QTextEdit::ExtraSelection underlined(const ProblemMark &problem)
{
    QTextEdit::ExtraSelection selection;
    selection.cursor = problem.place;
    selection.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    selection.format.setUnderlineColor(severityColour(problem.severity));
    return selection;
}

}

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

ProblemMarks::ProblemMarks(QTextDocument &document)
    : m_document(document)
{
}

void ProblemMarks::set(const Diagnostics &diagnostics, const TextSnapshot &text)
{
    m_all.clear();
    for (const Diagnostic &diagnostic : diagnostics) {
        if (diagnostic.severity() == Severity::Hint) {
            continue;
        }
        if (m_all.size() == mostMarks) {
            break;
        }
        const int begin = text.position(diagnostic.range.begin);
        const int end = text.position(diagnostic.range.end);
        m_all.push_back(
            {markedPlace(m_document, begin, end), diagnostic.severity(), QString::fromStdString(diagnostic.message())});
    }
}

const ProblemMark *ProblemMarks::next(int position) const
{
    const auto isAfter = [&](const ProblemMark &problem) { return problem.place.selectionStart() > position; };
    const auto following = std::ranges::find_if(m_all, isAfter);
    const auto next = following != m_all.end() ? following : m_all.begin();
    return next != m_all.end() ? &*next : nullptr;
}

QStringList ProblemMarks::messagesAt(int position) const
{
    QStringList messages;
    for (const ProblemMark &problem : m_all) {
        if (problem.place.selectionStart() <= position && position <= problem.place.selectionEnd()) {
            messages += problem.message;
        }
    }
    return messages;
}

QStringList ProblemMarks::messagesInLine(int number) const
{
    QStringList messages;
    for (const ProblemMark &problem : m_all) {
        if (line(problem) == number) {
            messages += problem.message;
        }
    }
    return messages;
}

int ProblemMarks::line(const ProblemMark &problem) const
{
    return m_document.findBlock(problem.place.selectionStart()).blockNumber();
}

QList<QTextEdit::ExtraSelection> ProblemMarks::underlines() const
{
    QList<QTextEdit::ExtraSelection> selections;
    for (const Severity severity : {Severity::Warning, Severity::Error}) {
        for (const ProblemMark &problem : m_all) {
            if (problem.severity == severity) {
                selections += underlined(problem);
            }
        }
    }
    return selections;
}

}
