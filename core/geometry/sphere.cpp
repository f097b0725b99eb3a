// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Sums of a few products err by less than eight units in the last place of their largest term.
double roundingBound(const glm::dvec3 &centre, double radius)
{
    const double size = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z), radius});
    return 8.0 * std::numeric_limits<double>::epsilon() * size;
}

/// The length, also where squares overflow or vanish.
double lengthOf(const glm::dvec3 &v)
{
    const double simple = glm::length(v);
    const bool isGood = (simple > 1e-140 && simple < 1e150) || std::isnan(simple); // hypot may lose a NaN
    return isGood ? simple : std::hypot(v.x, v.y, v.z);
}

double distanceBetween(const glm::dvec3 &a, const glm::dvec3 &b)
{
    return lengthOf(a - b);
}

glm::dvec3 middleOfBox(std::span<const Sphere> spheres)
{
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    glm::dvec3 greatest(-std::numeric_limits<double>::infinity());
    for (const Sphere &sphere : spheres) {
        if (!sphere.isEmpty()) {
            least = glm::min(least, sphere.centre - sphere.radius);
            greatest = glm::max(greatest, sphere.centre + sphere.radius);
        }
    }
    return 0.5 * least + 0.5 * greatest;
}

}

Sphere transformed(const AffineMap &map, double norm, const Sphere &sphere)
{
    if (sphere.isEmpty()) {
        return sphere;
    }
    const glm::dvec3 centre = map(sphere.centre);
    const double radius = norm * sphere.radius;
    const double moved = norm * (std::abs(sphere.centre.x) + std::abs(sphere.centre.y) + std::abs(sphere.centre.z));
    return {centre, radius + roundingBound(map.translation, radius) + roundingBound(centre, moved)};
}

double enclosingRadius(const glm::dvec3 &centre, std::span<const Sphere> spheres)
{
    double radius = -1.0;
    for (const Sphere &sphere : spheres) {
        if (!sphere.isEmpty()) {
            const double reach = distanceBetween(centre, sphere.centre) + sphere.radius;
            if (!std::isfinite(reach)) { // also where infinities have made a NaN
                return std::numeric_limits<double>::infinity();
            }
            radius = std::max(radius, reach);
        }
    }
    return radius < 0.0 ? radius : radius + roundingBound(centre, radius);
}

Sphere enclosingSphere(std::span<const Sphere> spheres)
{
    const double none = enclosingRadius(glm::dvec3(0.0), spheres);
    if (none < 0.0 || !std::isfinite(none)) {
        return {glm::dvec3(0.0), none};
    }
    glm::dvec3 centre = middleOfBox(spheres);
    Sphere best{centre, enclosingRadius(centre, spheres)};
    if (!std::isfinite(best.radius)) { // from there the distances overflow
        return {glm::dvec3(0.0), none};
    }
    const int steps = static_cast<int>(std::clamp<std::size_t>(200'000 / spheres.size(), 4, 48));
    for (int step = 1; step <= steps; ++step) {
        // Towards the far side of the farthest sphere, by ever smaller steps.
        const Sphere *farthest = nullptr;
        double reach = -1.0;
        for (const Sphere &sphere : spheres) {
            const double distance = sphere.isEmpty() ? -1.0 : distanceBetween(centre, sphere.centre) + sphere.radius;
            if (distance > reach) {
                reach = distance;
                farthest = &sphere;
            }
        }
        if (!farthest) {
            break;
        }
        const glm::dvec3 offset = farthest->centre - centre;
        const double distance = lengthOf(offset);
        if (distance == 0.0 || !std::isfinite(reach / distance)) {
            break;
        }
        centre += offset * (reach / distance / (step + 2.0));
        const double radius = enclosingRadius(centre, spheres);
        if (radius < best.radius) {
            best = {centre, radius};
        }
    }
    return best;
}

Sphere enclosingSphere(std::span<const glm::dvec3> points)
{
    std::vector<Sphere> spheres;
    spheres.reserve(points.size());
    for (const glm::dvec3 &point : points) {
        spheres.push_back({point, 0.0});
    }
    return enclosingSphere(spheres);
}

bool contains(const Sphere &outer, const Sphere &inner)
{
    const double reach = distanceBetween(outer.centre, inner.centre) + inner.radius;
    return inner.isEmpty() || reach + roundingBound(inner.centre, reach) <= outer.radius;
}

}
