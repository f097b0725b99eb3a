// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <optional>
#include <stop_token>
#include <string>

#include "collider.h"
#include "core/fractal/boxbounds.h"
#include "core/fractal/fractalgraph.h"
#include "core/fractal/hullbounds.h"
#include "core/geometry/mesh.h"
#include "equalproducts.h"
#include "facetree.h"
#include "leaffaces.h"
#include "localframes.h"

namespace romanesco {

/// Finds the nearest point of a fractal by branch and bound on its graph, at any depth: Promise::Exact. With an excess,
/// distances are at most (1 + excess) times the least, and it takes less: Promise::Within. Nothing within a query's radius
/// is exact in any case.
///
/// `distance` and `lower` differ by rounding: some units in the last place of the distance for each level that was gone
/// down, and of the coordinates of p. A branch that is smaller than that, or than the excess in parts of its distance, is
/// not gone down: it is found as a whole, its address is where it begins, and there is no face; the point is no farther
/// from the surface than the branch is large, and the distance may be as much too small. Below 1e-140, where squares are
/// no numbers of all digits, distances of fractals that are no larger themselves are not to be trusted.
///
/// Sweeps are exact whatever the excess: a time may be late only by what Touch tells, which is what keeps copies that are
/// touched at once from being looked at one by one. `lower` is proved of the fractal itself, all rounding counted. Nothing
/// is promised of one that grows beyond all doubles. A microsecond or three on the fractals of docs/colliders.md, some ten
/// with twenty levels more.
///
/// Where all maps are similarities p is taken into the frame of each copy; else copies are bounded by their parallelepipeds
/// seen from p, at two or three times the cost.
class ExactCollider final : public Collider
{
public:
    /// All must outlive it; graph and boxes are of that mesh. The error is a sentence: see FaceTree::build().
    [[nodiscard]] static std::expected<ExactCollider, std::string> create(const FractalGraph &graph,
                                                                          const BoxBounds &boxes, const Mesh &mesh,
                                                                          double excess = 0.0,
                                                                          const std::stop_token &stop = {});

    [[nodiscard]] std::unique_ptr<Search> search() const override;
    [[nodiscard]] std::unique_ptr<Search> searchPlaced(const AffineMap &worldFromModel) const override;
    [[nodiscard]] std::unique_ptr<Search> searchBelow(const Positions &state,
                                                      const std::optional<AffineMap> &placed) const override;
    [[nodiscard]] std::size_t memoryUse() const override;

    /// Whether p is taken into the frames.
    [[nodiscard]] bool usesLocalFrames() const { return m_inverses.has_value(); }

private:
    ExactCollider(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &mesh, FaceTree tree, double excess,
                  const std::stop_token &stop);

    const FractalGraph &m_graph;
    const BoxBounds &m_boxes;
    const Mesh &m_mesh;
    FaceTree m_tree;
    LeafFaces m_faces;
    double m_excess;
    HullBounds m_hulls;
    EqualProducts m_products;
    std::optional<LocalFrames::Inverses> m_inverses;
};

}
