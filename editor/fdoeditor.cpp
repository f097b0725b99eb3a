// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoeditor.h"

#include <algorithm>

#include <KSyntaxHighlighting/SyntaxHighlighter>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QMimeData>
#include <QTextBlock>
#include <QToolTip>
#include <QWheelEvent>

#include "editormargin.h"
#include "syntax.h"

namespace romanesco {

namespace {

/// Every edit moves the marks, every movement of the cursor draws them.
constexpr std::size_t mostMarks = 1'000;

constexpr qreal leastPointSize = 4;
constexpr qreal greatestPointSize = 96;

/// A stretch that can be underlined: a problem without length (something is missing here) takes the character before
/// it, else the one after it, within its line.
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

QTextEdit::ExtraSelection underlined(const FdoEditor::Problem &problem)
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

FdoEditor::FdoEditor(QWidget *parent)
    : QPlainTextEdit(parent)
    , m_highlighter(std::make_unique<KSyntaxHighlighting::SyntaxHighlighter>(document()))
    , m_margin(new EditorMargin(*this))
{
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_usualPointSize = font().pointSizeF();
    setFrameShape(NoFrame);
    setAccessibleName(tr("Text of the fractal"));

    connect(this, &QPlainTextEdit::blockCountChanged, this, &FdoEditor::layOutMargin);
    connect(this, &QPlainTextEdit::updateRequest, m_margin, qOverload<>(&QWidget::update));
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, &FdoEditor::updateSelections);
    applyTheme();
    layOutMargin();
}

FdoEditor::~FdoEditor() = default;

void FdoEditor::setFileName(const QString &name)
{
    m_highlighter->setDefinition(syntaxFor(name));
}

void FdoEditor::setDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text)
{
    m_problems.clear();
    for (const Diagnostic &diagnostic : diagnostics) {
        if (diagnostic.severity() == Severity::Hint) {
            continue;
        }
        if (m_problems.size() == mostMarks) {
            break;
        }
        const int begin = text.position(diagnostic.range.begin);
        const int end = text.position(diagnostic.range.end);
        m_problems.push_back(
            {markedPlace(document(), begin, end), diagnostic.severity(), QString::fromStdString(diagnostic.message())});
    }
    updateSelections();
    m_margin->update();
}

void FdoEditor::apply(const TextEdits &edits, const TextSnapshot &text)
{
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    // From the end, so that the places of the others stay what they are.
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        cursor.setPosition(text.position(edit->range.begin));
        cursor.setPosition(text.position(edit->range.end), QTextCursor::KeepAnchor);
        cursor.insertText(QString::fromStdString(edit->text));
    }
    cursor.endEditBlock();
}

void FdoEditor::goTo(SourceRange range, const TextSnapshot &text)
{
    QTextCursor cursor(document());
    cursor.setPosition(std::min(text.position(range.begin), document()->characterCount() - 1));
    setTextCursor(cursor);
    centerCursor();
    setFocus(Qt::OtherFocusReason);
}

void FdoEditor::goToNextProblem()
{
    const auto start = [](const Problem &problem) { return problem.place.selectionStart(); };
    const int here = textCursor().position();
    const auto following = std::ranges::find_if(m_problems, [&](const Problem &p) { return start(p) > here; });
    const auto next = following != m_problems.end() ? following : m_problems.begin();
    if (next == m_problems.end()) {
        return;
    }
    QTextCursor cursor(document());
    cursor.setPosition(start(*next));
    setTextCursor(cursor);
    ensureCursorVisible();
    setFocus(Qt::OtherFocusReason);
}

void FdoEditor::zoomBy(int points)
{
    QFont larger = font();
    larger.setPointSizeF(std::clamp(larger.pointSizeF() + points, leastPointSize, greatestPointSize));
    setFont(larger);
}

void FdoEditor::resetZoom()
{
    QFont usual = font();
    usual.setPointSizeF(m_usualPointSize);
    setFont(usual);
}

