// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>

#include <QObject>
#include <QPointF>

#include "flight.h"
#include "render/sceneview.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace romanesco {

/// What the mouse and the keyboard do to a view: left drag orbits, right drag or Shift + left drag pans, the wheel zooms
/// to the pointer; arrow keys orbit, + and - zoom; W, A, S, D fly, and then right drag looks about. For the GUI thread.
class ViewGestures : public QObject
{
    Q_OBJECT
public:
    /// Places are in the viewport. Both must outlive it.
    ViewGestures(const QWidget &viewport, SceneView &view, QObject *parent = nullptr);

    void press(const QMouseEvent &event);
    void move(const QMouseEvent &event);
    void release(const QMouseEvent &event);
    void turn(const QWheelEvent &event);
    /// Whether the key means something here.
    [[nodiscard]] bool pressKey(const QKeyEvent &event);
    [[nodiscard]] bool releaseKey(const QKeyEvent &event);
    /// All keys go up.
    void stop();

    /// From now on the view is walked with: what flew and zoomed goes along the camera's axes by this, in distances of what was
    /// ahead, and drags and arrow keys look about. None for the view as it was.
    using Walk = std::function<void(const glm::dvec3 &way)>;
    void setWalk(Walk walk) { m_walk = std::move(walk); }

    /// A button is held, or a key that flies.
    [[nodiscard]] bool isActive() const { return m_drag != Drag::None || m_flight.isActive(); }

    /// As SceneView has pointers.
    [[nodiscard]] glm::dvec2 pointer(const QPointF &place) const;
    /// The way back.
    [[nodiscard]] QPointF place(const glm::dvec2 &pointer) const;

Q_SIGNALS:
    /// What lies ahead will be asked for.
    void surfacesNeeded();
    /// The view is another.
    void moved();
    /// A press and release of a button in one place, which is not the begin of a drag.
    void clicked(const QPointF &place);
    void rightClicked(const QPointF &place);

private:
    enum class Drag { None, Orbit, Pan, Turn };

    void fly(const glm::dvec3 &way);
    [[nodiscard]] glm::dvec2 inHeights(const QPointF &movement) const;

    const QWidget &m_viewport;
    SceneView &m_view;
    Drag m_drag = Drag::None;
    Qt::MouseButton m_button = Qt::NoButton;
    bool m_isClick = false;
    QPointF m_pressedAt;
    QPointF m_lastAt;
    Flight m_flight;
    Walk m_walk;
};

}
