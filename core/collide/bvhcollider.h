// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "collider.h"
#include "facetree.h"

namespace romanesco {

/// For an ordinary mesh: Promise::Exact, by branch and bound in a tree of boxes. `distance` and `lower` are at most
/// 64·u·M apart, with u = 2^-53 and M the greatest distance along an axis to a vertex of the faces that were looked at;
/// what is told apart by less is decided by rounding, then by the face's number, never by the tree.
///
/// Sweeps are bounded by boxes, which are as good as the sphere is large beside them: `lower` is proved, and no other face
/// is touched before `time` but by less than Touch tells.
///
/// A query costs about a microsecond where 10^5 faces are spread out, and never allocates. Where many faces are equally
/// far, all of those are looked at.
class BvhCollider final : public Collider
{
public:
    /// The mesh must outlive it. The error is a sentence: a vertex of a face that is not finite or above 1e300, more
    /// than 2^31 faces, or cancelled. Cost: about a microsecond and 110 bytes a face.
    [[nodiscard]] static std::expected<BvhCollider, std::string> create(const Mesh &mesh,
                                                                        const std::stop_token &stop = {});

    /// Addresses are empty.
    [[nodiscard]] std::unique_ptr<Search> search() const override;
    [[nodiscard]] std::size_t memoryUse() const override;

private:
    BvhCollider(const Mesh &mesh, FaceTree tree)
        : m_mesh(mesh)
        , m_tree(std::move(tree))
    {
    }

    const Mesh &m_mesh;
    FaceTree m_tree;
};

}
