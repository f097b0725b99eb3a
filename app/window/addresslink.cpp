// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "addresslink.h"

#include "addresspane.h"
#include "editor/fdoeditor.h"
#include "texttab.h"
#include "viewport.h"

namespace romanesco {

AddressLink::AddressLink(AddressPane &pane, Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_pane(pane)
    , m_viewport(viewport)
{
    connect(&m_viewport, &Viewport::clicked, this, &AddressLink::tell);
    connect(&m_pane, &AddressPane::chosen, this, &AddressLink::choose);
    connect(&m_pane, &AddressPane::zoomRequested, &m_viewport, &Viewport::zoomToSelection);
    m_cursorRest.setSingleShot(true);
    m_cursorRest.setInterval(150);
    connect(&m_cursorRest, &QTimer::timeout, this, &AddressLink::showMapAtCursor);
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
    m_cursorRest.start();
}

void AddressLink::update()
{
    if (!m_viewport.appearance().colours.selection) {
        clear();
    }
    m_cursorRest.start();
}

/// Of the copy that stands out.
void AddressLink::tell()
{
    const std::optional<Selection> &selection = m_viewport.appearance().colours.selection;
    const auto &surroundings = m_viewport.view().surroundings();
    m_steps.clear();
    m_wholeWay.clear();
    if (selection && surroundings) {
        m_steps = addressSteps(*surroundings->scene, *selection, m_seen->preview().reading.get(),
                               m_seen->document().text().bytes());
        m_wholeWay = selection->steps;
    }
    m_pane.setSteps(m_steps);
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
    if (const std::optional<SourceRange> use = m_steps[count - 1].use; use && m_isLookedAt) {
        m_seen->editor().select(*use, m_seen->document().text());
        // Here one way is looked at, not all that the words have made.
        m_cursorRest.stop();
        m_viewport.selectMap(std::nullopt);
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
