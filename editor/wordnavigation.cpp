// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "wordnavigation.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QMouseEvent>

#include "fdoeditor.h"

namespace romanesco {

namespace {

/// While a person types or moves on, nothing flickers.
constexpr int restMilliseconds = 150;

/// The word that a position stands in: what may be underlined as a link.
TextStretch wordAt(QTextDocument &document, int position)
{
    QTextCursor cursor(&document);
    cursor.setPosition(position);
    cursor.select(QTextCursor::WordUnderCursor);
    return {cursor.selectionStart(), cursor.selectionEnd()};
}

}

WordNavigation::WordNavigation(FdoEditor &editor)
    : QObject(&editor)
    , m_editor(editor)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &WordNavigation::markUses);
    connect(&editor, &QPlainTextEdit::cursorPositionChanged, &m_rest, qOverload<>(&QTimer::start));
    connect(editor.document(), &QTextDocument::contentsChange, &m_rest, qOverload<>(&QTimer::start));
}

bool WordNavigation::goToDefinition()
{
    return follow(m_editor.textCursor().position());
}

void WordNavigation::goToUse(bool isForward)
{
    const std::vector<Occurrence> uses = usesAtCursor();
    if (uses.empty()) {
        return;
    }
    const std::size_t here = m_editor.language().offset(m_editor.textCursor().position());
    const auto current = std::ranges::find_if(uses, [&](const Occurrence &use) { return use.range.touches(here); });
    const auto count = static_cast<std::ptrdiff_t>(uses.size());
    const std::ptrdiff_t index = (current - uses.begin() + (isForward ? 1 : count - 1)) % count;
    goTo(uses[static_cast<std::size_t>(index)].range.begin);
}

bool WordNavigation::press(const QMouseEvent &event)
{
    m_pressed.reset();
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::ControlModifier) {
        return false;
    }
    const std::optional<int> position = m_editor.positionAt(event.position().toPoint());
    if (position && targetAt(*position)) {
        m_pressed = event.position().toPoint();
    }
    return m_pressed.has_value();
}

bool WordNavigation::release(const QMouseEvent &event)
{
    const std::optional<QPoint> pressed = std::exchange(m_pressed, std::nullopt);
    if (!pressed) {
        return false;
    }
    const QPoint place = event.position().toPoint();
    const bool isClick = (place - *pressed).manhattanLength() < QApplication::startDragDistance();
    if (const std::optional<int> position = m_editor.positionAt(place); position && isClick) {
        follow(*position);
    }
    return true;
}

void WordNavigation::point(const QPoint &place, Qt::KeyboardModifiers modifiers)
{
    m_mouse = place;
    changeModifiers(modifiers);
}

void WordNavigation::changeModifiers(Qt::KeyboardModifiers modifiers)
{
    const bool isInside = m_editor.viewport()->rect().contains(m_mouse);
    markLink(modifiers == Qt::ControlModifier && isInside ? m_editor.positionAt(m_mouse) : std::nullopt);
}

std::optional<Target> WordNavigation::targetAt(int position)
{
    LanguageText &text = m_editor.language();
    const std::size_t offset = text.offset(position);
    if (const FdoDocument *fdo = text.fdo()) {
        return definition(*fdo, offset);
    }
    const SdoSyntax *sdo = text.sdo();
    return sdo ? definition(*sdo, offset) : std::nullopt;
}

std::vector<Occurrence> WordNavigation::usesAtCursor()
{
    const FdoDocument *fdo = m_editor.language().fdo();
    const std::size_t offset = m_editor.language().offset(m_editor.textCursor().position());
    return fdo ? uses(*fdo, offset) : std::vector<Occurrence>();
}

bool WordNavigation::follow(int position)
{
    const std::optional<Target> target = targetAt(position);
    if (!target) {
        return false;
    }
    markLink(std::nullopt);
    if (target->path) {
        Q_EMIT openFileRequested(QString::fromStdString(*target->path));
    } else {
        goTo(target->range.begin);
    }
    return true;
}

void WordNavigation::goTo(std::size_t offset)
{
    QTextCursor cursor = m_editor.textCursor();
    cursor.setPosition(m_editor.language().position(offset));
    m_editor.setTextCursor(cursor);
    m_editor.ensureCursorVisible();
}

void WordNavigation::markUses()
{
    std::vector<TextStretch> stretches;
    for (const Occurrence &use : usesAtCursor()) {
        LanguageText &text = m_editor.language();
        stretches.push_back({text.position(use.range.begin), text.position(use.range.end)});
    }
    QTextCharFormat format;
    QColor quiet = m_editor.palette().color(QPalette::Highlight);
    quiet.setAlpha(48);
    format.setBackground(quiet);
    m_editor.mark(MarkLayer::Uses, std::move(stretches), format);
}

void WordNavigation::markLink(std::optional<int> position)
{
    const bool isLink = position && targetAt(*position);
    if (!isLink && m_editor.marks().stretches(MarkLayer::Link).empty()) {
        return;
    }
    QTextCharFormat format;
    format.setForeground(m_editor.palette().link());
    format.setFontUnderline(true);
    std::vector<TextStretch> stretches;
    if (isLink) {
        stretches.push_back(wordAt(*m_editor.document(), *position));
    }
    m_editor.mark(MarkLayer::Link, std::move(stretches), format);
    m_editor.viewport()->setCursor(isLink ? Qt::PointingHandCursor : Qt::IBeamCursor);
}

}
