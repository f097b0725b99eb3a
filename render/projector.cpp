// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "projector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace romanesco {

namespace {

/// In degrees; in units of the view.
constexpr double leastFieldOfView = 1e-6;
constexpr double leastViewHeight = 1e-9;

/// Of the card, with a margin: in pixels, where 1/256 is the rule; and as a share.
constexpr double placeRounding = 1.0 / 64.0;
constexpr double depthRounding = 1e-5;

}

Projector::Projector(const Camera &camera, const Sphere &nearby, double reach, int viewWidth, int viewHeight)
    : projection(camera.projection)
    , position(camera.position)
{
    const double size = 2.0 * nearby.radius;
    const double distance = glm::distance(camera.position, nearby.centre);
    unit = std::max({size, distance, std::numeric_limits<double>::min()});
    cameraFromHere = glm::transpose(camera.worldFromCamera) / unit;
    range = (distance + std::max(reach, nearby.radius)) / unit;
    const bool isPerspective = projection == Projection::Perspective;
    // What is narrower has no more pixels that differ, and floats would end.
    const double angle = std::max(camera.fieldOfView, leastFieldOfView);
    scaleY = isPerspective ? 1.0 / std::tan(0.5 * angle * std::numbers::pi / 180.0)
                           : 2.0 * unit / std::max(camera.viewHeight, leastViewHeight * unit);
    scaleX = scaleY * viewHeight / viewWidth;
    pixels = 0.5 * scaleY * viewHeight;
    width = viewWidth;
    height = viewHeight;
}

/// As the shaders have it: reversed.
double Projector::depthOf(double z) const
{
    if (projection == Projection::Perspective) {
        return near / z;
    }
    return 0.5 - 0.5 * (isDeep() ? std::copysign(std::log1p(std::abs(z)) / std::log1p(range), z) : z / range);
}

std::optional<Footprint> Projector::footprint(const AffineMap &map, const Box &box) const
{
    const bool isPerspective = projection == Projection::Perspective;
    const glm::dvec2 scale(scaleX, scaleY);
    glm::dvec2 least(std::numeric_limits<double>::infinity());
    glm::dvec2 most = -least;
    double front = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at = map({corner & 1 ? box.greatest.x : box.least.x, corner & 2 ? box.greatest.y : box.least.y,
                                   corner & 4 ? box.greatest.z : box.least.z});
        if (isPerspective && !(at.z > near)) {
            return std::nullopt;
        }
        const glm::dvec2 seen = scale * glm::dvec2(at) / (isPerspective ? at.z : 1.0);
        least = glm::min(least, seen);
        most = glm::max(most, seen);
        front = std::min(front, at.z);
    }
    // A pixel is drawn where its middle is; the card rounds places and depths a little.
    const glm::dvec2 size(width, height);
    const glm::dvec2 from = (0.5 + 0.5 * (least + jitter)) * size + (0.5 - placeRounding);
    const glm::dvec2 to = (0.5 + 0.5 * (most + jitter)) * size - (0.5 - placeRounding);
    return Footprint{from.x, from.y, to.x, to.y, depthOf(front) * (1.0 + depthRounding)};
}

AffineMap Projector::cameraFrom(const AffineMap &hereFromNode) const
{
    return {cameraFromHere * hereFromNode.linear, cameraFromHere * (hereFromNode.translation - position)};
}

}
