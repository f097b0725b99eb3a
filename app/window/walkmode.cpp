// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "walkmode.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/physics/scenephysics.h"
#include "viewport.h"

namespace romanesco {

namespace {

constexpr int millisecondsAFall = 16;
constexpr double longestFall = 0.1;
/// Of a way, in seconds.
constexpr double timeOfWay = 1.0 / 60.0;
/// Of the sphere, in distances of what is ahead; and of the scene where nothing is.
constexpr double radiusOfDistance = 0.02;
constexpr double shareOfScene = 0.25;
/// Of the scene: what is farther is not looked for.
constexpr double longestLook = 1e3;
/// Of the scene: where the world's coordinates tell places no better there is no walking.
constexpr double leastRadius = 1e-9;

}

WalkMode::WalkMode(Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_finding(*this)
{
    m_falling.setInterval(millisecondsAFall);
    connect(&m_falling, &QTimer::timeout, this, &WalkMode::fall);
}

WalkMode::~WalkMode()
{
    m_stop.request_stop();
}

void WalkMode::start()
{
    m_isOn = true;
    m_viewport.setWalk([this](const glm::dvec3 &way) { walk(way); });
    if (m_surface) {
        begin();
    } else {
        findSurface();
    }
}

void WalkMode::stop()
{
    m_isOn = false;
    m_walker.reset();
    m_falling.stop();
    m_viewport.setWalk({});
}

void WalkMode::setScene(const std::shared_ptr<const Scene> &scene)
{
    m_scene = scene;
    m_walker.reset();
    m_falling.stop();
    m_surface.reset();
    if (m_isOn) {
        findSurface();
    }
}

void WalkMode::setGravity(const glm::dvec3 &gravity)
{
    m_gravity = gravity;
    if (m_walker) {
        m_sinceFall.start();
        m_falling.start();
    }
}

/// One at a time: what has come meanwhile is found after that.
void WalkMode::findSurface()
{
    if (!m_scene || m_finding.isRunning()) {
        return;
    }
    m_finding.start(
        [scene = m_scene, stop = m_stop.get_token()] {
            return surfaceOf(scene, {}, stop).transform([](Surface &&surface) {
                return std::make_shared<const Surface>(std::move(surface));
            });
        },
        [this, scene = m_scene](const std::expected<std::shared_ptr<const Surface>, std::string> &found) {
            if (scene != m_scene) {
                findSurface();
            } else if (found) {
                takeSurface(*found);
            } else if (m_isOn) {
                stop();
                Q_EMIT ended(QString::fromStdString(found.error()));
            }
        });
}

void WalkMode::takeSurface(const std::shared_ptr<const Surface> &surface)
{
    m_surface = surface;
    if (m_isOn) {
        begin();
    }
}

/// From where the camera is, as large as suits what is ahead.
void WalkMode::begin()
{
    const SceneView &view = m_viewport.view();
    if (!view.surroundings() || !m_scene) {
        return;
    }
    const glm::dvec3 size = m_scene->extent.size();
    const double whole = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
    const glm::dvec3 eye = view.cameraInWorld().position;
    Touch ahead;
    m_surface->collider->search()->sweep(
        {.p = eye, .v = m_viewport.camera().worldFromCamera[2], .time = longestLook * whole}, ahead);
    m_pace = ahead.isFound() ? std::min(ahead.time, whole) : shareOfScene * whole;
    const double radius = radiusOfDistance * m_pace;
    if (!(radius > leastRadius * whole)) {
        stop();
        Q_EMIT ended(tr("It is too deep to walk here; fly instead."));
        return;
    }
    m_walker.emplace(*m_surface, eye, radius);
    setGravity(m_gravity);
}

/// Along the camera's axes.
void WalkMode::walk(const glm::dvec3 &way)
{
    if (m_walker) {
        go(m_viewport.camera().worldFromCamera * (m_pace * way), timeOfWay);
        if (m_gravity != glm::dvec3(0.0) && !m_falling.isActive()) {
            m_sinceFall.start();
            m_falling.start();
        }
    }
}

void WalkMode::fall()
{
    const double seconds = std::clamp(1e-9 * double(m_sinceFall.nsecsElapsed()), 1e-6, longestFall);
    m_sinceFall.start();
    if (!m_walker || m_gravity == glm::dvec3(0.0)) {
        m_falling.stop();
        return;
    }
    go(glm::dvec3(0.0), seconds);
    if (m_walker->isCarried()) {
        m_falling.stop();
    }
}

void WalkMode::go(const glm::dvec3 &way, double seconds)
{
    // by another way it may have gone elsewhere: by Fit, or to a copy
    const glm::dvec3 camera = m_viewport.view().cameraInWorld().position;
    if (glm::distance(camera, m_walker->position()) > m_walker->radius()) {
        begin();
        if (!m_walker) {
            return;
        }
    }
    const glm::dvec3 before = m_walker->position();
    m_walker->go(way, seconds, m_gravity);
    if (m_walker->position() != before) {
        m_viewport.shift(m_walker->position() - before);
    }
}

}
