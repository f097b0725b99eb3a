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
        NearestFace nearest(m_mesh, query);
        CopyWalk copies(m_graph, CopyWalk::Addresses::Keep, query.stop);
        hit.address.clear();
        while (copies.next()) {
            if (nearest.consider(m_worldFromModel * copies.modelFromBase(), NearestFace::Counted::Ahead, m_vertices)) {
                hit.address.assign(copies.address().begin(), copies.address().end());
            }
        }
        const bool isCutShort = query.stop.stop_requested();
        report(nearest, query, isCutShort ? Promise::UpperBound : Promise::Exact, hit);
    }

    void sweep(const Sweep &sweep, Touch &touch) override
    {
        const Path path(sweep);
        FirstTouch first(m_mesh, path);
        CopyWalk copies(m_graph, CopyWalk::Addresses::Keep, sweep.stop);
        clear(touch);
        while (copies.next()) {
            if (first.consider(m_worldFromModel * copies.modelFromBase(), m_vertices)) {
                touch.address.assign(copies.address().begin(), copies.address().end());
            }
        }
        first.report(sweep, touch);
        if (sweep.stop.stop_requested()) {
            touch.promise = Promise::UpperBound;
            touch.lower = 0.0;
        }
    }

private:
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
