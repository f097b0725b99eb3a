// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <expected>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "anchor.h"
#include "core/collide/facetree.h"
#include "core/collide/raywalk.h"
#include "core/geometry/sphere.h"
#include "scene.h"

namespace romanesco {

/// Finds what a ray meets first of a scene, in the world's coordinates: of all items, balls too, each at its place.
///
/// Items are walked from the one on whose sphere the ray comes first, until what was met is before all that are left; a ray
/// costs some nanoseconds for each item besides. Items that share a model share what was made of it. One thread uses it.
class SceneRayWalk
{
public:
    /// The error is a sentence, with the item's path where it has one: see FaceTree::build(). Cost: about a microsecond for
    /// each face of each mesh.
    [[nodiscard]] static std::expected<SceneRayWalk, std::string> create(std::shared_ptr<const Scene> scene,
                                                                         const std::stop_token &stop = {});

    /// See RayWalk::cast(); hit.root is 0. A budget is for all items together.
    void cast(const Ray &ray, RayHit &hit);

    /// The same in the coordinates of a place in the scene; hit.root is a node of what surrounds it.
    void cast(const Ray &ray, const Surroundings &from, RayHit &hit);

    /// By the last ray, the item in Scene::items that was met. Only where one was.
    [[nodiscard]] std::size_t item() const { return m_item; }

    [[nodiscard]] const std::shared_ptr<const Scene> &scene() const { return m_scene; }
    [[nodiscard]] std::size_t memoryUse() const;

private:
    explicit SceneRayWalk(std::shared_ptr<const Scene> scene)
        : m_scene(std::move(scene))
    {
    }

    /// What is needed for a model.
    struct Part {
        Part(const Model &model, FaceTree &&faces);

        FaceTree tree;
        RayWalk walk;
    };
    struct Placed {
        Part *part;
        /// Holds the item, in the world, and what stands for small parts of it.
        Sphere bound;
    };
    /// An item that the ray does not meet before a way.
    struct Waiting {
        double way;
        std::size_t item;
    };

    void listItems(const Ray &ray, const glm::dvec3 &direction);
    [[nodiscard]] Waiting takeNearest();
    void take(std::size_t item, RayHit &hit);

    std::shared_ptr<const Scene> m_scene;
    std::vector<std::unique_ptr<Part>> m_parts;
    /// By item.
    std::vector<Placed> m_placed;
    /// A heap of the items that were not looked at, the nearest on top.
    std::vector<Waiting> m_waiting;
    std::vector<RayRoot> m_root{RayRoot{}};
    std::vector<RayRoot> m_roots;
    RayHit m_ofItem;
    std::size_t m_item = 0;
};

}
