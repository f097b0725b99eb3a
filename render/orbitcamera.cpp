// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "orbitcamera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

constexpr double straightUp = std::numbers::pi / 2.0;

/// Without roll: right is horizontal. Yaw from forward (z) towards the right (x), pitch upwards.
glm::dmat3 levelRotation(double yaw, double pitch)
{
    const glm::dvec3 right(std::cos(yaw), 0.0, -std::sin(yaw));
    const glm::dvec3 forward(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    return {right, glm::cross(forward, right), forward};
}

}

void OrbitCamera::start(const Camera &camera, const Sphere &nearby)
{
    m_camera = camera;
    m_nearbySize = 2.0 * nearby.radius;
    const glm::dmat3 &axes = camera.worldFromCamera;
    m_yaw = std::atan2(axes[2].x, axes[2].z);
    m_pitch = std::asin(std::clamp(axes[2].y, -1.0, 1.0));
    const glm::dmat3 level = levelRotation(m_yaw, m_pitch);
    m_roll = std::atan2(glm::dot(axes[0], level[1]), glm::dot(axes[0], level[0]));

    double away = glm::dot(nearby.centre - camera.position, axes[2]);
    if (away < 1e-3 * m_nearbySize || away <= 0.0) {
        away = m_nearbySize > 0.0 ? m_nearbySize : 1.0;
    }
    m_pivot = camera.position + axes[2] * away;
}

void OrbitCamera::fit(const Scene &scene, double aspect)
{
    const glm::dvec3 forward = glm::normalize(glm::dvec3(-1.0, -0.8, 1.2));
    m_camera.fieldOfView = Camera{}.fieldOfView;
    m_roll = 0.0;
    setDirection(std::atan2(forward.x, forward.z), std::asin(forward.y));
    refit(scene, aspect);
}

void OrbitCamera::refit(const Scene &scene, double aspect)
{
    m_camera = fittedCamera(m_camera, scene, aspect);
    m_nearbySize = glm::length(scene.extent.size());
    // The pivot is the point of the view's axis that is nearest to the middle, so that turning keeps the scene in view.
    const glm::dvec3 &forward = m_camera.worldFromCamera[2];
    m_pivot = m_camera.position + forward * glm::dot(scene.extent.centre() - m_camera.position, forward);
}

void OrbitCamera::frame(const Sphere &ball, double aspect)
{
    const double half = 0.5 * m_camera.fieldOfView * std::numbers::pi / 180.0;
    const double narrower = std::atan(std::tan(half) * std::min(1.0, aspect));
    m_pivot = ball.centre;
    m_camera.position = m_pivot - m_camera.worldFromCamera[2] * (ball.radius / std::sin(narrower));
    m_camera.viewHeight = 2.0 * ball.radius / std::min(1.0, aspect);
}

void OrbitCamera::fly(const glm::dvec3 &way)
{
    const glm::dvec3 move = distance() * (m_camera.worldFromCamera * way);
    m_camera.position += move;
    m_pivot += move;
}

void OrbitCamera::turn(const glm::dvec2 &movement)
{
    const double away = distance();
    setDirection(m_yaw + movement.x * std::numbers::pi, m_pitch + movement.y * std::numbers::pi);
    m_pivot = m_camera.position + m_camera.worldFromCamera[2] * away;
}

void OrbitCamera::look(double yawDegrees, double pitchDegrees)
{
    constexpr double radians = std::numbers::pi / 180.0;
    const double away = distance();
    m_roll = 0.0;
    setDirection(yawDegrees * radians, pitchDegrees * radians);
    m_camera.position = m_pivot - m_camera.worldFromCamera[2] * away;
}

void OrbitCamera::orbit(const glm::dvec2 &movement)
{
    const double away = distance();
    setDirection(m_yaw + movement.x * std::numbers::pi, m_pitch + movement.y * std::numbers::pi);
    m_camera.position = m_pivot - m_camera.worldFromCamera[2] * away;
}

void OrbitCamera::pan(const glm::dvec2 &movement)
{
    shift(-(m_camera.worldFromCamera * glm::dvec3(movement * planeHeight(), 0.0)));
}

void OrbitCamera::shift(const glm::dvec3 &way)
{
    m_camera.position += way;
    m_pivot += way;
}

void OrbitCamera::zoom(double factor, const glm::dvec2 &pointer)
{
    // Past that, numbers and the near plane end the view.
    if (m_nearbySize > 0.0) {
        const double height = planeHeight();
        const double most = m_isNearbyWhole ? std::max(1.0, 1e6 * m_nearbySize / height) : factor;
        factor = std::clamp(factor, std::min(1.0, 1e-4 * m_nearbySize / height), std::max(1.0, most));
    }
    const glm::dvec3 target = m_pivot + m_camera.worldFromCamera * glm::dvec3(pointer * planeHeight(), 0.0);
    m_camera.position = target + (m_camera.position - target) * factor;
    m_pivot = target + (m_pivot - target) * factor;
    m_camera.viewHeight *= factor;
}

void OrbitCamera::setProjection(Projection projection)
{
    const double height = planeHeight();
    if (projection == Projection::Perspective) {
        const double away = 0.5 * height / std::tan(0.5 * m_camera.fieldOfView * std::numbers::pi / 180.0);
        m_camera.position = m_pivot - m_camera.worldFromCamera[2] * away;
    }
    m_camera.projection = projection;
    m_camera.viewHeight = height;
}

void OrbitCamera::setPivotDistance(double distance)
{
    m_pivot = m_camera.position + distance * m_camera.worldFromCamera[2];
}

void OrbitCamera::move(const Anchor::Move &move)
{
    m_camera.position = move(m_camera.position);
    m_pivot = move(m_pivot);
    m_camera.viewHeight /= move.scale;
}

void OrbitCamera::setNearby(double size, bool isWhole)
{
    m_nearbySize = size;
    m_isNearbyWhole = isWhole;
}

void OrbitCamera::setDirection(double yaw, double pitch)
{
    m_yaw = std::remainder(yaw, 2.0 * std::numbers::pi);
    m_pitch = std::clamp(pitch, -straightUp, straightUp);
    const glm::dmat3 level = levelRotation(m_yaw, m_pitch);
    const double c = std::cos(m_roll);
    const double s = std::sin(m_roll);
    m_camera.worldFromCamera = {c * level[0] + s * level[1], c * level[1] - s * level[0], level[2]};
}

double OrbitCamera::distance() const
{
    return glm::distance(m_camera.position, m_pivot);
}

double OrbitCamera::planeHeight() const
{
    if (m_camera.projection == Projection::Orthographic) {
        return m_camera.viewHeight;
    }
    return 2.0 * distance() * std::tan(0.5 * m_camera.fieldOfView * std::numbers::pi / 180.0);
}

}
