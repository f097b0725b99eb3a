// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "viewport.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QContextMenuEvent>
#include <QEnterEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "pointertool.h"

namespace romanesco {

namespace {

/// What stands for a node reaches at most a tenth of its bound's radius beyond that (see standIn()), so points of the two
/// are at most so many of its diameters apart; and the nearer half of a bound looks a little larger than its middle.
constexpr double shiftOfStandIn = 1.07;

std::string lineOf(const std::optional<SavedView> &view)
{
    return view ? viewLine(*view) : std::string();
}

}

Viewport::Viewport(QWidget *parent)
    : LivePicture(parent)
    , m_gestures(*this, m_view)
    , m_overlay(new ToolOverlay(*this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAccessibleName(tr("Picture of the fractal"));
    connect(&m_gestures, &ViewGestures::surfacesNeeded, this, &Viewport::findSurfaces);
    connect(&m_gestures, &ViewGestures::moved, this, &Viewport::moved);
    connect(&m_gestures, &ViewGestures::clicked, this, [this](const QPointF &place) {
        findSurfaces();
        if (!m_tool || !m_tool->click(place)) {
            selectAt(place);
        }
    });
    connect(&m_gestures, &ViewGestures::rightClicked, this, [this](const QPointF &place) {
        findSurfaces();
        selectAt(place);
        Q_EMIT menuRequested(mapToGlobal(place.toPoint()));
    });
    connect(&m_surfaceFinder, &SurfaceFinder::found, this, [this](const std::shared_ptr<SceneRayWalk> &walk) {
        if (walk->scene() == drawnScene()) {
            m_view.setRayWalk(walk);
        }
    });
}

Viewport::~Viewport() = default;

void Viewport::setScene(std::shared_ptr<const Scene> scene)
{
    const std::shared_ptr<const Scene> before = drawnScene();
    if (scene == before) {
        return;
    }
    // Who edits the line of the camera sees what it does.
    const bool hasNewCamera =
        scene && scene->camera && before && !(before->camera && cameraOf(*before->camera) == cameraOf(*scene->camera));
    const bool hasNewView = hasNewCamera && lineOf(scene->view) != lineOf(before->view);
    m_resetsView = m_resetsView || hasNewView;
    m_followsCamera = m_followsCamera || (hasNewCamera && !hasNewView);
    m_view.setScene(scene);
    takeScene(std::move(scene));
    Q_EMIT sceneChanged(true);
    if (underMouse()) {
        findSurfaces();
    }
    paceText();
}

void Viewport::startScene(std::shared_ptr<const Scene> scene, const std::optional<SceneView> &view)
{
    const Projection before = camera().projection;
    const auto trail = m_view.trail();
    m_view = view.value_or(SceneView());
    m_view.setScene(scene);
    m_view.setTrail(trail);
    m_resetsView = !view;
    m_followsCamera = false;
    takeScene(std::move(scene));
    Q_EMIT sceneChanged(false);
    if (underMouse()) {
        findSurfaces();
    }
    moved();
    if (camera().projection != before) {
        Q_EMIT projectionChanged(camera().projection);
    }
}

/// What stood out was of the last one.
void Viewport::takeScene(std::shared_ptr<const Scene> scene)
{
    drawScene(std::move(scene));
    m_appearance.colours.selection.reset();
    m_appearance.colours.map.reset();
}

void Viewport::resetView()
{
    m_resetsView = true;
    wake();
}

void Viewport::fit()
{
    if (drawnScene()) {
        m_view.refit(aspect());
        moved();
    }
}

void Viewport::lookFrom(Side side)
{
    switch (side) {
    case Side::Front:
        m_view.look(0.0, 0.0);
        break;
    case Side::Right:
        m_view.look(-90.0, 0.0);
        break;
    case Side::Top:
        m_view.look(0.0, -90.0);
        break;
    }
    moved();
}

void Viewport::setProjection(Projection projection)
{
    if (projection != camera().projection) {
        m_view.setProjection(projection);
        moved();
        Q_EMIT projectionChanged(projection);
    }
}

View Viewport::shownView() const
{
    View view;
    view.camera = camera();
    view.surroundings = m_view.surroundings();
    view.appearance = m_appearance;
    return view;
}

void Viewport::startView()
{
    const Projection before = camera().projection;
    if (std::exchange(m_followsCamera, false) && !m_resetsView && drawnScene()->camera) {
        m_view.start(cameraOf(*drawnScene()->camera));
    } else {
        m_view.start(aspect());
    }
    m_resetsView = false;
    // Counts as a movement: nobody knows yet what a fine picture of this scene takes, and a coarse one is soon there.
    moved();
    if (camera().projection != before) {
        Q_EMIT projectionChanged(camera().projection);
    }
}

// ---- Surfaces under the pointer

/// The first time that it may be asked for.
void Viewport::findSurfaces()
{
    if (!m_view.hasRayWalk()) {
        m_surfaceFinder.find(drawnScene());
    }
}

void Viewport::selectAt(const QPointF &place)
{
    select(copyAt(place));
    Q_EMIT clicked(place.toPoint());
}

std::optional<Selection> Viewport::copyAt(const QPointF &place) const
{
    const auto picked = m_view.pick(m_gestures.pointer(place), 1.0 / std::max(1, height()));
    return picked ? std::optional(Selection{picked->item, picked->steps}) : std::nullopt;
}

std::optional<SceneView::Picked> Viewport::surfaceAt(const QPointF &place) const
{
    return m_view.pick(m_gestures.pointer(place), 0.0);
}

std::optional<QPointF> Viewport::placeOf(const glm::dvec3 &point) const
{
    const std::optional<glm::dvec2> seen = seenAt(camera(), point);
    return seen ? std::optional(m_gestures.place(*seen)) : std::nullopt;
}

void Viewport::setTool(PointerTool *tool)
{
    m_tool = tool;
    m_isToolDragged = false;
    m_overlay->show(tool);
    unsetCursor();
}

void Viewport::select(const std::optional<Selection> &selection)
{
    Appearance appearance = m_appearance;
    appearance.colours.selection = selection;
    setAppearance(appearance);
}

void Viewport::selectMap(const std::optional<Step> &map)
{
    Appearance appearance = m_appearance;
    appearance.colours.map = map ? std::optional(MapSelection{0, *map}) : std::nullopt;
    setAppearance(appearance);
}

void Viewport::zoomToSelection()
{
    const std::optional<Selection> &selection = m_appearance.colours.selection;
    if (selection && drawnScene() && m_view.goTo(selection->item, selection->steps, aspect())) {
        moved();
    }
}

void Viewport::setAppearance(const Appearance &appearance)
{
    if (appearance != m_appearance) {
        m_appearance = appearance;
        moved();
    }
}

double Viewport::shiftOfTolerance() const
{
    if (camera().projection == Projection::Orthographic) {
        return shiftOfStandIn;
    }
    // Seen at an angle to the axis of the view, what is at a distance along the axis is as much larger as it is nearer.
    const double up = std::tan(0.5 * camera().fieldOfView * std::numbers::pi / 180.0);
    return shiftOfStandIn * std::hypot(1.0, up, up * aspect());
}

std::optional<Turn> Viewport::turn() const
{
    if (!isViewStarted()) {
        return std::nullopt;
    }
    const QSize size = pixelSize();
    Turn turn{drawnScene(), shownView(), m_view.pivot(), 1, m_view.trail()};
    turn.view.appearance.colours.selection.reset();
    turn.view.appearance.colours.map.reset();
    turn.view.pixelTolerance = pixelTolerance();
    turn.view.width = size.width();
    turn.view.height = size.height();
    return turn;
}

void Viewport::setTrail(std::optional<std::size_t> trail)
{
    m_view.setTrail(trail);
    moved();
}

void Viewport::shift(const glm::dvec3 &way)
{
    m_view.shift(way);
    moved();
}

void Viewport::enterEvent(QEnterEvent *event)
{
    LivePicture::enterEvent(event);
    findSurfaces();
}

// ---- Mouse and keyboard

void Viewport::mousePressEvent(QMouseEvent *event)
{
    m_isToolDragged = m_tool && event->button() == Qt::LeftButton && m_tool->press(event->position());
    if (!m_isToolDragged) {
        m_gestures.press(*event);
    }
}

void Viewport::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isToolDragged) {
        m_tool->drag(event->position(), event->modifiers());
        return;
    }
    m_gestures.move(*event);
    if (m_tool && event->buttons() == Qt::NoButton) {
        m_tool->hover(event->position());
    }
}

void Viewport::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_isToolDragged) {
        m_gestures.release(*event);
    } else if (event->button() == Qt::LeftButton) {
        m_isToolDragged = false;
        m_tool->release();
    }
}

void Viewport::wheelEvent(QWheelEvent *event)
{
    m_gestures.turn(*event);
    event->accept();
}

/// That of a key; a press of the right button may be the begin of a drag.
void Viewport::contextMenuEvent(QContextMenuEvent *event)
{
    if (event->reason() == QContextMenuEvent::Keyboard) {
        Q_EMIT menuRequested(mapToGlobal(rect().center()));
    }
}

void Viewport::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_tool) {
        Q_EMIT toolDismissed();
    } else if (!m_gestures.pressKey(*event)) {
        LivePicture::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent *event)
{
    if (!m_gestures.releaseKey(*event)) {
        LivePicture::keyReleaseEvent(event);
    }
}

void Viewport::focusOutEvent(QFocusEvent *event)
{
    m_gestures.stop();
    LivePicture::focusOutEvent(event);
}

}
