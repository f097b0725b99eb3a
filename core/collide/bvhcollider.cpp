// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "bvhcollider.h"

#include <cassert>

#include "facesweep.h"
#include "nearest.h"
#include "sweeping.h"
#include "treesearch.h"

namespace romanesco {

namespace {

class BvhSearch final : public Search
{
public:
    BvhSearch(const Mesh &mesh, const FaceTree &tree)
        : m_mesh(mesh)
        , m_tree(mesh, tree)
        , m_sweep(mesh, tree)
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        const FaceRanking &ranking = m_tree.nearest(query.p, query.radius, query.motion);
        clear(hit);
        hit.lower = ranking.lower();
        hit.cost = {ranking.facesShown(), m_tree.nodeVisits()};
        if (ranking.face() == FaceRanking::none) {
            return;
        }
        const Triangle triangle = triangleOf(m_mesh, ranking.face());
        const ClosestPoint nearest = closestPoint(triangle, query.p);
        hit.lower = std::min(hit.lower, nearest.lower);
        if (nearest.distance <= query.radius) {
            hit.face = ranking.face();
            place(hit, nearest, triangle, query.p, query.motion);
        }
    }

    void sweep(const Sweep &sweep, Touch &touch) override
    {
        const Path path(sweep);
        SweptFace found;
        m_sweep.sweep(path.start, path.sphere, path.length, path.slack, found);
        clear(touch);
        touch.cost = {found.faceTests, found.nodeVisits};
        if (found.face != Mesh::none) {
            touch.face = found.face;
            place(touch, path, found.way, found.triangle);
        }
        prove(touch, path, found.lower, sweep);
    }

private:
    const Mesh &m_mesh;
    TreeSearch m_tree;
    FaceSweep m_sweep;
};

}

std::expected<BvhCollider, std::string> BvhCollider::create(const Mesh &mesh, const std::stop_token &stop)
{
    auto tree = FaceTree::build(mesh, stop);
    if (!tree) {
        return std::unexpected(std::move(tree.error()));
    }
    return BvhCollider(mesh, std::move(*tree));
}

std::unique_ptr<Search> BvhCollider::search() const
{
    return std::make_unique<BvhSearch>(m_mesh, m_tree);
}

std::size_t BvhCollider::memoryUse() const
{
    return sizeof(*this) - sizeof(m_tree) + m_tree.memoryUse();
}

}
