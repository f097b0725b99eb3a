// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "viewport.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include <QContextMenuEvent>
#include <QEnterEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QWheelEvent>

#include "pointertool.h"

namespace romanesco {

namespace {

using namespace std::chrono_literals;

constexpr auto slice = 25ms;
/// The camera counts as moving until it has rested so long.
constexpr auto restAfter = 150ms;

/// What stands for a node reaches at most a tenth of its bound's radius beyond that (see standIn()), so points of the two
/// are at most so many of its diameters apart; and the nearer half of a bound looks a little larger than its middle.
constexpr double shiftOfStandIn = 1.07;

constexpr int fineSamples = 8;
/// Where the screen's own pixels are so small, half of them do.
constexpr int fineSamplesOnDenseScreens = 4;
constexpr double slowMilliseconds = 100.0;
constexpr double slowWhileChanging = 16.0;

std::string lineOf(const std::optional<SavedView> &view)
{
    return view ? viewLine(*view) : std::string();
}

}

Viewport::Viewport(QWidget *parent)
    : QOpenGLWidget(parent)
    , m_gestures(*this, m_view)
    , m_overlay(new ToolOverlay(*this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAccessibleName(tr("Picture of the fractal"));
    m_rest.setSingleShot(true);
    m_rest.setInterval(restAfter);
    connect(&m_rest, &QTimer::timeout, &m_drawing, qOverload<>(&QTimer::start));
    connect(&m_drawing, &QTimer::timeout, this, &Viewport::drawOn);
    connect(&m_gestures, &ViewGestures::surfacesNeeded, this, &Viewport::findSurfaces);
    connect(&m_gestures, &ViewGestures::moved, this, &Viewport::cameraChanged);
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
        if (walk->scene() == m_scene) {
            m_view.setRayWalk(walk);
        }
    });
}

Viewport::~Viewport()
{
    release();
}

void Viewport::setScene(std::shared_ptr<const Scene> scene)
{
    if (scene == m_scene) {
        return;
    }
    // Who edits the line of the camera sees what it does.
    const bool hasNewCamera = scene && scene->camera && m_scene
        && !(m_scene->camera && cameraOf(*m_scene->camera) == cameraOf(*scene->camera));
    const bool hasNewView = hasNewCamera && lineOf(scene->view) != lineOf(m_scene->view);
    m_resetsView = m_resetsView || hasNewView;
    m_followsCamera = m_followsCamera || (hasNewCamera && !hasNewView);
    m_scene = std::move(scene);
    m_view.setScene(m_scene);
    m_appearance.colours.selection.reset();
    m_appearance.colours.map.reset();
    m_isSceneNew = true;
    Q_EMIT sceneChanged(true);
    if (underMouse()) {
        findSurfaces();
    }
    // A text that changes is followed coarsely where a fine picture takes its time, and sooner while it goes on changing.
    const bool goesOn = m_sinceScene.isValid() && m_sinceScene.elapsed() < restAfter.count();
    if (m_fineMilliseconds > (goesOn ? slowWhileChanging : slowMilliseconds)) {
        m_rest.start();
    }
    m_sinceScene.start();
    m_drawing.start();
}

void Viewport::startScene(std::shared_ptr<const Scene> scene, const std::optional<SceneView> &view)
{
    const Projection before = camera().projection;
    const auto trail = m_view.trail();
    m_scene = std::move(scene);
    m_view = view.value_or(SceneView());
    m_view.setScene(m_scene);
    m_view.setTrail(trail);
    m_resetsView = !view;
    m_followsCamera = false;
    m_appearance.colours.selection.reset();
    m_appearance.colours.map.reset();
    m_isSceneNew = true;
    Q_EMIT sceneChanged(false);
    if (underMouse()) {
        findSurfaces();
    }
    cameraChanged();
    if (camera().projection != before) {
        Q_EMIT projectionChanged(camera().projection);
    }
}

void Viewport::resetView()
{
    m_resetsView = true;
    m_drawing.start();
}

void Viewport::fit()
{
    if (m_scene) {
        m_view.refit(aspect());
        cameraChanged();
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
    cameraChanged();
}

void Viewport::setProjection(Projection projection)
{
    if (projection != camera().projection) {
        m_view.setProjection(projection);
        cameraChanged();
        Q_EMIT projectionChanged(projection);
    }
}

bool Viewport::isPictureFinished() const
{
    return hasNothingToDraw() && !isMoving();
}

/// Until the camera moves, or has rested long enough for a fine picture.
bool Viewport::hasNothingToDraw() const
{
    return m_renderer && m_renderer->isFinished() && !m_isSceneNew && !((m_resetsView || m_followsCamera) && m_scene)
        && m_begun == request();
}

// ---- Drawing

void Viewport::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::release, Qt::UniqueConnection);
    if (!makeRenderer()) {
        reportWhetherAvailable();
    }
}

