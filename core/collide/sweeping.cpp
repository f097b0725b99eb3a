// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sweeping.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/sizes.h"

namespace romanesco {

namespace {

constexpr double greatestCoordinate = 1e150;
constexpr double slackOfRadius = 1e-5;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is so far away is touched on a way that is no longer than that and the radius, or not at all.
double reachWithin(const Path &path, double far)
{
    const double radius = path.sphere.radius;
    return far + radius + std::min(path.length, far + radius);
}

[[maybe_unused]] bool isOfNumbers(const glm::dvec3 &v)
{
    return std::isfinite(v.x + v.y + v.z) && greatestSize(v) <= greatestCoordinate;
}

}

Path::Path(const Sweep &sweep)
    : start(sweep.p)
    , sphere{glm::dvec3(0.0), sweep.radius}
    , slack(slackOfRadius * sweep.radius)
{
    assert(isOfNumbers(sweep.p) && isOfNumbers(sweep.v) && "nothing is touched on a way that is nowhere");
    assert(sweep.radius >= 0.0 && sweep.radius <= greatestCoordinate && "a sphere has a size, or is a point");
    assert(sweep.time >= 0.0 && "it does not move back");
    const double size = greatestSize(sweep.v); // scaled, since squares of small numbers underflow
    if (size > 0.0 && sweep.time > 0.0) {
        const glm::dvec3 scaled = sweep.v / size;
        speed = size * glm::length(scaled);
        sphere.direction = glm::normalize(scaled);
        length = speed * sweep.time;
    }
}

double Path::timeOf(double way) const
{
    return speed > 0.0 ? way / speed : way > 0.0 ? infinity : 0.0;
}

bool FirstTouch::consider(const AffineMap &modelFromBase, std::vector<glm::dvec3> &scratch)
{
    scratch.resize(m_mesh.vertices.size());
    std::ranges::transform(m_mesh.vertices, scratch.begin(),
                           [&](const glm::dvec3 &vertex) { return modelFromBase(vertex) - m_path.start; });
    bool isFirst = false;
    for (std::size_t i = 0; i < m_mesh.faces.size(); ++i) {
        const Mesh::Face &face = m_mesh.faces[i];
        const Triangle triangle{scratch[face[0]], scratch[face[1]], scratch[face[2]]};
        const TriangleTouch found = romanesco::touch(triangle, m_path.sphere, 0.0, m_best);
        m_lower = std::min(m_lower, found.way);
        if (found.isTouch && (found.way < m_best || !isFound())) {
            m_best = found.way;
            m_triangle = triangle;
            m_face = static_cast<std::uint32_t>(i);
            isFirst = true;
        }
    }
    m_faceTests += m_mesh.faces.size();
    return isFirst;
}

void FirstTouch::restart()
{
    m_best = m_path.length;
    m_lower = infinity;
    m_face = Mesh::none;
}

void FirstTouch::report(const Sweep &sweep, Touch &touch) const
{
    touch.cost.faceTests = m_faceTests;
    if (isFound()) {
        touch.face = m_face;
        place(touch, m_path, m_best, m_triangle);
    }
    prove(touch, m_path, m_lower, sweep);
}

double reachOf(const Path &path, const Box &box)
{
    return box.isEmpty() ? 0.0 : reachWithin(path, sumOfSizes(path.start) + sumOfSizes(box));
}

double reachFromStart(const Path &path, const Box &seen)
{
    return seen.isEmpty() ? 0.0 : reachWithin(path, sumOfSizes(seen));
}

void touchPoint(const glm::dvec3 &point, const MovingSphere &sphere, double limit, SweptFace &found)
{
    found = {.triangle = {point, point, point}};
    const TriangleTouch touched = touch(found.triangle, sphere, 0.0, limit);
    found.lower = touched.way;
    found.way = touched.isTouch ? touched.way : infinity;
}

double refined(double way, const Triangle &triangle, const MovingSphere &sphere, double slack)
{
    const TriangleTouch found = touch(triangle, sphere, way, way + slack);
    return found.isTouch ? found.way : way;
}

void place(Touch &touch, const Path &path, double way, const Triangle &triangle)
{
    const Contact contact = contactAt(way, triangle, path.sphere);
    touch.time = path.timeOf(way);
    touch.point = path.start + contact.point;
    touch.direction = contact.direction;
}

void prove(Touch &touch, const Path &path, double lower, const Sweep &sweep)
{
    touch.time = touch.isFound() ? std::min(touch.time, sweep.time) : touch.time;
    touch.lower = std::clamp(path.timeOf(lower), 0.0, std::min(touch.time, sweep.time));
}

}
