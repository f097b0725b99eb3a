// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoeditor.h"

#include <algorithm>

#include <KSyntaxHighlighting/SyntaxHighlighter>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolTip>
#include <QWheelEvent>

#include "brackets.h"
#include "core/language/formatter.h"
#include "editormargin.h"
#include "folding.h"
#include "inlaynumbers.h"
#include "pinnednumbers.h"
#include "renaming.h"
#include "renumberoffer.h"
#include "syntax.h"
#include "textediting.h"
#include "tooltips.h"
#include "wordnavigation.h"

namespace romanesco {

namespace {

constexpr qreal leastPointSize = 4;
constexpr qreal greatestPointSize = 96;

}

FdoEditor::FdoEditor(QWidget *parent)
    : QPlainTextEdit(parent)
    , m_highlighter(std::make_unique<KSyntaxHighlighting::SyntaxHighlighter>(document()))
    , m_language(*document())
    , m_completion(new CompletionPopup(*this, m_language))
    , m_fixes(new QuickFixes(*this, m_language))
    , m_navigation(new WordNavigation(*this))
    , m_scrubber(*this)
    , m_renumbering(new RenumberOffer(*this, m_language))
    , m_folding(new Folding(*this, m_language))
    , m_pinned(new PinnedNumbers(*this))
    , m_margin(new EditorMargin(*this))
    , m_problems(*document())
{
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_usualPointSize = font().pointSizeF();
    setFrameShape(NoFrame);
    setAccessibleName(tr("Text of the fractal"));

    connect(this, &QPlainTextEdit::blockCountChanged, this, &FdoEditor::layOutMargin);
    connect(this, &QPlainTextEdit::updateRequest, m_margin, qOverload<>(&QWidget::update));
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, &FdoEditor::updateSelections);
    connect(document(), &QTextDocument::contentsChange, this, [this] { m_marks.clear(); });
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &FdoEditor::updateSelections);
    connect(m_navigation, &WordNavigation::openFileRequested, this, &FdoEditor::openFileRequested);
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, &FdoEditor::markBrackets);
    connect(this, &QPlainTextEdit::textChanged, this, &FdoEditor::markBrackets);
    connect(m_folding, &Folding::changed, m_margin, qOverload<>(&QWidget::update));
    connect(m_renumbering, &RenumberOffer::changed, this, &FdoEditor::renumberingOffered);
    // Numbers beside lines that were not edited may change too.
    connect(this, &QPlainTextEdit::textChanged, viewport(), qOverload<>(&QWidget::update));
    viewport()->setMouseTracking(true);
    applyTheme();
    layOutMargin();
}

FdoEditor::~FdoEditor()
{
    // It takes its colours off, which counts as a change of the text: all that follow changes must be there still.
    m_highlighter.reset();
}

void FdoEditor::setFileName(const QString &name)
{
    m_highlighter->setDefinition(syntaxFor(name));
    m_language.setFileName(name);
}

void FdoEditor::setDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text)
{
    m_fixes->setDiagnostics(diagnostics, text);
    m_problems.set(diagnostics, text);
    updateSelections();
    m_margin->update();
}

void FdoEditor::apply(const TextEdits &edits, const TextSnapshot &text)
{
    applyEdits(*this, edits, text);
}

void FdoEditor::goTo(SourceRange range, const TextSnapshot &text)
{
    QTextCursor cursor(document());
    cursor.setPosition(std::min(text.position(range.begin), document()->characterCount() - 1));
    setTextCursor(cursor);
    centerCursor();
    setFocus(Qt::OtherFocusReason);
}

void FdoEditor::select(SourceRange range, const TextSnapshot &text)
{
    const int last = document()->characterCount() - 1;
    QTextCursor cursor(document());
    cursor.setPosition(std::min(text.position(range.begin), last));
    cursor.setPosition(std::min(text.position(range.end), last), QTextCursor::KeepAnchor);
    setTextCursor(cursor);
    ensureCursorVisible();
}