/// Else m_lack says why there is none.
bool Viewport::makeRenderer()
{
    if (context()->isOpenGLES()) {
        // which libepoxy would look for libraries for that need not be there
        m_lack = tr("Drawing needs OpenGL 4.5; this system offers OpenGL ES.");
        return false;
    }
    auto made = Renderer::create();
    if (!made) {
        m_lack = QString::fromStdString(made.error());
        return false;
    }
    m_lack.clear();
    m_renderer = std::move(*made);
    m_isSceneNew = true;
    m_begun.reset();
    m_drawing.start();
    Q_EMIT ready(QString::fromStdString(m_renderer->description()));
    return true;
}

/// What was on the card went with a reset of the driver, and the context too, unless the driver could spare it.
void Viewport::recover()
{
    m_renderer.reset();
    if (!makeRenderer()) {
        m_lack = tr("The graphics driver was reset. Pictures come back when the program is started anew.");
        reportWhetherAvailable();
    }
}

/// The renderer goes while its context is still there: before the widget does, or when the window changes it.
void Viewport::release()
{
    if (context()) {
        disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::release);
    }
    if (m_renderer) {
        makeCurrent();
        m_renderer.reset();
        doneCurrent();
    }
}

void Viewport::paintGL()
{
    if (m_renderer) {
        const qreal ratio = devicePixelRatioF();
        const int wide = qRound(width() * ratio);
        const int high = qRound(height() * ratio);
        m_renderer->present(defaultFramebufferObject(), wide, high);
        if (m_balls) {
            if (const auto drawn = m_renderer->presentBalls(defaultFramebufferObject(), wide, high, *m_balls); !drawn) {
                Q_EMIT pictureFailed(QString::fromStdString(drawn.error()));
            }
        }
    }
}

/// One slice, between other events. Not part of painting: the window is put together anew only when there is something
/// new to see.
void Viewport::drawOn()
{
    if (!m_renderer || !isVisible()) {
        m_drawing.stop();
        return;
    }
    makeCurrent();
    if ((m_resetsView || m_followsCamera) && m_scene) {
        startView();
    }
    beginPictureIfDue();
    m_renderer->step(slice);
    if (m_renderer->isLost()) {
        recover();
    } else {
        announceProgress();
    }
    doneCurrent();
    if (hasNothingToDraw()) {
        m_drawing.stop();
    }
}

void Viewport::startView()
{
    const Projection before = camera().projection;
    if (std::exchange(m_followsCamera, false) && !m_resetsView && m_scene->camera) {
        m_view.start(cameraOf(*m_scene->camera));
    } else {
        m_view.start(aspect());
    }
    m_resetsView = false;
    // Counts as a movement: nobody knows yet what a fine picture of this scene takes, and a coarse one is soon there.
    cameraChanged();
    if (camera().projection != before) {
        Q_EMIT projectionChanged(camera().projection);
    }
}

void Viewport::beginPictureIfDue()
{
    const Request wanted = request();
    // A picture of which nothing is to be seen yet is finished first, lest a slow machine never show anything; except
    // that a fine one makes way for a coarse one, which is quickly there and stays.
    const bool makesWay = !isNothingSeenYet() || (wanted.isCoarse && !m_begun->isCoarse);
    const bool isGivenUp =
        wanted.isCoarse && isNothingSeenYet() && m_begun->isCoarse && m_dragTolerance.givesUp(drawnFor());
    if (m_isSceneNew || isGivenUp || (m_begun != wanted && makesWay)) {
        begin(wanted);
    }
}

bool Viewport::isNothingSeenYet() const
{
    return m_begun && !m_renderer->isFinished() && m_renderer->finishedSamples() == 0;
}

/// The picture under way or finished last, in milliseconds.
double Viewport::drawnFor() const
{
    return double(m_sinceBegun.nsecsElapsed()) * 1e-6;
}

void Viewport::begin(const Request &wanted)
{
    if (m_isSceneNew) {
        m_isSceneNew = false;
        m_renderer->setScene(m_scene);
    }
    View view;
    view.camera = camera();
    view.surroundings = m_view.surroundings();
    view.appearance = m_appearance;
    view.width = wanted.width;
    view.height = wanted.height;
    view.pixelTolerance = wanted.isCoarse ? std::max(m_dragTolerance.pixels(), m_tolerance) : m_tolerance;
    view.samples = wanted.samples;
    view.leavesOutBalls = wanted.leavesOutBalls;
    m_renderer->begin(view);
    m_sinceBegun.start();
    m_begun = wanted;
    m_begunTolerance = view.pixelTolerance;
    m_announcedSamples = 0;
    m_isFinishAnnounced = false;
}

