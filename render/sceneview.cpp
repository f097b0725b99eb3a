// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneview.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "core/scene/dynamicfractal.h"

namespace romanesco {

namespace {

/// A ray that comes past very many copies ends there, lest a pointer that moves wait for it.
constexpr std::uint64_t mostNodes = 100'000;

/// Of what stands for a place, at one step: some units in the last place.
constexpr double roundings = 16.0 * std::numeric_limits<double>::epsilon();

/// As well as this part of a node the camera's place has to be known there.
constexpr double finePlace = 1e-8;

}

void SceneView::setScene(std::shared_ptr<const Scene> scene)
{
    m_scene = std::move(scene);
    m_marks.clear();
    if (!m_scene) {
        m_anchor.reset();
        m_surroundings.reset();
        return;
    }
    if (m_anchor) {
        for (const Anchor::Move &step : m_anchor->moveTo(m_scene)) {
            move(step);
        }
    } else {
        m_anchor.emplace(m_scene);
    }
    follow();
    settle();
}

bool SceneView::start(double aspect)
{
    if (m_scene->view && startFrom(*m_scene->view)) {
        return false;
    }
    if (m_scene->camera) {
        start(cameraOf(*m_scene->camera));
        return false;
    }
    toWorld();
    m_orbit.fit(*m_scene, aspect);
    follow();
    return true;
}

void SceneView::start(const Camera &camera)
{
    toWorld();
    m_orbit.start(camera, m_surroundings->nearby);
    follow();
}

/// False where the way to its place is not there.
bool SceneView::startFrom(const SavedView &view)
{
    toWorld();
    if (view.place && !enter(view.place->item, view.place->steps)) {
        m_anchor.emplace(m_scene); // what is seen has not gone along
        settle();
        return false;
    }
    settle();
    countMarksFromHere();
    m_orbit.start(cameraOf(view.camera), m_surroundings->nearby);
    m_orbit.setNearby(2.0 * m_surroundings->nearby.radius, m_anchor->isInWorld());
    if (m_trail) {
        follow();
    }
    return true;
}

/// From the world.
bool SceneView::enter(std::size_t item, std::span<const Step> steps)
{
    return m_anchor->enter({0, static_cast<std::uint32_t>(item)})
        && std::ranges::all_of(steps, [&](const Step &step) { return m_anchor->enter(step); });
}

bool SceneView::goTo(std::size_t item, std::span<const Step> steps, double aspect)
{
    const SceneView before = *this;
    toWorld();
    if (!enter(item, steps) || !(m_anchor->bound().radius > 0.0)) {
        *this = before;
        return false;
    }
    settle();
    countMarksFromHere();
    m_orbit.frame(m_anchor->bound(), aspect);
    follow();
    return true;
}

SavedView SceneView::saved() const
{
    const Camera inWorld = cameraInWorld();
    const double rounding = std::numeric_limits<double>::epsilon() * glm::length(inWorld.position);
    if (m_anchor->isInWorld() || rounding < finePlace * std::exp2(m_surroundings->unitExponent)) {
        return {.place = {}, .camera = writtenOf(inWorld)};
    }
    return {.place = m_anchor->place(), .camera = writtenOf(camera())};
}

void SceneView::refit(double aspect)
{
    toWorld();
    m_orbit.refit(*m_scene, aspect);
    follow();
}

void SceneView::toWorld()
{
    if (m_anchor) {
        for (const Anchor::Move &step : m_anchor->leave()) {
            move(step);
        }
    }
    m_anchor.emplace(m_scene);
    settle();
}

/// All that is counted from here.
void SceneView::move(const Anchor::Move &move)
{
    m_orbit.move(move);
    for (Mark &mark : m_marks) {
        mark.error += roundings * (glm::length(mark.point) + glm::length(move.offset));
        mark.point = move(mark.point);
        mark.error /= move.scale;
    }
}

/// From the world, as well as that can tell them.
void SceneView::countMarksFromHere()
{
    const double unit = std::exp2(m_surroundings->unitExponent);
    for (Mark &mark : m_marks) {
        mark.error += roundings * (glm::length(mark.point) + glm::length(m_surroundings->origin));
        mark.point = (mark.point - m_surroundings->origin) / unit;
        mark.error /= unit;
    }
}

void SceneView::look(double yawDegrees, double pitchDegrees)
{
    m_orbit.look(yawDegrees, pitchDegrees);
    follow();
}

void SceneView::orbit(const glm::dvec2 &movement)
{
    m_orbit.orbit(movement);
    follow();
}

void SceneView::pan(const glm::dvec2 &movement)
{
    m_orbit.pan(movement);
    follow();
}

void SceneView::turn(const glm::dvec2 &movement)
{
    m_orbit.turn(movement);
    follow();
}

void SceneView::shift(const glm::dvec3 &way)
{
    if (m_surroundings) {
        m_orbit.shift(way * std::exp2(-m_surroundings->unitExponent));
        follow();
    }
}

void SceneView::fly(const glm::dvec3 &way)
{
    if (const auto ahead = pick({0.0, 0.0}, 1e-3)) {
        m_orbit.setPivotDistance(ahead->distance);
    }
    m_orbit.fly(way);
    follow();
}

void SceneView::zoom(double factor, const glm::dvec2 &pointer)
{
    if (const auto picked = pick(pointer, 1e-3)) {
        m_orbit.setPivotDistance(picked->distance);
    }
    m_orbit.zoom(factor, pointer);
    follow();
}

Camera SceneView::cameraInWorld() const
{
    Camera inWorld = camera();
    const double unit = std::exp2(m_surroundings->unitExponent);
    inWorld.position = m_surroundings->worldFromHere(inWorld.position);
    inWorld.viewHeight = std::max(unit * inWorld.viewHeight, std::numeric_limits<double>::min());
    return inWorld;
}

std::optional<SceneView::Picked> SceneView::pick(const glm::dvec2 &pointer, double share) const
{
    if (!hasRayWalk() || !m_surroundings) {
        return std::nullopt;
    }
    const Camera &camera = m_orbit.camera();
    const glm::dmat3 &axes = camera.worldFromCamera;
    Ray ray;
    ray.nodeBudget = mostNodes;
    if (camera.projection == Projection::Perspective) {
        const double slope = 2.0 * std::tan(0.5 * camera.fieldOfView * std::numbers::pi / 180.0);
        ray.origin = camera.position;
        ray.direction = axes * glm::dvec3(slope * pointer, 1.0);
        ray.spread = 0.5 * share * slope;
    } else {
        ray.origin = camera.position + axes * glm::dvec3(camera.viewHeight * pointer, 0.0);
        ray.direction = axes[2];
        ray.width = 0.5 * share * camera.viewHeight;
        ray.least = -2.0 * (m_surroundings->reach + glm::distance(camera.position, m_surroundings->nearby.centre));
    }
    RayHit hit;
    m_walk->cast(ray, *m_surroundings, hit);
    if (!hit.isFound()) {
        return std::nullopt;
    }
    const Surroundings::Node &root = m_surroundings->nodes[hit.root];
    const auto shared = m_surroundings->path.begin() + static_cast<std::ptrdiff_t>(root.sharedSteps);
    Picked picked{m_walk->item(), {m_surroundings->path.begin(), shared}, hit.t, hit.point, hit.direction};
    picked.error = roundings * double(1 + hit.choices.size()) * (glm::length(hit.point) + glm::length(camera.position));
    picked.steps.insert(picked.steps.end(), root.steps.begin(), root.steps.end());
    picked.steps.insert(picked.steps.end(), hit.choices.begin(), hit.choices.end());
    return picked;
}

void SceneView::setProjection(Projection projection)
{
    m_orbit.setProjection(projection);
    follow();
}

void SceneView::setTrail(std::optional<std::size_t> trail)
{
    m_trail = trail;
    follow();
    if (m_anchor) {
        settle();
    }
}

/// What is near a camera is what it stands at; of an orthographic one, which stands nowhere, what is in the middle of the
/// view and as large.
void SceneView::follow()
{
    if (!m_anchor) {
        return;
    }
    const Camera &camera = m_orbit.camera();
    const bool isPerspective = camera.projection == Projection::Perspective;
    const auto moves = m_trail ? m_anchor->leave()
                               : m_anchor->follow(isPerspective ? camera.position : m_orbit.pivot(),
                                                  isPerspective ? 0.0 : 0.5 * camera.viewHeight);
    for (const Anchor::Move &step : moves) {
        move(step);
    }
    if (m_trail || !moves.empty()) {
        settle();
    }
}

void SceneView::settle()
{
    m_surroundings = m_trail ? dynamicSurroundings(m_scene, camera().position, *m_trail) : m_anchor->surroundings();
    const Sphere &nearby = m_surroundings->nearby;
    m_orbit.setNearby(2.0 * nearby.radius, m_anchor->isInWorld() && nearby.radius >= m_anchor->bound().radius);
}

}
