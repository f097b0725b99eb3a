// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <glm/geometric.hpp>

#include "core/physics/ballstepper.h"
#include "core/scene/scenecollider.h"
#include "tests/core/scene/randomscenes.h"

/// Surfaces that balls fall on.
namespace romanesco::test {

/// A scene as a surface, and a search of its own for what tests ask.
struct Ground {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const SceneCollider> collider;
    Surface surface;
    Probe probe;
    std::unique_ptr<Search> search;

    explicit Ground(const std::vector<SceneItem> &items, ColliderKind kind = ColliderKind::Exact, double excess = 0.0)
        : scene(sceneOf(items))
        , collider(std::make_shared<const SceneCollider>(SceneCollider::create(scene, {kind, excess}).value()))
        , surface{collider, kind != ColliderKind::Greedy && kind != ColliderKind::Octree, sizeOf(items),
                  kind == ColliderKind::Exact || kind == ColliderKind::Bvh || kind == ColliderKind::Simple}
        , probe(surface)
        , search(collider->search())
    {
    }
    explicit Ground(const Mesh &mesh, const AffineMap &place = {})
        : Ground({{.model = modelOf(mesh), .worldFromModel = place}})
    {
    }
    Ground(const QString &example, std::uint64_t depth, const AffineMap &place = {})
        : Ground({{.model = modelOf(example, depth), .worldFromModel = place}})
    {
    }
    Ground(Ground &&) = delete;

    /// How far the surface is.
    [[nodiscard]] double distance(const glm::dvec3 &p) const
    {
        Hit hit;
        search->closest({p}, hit);
        return hit.distance;
    }

    static double sizeOf(const std::vector<SceneItem> &items)
    {
        double size = 0.0;
        for (const SceneItem &item : items) {
            const Sphere sphere = boundingSphere(item);
            size = std::max(size, glm::length(sphere.centre) + sphere.radius);
        }
        return size;
    }
};

/// Two faces at y = 0, so wide to each side.
inline Mesh floorMesh(double half)
{
    return {{{-half, 0, -half}, {half, 0, -half}, {-half, 0, half}, {half, 0, half}}, {{0, 1, 2}, {1, 3, 2}}};
}

/// Twelve faces, from -half to half along each axis.
inline Mesh boxMesh(double half)
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back(
            {(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half});
    }
    mesh.faces = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 3, 6}, {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// Two planes that meet in the line x = 0 at y = 0, each of a slope.
inline Mesh grooveMesh(double half, double slope)
{
    const double high = half * slope;
    return {{{-half, high, -half},
             {0, 0, -half},
             {half, high, -half},
             {-half, high, half},
             {0, 0, half},
             {half, high, half}},
            {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}}};
}

inline BallState ballAt(const glm::dvec3 &position, double radius, double restitution = 0.5,
                        const glm::dvec3 &velocity = glm::dvec3(0.0))
{
    BallState ball;
    ball.position = position;
    ball.velocity = velocity;
    ball.radius = radius;
    ball.restitution = restitution;
    return ball;
}

/// By gravity and motion, of a mass of 1.
inline double energyOf(const BallState &ball, const Laws &laws)
{
    return 0.5 * glm::dot(ball.velocity, ball.velocity) - glm::dot(laws.gravity, ball.position);
}

}
