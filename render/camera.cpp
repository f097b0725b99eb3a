// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/rotation.h"

namespace romanesco {

namespace {

constexpr double margin = 1.05;

}

glm::dmat3 rotationLooking(const glm::dvec3 &forward, const glm::dvec3 &up)
{
    const glm::dvec3 f = glm::normalize(forward);
    // Left-handed: right = up x forward.
    const glm::dvec3 right = glm::normalize(glm::cross(up, f));
    return {right, glm::cross(f, right), f};
}

Camera cameraOf(const SceneDescription::Camera &written)
{
    Camera camera;
    camera.position = written.position;
    camera.worldFromCamera = rotationFromRadians(written.rotation);
    if (written.isOrthographic) {
        camera.projection = Projection::Orthographic;
        camera.viewHeight = written.view;
    } else {
        camera.fieldOfView = written.view;
    }
    return camera;
}

SceneDescription::Camera writtenOf(const Camera &camera)
{
    const bool isOrthographic = camera.projection == Projection::Orthographic;
    return {camera.position,
            radiansOf(camera.worldFromCamera),
            isOrthographic,
            isOrthographic ? camera.viewHeight : camera.fieldOfView,
            {}};
}

double heightAt(const Camera &camera, const glm::dvec3 &point)
{
    if (camera.projection == Projection::Orthographic) {
        return camera.viewHeight;
    }
    const double away = glm::dot(camera.worldFromCamera[2], point - camera.position);
    return 2.0 * away * std::tan(0.5 * camera.fieldOfView * std::numbers::pi / 180.0);
}

std::optional<glm::dvec2> seenAt(const Camera &camera, const glm::dvec3 &point)
{
    const double height = heightAt(camera, point);
    if (!(height > 0.0)) {
        return std::nullopt;
    }
    const glm::dvec3 inCamera = glm::transpose(camera.worldFromCamera) * (point - camera.position);
    return glm::dvec2(inCamera) / height;
}

Camera fittedCamera(const Scene &scene, double aspect)
{
    Camera camera;
    camera.worldFromCamera = rotationLooking(glm::dvec3(-1.0, -0.8, 1.2));
    return fittedCamera(camera, scene, aspect);
}

Camera fittedCamera(Camera camera, const Scene &scene, double aspect)
{
    const glm::dvec3 middle = scene.extent.centre();
    const double size = glm::length(scene.extent.size());
    const auto moveTo = [&](const glm::dvec3 &fromMiddle) {
        camera.position = middle + camera.worldFromCamera * fromMiddle;
        return camera;
    };
    if (!(size > 0.0)) {
        return moveTo({0.0, 0.0, -1.0});
    }
    // How far the scene reaches along a direction in the camera's axes, from its middle.
    const auto reach = [&](const glm::dvec3 &direction) {
        const glm::dvec3 inWorld = camera.worldFromCamera * direction;
        return reachAlong(scene.items, inWorld) - glm::dot(inWorld, middle);
    };
    if (camera.projection == Projection::Orthographic) {
        const glm::dvec2 most(reach({1, 0, 0}), reach({0, 1, 0}));
        const glm::dvec2 least(-reach({-1, 0, 0}), -reach({0, -1, 0}));
        camera.viewHeight = margin * std::max(most.y - least.y, (most.x - least.x) / aspect);
        return moveTo({0.5 * (most + least), -size});
    }
    // With the camera at (c, -distance), each point must keep |x - c.x| <= a·(z + distance), and so for y and b. So the
    // reaches along (±1, 0, -a) bound ±c.x + a·distance from below.
    const double b = std::tan(0.5 * camera.fieldOfView * std::numbers::pi / 180.0) / margin;
    const double a = b * aspect;
    const glm::dvec2 positive(reach({1, 0, -a}), reach({0, 1, -b}));
    const glm::dvec2 negative(reach({-1, 0, -a}), reach({0, -1, -b}));
    const glm::dvec2 distance = 0.5 * (positive + negative) / glm::dvec2(a, b);
    return moveTo({0.5 * (positive - negative), -std::max(distance.x, distance.y)});
}

}
