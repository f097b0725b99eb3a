// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// A binary tree of boxes round the faces of a mesh. Boxes are exact: the least and greatest coordinates of vertices.
///
/// Built from above; a node is divided where the surface area of the two boxes, weighted by their faces, is least, out of
/// 15 planes along each axis (MacDonald and Booth 1990, binned as by Wald 2007); in halves where that leads nowhere.
/// Immutable; any number of threads may read it.
class FaceTree
{
public:
    struct Node {
        Box box;
        /// Of a leaf, its first face in faces(). Else the first of two nodes side by side.
        std::uint32_t first = 0;
        /// Faces of a leaf; 0 where the node is divided.
        std::uint32_t faceCount = 0;
    };

    /// No way from the root to a leaf passes more nodes.
    static constexpr std::size_t mostDepth = 96;
    static constexpr std::uint32_t mostFacesOfLeaf = 4;

    /// The error is a sentence: a vertex of a face that is not finite or above 1e300, more than 2^31 faces, or cancelled.
    /// Cost: about a microsecond a face, and 60 bytes beside what is kept.
    [[nodiscard]] static std::expected<FaceTree, std::string> build(const Mesh &mesh, const std::stop_token &stop = {});

    /// The root first; none for a mesh without faces.
    [[nodiscard]] std::span<const Node> nodes() const { return m_nodes; }
    /// Numbers of the mesh's faces, those of a leaf together and in order.
    [[nodiscard]] std::span<const std::uint32_t> faces() const { return m_faces; }

    /// Bytes held.
    [[nodiscard]] std::size_t memoryUse() const;

private:
    class Builder;
    FaceTree() = default;

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_faces;
};

}
