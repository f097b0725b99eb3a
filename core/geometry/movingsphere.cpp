// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "movingsphere.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hull.h"
#include "triangledistance.h"

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unitRoundoff = std::numeric_limits<double>::epsilon() / 2;

double largest(const glm::dvec3 &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double largest(const Triangle &triangle)
{
    return std::max({largest(triangle[0]), largest(triangle[1]), largest(triangle[2])});
}

/// Of length 1, or 0; also of what has a square that is no number.
glm::dvec3 unit(const glm::dvec3 &v)
{
    const double size = largest(v);
    return size > 0.0 ? glm::normalize(v / size) : glm::dvec3(0.0);
}

}

double SupportPlane::wayOf(const MovingSphere &sphere, double from) const
{
    const double closing = glm::dot(normal, sphere.direction);
    const double gap = offset - sphere.radius - from * closing;
    return gap <= 0.0 ? from : closing > 0.0 ? from + gap / closing : infinity;
}

SupportPlane BoxBody::planeFrom(const glm::dvec3 &point) const
{
    const glm::dvec3 nearest = glm::clamp(point, box.least, box.greatest);
    const glm::dvec3 way = nearest - point;
    const double length = glm::length(way);
    if (!(length > 0.0)) {
        return {};
    }
    const glm::dvec3 normal = way / length;
    return {normal, glm::dot(normal, nearest)};
}

/// From the middle two rounds along the edges; whatever they find, the plane is moved until nothing sticks out.
SupportPlane ParallelepipedBody::planeFrom(const glm::dvec3 &point) const
{
    glm::dvec3 way = middle - point;
    std::array<double, 3> along{};
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double square = glm::dot(halfEdges[i], halfEdges[i]);
            if (square > 0.0) {
                const double next = std::clamp(along[i] - glm::dot(way, halfEdges[i]) / square, -1.0, 1.0);
                way += (next - along[i]) * halfEdges[i];
                along[i] = next;
            }
        }
    }
    const double length = glm::length(way);
    if (!(length > 0.0)) {
        return {};
    }
    const glm::dvec3 normal = way / length;
    double offset = glm::dot(normal, middle);
    for (const glm::dvec3 &edge : halfEdges) {
        offset -= std::abs(glm::dot(normal, edge));
    }
    return {normal, offset};
}

Box ParallelepipedBody::box() const
{
    const glm::dvec3 reach = glm::abs(halfEdges[0]) + glm::abs(halfEdges[1]) + glm::abs(halfEdges[2]);
    return {middle - reach, middle + reach};
}

ParallelepipedBody parallelepiped(const AffineMap &map, const Box &box)
{
    const glm::dvec3 half = 0.5 * box.size();
    return {map(box.centre()), {map.linear[0] * half.x, map.linear[1] * half.y, map.linear[2] * half.z}};
}

SupportPlane HullBody::planeFrom(const glm::dvec3 &point) const
{
    const glm::dvec3 way = distanceToHull(corners, point).way;
    const double length = glm::length(way);
    if (!(length > 0.0)) {
        return {};
    }
    const glm::dvec3 normal = way / length;
    double offset = infinity;
    for (const glm::dvec3 &corner : corners) {
        offset = std::min(offset, glm::dot(normal, corner));
    }
    return {normal, offset - error};
}

double wayToBox(const Box &box, const MovingSphere &sphere)
{
    double enter = 0.0;
    double leave = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double least = box.least[axis] - sphere.radius;
        const double greatest = box.greatest[axis] + sphere.radius;
        const double perWay = 1.0 / sphere.direction[axis];
        if (!std::isfinite(perWay)) {
            if (least > 0.0 || greatest < 0.0) {
                return infinity;
            }
            continue;
        }
        const double one = least * perWay;
        const double other = greatest * perWay;
        enter = std::max(enter, std::min(one, other));
        leave = std::min(leave, std::max(one, other));
    }
    return enter <= leave ? enter : infinity;
}

namespace {

/// Both in unitRoundoff·M. The radius grows by what planes may be off: the offsets of vertices and products with them,
/// lengths of 1, and ways, of which none that counts is above 3·M.
constexpr double grown = 48.0;
constexpr double closeEnough = 8.0;

SupportPlane planeBetween(const glm::dvec3 &point, const Triangle &triangle)
{
    const auto quick = quickSeparation(triangle, point);
    const glm::dvec3 normal = quick ? quick->direction : separatingDirection(triangle, point);
    return {normal,
            std::min({glm::dot(normal, triangle[0]), glm::dot(normal, triangle[1]), glm::dot(normal, triangle[2])})};
}

}

TriangleTouch touch(const Triangle &triangle, const MovingSphere &sphere, double from, double until)
{
    assert(sphere.radius >= 0.0 && "a sphere has a size, or is a point");
    assert(from < infinity && "what is never touched need not be looked at");
    constexpr int mostSteps = 200;
    const double unit = unitRoundoff * std::max(largest(triangle), sphere.radius);
    const MovingSphere grownSphere{sphere.direction, sphere.radius + grown * unit};
    double way = from;
    for (int step = 0; step < mostSteps; ++step) {
        if (way > until) {
            return {way, false};
        }
        const double next = planeBetween(way * sphere.direction, triangle).wayOf(grownSphere, way);
        if (next == infinity) {
            return {next, false};
        }
        // the gap is no greater than the way that it takes
        const bool isThere = next - way <= closeEnough * unit;
        way = next;
        if (isThere) {
            return {way, way <= until};
        }
    }
    return {way, way <= until};
}

Contact contactAt(double way, const Triangle &triangle, const MovingSphere &sphere)
{
    const glm::dvec3 centre = way * sphere.direction;
    const ClosestPoint nearest = closestPoint(triangle, centre);
    const double size = std::max(largest(triangle), largest(centre));
    if (nearest.distance > 64.0 * unitRoundoff * size) {
        return {nearest.point, unit(centre - nearest.point)};
    }
    const glm::dvec3 normal = unit(glm::cross(unit(triangle[1] - triangle[0]), unit(triangle[2] - triangle[0])));
    if (normal != glm::dvec3(0.0)) {
        return {nearest.point, glm::dot(normal, sphere.direction) > 0.0 ? -normal : normal};
    }
    const bool rests = sphere.direction == glm::dvec3(0.0);
    return {nearest.point, rests ? glm::dvec3(0.0, 1.0, 0.0) : -sphere.direction};
}

}
