// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "addresslink.h"

#include <algorithm>

#include <QAction>

#include "addresspane.h"
#include "editor/fdoeditor.h"
#include "texttab.h"
#include "viewport.h"

namespace romanesco {

AddressLink::AddressLink(AddressPane &pane, Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_pane(pane)
    , m_viewport(viewport)
    , m_hover(viewport)
{
    connect(&m_viewport, &Viewport::clicked, this, &AddressLink::tell);
    connect(&m_pane, &AddressPane::chosen, this, &AddressLink::choose);
    connect(&m_pane, &AddressPane::zoomRequested, &m_viewport, &Viewport::zoomToSelection);
    connect(&m_pane, &AddressPane::collapseRequested, this, &AddressLink::collapse);
    connect(&m_hover, &HoverPick::rested, this, [this](const Selection &copy) { Q_EMIT told(wordsOf(copy)); });
    connect(&m_hover, &HoverPick::left, this, [this] { Q_EMIT told(addressWords(m_steps)); });
    m_cursorRest.setSingleShot(true);
    m_cursorRest.setInterval(150);
    connect(&m_cursorRest, &QTimer::timeout, this, &AddressLink::showMapAtCursor);
}

void AddressLink::use(QAction &zoom, QAction &collapse)
{
    m_zoomAction = &zoom;
    m_collapseAction = &collapse;
    connect(&zoom, &QAction::triggered, &m_viewport, &Viewport::zoomToSelection);
    connect(&collapse, &QAction::triggered, this, &AddressLink::collapse);
    offer();
}

void AddressLink::follow(TextTab &seen, bool isLookedAt)
{
    m_seen = &seen;
    m_isLookedAt = isLookedAt;
    m_whileFollowed = std::make_unique<QObject>();
    connect(&seen.editor(), &QPlainTextEdit::cursorPositionChanged, m_whileFollowed.get(),
            [this] { m_cursorRest.start(); });
    m_cursorRest.start();
}

void AddressLink::clear()
{
    m_steps.clear();
    m_pane.setSteps({});
    offer();
    m_cursorRest.start();
}

void AddressLink::update()
{
    if (m_viewport.appearance().colours.selection) {
        list(); // a tool holds on to it
    } else {
        clear();
    }
    m_cursorRest.start();
}

/// Of a copy of the scene that is seen.
std::vector<AddressStep> AddressLink::stepsTo(const Selection &copy) const
{
    const auto &surroundings = m_viewport.view().surroundings();
    return surroundings
        ? addressSteps(*surroundings->scene, copy, m_seen->preview().reading.get(), m_seen->document().text().bytes())
        : std::vector<AddressStep>();
}

QString AddressLink::wordsOf(const Selection &copy) const
{
    return addressWords(stepsTo(copy));
}

QString AddressLink::wordsOf(std::size_t item, const Address &address) const
{
    const auto &surroundings = m_viewport.view().surroundings();
    return surroundings ? addressWords(addressSteps(*surroundings->scene, item, address,
                                                    m_seen->preview().reading.get(), m_seen->document().text().bytes()))
                        : QString();
}

/// Of the copy that stands out.
void AddressLink::list()
{
    const std::optional<Selection> &selection = m_viewport.appearance().colours.selection;
    m_steps.clear();
    m_wholeWay.clear();
    if (selection) {
        m_steps = stepsTo(*selection);
        m_wholeWay = selection->steps;
    }
    m_pane.setSteps(m_steps);
    offer();
}

void AddressLink::tell()
{
    list();
    Q_EMIT told(addressWords(m_steps));
}

/// So many of the steps: their words in the text, and what they lead to in the picture.
void AddressLink::choose(std::size_t count)
{
    std::optional<Selection> selection = m_viewport.appearance().colours.selection;
    if (!selection || count > m_steps.size() || count > m_wholeWay.size()) {
        return;
    }
    selection->steps.assign(m_wholeWay.begin(), m_wholeWay.begin() + static_cast<std::ptrdiff_t>(count));
    m_viewport.select(selection);
    offer();
    if (const std::optional<SourceRange> use = m_steps[count - 1].use; use && m_isLookedAt) {
        m_seen->editor().select(*use, m_seen->document().text());
        // Here one way is looked at, not all that the words have made.
        m_cursorRest.stop();
        m_viewport.selectMap(std::nullopt);
    }
}

/// What can be done with the copy that stands out.
void AddressLink::offer()
{
    const std::optional<quint64> depth = collapsedDepth();
    m_pane.setCollapse(depth);
    if (m_zoomAction) {
        m_zoomAction->setEnabled(!m_steps.empty());
        m_collapseAction->setEnabled(depth.has_value());
    }
}

/// The depth for which the chosen step, or the last before it that the depth counts, would be in the last iteration; nothing
/// where that would change nothing.
std::optional<quint64> AddressLink::collapsedDepth() const
{
    const std::optional<Selection> &selection = m_viewport.appearance().colours.selection;
    if (!selection || !m_isLookedAt || m_seen->editor().isReadOnly() || !m_seen->depth().value()) {
        return std::nullopt;
    }
    std::optional<quint64> depth;
    for (std::size_t i = 0; i < std::min(m_steps.size(), selection->steps.size()); ++i) {
        if (m_steps[i].pass) {
            depth = *m_steps[i].pass;
        }
    }
    const bool isThere = !m_seen->isEndless() && depth == m_seen->depth().value();
    return isThere ? std::nullopt : depth;
}

void AddressLink::collapse()
{
    if (const std::optional<quint64> depth = collapsedDepth()) {
        m_seen->setEndless(false);
        m_seen->depth().setValue(*depth);
    }
}

void AddressLink::showMapAtCursor()
{
    const Preview &preview = m_seen->preview();
    const TextSnapshot &text = m_seen->document().text();
    std::optional<Step> map;
    // Of a text that is not built yet, places mean nothing.
    if (m_isLookedAt && preview.reading && preview.text.bytes() == text.bytes()) {
        map = mapAt(*preview.reading, text.bytes(), text.offset(m_seen->editor().textCursor().position()));
    }
    m_viewport.selectMap(map);
}

}
