// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <KSyntaxHighlighting/Theme>
#include <QPlainTextEdit>

#include "completionpopup.h"
#include "core/text/diagnostic.h"
#include "core/text/textedit.h"
#include "languagetext.h"
#include "problemmarks.h"
#include "quickfixes.h"
#include "scrubber.h"
#include "textmarks.h"
#include "textsnapshot.h"

namespace KSyntaxHighlighting {
class SyntaxHighlighter;
}

namespace romanesco {

class EditorMargin;
class Folding;
class PinnedNumbers;
class RenumberOffer;
class WordNavigation;

/// The text of a fractal: coloured, with line numbers, and with its problems marked in the text and in the margin.
/// Problems move with the text until they are set anew.
class FdoEditor : public QPlainTextEdit
{
    Q_OBJECT
public:
    explicit FdoEditor(QWidget *parent = nullptr);
    ~FdoEditor() override;

    /// Colours and reads the text as the ending of the name asks.
    void setFileName(const QString &name);

    [[nodiscard]] TextSnapshot snapshot() const { return TextSnapshot(*document()); }
    /// The text as its language reads it.
    [[nodiscard]] LanguageText &language() { return m_language; }

    /// The files that completion offers.
    void setFiles(FileNames files) { m_completion->setFiles(std::move(files)); }

    /// Marks errors and warnings, in place of those marked before; hints stay unmarked. Ranges are of that text, which
    /// the document still has.
    void setDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text);

    [[nodiscard]] const std::vector<ProblemMark> &problems() const { return m_problems.all(); }

    /// One undo step; the cursor stays at its word. Ranges are of that text, which the document still has.
    void apply(const TextEdits &edits, const TextSnapshot &text);

    /// Puts the cursor at the begin of a range of the text and scrolls there.
    void goTo(SourceRange range, const TextSnapshot &text);
    /// Selects a range of the text and shows it; the focus stays where it is.
    void select(SourceRange range, const TextSnapshot &text);
    /// The first problem after the cursor, from the end on again from the start.
    void goToNextProblem();

    /// The font without zoom; how far it is zoomed stays.
    void setUsualFont(QFont font);
    /// Larger or smaller by so many points; the size stays between 4 and 96.
    void zoomBy(int points);
    void resetZoom();

    // For the features beside it.
    /// Marks stretches until the text changes.
    void mark(MarkLayer layer, std::vector<TextStretch> stretches, const QTextCharFormat &format);
    [[nodiscard]] const TextMarks &marks() const { return m_marks; }
    /// Of the character under a point of the viewport; nothing beside the text.
    [[nodiscard]] std::optional<int> positionAt(const QPoint &point) const;
    /// A tool tip below the cursor.
    void sayAtCursor(const QString &sentence);

    /// So many uses would change by renumber(); 0 where nothing is offered.
    [[nodiscard]] int renumberingCount() const;

    [[nodiscard]] PinnedNumbers &pinnedNumbers() { return *m_pinned; }

    // For the margin.
    [[nodiscard]] Folding &folding() { return *m_folding; }
    struct VisibleLine {
        int number;
        QRect area;
        /// Null where the line has no problem.
        const ProblemMark *worst;
    };
    [[nodiscard]] std::vector<VisibleLine> visibleLines() const;
    [[nodiscard]] QString messagesInLine(int number) const;
    [[nodiscard]] QColor colour(KSyntaxHighlighting::Theme::EditorColorRole role) const;

public Q_SLOTS:
    /// Offers what may stand at the cursor (Ctrl+Space).
    void complete() { m_completion->open(); }
    /// Offers to put right what is wrong at the cursor (Ctrl+.).
    void offerFixes() { m_fixes->offer(); }
    /// Says what the word at the cursor stands for, as the mouse does that rests on it.
    void showTip();
    /// To what the word at the cursor stands for (F12); a path asks for its file.
    void goToDefinition();
    /// Round the uses of the word at the cursor.
    void goToNextUse();
    void goToPreviousUse();
    /// Asks for another name for what the word at the cursor stands for (F2).
    void rename();
    /// Tidies the layout of the text (Ctrl+I): one undo step; the cursor stays at its word.
    void format();
    void toggleComment();
    void duplicateLines();
    /// Moves the number at the cursor by so many of its last decimal, or of one behind it (Alt+Up, Alt+Down; with Shift
    /// finer).
    void stepNumber(int steps, bool isFiner) { m_scrubber.step(steps, isFiner); }
    /// Takes the offer to change uses of vectors by number, or declines it.
    void renumber();
    void dismissRenumbering();
    /// The section that the cursor is in (Ctrl+Shift+-, Ctrl+Shift++), or all.
    void fold();
    void unfold();
    void foldAll();
    void unfoldAll();
    /// Asks for the number of a line and goes there (Ctrl+L).
    void askForLine();
    /// A line from 1; beyond the text it is the last.
    void goToLine(int line);

Q_SIGNALS:
    /// A path as it is written in the text.
    void openFileRequested(const QString &path);
    /// Vectors came or went: renumber() would change so many uses. 0 withdraws the offer.
    void renumberingOffered(int count);

protected:
    bool canInsertFromMimeData(const QMimeData *source) const override;
    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void applyTheme();
    void layOutMargin();
    void updateSelections();
    void markBrackets();
    void showTip(int position, const QPoint &globalPlace);

    std::unique_ptr<KSyntaxHighlighting::SyntaxHighlighter> m_highlighter;
    KSyntaxHighlighting::Theme m_theme;
    LanguageText m_language;
    CompletionPopup *m_completion;
    QuickFixes *m_fixes;
    TextMarks m_marks;
    WordNavigation *m_navigation;
    Scrubber m_scrubber;
    RenumberOffer *m_renumbering;
    Folding *m_folding;
    PinnedNumbers *m_pinned;
    EditorMargin *m_margin;
    ProblemMarks m_problems;
    qreal m_usualPointSize;
};

}
