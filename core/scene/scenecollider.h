// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/collide/collider.h"
#include "core/collide/colliderkind.h"
#include "core/geometry/box.h"
#include "core/geometry/similarity.h"
#include "scene.h"
#include "surroundings.h"

namespace romanesco {

/// The surface of all objects and fractals of a scene, each at its place, in the world's coordinates. Balls move, so they
/// are no part of it.
///
/// Items that share a model share its collider. Where an item's place is a similarity a query goes into the model's
/// coordinates; anywhere else (sheared, flat, at a point) into a search of the surface as it is placed, and what has to be
/// written out is written out where it stands.
///
/// It promises of a scene what its kind does of an item; sweeps are exact with Approximate too. Each item is passed over whose box is farther than what was
/// found; a query costs some nanoseconds for each besides, and a budget of nodes is for all together.
class SceneCollider final : public Collider
{
public:
    /// Coordinates of a query's p may be so large, either way.
    static constexpr double farthest = 1e140;
    /// Bvh writes out so many faces of fractals in all; Simple looks at so many for a point.
    static constexpr std::uint64_t mostFaces = 100'000'000;

    struct Options {
        ColliderKind kind = ColliderKind::Exact;
        /// Of Approximate.
        double excess = 1e-3;
    };

    /// The error is a sentence, with the item's path where it has one: what the kind of collider cannot do, or cancelled.
    [[nodiscard]] static std::expected<SceneCollider, std::string>
    create(std::shared_ptr<const Scene> scene, const Options &options, const std::stop_token &stop = {});

    /// The same surface in the coordinates of a place of the same items, balls aside, where what is near keeps its precision however deep that lies. Nothing of
    /// what Surroundings leaves out is found. Only where it searchesBelow(): Exact and Approximate. Cost:
    /// that of a box for each node; colliders are shared.
    [[nodiscard]] SceneCollider at(std::shared_ptr<const Surroundings> place) const;

    /// Whether at() may be asked for.
    [[nodiscard]] bool searchesBelow() const
    {
        return m_kind == ColliderKind::Exact || m_kind == ColliderKind::Approximate;
    }
    /// What its searches promise that are not cut short.
    [[nodiscard]] Promise promise() const { return m_promise; }

    /// A SceneSearch.
    [[nodiscard]] std::unique_ptr<Search> search() const override;
    [[nodiscard]] std::size_t memoryUse() const override;

private:
    friend class SceneSearch;
    class Builder;

    /// What is searched: a model's own, or one in the world's coordinates; of a place, what a state leads to.
    struct Surface {
        std::shared_ptr<const Collider> collider;
        std::optional<AffineMap> worldFromModel = {};
        Positions state = {};
    };
    /// An item with faces; of a place, a node of one.
    struct Placed {
        std::size_t item = 0;
        /// In the world.
        Box box;
        std::size_t surface = 0;
        /// None where the surface is in the world's coordinates already.
        std::optional<Similarity> worldFromModel = {};
        /// Of the place's.
        std::size_t node = 0;
    };

    SceneCollider() = default;

    std::shared_ptr<const Scene> m_scene;
    /// Null in the world.
    std::shared_ptr<const Surroundings> m_place;
    /// What has been written out, for the colliders of it.
    std::vector<std::shared_ptr<const Mesh>> m_meshes;
    std::vector<Surface> m_surfaces;
    std::vector<Placed> m_placed;
    ColliderKind m_kind = ColliderKind::Exact;
    Promise m_promise = Promise::Exact;
    double m_excess = 0.0;
};

}
