// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "gizmoshape.h"

#include <glm/geometric.hpp>

#include "core/geometry/rotation.h"

namespace romanesco {

namespace {

constexpr int ringPoints = 48;
/// In degrees; speeds are differences over so little.
constexpr double smallAngle = 0.01;

/// A point of the ring of an angle, where that angle is t.
glm::dvec3 onRing(const TransformParts &parts, int axis, double t)
{
    glm::dvec3 angles(0.0);
    for (int i = 0; i < axis; ++i) {
        angles[i] = parts.rotation[i];
    }
    angles[axis] = t;
    return rotationFromDegrees(angles) * (axis == 0 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0));
}

/// A direction of the camera's coordinates in which a component grows.
glm::dvec3 directionOf(GizmoKind kind, const GizmoFrame &frame, int axis)
{
    glm::dvec3 unit(0.0);
    unit[axis] = 1.0;
    const glm::dvec3 inParent = kind == GizmoKind::Scale ? rotationFromDegrees(frame.parts.rotation) * unit : unit;
    return frame.hereFromParent.linear * inParent;
}

GizmoHandle ringOf(const GizmoFrame &frame, int axis, double size)
{
    GizmoHandle handle{axis, {}};
    const double radius = size / operatorNorm(frame.hereFromParent.linear);
    for (int i = 0; i <= ringPoints; ++i) {
        const double t = frame.parts.rotation[axis] + 360.0 * i / ringPoints;
        handle.line.push_back(frame.hereFromParent(frame.parts.position + radius * onRing(frame.parts, axis, t)));
    }
    return handle;
}

}

const glm::dvec3 &gizmoVector(GizmoKind kind, const TransformParts &parts)
{
    return kind == GizmoKind::Move ? parts.position : kind == GizmoKind::Rotate ? parts.rotation : parts.scale;
}

std::vector<GizmoHandle> gizmoHandles(GizmoKind kind, const GizmoFrame &frame, double size)
{
    std::vector<GizmoHandle> handles;
    const glm::dvec3 middle = frame.hereFromParent(frame.parts.position);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction = directionOf(kind, frame, axis);
        const double length = glm::length(direction);
        if (!(length > 0.0)) {
            continue;
        }
        handles.push_back(kind == GizmoKind::Rotate ? ringOf(frame, axis, size)
                                                    : GizmoHandle{axis, {middle, middle + size / length * direction}});
    }
    if (kind == GizmoKind::Scale && handles.size() == 3) {
        // The middle of all; it grows towards the upper right of the view, which its speed says.
        handles.push_back({GizmoHandle::all, {middle}});
    }
    return handles;
}

glm::dvec2 gizmoSpeed(GizmoKind kind, const GizmoFrame &frame, const GizmoHandle &handle, std::size_t point,
                      const Camera &camera)
{
    const glm::dvec3 &here = handle.line[point];
    if (handle.axis == GizmoHandle::all) {
        return {0.1, 0.1};
    }
    glm::dvec3 there = here;
    double step = 1.0;
    if (kind == GizmoKind::Rotate) {
        step = smallAngle;
        const double radius = glm::distance(frame.hereFromParent(frame.parts.position), here)
            / glm::length(frame.hereFromParent.linear
                          * onRing(frame.parts, handle.axis,
                                   frame.parts.rotation[handle.axis] + 360.0 * double(point) / ringPoints));
        const double t = frame.parts.rotation[handle.axis] + 360.0 * double(point) / ringPoints + smallAngle;
        there = frame.hereFromParent(frame.parts.position + radius * onRing(frame.parts, handle.axis, t));
    } else {
        // a thousandth of the handle, which is in view as a whole
        const glm::dvec3 outwards = handle.line[1] - handle.line[0];
        const double length = glm::length(outwards);
        step = 1e-3 * (kind == GizmoKind::Scale ? 1.0 : length / glm::length(directionOf(kind, frame, handle.axis)));
        there = here + 1e-3 * outwards;
    }
    const auto from = seenAt(camera, here);
    const auto to = seenAt(camera, there);
    return from && to ? (*to - *from) / step : glm::dvec2(0.0);
}

glm::dvec3 gizmoDragged(GizmoKind kind, const TransformParts &parts, int axis, const glm::dvec2 &speed,
                        const glm::dvec2 &way)
{
    glm::dvec3 vector = gizmoVector(kind, parts);
    const double squared = glm::dot(speed, speed);
    const double change = squared > 0.0 ? glm::dot(way, speed) / squared : 0.0;
    for (int i = 0; i < 3; ++i) {
        if (axis == i || axis == GizmoHandle::all) {
            vector[i] += kind == GizmoKind::Scale ? change * vector[i] : change;
        }
    }
    return vector;
}

}
