// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "collider.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// Looks at every face of every copy: Promise::Exact. The dissertation's object collider (4.4.2), with all three edges of
/// a face, and the oracle of all others. A query costs half a microsecond or so a face, and allocates; it never ends on
/// a fractal of too many copies.
class SimpleCollider final : public Collider
{
public:
    /// Both must outlive it; the graph is of that mesh.
    SimpleCollider(const FractalGraph &graph, const Mesh &mesh);

    [[nodiscard]] std::unique_ptr<Search> search() const override { return searchPlaced({}); }
    [[nodiscard]] std::unique_ptr<Search> searchPlaced(const AffineMap &worldFromModel) const override;
    [[nodiscard]] std::size_t memoryUse() const override { return sizeof(*this); }

private:
    const FractalGraph &m_graph;
    const Mesh &m_mesh;
};

}