void FdoEditor::goToNextProblem()
{
    const ProblemMark *next = m_problems.next(textCursor().position());
    if (!next) {
        return;
    }
    QTextCursor cursor(document());
    cursor.setPosition(next->place.selectionStart());
    setTextCursor(cursor);
    ensureCursorVisible();
    setFocus(Qt::OtherFocusReason);
}

void FdoEditor::goToLine(int line)
{
    const int last = blockCount() - 1;
    setTextCursor(QTextCursor(document()->findBlockByNumber(std::clamp(line - 1, 0, last))));
    centerCursor();
    setFocus(Qt::OtherFocusReason);
}

void FdoEditor::goToDefinition()
{
    if (!m_navigation->goToDefinition()) {
        sayAtCursor(tr("The word at the cursor leads nowhere."));
    }
}

void FdoEditor::goToNextUse()
{
    m_navigation->goToUse(true);
}

void FdoEditor::goToPreviousUse()
{
    m_navigation->goToUse(false);
}

void FdoEditor::rename()
{
    askForName(*this);
}

void FdoEditor::format()
{
    if (const FdoDocument *fdo = m_language.fdo()) {
        apply(formatting(fdo->syntax), m_language.snapshot());
    } else if (const SdoSyntax *sdo = m_language.sdo()) {
        apply(formatting(*sdo), m_language.snapshot());
    }
}

void FdoEditor::toggleComment()
{
    romanesco::toggleComment(*this);
}

void FdoEditor::duplicateLines()
{
    romanesco::duplicateLines(*this);
}

int FdoEditor::renumberingCount() const
{
    return m_renumbering->count();
}

void FdoEditor::renumber()
{
    m_renumbering->take();
}

void FdoEditor::dismissRenumbering()
{
    m_renumbering->dismiss();
}

void FdoEditor::fold()
{
    m_folding->foldAtCursor();
}

void FdoEditor::unfold()
{
    m_folding->unfoldAtCursor();
}

void FdoEditor::foldAll()
{
    m_folding->foldAll();
}

void FdoEditor::unfoldAll()
{
    m_folding->unfoldAll();
}

void FdoEditor::askForLine()
{
    romanesco::askForLine(*this);
}

void FdoEditor::mark(MarkLayer layer, std::vector<TextStretch> stretches, const QTextCharFormat &format)
{
    m_marks.set(layer, std::move(stretches), format);
    updateSelections();
}

void FdoEditor::sayAtCursor(const QString &sentence)
{
    QToolTip::showText(viewport()->mapToGlobal(cursorRect().bottomLeft()), sentence, viewport());
}

void FdoEditor::setUsualFont(QFont usual)
{
    const qreal zoomed = font().pointSizeF() - m_usualPointSize;
    m_usualPointSize = usual.pointSizeF();
    usual.setPointSizeF(std::clamp(m_usualPointSize + zoomed, leastPointSize, greatestPointSize));
    setFont(usual);
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
    for (const ProblemMark &problem : problems()) {
        const auto line = std::ranges::find(lines, m_problems.line(problem), &VisibleLine::number);
        if (line != lines.end() && (!line->worst || problem.severity < line->worst->severity)) {
            line->worst = &problem;
        }
    }
    return lines;
}