std::vector<FdoEditor::VisibleLine> FdoEditor::visibleLines() const
{
    std::vector<VisibleLine> lines;
    QTextBlock block = firstVisibleBlock();
    QRectF area = blockBoundingGeometry(block).translated(contentOffset());
    while (block.isValid() && area.top() <= viewport()->height()) {
        if (block.isVisible()) {
            lines.push_back({block.blockNumber(), area.toAlignedRect(), nullptr});
        }
        block = block.next();
        area = blockBoundingGeometry(block).translated(contentOffset());
    }
    for (const Problem &problem : m_problems) {
        const int number = document()->findBlock(problem.place.selectionStart()).blockNumber();
        const auto line = std::ranges::find(lines, number, &VisibleLine::number);
        if (line != lines.end() && (!line->worst || problem.severity < line->worst->severity)) {
            line->worst = &problem;
        }
    }
    return lines;
}

QString FdoEditor::messagesInLine(int number) const
{
    QStringList messages;
    for (const Problem &problem : m_problems) {
        if (document()->findBlock(problem.place.selectionStart()).blockNumber() == number) {
            messages += problem.message;
        }
    }
    return messages.join(u'\n');
}

QColor FdoEditor::colour(KSyntaxHighlighting::Theme::EditorColorRole role) const
{
    return QColor::fromRgba(m_theme.editorColor(role));
}

/// Files that are dropped are for the window to open, not to be written as their addresses.
bool FdoEditor::canInsertFromMimeData(const QMimeData *source) const
{
    return !source->hasUrls() && QPlainTextEdit::canInsertFromMimeData(source);
}

void FdoEditor::changeEvent(QEvent *event)
{
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        applyTheme();
    } else if (event->type() == QEvent::FontChange) {
        setTabStopDistance(4 * fontMetrics().horizontalAdvance(u' '));
        layOutMargin();
    }
}

void FdoEditor::resizeEvent(QResizeEvent *event)
{
    QPlainTextEdit::resizeEvent(event);
    layOutMargin();
}

bool FdoEditor::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        const QString messages = messagesAt(help->pos());
        if (messages.isEmpty()) {
            QToolTip::hideText();
        } else {
            QToolTip::showText(help->globalPos(), messages, viewport());
        }
        return true;
    }
    return QPlainTextEdit::viewportEvent(event);
}

void FdoEditor::wheelEvent(QWheelEvent *event)
{
    if (!(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
        QPlainTextEdit::wheelEvent(event);
        return;
    }
    // With Alt, Qt gives the wheel's movement as a horizontal one.
    const QPoint delta = event->angleDelta();
    const int movement = delta.y() != 0 ? delta.y() : delta.x();
    if (movement != 0) {
        zoomBy(movement > 0 ? 1 : -1);
    }
    event->accept();
}

void FdoEditor::applyTheme()
{
    m_theme = themeFor(palette());
    m_highlighter->setTheme(m_theme);
    m_highlighter->rehighlight();
    updateSelections();
}

void FdoEditor::layOutMargin()
{
    // Also called while the base class is still being built.
    if (!m_margin) {
        return;
    }
    const int width = m_margin->sizeHint().width();
    setViewportMargins(width, 0, 0, 0);
    const QRect inner = contentsRect();
    m_margin->setGeometry(inner.left(), inner.top(), width, inner.height());
}

void FdoEditor::updateSelections()
{
    QList<QTextEdit::ExtraSelection> selections;
    QTextEdit::ExtraSelection line;
    line.cursor = textCursor();
    line.cursor.clearSelection();
    line.format.setBackground(colour(KSyntaxHighlighting::Theme::CurrentLine));
    line.format.setProperty(QTextFormat::FullWidthSelection, true);
    selections += line;
    // Errors last, so that they lie above warnings.
    for (const Severity severity : {Severity::Warning, Severity::Error}) {
        for (const Problem &problem : m_problems) {
            if (problem.severity == severity) {
                selections += underlined(problem);
            }
        }
    }
    setExtraSelections(selections);
}

QString FdoEditor::messagesAt(const QPoint &point) const
{
    // The cursor that is nearest may be far from the point, at the end of a line; or behind the character it is on.
    const QTextCursor nearest = cursorForPosition(point);
    const QRect caret = cursorRect(nearest);
    const bool isOnText = point.y() <= caret.bottom() && point.x() <= caret.right() + caret.height() / 2;
    QStringList messages;
    for (const Problem &problem : m_problems) {
        const int begin = problem.place.selectionStart();
        const int end = problem.place.selectionEnd();
        if (isOnText && begin <= nearest.position() && nearest.position() <= end) {
            messages += problem.message;
        }
    }
    return messages.join(u'\n');
}

}
