// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "hoverpick.h"

#include <chrono>
#include <utility>

#include <QMouseEvent>

#include "viewport.h"

namespace romanesco {

namespace {

constexpr std::chrono::milliseconds restsAfter(300);
/// The words of a longer way take their time.
constexpr std::size_t mostSteps = 10'000;

}

HoverPick::HoverPick(Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restsAfter);
    connect(&m_rest, &QTimer::timeout, this, &HoverPick::look);
    // Where the view moves, something else comes under the mouse.
    connect(&m_viewport, &Viewport::viewMoved, this, [this] {
        leave();
        if (m_isOver) {
            m_rest.start();
        }
    });
    m_viewport.installEventFilter(this);
}

bool HoverPick::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseMove: {
        const auto &moved = *static_cast<const QMouseEvent *>(event);
        m_isOver = moved.buttons() == Qt::NoButton;
        m_place = moved.position();
        leave();
        if (m_isOver) {
            m_rest.start();
        }
        break;
    }
    case QEvent::MouseButtonPress:
    case QEvent::Leave:
    case QEvent::Hide:
        m_isOver = false;
        m_rest.stop();
        leave();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void HoverPick::look()
{
    if (!m_viewport.view().hasRayWalk() || m_viewport.isHeld()) {
        m_rest.start();
        return;
    }
    const std::optional<Selection> copy = m_viewport.tool() ? std::nullopt : m_viewport.copyAt(m_place);
    if (copy && copy->steps.size() <= mostSteps) {
        m_isResting = true;
        Q_EMIT rested(*copy);
    }
}

void HoverPick::leave()
{
    if (std::exchange(m_isResting, false)) {
        Q_EMIT left();
    }
}

}
