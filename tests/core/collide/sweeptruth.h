// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include <QString>
#include <glm/geometric.hpp>

#include "core/collide/collider.h"
#include "tests/core/collide/bruteforce.h"

/// The oracle of sweeps: every face of a written-out fractal, in 113 bits. The distance from a point that moves to a
/// triangle is a convex function of time.
namespace romanesco::test {

using WideTriangle = std::array<truth::Vector<Wide>, 3>;

inline glm::dvec3 narrow(const truth::Vector<Wide> &v)
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// What rounding may come to: of all coordinates together, for each level.
inline double roundingOf(const Sweep &sweep, double size)
{
    return 1e-12 * (size + glm::length(sweep.p) + sweep.radius + glm::length(sweep.v) * sweep.time);
}

inline QString words(const Sweep &sweep, const Touch &touch)
{
    return QStringLiteral("r %1, length %2: %3, at least %4")
        .arg(sweep.radius)
        .arg(glm::length(sweep.v) * sweep.time)
        .arg(touch.time, 0, 'g', 17)
        .arg(touch.lower, 0, 'g', 17);
}

class SweepTruth
{
public:
    void add(const naive::Fractal &fractal, const Mesh &mesh, const naive::Picks &picks)
    {
        for (const Mesh::Face &face : mesh.faces) {
            WideTriangle triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                triangle[i] = placed(picks, fractal.maps, mesh.vertices[face[i]]);
            }
            add(triangle);
        }
    }

    /// Of one that is flat, but for what 113 bits tell of its plane, the edges are enough.
    void add(const WideTriangle &triangle)
    {
        const auto &[a, b, c] = triangle;
        const auto u = truth::difference(b, a);
        const auto v = truth::difference(c, a);
        const Wide squares = truth::dot(u, u) * truth::dot(v, v);
        if (squares - truth::dot(u, v) * truth::dot(u, v) < 1e-24 * squares) {
            keep({a, b, b});
            keep({b, c, c});
            keep({c, a, a});
        } else {
            keep(triangle);
        }
    }

    /// From the origin to the farthest vertex.
    [[nodiscard]] double size() const { return m_size; }
    [[nodiscard]] const std::vector<WideTriangle> &triangles() const { return m_triangles; }

    /// The least distance between the sweep's centre and a face, from 0 to a time; or more than `enough`.
    [[nodiscard]] Wide leastUntil(const Sweep &sweep, double time, double enough) const
    {
        Wide least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < m_triangles.size(); ++i) {
            const auto &[centre, radius] = m_balls[i];
            const double square = glm::dot(sweep.v, sweep.v);
            const double nearest =
                square > 0 ? std::clamp(glm::dot(centre - sweep.p, sweep.v) / square, 0.0, time) : 0.0;
            const double distance = glm::distance(centre, sweep.p + nearest * sweep.v);
            if (distance * (1 - 1e-9) - radius <= enough) {
                least = std::min(least, leastTo(m_triangles[i], sweep, time));
            }
        }
        return least;
    }

    /// From where the centre is at a time.
    [[nodiscard]] static Wide distanceAt(const WideTriangle &triangle, const Sweep &sweep, const Wide &time)
    {
        truth::Vector<Wide> at;
        for (std::size_t i = 0; i < 3; ++i) {
            const int axis = static_cast<int>(i);
            at[i] = Wide(sweep.p[axis]) + time * Wide(sweep.v[axis]);
        }
        return truth::distance<Wide>(triangle, at);
    }
    [[nodiscard]] Wide distanceAt(const Sweep &sweep, double time) const
    {
        Wide least = std::numeric_limits<double>::infinity();
        for (const WideTriangle &triangle : m_triangles) {
            least = std::min(least, distanceAt(triangle, sweep, Wide(time)));
        }
        return least;
    }

private:
    void keep(const WideTriangle &triangle)
    {
        Ball ball{(narrow(triangle[0]) + narrow(triangle[1]) + narrow(triangle[2])) / 3.0, 0.0};
        for (const auto &vertex : triangle) {
            ball.radius = std::max(ball.radius, glm::distance(ball.centre, narrow(vertex)));
            m_size = std::max(m_size, glm::length(narrow(vertex)));
        }
        m_triangles.push_back(triangle);
        m_balls.push_back(ball);
    }

    struct Ball {
        glm::dvec3 centre{0.0};
        double radius = 0.0;
    };

    /// By thirds.
    static Wide leastTo(const WideTriangle &triangle, const Sweep &sweep, double time)
    {
        Wide from = 0;
        Wide to = time;
        Wide least = std::min(distanceAt(triangle, sweep, from), distanceAt(triangle, sweep, to));
        for (int i = 0; i < 100 && sweep.v != glm::dvec3(0.0); ++i) {
            const Wide left = from + (to - from) / 3;
            const Wide right = to - (to - from) / 3;
            const Wide atLeft = distanceAt(triangle, sweep, left);
            const Wide atRight = distanceAt(triangle, sweep, right);
            least = std::min({least, atLeft, atRight});
            (atLeft <= atRight ? to : from) = atLeft <= atRight ? right : left;
        }
        return least;
    }

    std::vector<WideTriangle> m_triangles;
    std::vector<Ball> m_balls;
    double m_size = 0.0;
};

inline SweepTruth truthOf(const RandomFractal &sample)
{
    SweepTruth truth;
    for (const naive::Picks &picks : naive::allPicks(sample.fractal.levels())) {
        truth.add(sample.fractal, sample.mesh, picks);
    }
    return truth;
}

inline SweepTruth truthOf(const Mesh &mesh)
{
    SweepTruth truth;
    for (const Mesh::Face &face : mesh.faces) {
        truth.add({wide(mesh.vertices[face[0]]), wide(mesh.vertices[face[1]]), wide(mesh.vertices[face[2]])});
    }
    return truth;
}

/// A sphere of any size: at the surface or past it, from near or far, to its end or beyond; or any way.
inline Sweep randomSweep(std::mt19937_64 &random, const SweepTruth &truth)
{
    const auto sizeFrom = [&](double least, double greatest) {
        return std::pow(10.0, uniform(random, least, greatest));
    };
    const double size = std::max(truth.size(), 1e-3);
    Sweep sweep;
    sweep.radius = random() % 10 == 0 ? 0.0 : size * sizeFrom(-9, 0.5);
    const glm::dvec3 direction = glm::normalize(randomPoint(random, 1.0) + glm::dvec3(0.0, 1e-9, 0.0));
    const double speed = sizeFrom(-3, 3);
    const double length = size * sizeFrom(-3, 1.5);
    sweep.p = randomPoint(random, 1.5 * size);
    if (random() % 4 != 0) {
        const WideTriangle &triangle = truth.triangles()[random() % truth.triangles().size()];
        const glm::dvec3 corner = narrow(triangle[random() % 3]);
        const glm::dvec3 target = corner + uniform(random, 0, 0.7) * (narrow(triangle[random() % 3]) - corner);
        const double amiss =
            random() % 2 == 0 ? uniform(random, 0, 1.5) : 1 + uniform(random, -1, 1) * sizeFrom(-9, -1);
        const glm::dvec3 across = glm::normalize(glm::cross(direction, glm::dvec3(0.31, 0.74, -0.2)));
        sweep.p = target + amiss * sweep.radius * across - uniform(random, 0, 1.2) * length * direction;
    }
    sweep.v = random() % 20 == 0 ? glm::dvec3(0.0) : speed * direction;
    sweep.time = length / speed;
    return sweep;
}

}
