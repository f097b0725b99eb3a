// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "camera.h"
#include "core/geometry/box.h"
#include "core/geometry/sphere.h"
#include "depthpyramid.h"

namespace romanesco {

/// How a camera maps what it sees to the screen, in units in which the scene and its distance are about 1, so that a
/// scene of any size fits the card's floats.
struct Projector {
    Projector() = default;
    /// nearby: round what is looked at, in the camera's coordinates; from its middle nothing is farther than reach.
    Projector(const Camera &camera, const Sphere &nearby, double reach, int viewWidth, int viewHeight);

    /// A node's own coordinates to the camera's, in units of the view. What is near the camera keeps its precision
    /// however far from the origin both are.
    [[nodiscard]] AffineMap cameraFrom(const AffineMap &hereFromNode) const;

    Projection projection = Projection::Perspective;
    /// The camera's place, and the world's axes to the camera's in units of the view.
    glm::dvec3 position{0.0};
    glm::dmat3 cameraFromHere{1.0};
    double unit = 1.0;
    /// Clip x and y for each unit sideways: at distance 1 for perspective.
    double scaleX = 1.0;
    double scaleY = 1.0;
    /// Perspective: nothing nearer is drawn. A hundred-thousandth of the scene's size and distance.
    double near = 1e-5;
    /// Orthographic: depth runs over ±range, in logarithms where that is long.
    double range = 1.0;
    [[nodiscard]] bool isDeep() const { return projection == Projection::Orthographic && range > longRange; }
    /// Pixels for each unit sideways, at distance 1 for perspective.
    double pixels = 1.0;
    /// Of the picture, in pixels; and how far its pixels are shifted, in clip coordinates.
    int width = 0;
    int height = 0;
    glm::dvec2 jitter{0.0};

    /// Where the card draws what is in a box, mapped to the camera's axes; none where it reaches behind the camera.
    [[nodiscard]] std::optional<Footprint> footprint(const AffineMap &map, const Box &box) const;

private:
    static constexpr double longRange = 100.0;

    [[nodiscard]] double depthOf(double z) const;
};

}
