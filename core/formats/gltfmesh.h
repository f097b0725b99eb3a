// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "materialtable.h"

namespace romanesco {

/// Faces of one material, over vertices of which each has one position, one normal and so on, as graphics cards want them
/// and glTF has them: an OBJ's corners have an index for each.
struct GltfPrimitive {
    /// In the MaterialTable, or Mesh::none.
    std::uint32_t material = Mesh::none;
    struct Vertex {
        std::uint32_t position;
        /// Mesh::none where the corner has none.
        std::uint32_t textureCoordinates;
        std::uint32_t normal;
        auto operator<=>(const Vertex &) const = default;
    };
    std::vector<Vertex> vertices;
    std::vector<Mesh::Face> faces;
    /// Whether all vertices have a normal; and some texture coordinates, or the material a texture, which needs them.
    bool hasNormals = false;
    bool hasTextureCoordinates = false;
    bool hasColours = false;

    /// Bytes of a vertex in the file: position, normal, texture coordinates and colour, one after the other.
    [[nodiscard]] std::uint32_t stride() const
    {
        return 12 + (hasNormals ? 12 : 0) + (hasTextureCoordinates ? 8 : 0) + (hasColours ? 12 : 0);
    }
};

/// A primitive for each material of the mesh. Cost: a search for each corner.
[[nodiscard]] std::vector<GltfPrimitive> primitivesOf(const Mesh &mesh, const MaterialTable &materials);

}
