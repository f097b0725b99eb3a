// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "exactcollider.h"

#include <cassert>
#include <utility>

#include "branchandbound.h"
#include "localsweep.h"
#include "relativeframes.h"
#include "relativesweep.h"
#include "sweepsearch.h"

namespace romanesco {

namespace {

template<typename Closest, typename First>
class ExactSearch final : public Search
{
public:
    ExactSearch(Closest closest, First first)
        : m_closest(std::move(closest))
        , m_first(std::move(first))
    {
    }

    void closest(const Query &query, Hit &hit) override { m_closest.closest(query, hit); }
    void sweep(const Sweep &sweep, Touch &touch) override { m_first.sweep(sweep, touch); }

private:
    Closest m_closest;
    First m_first;
};

}

ExactCollider::ExactCollider(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &mesh, FaceTree tree,
                             double excess, const std::stop_token &stop)
    : m_graph(graph)
    , m_boxes(boxes)
    , m_mesh(mesh)
    , m_tree(std::move(tree))
    , m_faces(mesh)
    , m_excess(excess)
    , m_hulls(graph, boxes, mesh, stop)
    , m_products(graph)
    , m_inverses(LocalFrames::inverses(graph))
{
    assert(excess >= 0.0 && "no distance is less than the least");
}

std::expected<ExactCollider, std::string> ExactCollider::create(const FractalGraph &graph, const BoxBounds &boxes,
                                                                const Mesh &mesh, double excess,
                                                                const std::stop_token &stop)
{
    auto tree = FaceTree::build(mesh, stop);
    if (!tree) {
        return std::unexpected(std::move(tree.error()));
    }
    ExactCollider made(graph, boxes, mesh, std::move(*tree), excess, stop);
    if (stop.stop_requested()) {
        return std::unexpected("cancelled");
    }
    return made;
}

std::unique_ptr<Search> ExactCollider::search() const
{
    return searchBelow(Positions{0}, std::nullopt);
}

std::unique_ptr<Search> ExactCollider::searchPlaced(const AffineMap &worldFromModel) const
{
    return searchBelow(Positions{0}, worldFromModel);
}

std::unique_ptr<Search> ExactCollider::searchBelow(const Positions &state, const std::optional<AffineMap> &placed) const
{
    const auto with = [&]<typename OfPoints, typename OfSweeps>(OfPoints points, OfSweeps sweeps) {
        using Closest = BranchAndBound<OfPoints>;
        using First = SweepSearch<OfSweeps>;
        return std::make_unique<ExactSearch<Closest, First>>(
            Closest(m_graph, m_boxes, m_hulls, m_products, state, std::move(points), m_excess),
            First(m_graph, m_boxes, m_hulls, m_products, state, std::move(sweeps)));
    };
    if (m_inverses && !placed) {
        return with(LocalFrames(m_graph, *m_inverses, m_mesh, m_tree, m_faces),
                    LocalSweep(m_graph, *m_inverses, m_mesh, m_tree, m_faces));
    }
    const AffineMap map = placed.value_or(AffineMap{});
    return with(RelativeFrames(m_graph, m_mesh, m_tree, m_faces, map),
                RelativeSweep(m_graph, m_mesh, m_tree, m_faces, map));
}

std::size_t ExactCollider::memoryUse() const
{
    std::size_t bytes = sizeof(*this) - sizeof(m_tree) + m_tree.memoryUse() + m_faces.memoryUse() + m_hulls.memoryUse()
        + m_products.memoryUse();
    if (m_inverses) {
        bytes += m_inverses->capacity() * sizeof(m_inverses->front());
        for (const auto &ofSet : *m_inverses) {
            bytes += ofSet.capacity() * sizeof(LocalFrames::Inverse);
        }
    }
    return bytes;
}

}
