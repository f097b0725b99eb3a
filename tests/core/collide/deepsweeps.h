// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "core/collide/exactcollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"

namespace romanesco::test {

/// An example at any depth, and spheres that move in it.
struct Deep {
    Sample fractal;
    BoxBounds boxes;
    ExactCollider collider;

    Deep(const QString &name, std::uint64_t depth)
        : fractal(sample(name, depth))
        , boxes(fractal.graph, fractal.mesh)
        , collider(ExactCollider::create(fractal.graph, boxes, fractal.mesh).value())
    {
    }

    [[nodiscard]] double size() const { return glm::length(boxes.at(fractal.graph, 0).size()); }

    /// That starts in the air, in the box or near the surface.
    [[nodiscard]] Sweep sweep(std::mt19937_64 &random, Search &search) const
    {
        Hit hit;
        while (true) {
            Sweep sweep;
            sweep.radius = size() * std::pow(10.0, uniform(random, -6, -1.5));
            sweep.p = boxes.at(fractal.graph, 0).centre() + randomPoint(random, 0.35 * size());
            search.closest({sweep.p}, hit);
            if (random() % 2 == 0) {
                sweep.p = hit.point + uniform(random, 1.01, 4) * sweep.radius * hit.direction;
                search.closest({sweep.p}, hit);
            }
            if (hit.lower > 1.001 * sweep.radius) {
                const double length = std::min(sweep.radius * std::pow(10.0, uniform(random, 0, 4)), size());
                sweep.v = length * glm::normalize(randomPoint(random, 1.0));
                return sweep;
            }
        }
    }
};

}
