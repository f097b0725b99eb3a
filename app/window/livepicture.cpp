// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "livepicture.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace romanesco {

namespace {

using namespace std::chrono_literals;

constexpr auto slice = 25ms;
/// The view counts as moving until it has rested so long.
constexpr auto restAfter = 150ms;

constexpr int fineSamples = 8;
/// Where the screen's own pixels are so small, half of them do.
constexpr int fineSamplesOnDenseScreens = 4;
/// Fine pictures of a text that take longer follow its changes coarsely.
constexpr double slowMilliseconds = 100.0;
constexpr double slowWhileChanging = 16.0;

}

LivePicture::LivePicture(QWidget *parent)
    : QOpenGLWidget(parent)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restAfter);
    connect(&m_rest, &QTimer::timeout, &m_drawing, qOverload<>(&QTimer::start));
    connect(&m_drawing, &QTimer::timeout, this, &LivePicture::drawOn);
}

LivePicture::~LivePicture()
{
    release();
}

void LivePicture::drawScene(std::shared_ptr<const Scene> scene)
{
    m_scene = std::move(scene);
    m_isSceneNew = true;
}

void LivePicture::paceText()
{
    const bool goesOn = m_sinceScene.isValid() && m_sinceScene.elapsed() < restAfter.count();
    if (m_fineMilliseconds > (goesOn ? slowWhileChanging : slowMilliseconds)) {
        m_rest.start();
    }
    m_sinceScene.start();
    m_drawing.start();
}

void LivePicture::moved()
{
    ++m_revision;
    m_rest.start();
    m_drawing.start();
    Q_EMIT viewMoved();
}

void LivePicture::setPixelTolerance(double pixels)
{
    if (pixels != m_tolerance) {
        m_tolerance = pixels;
        moved();
    }
}

void LivePicture::setBalls(std::optional<std::vector<BallSprite>> balls)
{
    const bool isOfAnotherKind = balls.has_value() != m_balls.has_value();
    m_balls = std::move(balls);
    update();
    if (isOfAnotherKind) {
        m_drawing.start();
    }
}

bool LivePicture::isPictureFinished() const
{
    return hasNothingToDraw() && !isMoving();
}

/// Until the view moves, or has rested long enough for a fine picture.
bool LivePicture::hasNothingToDraw() const
{
    return m_renderer && m_renderer->isFinished() && !m_isSceneNew && !isStartDue() && m_begun == request();
}

// ---- The renderer

void LivePicture::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &LivePicture::release, Qt::UniqueConnection);
    // Not before the window is seen: it is to be there as soon as it can.
    m_isRendererDue = true;
    constexpr auto onceSeen = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    connect(this, &QOpenGLWidget::frameSwapped, this, &LivePicture::startDrawing, onceSeen);
}

void LivePicture::startDrawing()
{
    if (std::exchange(m_isRendererDue, false)) {
        makeCurrent();
        if (!makeRenderer()) {
            reportWhetherAvailable();
        }
        doneCurrent();
    }
}

/// Else m_lack says why there is none.
bool LivePicture::makeRenderer()
{
    if (context()->isOpenGLES()) {
        // libepoxy would look for its libraries, which need not be there
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
void LivePicture::recover()
{
    m_renderer.reset();
    if (!makeRenderer()) {
        m_lack = tr("The graphics driver was reset. Pictures come back when the program is started anew.");
        reportWhetherAvailable();
    }
}

/// The renderer goes while its context is still there: before the widget does, or when the window changes it.
void LivePicture::release()
{
    if (context()) {
        disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &LivePicture::release);
    }
    m_isRendererDue = false;
    if (m_renderer) {
        makeCurrent();
        m_renderer.reset();
        doneCurrent();
    }
}

void LivePicture::paintGL()
{
    if (!m_renderer) {
        const auto [red, green, blue] = View().backgroundBottom;
        QOpenGLFunctions *gl = context()->functions();
        gl->glClearColor(red, green, blue, 1.0F);
        gl->glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    const QSize size = pixelSize();
    m_renderer->present(defaultFramebufferObject(), size.width(), size.height());
    if (m_balls) {
        const auto drawn = m_renderer->presentBalls(defaultFramebufferObject(), size.width(), size.height(), *m_balls);
        if (!drawn) {
            Q_EMIT pictureFailed(QString::fromStdString(drawn.error()));
        }
    }
}

void LivePicture::resizeGL(int, int)
{
    m_drawing.start();
}

void LivePicture::showEvent(QShowEvent *event)
{
    QOpenGLWidget::showEvent(event);
    m_drawing.start();
    // Where the platform has no OpenGL, nobody calls initializeGL().
    QTimer::singleShot(0, this, &LivePicture::reportWhetherAvailable);
}

void LivePicture::reportWhetherAvailable()
{
    if (isVisible() && !m_renderer && !m_isRendererDue) {
        Q_EMIT unavailable(m_lack.isEmpty() ? tr("Drawing needs OpenGL 4.5; this system offers none here.") : m_lack);
    }
}

// ---- Slices

/// One slice, between other events. Not part of painting: the window is put together anew only when there is something
/// new to see.
void LivePicture::drawOn()
{
    if (!m_renderer || !isVisible()) {
        m_drawing.stop();
        return;
    }
    makeCurrent();
    if (isStartDue()) {
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

void LivePicture::beginPictureIfDue()
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

bool LivePicture::isNothingSeenYet() const
{
    return m_begun && !m_renderer->isFinished() && m_renderer->finishedSamples() == 0;
}

/// The picture under way or finished last, in milliseconds.
double LivePicture::drawnFor() const
{
    return double(m_sinceBegun.nsecsElapsed()) * 1e-6;
}

void LivePicture::begin(const Request &wanted)
{
    if (m_isSceneNew) {
        m_isSceneNew = false;
        m_renderer->setScene(m_scene);
    }
    View view = shownView();
    view.width = wanted.size.width();
    view.height = wanted.size.height();
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

void LivePicture::announceProgress()
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

LivePicture::Request LivePicture::request() const
{
    const bool isCoarse = isMoving();
    const int samples = devicePixelRatioF() >= 1.5 ? fineSamplesOnDenseScreens : fineSamples;
    return {m_revision, pixelSize(), isCoarse, isCoarse ? 1 : samples, m_tolerance, m_balls.has_value()};
}

bool LivePicture::isMoving() const
{
    return m_rest.isActive();
}

QSize LivePicture::pixelSize() const
{
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

double LivePicture::aspect() const
{
    return double(std::max(1, width())) / std::max(1, height());
}

}
