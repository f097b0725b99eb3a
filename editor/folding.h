// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QObject>

#include "core/language/structure.h"

class QPlainTextEdit;
class QTextBlock;

namespace romanesco {

class LanguageText;

/// Folds sections of a text away: all of their lines but the first are out of sight. Which are is kept in the document's
/// blocks alone. A fold opens when it or the line before is edited, and when the cursor comes into it, so that nothing
/// happens out of sight.
class Folding : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    Folding(QPlainTextEdit &editor, LanguageText &text);

    /// Lines count from 0.
    [[nodiscard]] bool canFold(int line);
    [[nodiscard]] bool isFolded(int line) const;

    /// Of the section that starts in a line.
    void toggle(int line);

    /// The section that the cursor is in, which goes to the end of its first line.
    void foldAtCursor();
    void unfoldAtCursor();
    void foldAll();
    void unfoldAll();

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] std::optional<FoldingRange> sectionAt(int line);
    void fold(FoldingRange section);
    void unfoldRound(const QTextBlock &line);
    void setVisible(QTextBlock first, const QTextBlock &end, bool isVisible);
    void openWhatIsEdited(int begin, int added);

    QPlainTextEdit &m_editor;
    LanguageText &m_text;
};

}
