// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <vector>

#include <KSyntaxHighlighting/Theme>
#include <QPlainTextEdit>

#include "core/text/diagnostic.h"
#include "core/text/textedit.h"
#include "textsnapshot.h"

namespace KSyntaxHighlighting {
class SyntaxHighlighter;
}

namespace romanesco {

class EditorMargin;

/// The text of a fractal: coloured, with line numbers, and with its problems marked in the text and in the margin.
/// Problems move with the text until they are set anew.
class FdoEditor : public QPlainTextEdit
{
    Q_OBJECT
public:
    explicit FdoEditor(QWidget *parent = nullptr);
    ~FdoEditor() override;

    /// Colours the text as the ending of the name asks.
    void setFileName(const QString &name);

    [[nodiscard]] TextSnapshot snapshot() const { return TextSnapshot(*document()); }

    /// Marks errors and warnings, in place of those marked before; hints stay unmarked. Ranges are of that text, which
    /// the document still has.
    void setDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text);

    /// What is wrong with one stretch of the text.
    struct Problem {
        QTextCursor place;
        Severity severity;
        QString message;
    };
    [[nodiscard]] const std::vector<Problem> &problems() const { return m_problems; }

    /// One undo step. Ranges are of that text, which the document still has.
    void apply(const TextEdits &edits, const TextSnapshot &text);

    /// Puts the cursor at the begin of a range of the text and scrolls there.
    void goTo(SourceRange range, const TextSnapshot &text);
    /// The first problem after the cursor, from the end on again from the start.
    void goToNextProblem();

    /// Larger or smaller by so many points; the size stays between 4 and 96.
    void zoomBy(int points);
    void resetZoom();

    // For the margin.
    struct VisibleLine {
        int number;
        QRect area;
        /// Null where the line has no problem.
        const Problem *worst;
    };
    [[nodiscard]] std::vector<VisibleLine> visibleLines() const;
    [[nodiscard]] QString messagesInLine(int number) const;
    [[nodiscard]] QColor colour(KSyntaxHighlighting::Theme::EditorColorRole role) const;

protected:
    bool canInsertFromMimeData(const QMimeData *source) const override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void applyTheme();
    void layOutMargin();
    void updateSelections();
    [[nodiscard]] QString messagesAt(const QPoint &point) const;

    std::unique_ptr<KSyntaxHighlighting::SyntaxHighlighter> m_highlighter;
    KSyntaxHighlighting::Theme m_theme;
    EditorMargin *m_margin;
    std::vector<Problem> m_problems;
    qreal m_usualPointSize;
};

/// Red for errors, amber for warnings, grey for hints: readable on light and on dark.
[[nodiscard]] QColor severityColour(Severity severity);

}
