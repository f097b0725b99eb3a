// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "simplecollider.h"

#include "core/fractal/copies.h"
#include "nearest.h"

namespace romanesco {

namespace {

class SimpleSearch final : public Search
{
public:
    SimpleSearch(const FractalGraph &graph, const Mesh &mesh)
        : m_graph(graph)
        , m_mesh(mesh)
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        NearestFace nearest(m_mesh, query.p);
        CopyWalk copies(m_graph, CopyWalk::Addresses::Keep);
        hit.address.clear();
        while (copies.next()) {
            if (nearest.consider(copies.modelFromBase(), m_vertices)) {
                hit.address.assign(copies.address().begin(), copies.address().end());
            }
        }
        report(nearest, query, Promise::Exact, hit);
    }

private:
    const FractalGraph &m_graph;
    const Mesh &m_mesh;
    std::vector<glm::dvec3> m_vertices;
};

}

SimpleCollider::SimpleCollider(const FractalGraph &graph, const Mesh &mesh)
    : m_graph(graph)
    , m_mesh(mesh)
{
}

std::unique_ptr<Search> SimpleCollider::search() const
{
    return std::make_unique<SimpleSearch>(m_graph, m_mesh);
}

}
