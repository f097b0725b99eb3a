// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "viewgestures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

namespace romanesco {

namespace {

constexpr double clickDistance = 4.0;
constexpr double zoomOfNotch = 0.85;
/// In distances of what was ahead.
constexpr double wayOfNotch = 0.1;
/// Of an arrow key, in heights of the view.
constexpr double keyMovement = 1.0 / 24.0;

}

ViewGestures::ViewGestures(const QWidget &viewport, SceneView &view, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_view(view)
{
    connect(&m_flight, &Flight::begun, this, &ViewGestures::surfacesNeeded);
    connect(&m_flight, &Flight::flown, this, &ViewGestures::fly);
}

glm::dvec2 ViewGestures::pointer(const QPointF &place) const
{
    // The pointer's place is the corner of its pixel.
    return inHeights(place + QPointF(0.5, 0.5) - QPointF(m_viewport.width() / 2.0, m_viewport.height() / 2.0));
}

QPointF ViewGestures::place(const glm::dvec2 &pointer) const
{
    const double height = std::max(1, m_viewport.height());
    return {pointer.x * height + m_viewport.width() / 2.0 - 0.5, -pointer.y * height + m_viewport.height() / 2.0 - 0.5};
}

/// A movement on the screen in heights of the view, y up.
glm::dvec2 ViewGestures::inHeights(const QPointF &movement) const
{
    return glm::dvec2(movement.x(), -movement.y()) / double(std::max(1, m_viewport.height()));
}

void ViewGestures::press(const QMouseEvent &event)
{
    const bool isLeft = event.button() == Qt::LeftButton;
    const bool isRight = event.button() == Qt::RightButton;
    const bool pans = isRight || (isLeft && event.modifiers() & Qt::ShiftModifier);
    const bool turns = m_walk ? isLeft || isRight : m_flight.isActive() && isRight;
    m_drag = turns ? Drag::Turn : pans ? Drag::Pan : isLeft ? Drag::Orbit : Drag::None;
    m_button = event.button();
    m_isClick = true;
    m_pressedAt = m_lastAt = event.position();
}

void ViewGestures::move(const QMouseEvent &event)
{
    if (m_drag == Drag::None) {
        return;
    }
    const QPointF way = event.position() - m_pressedAt;
    m_isClick = m_isClick && std::hypot(way.x(), way.y()) < clickDistance;
    if (m_isClick) {
        return;
    }
    const glm::dvec2 movement = inHeights(event.position() - m_lastAt);
    m_lastAt = event.position();
    if (m_drag == Drag::Orbit) {
        m_view.orbit(movement);
    } else if (m_drag == Drag::Turn) {
        m_view.turn(movement);
    } else {
        m_view.pan(movement);
    }
    Q_EMIT moved();
}

void ViewGestures::release(const QMouseEvent &event)
{
    const Drag ended = std::exchange(m_drag, Drag::None);
    if (!m_isClick) {
        return;
    }
    const bool isTurn = ended == Drag::Turn && m_walk;
    if (ended == Drag::Orbit || (isTurn && m_button == Qt::LeftButton)) {
        Q_EMIT clicked(event.position());
    } else if ((ended == Drag::Pan || isTurn) && m_button == Qt::RightButton) {
        Q_EMIT rightClicked(event.position());
    }
}

void ViewGestures::turn(const QWheelEvent &event)
{
    const double notches = event.angleDelta().y() / 120.0;
    if (m_walk) {
        m_walk({0.0, 0.0, wayOfNotch * notches});
        return;
    }
    Q_EMIT surfacesNeeded();
    m_view.zoom(std::pow(zoomOfNotch, notches), pointer(event.position()));
    Q_EMIT moved();
}

void ViewGestures::fly(const glm::dvec3 &way)
{
    if (m_walk) {
        m_walk(way);
        return;
    }
    m_view.fly(way);
    Q_EMIT moved();
}

void ViewGestures::stop()
{
    m_flight.stop();
}

bool ViewGestures::releaseKey(const QKeyEvent &event)
{
    // A key that is held is released again and again.
    return !event.isAutoRepeat() && m_flight.setHeld(event.key(), false);
}

bool ViewGestures::pressKey(const QKeyEvent &event)
{
    if (event.modifiers() == Qt::NoModifier && m_flight.setHeld(event.key(), true)) {
        return true;
    }
    glm::dvec2 way(0.0);
    switch (event.key()) {
    case Qt::Key_Left:
        way.x = -keyMovement;
        break;
    case Qt::Key_Right:
        way.x = keyMovement;
        break;
    case Qt::Key_Up:
        way.y = keyMovement;
        break;
    case Qt::Key_Down:
        way.y = -keyMovement;
        break;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
        if (m_walk) {
            m_walk({0.0, 0.0, event.key() == Qt::Key_Plus ? wayOfNotch : -wayOfNotch});
            return true;
        }
        m_view.zoom(event.key() == Qt::Key_Plus ? zoomOfNotch : 1.0 / zoomOfNotch, glm::dvec2(0.0));
        Q_EMIT moved();
        return true;
    default:
        return false;
    }
    if (m_walk) {
        m_view.turn(way);
    } else if (event.modifiers() & Qt::ShiftModifier) {
        m_view.pan(way);
    } else {
        m_view.orbit(way);
    }
    Q_EMIT moved();
    return true;
}

}
