// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "hull.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <queue>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Up to four points, seen from p, and the point of their hull that is nearest to p.
class Simplex
{
public:
    explicit Simplex(const glm::dvec3 &point)
        : m_nearest(point)
    {
        m_points[0] = point;
    }

    [[nodiscard]] const glm::dvec3 &nearest() const { return m_nearest; }

    /// Takes a point in and leaves out those that the nearest point does not need. Whether it came nearer.
    bool add(const glm::dvec3 &point)
    {
        m_points[m_count] = point;
        m_least = glm::dot(m_nearest, m_nearest);
        m_best = 0;
        for (unsigned others = 0; others < 1u << m_count; ++others) {
            consider(others | 1u << m_count);
        }
        keep(m_best);
        return m_best != 0;
    }

private:
    /// The points of a subset, the nearest point to p of the flat through them, if it is inside.
    void consider(unsigned subset)
    {
        std::array<glm::dvec3, 4> chosen{};
        std::size_t count = 0;
        for (std::size_t i = 0; i <= m_count; ++i) {
            if ((subset >> i & 1) != 0) {
                chosen[count++] = m_points[i];
            }
        }
        const glm::dvec3 &a = chosen[0];
        const glm::dvec3 u = chosen[1] - a;
        const glm::dvec3 v = chosen[2] - a;
        const glm::dvec3 w = chosen[3] - a;
        switch (count) {
        case 1:
            offer(subset, a, true);
            break;
        case 2: {
            const double along = -glm::dot(a, u) / glm::dot(u, u);
            offer(subset, a + along * u, along > 0.0 && along < 1.0);
            break;
        }
        case 3: {
            const glm::dvec3 normal = glm::cross(u, v);
            const double square = glm::dot(normal, normal);
            const double alongU = -glm::dot(glm::cross(a, v), normal) / square;
            const double alongV = -glm::dot(glm::cross(u, a), normal) / square;
            offer(subset, normal * (glm::dot(a, normal) / square),
                  alongU > 0.0 && alongV > 0.0 && alongU + alongV < 1.0);
            break;
        }
        default: {
            const double volume = glm::dot(u, glm::cross(v, w));
            const double alongU = -glm::dot(a, glm::cross(v, w)) / volume;
            const double alongV = -glm::dot(u, glm::cross(a, w)) / volume;
            const double alongW = -glm::dot(u, glm::cross(v, a)) / volume;
            offer(subset, glm::dvec3(0.0),
                  alongU > 0.0 && alongV > 0.0 && alongW > 0.0 && alongU + alongV + alongW < 1.0);
            break;
        }
        }
    }

    void offer(unsigned subset, const glm::dvec3 &nearest, bool isInside)
    {
        const double square = glm::dot(nearest, nearest);
        if (isInside && square < m_least) {
            m_least = square;
            m_nearest = nearest;
            m_best = subset;
        }
    }

    void keep(unsigned subset)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i <= m_count && subset != 0; ++i) {
            if ((subset >> i & 1) != 0) {
                m_points[kept++] = m_points[i];
            }
        }
        m_count = subset != 0 ? kept : m_count;
    }

    std::array<glm::dvec3, 4> m_points{};
    std::size_t m_count = 1;
    glm::dvec3 m_nearest;
    double m_least = 0.0;
    unsigned m_best = 0;
};

}

HullDistance distanceToHull(const glm::dvec3 &first, const PointsByDirection &points, double enough)
{
    constexpr int mostSteps = 64;
    constexpr double closeEnough = 4.0 * std::numeric_limits<double>::epsilon();
    Simplex simplex(first);
    double least = 0.0;
    for (int step = 0; step < mostSteps; ++step) {
        const glm::dvec3 way = simplex.nearest();
        const double length = glm::length(way);
        const glm::dvec3 point = points.leastAlong(way);
        least = length > 0.0 ? std::max(least, glm::dot(way, point) / length) : 0.0;
        if (length - least <= closeEnough * length || least > enough || !simplex.add(point)) {
            break;
        }
        if (simplex.nearest() == glm::dvec3(0.0)) {
            least = 0.0;
            break;
        }
    }
    return {least, std::max(least, glm::length(simplex.nearest())), simplex.nearest()};
}

namespace {

class SeenPoints final : public PointsByDirection
{
public:
    SeenPoints(std::span<const glm::dvec3> points, const glm::dvec3 &p)
        : m_points(points)
        , m_p(p)
    {
    }

    [[nodiscard]] glm::dvec3 leastAlong(const glm::dvec3 &direction) const override
    {
        return *std::ranges::min_element(m_points, {}, [&](const glm::dvec3 &point) {
            return glm::dot(direction, point - m_p);
        }) - m_p;
    }

private:
    std::span<const glm::dvec3> m_points;
    glm::dvec3 m_p;
};

}

HullDistance distanceToHull(std::span<const glm::dvec3> points, const glm::dvec3 &p, double enough)
{
    assert(!points.empty() && "nothing is not far from anywhere");
    return distanceToHull(points.front() - p, SeenPoints(points, p), enough);
}

Hull thinned(std::span<const glm::dvec3> points, std::size_t mostCorners, double tolerance)
{
    Hull hull;
    if (points.empty()) {
        return hull;
    }
    // Distances only shrink while corners come: what was found once is an upper bound, and to be found anew only where it
    // is the greatest.
    using Outside = std::pair<double, std::size_t>;
    std::priority_queue<Outside> outside;
    const glm::dvec3 &first = points.front();
    hull.corners.push_back(first);
    for (std::size_t i = 1; i < points.size(); ++i) {
        outside.emplace(glm::distance(points[i], first), i);
    }
    while (!outside.empty()) {
        const std::size_t farthest = outside.top().second;
        outside.pop();
        const double distance = distanceToHull(hull.corners, points[farthest]).greatest;
        if (!outside.empty() && distance < outside.top().first) {
            outside.emplace(distance, farthest);
        } else if (distance <= tolerance || hull.corners.size() == mostCorners) {
            hull.error = distance;
            break;
        } else {
            hull.corners.push_back(points[farthest]);
        }
    }
    return hull;
}

}
