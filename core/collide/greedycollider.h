// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <string>
#include <vector>

#include "collider.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// The dissertation's collider for fractals (4.4.3), as it is: in each of d steps it puts the base mesh, of b faces, into
/// each of the t transformations of an iteration, and goes on in the one that is nearest: b·t·d faces. It is called fully
/// accurate there, but a base mesh bounds nothing of what grows on it: Promise::UpperBound. Kept for comparison.
///
/// A sweep, of which the dissertation has none, goes on in the one that the sphere touches first, or, where it touches
/// none, in the one that is nearest to its start.
///
/// A step is an iteration of an innermost recursive; levels that are in none are a step each, and so are those of an
/// iteration of more than 10^5 transformations. `#` is one of the t.
class GreedyCollider final : public Collider
{
public:
    /// Both must outlive it; the graph is of that mesh. The error is a sentence: a fractal of more than 10^6 levels.
    [[nodiscard]] static std::expected<GreedyCollider, std::string> create(const FractalGraph &graph, const Mesh &mesh);

    /// The address of what is found has its picks where the steps made them, which may be later than the canonical word
    /// has them.
    [[nodiscard]] std::unique_ptr<Search> search() const override { return searchPlaced({}); }
    [[nodiscard]] std::unique_ptr<Search> searchPlaced(const AffineMap &worldFromModel) const override;
    [[nodiscard]] std::size_t memoryUse() const override;

private:
    class Descent;

    GreedyCollider(const FractalGraph &graph, const Mesh &mesh);

    const FractalGraph &m_graph;
    const Mesh &m_mesh;
    /// The transformations of each step: by repeat where an iteration is one, else empty; and by slot. Those of several
    /// levels in order, the pick of the first level changing last, `#` the last of its level.
    std::vector<std::vector<AffineMap>> m_ofIteration;
    std::vector<std::vector<AffineMap>> m_ofSlot;
};

}