void Viewport::announceProgress()
{
    if (m_renderer->finishedSamples() > m_announcedSamples) {
        m_announcedSamples = m_renderer->finishedSamples();
        update();
        const DrawStatistics statistics = m_renderer->statistics();
        if (m_begun->isCoarse) {
            m_dragTolerance.finished(drawnFor());
        } else {
            m_fineMilliseconds = statistics.milliseconds;
        }
        Q_EMIT pictureAdvanced(statistics, m_begunTolerance);
    }
    if (m_renderer->isFinished() && !std::exchange(m_isFinishAnnounced, true)) {
        Q_EMIT pictureFailed(QString::fromStdString(m_renderer->error()));
        if (isPictureFinished()) {
            Q_EMIT pictureFinished();
        }
    }
}

void Viewport::resizeGL(int, int)
{
    m_drawing.start();
}

void Viewport::showEvent(QShowEvent *event)
{
    QOpenGLWidget::showEvent(event);
    m_drawing.start();
    // Where the platform has no OpenGL, nobody calls initializeGL().
    QTimer::singleShot(0, this, &Viewport::reportWhetherAvailable);
}

void Viewport::reportWhetherAvailable()
{
    if (isVisible() && !m_renderer) {
        Q_EMIT unavailable(m_lack.isEmpty() ? tr("Drawing needs OpenGL 4.5; this system offers none here.") : m_lack);
    }
}

Viewport::Request Viewport::request() const
{
    const qreal ratio = devicePixelRatioF();
    const bool isCoarse = isMoving();
    const int samples = ratio >= 1.5 ? fineSamplesOnDenseScreens : fineSamples;
    return {m_cameraRevision,
            std::max(1, qRound(width() * ratio)),
            std::max(1, qRound(height() * ratio)),
            isCoarse,
            isCoarse ? 1 : samples,
            m_tolerance,
            m_balls.has_value()};
}

bool Viewport::isMoving() const
{
    return m_rest.isActive();
}

void Viewport::cameraChanged()
{
    ++m_cameraRevision;
    m_rest.start();
    m_drawing.start();
    Q_EMIT viewMoved();
}

double Viewport::aspect() const
{
    return double(std::max(1, width())) / std::max(1, height());
}

// ---- Surfaces under the pointer

/// The first time that it may be asked for.
void Viewport::findSurfaces()
{
    if (!m_view.hasRayWalk()) {
        m_surfaceFinder.find(m_scene);
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

void Viewport::setBalls(std::optional<std::vector<BallSprite>> balls)
{
    const bool isOfAnotherKind = balls.has_value() != m_balls.has_value();
    m_balls = std::move(balls);
    update();
    if (isOfAnotherKind) {
        m_drawing.start();
    }
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
    if (selection && m_scene && m_view.goTo(selection->item, selection->steps, aspect())) {
        cameraChanged();
    }
}

void Viewport::setAppearance(const Appearance &appearance)
{
    if (appearance != m_appearance) {
        m_appearance = appearance;
        cameraChanged();
    }
}

void Viewport::setPixelTolerance(double pixels)
{
    if (pixels != m_tolerance) {
        m_tolerance = pixels;
        cameraChanged();
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
    const Request size = request();
    Turn turn{m_scene, {}, m_view.pivot(), 1, m_view.trail()};
    turn.view.camera = camera();
    turn.view.surroundings = m_view.surroundings();
    turn.view.appearance = m_appearance;
    turn.view.appearance.colours.selection.reset();
    turn.view.appearance.colours.map.reset();
    turn.view.pixelTolerance = m_tolerance;
    turn.view.width = size.width;
    turn.view.height = size.height;
    return turn;
}

void Viewport::setTrail(std::optional<std::size_t> trail)
{
    m_view.setTrail(trail);
    cameraChanged();
}

void Viewport::shift(const glm::dvec3 &way)
{
    m_view.shift(way);
    cameraChanged();
}

void Viewport::enterEvent(QEnterEvent *event)
{
    QOpenGLWidget::enterEvent(event);
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
        QOpenGLWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent *event)
{
    if (!m_gestures.releaseKey(*event)) {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusOutEvent(QFocusEvent *event)
{
    m_gestures.stop();
    QOpenGLWidget::focusOutEvent(event);
}

}