QString FdoEditor::messagesInLine(int number) const
{
    return m_problems.messagesInLine(number).join(u'\n');
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

/// Qt's, and what can be done to a number. By the key it is about the cursor's.
void FdoEditor::contextMenuEvent(QContextMenuEvent *event)
{
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard;
    const std::optional<int> position = isByKey ? textCursor().position() : positionAt(event->pos());
    QMenu *menu = createStandardContextMenu(event->pos());
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (position && numberAt(m_language, *position)) {
        menu->addSeparator();
        QAction *pin = menu->addAction(tr("&Pin as Slider"), this, [this, at = *position] { m_pinned->pin(at); });
        pin->setEnabled(!isReadOnly());
    }
    menu->popup(event->globalPos());
}

void FdoEditor::keyPressEvent(QKeyEvent *event)
{
    if (m_completion->takes(*event)) {
        event->ignore();
        return;
    }
    const bool isStep = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    if (isStep && (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::AltModifier) {
        stepNumber(event->key() == Qt::Key_Up ? 1 : -1, event->modifiers() & Qt::ShiftModifier);
        return;
    }
    QPlainTextEdit::keyPressEvent(event);
    m_completion->follow(*event);
    if (event->key() == Qt::Key_Control) {
        m_navigation->changeModifiers(event->modifiers() | Qt::ControlModifier);
    }
}

void FdoEditor::keyReleaseEvent(QKeyEvent *event)
{
    QPlainTextEdit::keyReleaseEvent(event);
    m_navigation->changeModifiers(Qt::NoModifier);
    if (event->key() == Qt::Key_Alt) {
        m_scrubber.endSteps();
    }
}

void FdoEditor::mouseMoveEvent(QMouseEvent *event)
{
    m_navigation->point(event->position().toPoint(), event->buttons() ? Qt::NoModifier : event->modifiers());
    if (m_scrubber.move(*event)) {
        return;
    }
    QPlainTextEdit::mouseMoveEvent(event);
}

void FdoEditor::mousePressEvent(QMouseEvent *event)
{
    const bool isLink = m_navigation->press(*event);
    const bool isNumber = m_scrubber.press(*event);
    if (!isLink && !isNumber) {
        QPlainTextEdit::mousePressEvent(event);
    }
}

void FdoEditor::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_scrubber.release(*event)) {
        m_navigation->forgetPress();
    } else if (!m_navigation->release(*event)) {
        QPlainTextEdit::mouseReleaseEvent(event);
    }
}

void FdoEditor::paintEvent(QPaintEvent *event)
{
    QPlainTextEdit::paintEvent(event);
    QPainter painter(viewport());
    painter.setClipRect(event->rect());
    paintInlayNumbers(painter, *this);
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
        if (const std::optional<int> position = positionAt(help->pos())) {
            showTip(*position, help->globalPos());
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    if (event->type() == QEvent::Leave) {
        m_navigation->point({-1, -1}, Qt::NoModifier);
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
    markBrackets();
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
    if (!m_marks.isEmpty()) {
        // To tell what is in sight is dear in a line of 1 MB.
        const int first = cursorForPosition({0, 0}).position();
        const int last = cursorForPosition(viewport()->rect().bottomRight()).position();
        selections += m_marks.between(first, last, *document());
    }
    setExtraSelections(selections + m_problems.underlines());
}

void FdoEditor::markBrackets()
{
    QTextCharFormat format;
    format.setBackground(colour(KSyntaxHighlighting::Theme::BracketMatching));
    std::vector<TextStretch> brackets = matchingBrackets(*document(), textCursor().position());
    if (!brackets.empty() || !m_marks.stretches(MarkLayer::Brackets).empty()) {
        mark(MarkLayer::Brackets, std::move(brackets), format);
    }
}

std::optional<int> FdoEditor::positionAt(const QPoint &point) const
{
    // The cursor that is nearest may be far from the point, at the end of a line; or behind the character it is on.
    const QTextCursor nearest = cursorForPosition(point);
    const QRect caret = cursorRect(nearest);
    const bool isOnText = point.y() <= caret.bottom() && point.x() <= caret.right() + caret.height() / 2;
    return isOnText ? std::optional(nearest.position()) : std::nullopt;
}

void FdoEditor::showTip()
{
    showTip(textCursor().position(), viewport()->mapToGlobal(cursorRect().bottomLeft()));
}

void FdoEditor::showTip(int position, const QPoint &globalPlace)
{
    // Without words it hides.
    QToolTip::showText(globalPlace, tipWords(m_problems.messagesAt(position), m_language, position), viewport());
}

}
