// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include <glm/geometric.hpp>

#include "core/collide/raywalk.h"

/// Rays through fractals.
namespace romanesco::test {

const std::vector<RayRoot> asItIs{{}};

/// A walk with what it needs.
struct Walker {
    Walker(const FractalGraph &graph, const Mesh &mesh)
        : boxes(graph, mesh)
        , tree(FaceTree::build(mesh).value())
        , walk(graph, boxes, mesh, tree)
    {
    }

    RayHit cast(const Ray &ray, const std::vector<RayRoot> &roots = asItIs)
    {
        RayHit hit;
        walk.cast(ray, roots, hit);
        return hit;
    }

    BoxBounds boxes;
    FaceTree tree;
    RayWalk walk;
};

/// A camera that sees a sphere whole.
struct View {
    explicit View(const Sphere &sphere)
        : sees(sphere)
    {
        const glm::dvec3 forward = glm::normalize(glm::dvec3(-1, -0.8, 1.2));
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), forward));
        worldFromView = {right, glm::cross(forward, right), forward};
    }

    /// Through a place from -1 to 1 across the view, at any distance.
    [[nodiscard]] Ray ray(double x, double y, double distance = 2.0) const
    {
        const glm::dvec3 forward = worldFromView[2];
        const double half = 1.0 / distance;
        return {.origin = sees.centre - distance * sees.radius * forward,
                .direction = worldFromView * glm::dvec3(x * half, y * half, 1.0)};
    }

    Sphere sees;
    glm::dmat3 worldFromView;
};

}
