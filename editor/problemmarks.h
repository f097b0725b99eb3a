// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include <QTextEdit>

#include "core/text/diagnostic.h"
#include "textsnapshot.h"

namespace romanesco {

/// Red for errors, amber for warnings, grey for hints: readable on light and on dark.
[[nodiscard]] QColor severityColour(Severity severity);

/// What is wrong with one stretch of the text. One without length (something is missing here) takes the character before
/// it, else the one after it, within its line.
struct ProblemMark {
    QTextCursor place;
    Severity severity;
    QString message;
};

/// The problems of a text, the first thousand of them. They move with the text until they are set anew.
class ProblemMarks
{
public:
    explicit ProblemMarks(QTextDocument &document);

    /// Errors and warnings, in place of those before; hints stay unmarked. Ranges are of that text, which the document
    /// still has.
    void set(const Diagnostics &diagnostics, const TextSnapshot &text);

    [[nodiscard]] const std::vector<ProblemMark> &all() const { return m_all; }
    /// The first that begins after the position, from the end on again from the start; null where there is none.
    [[nodiscard]] const ProblemMark *next(int position) const;
    [[nodiscard]] QStringList messagesAt(int position) const;
    [[nodiscard]] QStringList messagesInLine(int number) const;
    /// The number of the line, from 0, where one begins.
    [[nodiscard]] int line(const ProblemMark &problem) const;
    /// Waves in the colours of the severities; errors last, so that they lie above warnings.
    [[nodiscard]] QList<QTextEdit::ExtraSelection> underlines() const;

private:
    QTextDocument &m_document;
    std::vector<ProblemMark> m_all;
};

}
