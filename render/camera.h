// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/scene/scene.h"

namespace romanesco {

enum class Projection { Perspective, Orthographic };

/// Where a picture is taken from, in left-handed world coordinates.
struct Camera {
    glm::dvec3 position{0.0, 0.0, -1.0};
    /// Columns right, up, forward; a rotation.
    glm::dmat3 worldFromCamera{1.0};
    Projection projection = Projection::Perspective;
    /// Perspective: the vertical angle of view in degrees, between 0 and 180.
    double fieldOfView = 60.0;
    /// Orthographic: the height of the view in world units.
    double viewHeight = 2.0;

    bool operator==(const Camera &) const = default;
};

/// As an .sdo gives it.
[[nodiscard]] Camera cameraOf(const SceneDescription::Camera &written);
/// The other way round, without a range.
[[nodiscard]] SceneDescription::Camera writtenOf(const Camera &camera);

/// Where a point is seen: in heights of the view from its middle, x right and y up. Nothing for one that is not before a
/// perspective camera.
[[nodiscard]] std::optional<glm::dvec2> seenAt(const Camera &camera, const glm::dvec3 &point);
/// How large a height of the view is where the point stands, in the point's units; 0 or less behind a perspective camera.
[[nodiscard]] double heightAt(const Camera &camera, const glm::dvec3 &point);

/// A camera that looks along forward with up upwards (any vectors that are not parallel).
[[nodiscard]] glm::dmat3 rotationLooking(const glm::dvec3 &forward, const glm::dvec3 &up = {0.0, 1.0, 0.0});

/// The view where a scene gives none: the whole scene, seen from the direction (1, 0.8, -1.2). aspect is width by
/// height.
[[nodiscard]] Camera fittedCamera(const Scene &scene, double aspect);

/// The same camera moved back or forth (or, orthographic, widened) and sideways until the scene fills the view but for a
/// margin of 5 %. Costs some milliseconds: six searches of how far the scene reaches.
[[nodiscard]] Camera fittedCamera(Camera camera, const Scene &scene, double aspect);

}
