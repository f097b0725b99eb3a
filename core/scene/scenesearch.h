// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "scenecollider.h"

namespace romanesco {

/// A search of a scene. Of items that are equally near it finds the one whose box is nearer, then the first.
class SceneSearch final : public Search
{
public:
    explicit SceneSearch(const SceneCollider &collider);

    /// No coordinate of p may be beyond SceneCollider::farthest.
    void closest(const Query &query, Hit &hit) override;

    /// The same of a sweep's p, v and radius. What an item's place puts a path off by counts as rounding.
    void sweep(const Sweep &sweep, Touch &touch) override;

    /// By the last query or sweep, the item in Scene::items that its face and address are of. Only where one was found.
    [[nodiscard]] std::size_t item() const { return m_collider.m_placed[m_found].item; }

    /// The whole of the address that was found, which of a place's collider begins at a node. Cost: that of addressOf().
    [[nodiscard]] Address addressOf(const SurfacePoint &found) const;

private:
    /// An item at that distance, or not touched before that time.
    struct Waiting {
        double distance;
        std::size_t placed;
    };

    template<typename DistanceTo>
    void listItems(const DistanceTo &distanceTo);
    [[nodiscard]] Waiting takeNearest();
    Search &searchOf(const SceneCollider::Placed &placed);
    void searchItem(const SceneCollider::Placed &placed, const Query &query);
    void searchModel(Search &search, const Similarity &worldFromModel, const Query &query);
    void take(const SceneCollider::Placed &placed, Hit &hit);
    void sweepItem(const SceneCollider::Placed &placed, const Sweep &sweep);
    void take(const SceneCollider::Placed &placed, Touch &touch);
    void promise(const Query &query, bool isCutShort, Hit &hit) const;

    const SceneCollider &m_collider;
    /// By surface, each made when it is first needed.
    std::vector<std::unique_ptr<Search>> m_searches;
    /// A heap of the items that were not looked at, the nearest box on top.
    std::vector<Waiting> m_waiting;
    Hit m_ofItem;
    Touch m_touchOfItem;
    std::size_t m_found = 0;
};

}
