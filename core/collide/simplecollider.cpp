// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "simplecollider.h"

#include "core/fractal/copies.h"
#include "nearest.h"
#include "sweeping.h"

namespace romanesco {

namespace {

class SimpleSearch final : public Search
{
public:
    SimpleSearch(const FractalGraph &graph, const Mesh &mesh, const AffineMap &worldFromModel)
        : m_graph(graph)
        , m_mesh(mesh)
        , m_worldFromModel(worldFromModel)
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        Query fromPoint = query;
        fromPoint.p = {};
        const AffineMap seen = seenFrom(query.p);
        NearestFace nearest(m_mesh, fromPoint);
        CopyWalk copies(m_graph, CopyWalk::Addresses::Keep, query.stop);
        hit.address.clear();
        while (copies.next()) {
            if (nearest.consider(seen * copies.modelFromBase(), NearestFace::Counted::Ahead, m_vertices)) {
                hit.address.assign(copies.address().begin(), copies.address().end());
            }
        }
        const bool isCutShort = query.stop.stop_requested();
        report(nearest, fromPoint, isCutShort ? Promise::UpperBound : Promise::Exact, hit);
        if (hit.isFound()) {
            hit.point += query.p;
        }
    }

    void sweep(const Sweep &sweep, Touch &touch) override
    {
        Sweep fromStart = sweep;
        fromStart.p = {};
        const AffineMap seen = seenFrom(sweep.p);
        const Path path(fromStart);
        FirstTouch first(m_mesh, path);
        CopyWalk copies(m_graph, CopyWalk::Addresses::Keep, sweep.stop);
        clear(touch);
        while (copies.next()) {
            if (first.consider(seen * copies.modelFromBase(), m_vertices)) {
                touch.address.assign(copies.address().begin(), copies.address().end());
            }
        }
        first.report(fromStart, touch);
        touch.point += sweep.p;
        if (sweep.stop.stop_requested()) {
            touch.promise = Promise::UpperBound;
            touch.lower = 0.0;
        }
    }

private:
    /// Places all as it is seen from p, so that what both are far from does not count.
    [[nodiscard]] AffineMap seenFrom(const glm::dvec3 &p) const
    {
        return {m_worldFromModel.linear, m_worldFromModel.translation - p};
    }

    const FractalGraph &m_graph;
    const Mesh &m_mesh;
    AffineMap m_worldFromModel;
    std::vector<glm::dvec3> m_vertices;
};

}

SimpleCollider::SimpleCollider(const FractalGraph &graph, const Mesh &mesh)
    : m_graph(graph)
    , m_mesh(mesh)
{
}

std::unique_ptr<Search> SimpleCollider::searchPlaced(const AffineMap &worldFromModel) const
{
    return std::make_unique<SimpleSearch>(m_graph, m_mesh, worldFromModel);
}

}
