// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include "core/collide/collider.h"
#include "core/geometry/mesh.h"

namespace romanesco::bench {

/// CGAL's AABB tree of triangles, in double precision, with the points from which it guesses where to begin. It tells no
/// costs.
class CgalCollider final : public Collider
{
public:
    explicit CgalCollider(const Mesh &all);
    ~CgalCollider() override;

    [[nodiscard]] std::unique_ptr<Search> search() const override;
    /// What the heap grew by when it was built, triangles with it.
    [[nodiscard]] std::size_t memoryUse() const override { return m_bytes; }

private:
    class Tree;
    class Descent;

    std::unique_ptr<Tree> m_tree;
    std::size_t m_bytes;
};

}
