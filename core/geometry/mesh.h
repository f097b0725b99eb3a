// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "material.h"
#include "sphere.h"

namespace romanesco {

/// Triangles over shared vertices, in the mesh's own units. Every index is below the size of what it points into, or
/// `none` where that is allowed. Attributes that a mesh does not have are empty.
struct Mesh {
    using Face = std::array<std::uint32_t, 3>;
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<glm::dvec3> vertices;
    std::vector<Face> faces;

    /// Beside vertices: red, green, blue from 0 to 1.
    std::vector<glm::vec3> colours{};
    std::vector<glm::dvec2> textureCoordinates{};
    /// Need not have length 1.
    std::vector<glm::dvec3> normals{};
    /// Beside faces: what each corner has of the two lists above; `none` at corners without.
    std::vector<Face> faceTextureCoordinates{};
    std::vector<Face> faceNormals{};

    /// A run of faces, to the first face of the next part, that look and belong alike.
    struct Part {
        std::uint32_t firstFace = 0;
        /// In materials, or none.
        std::uint32_t material = none;
        /// In groups, or none.
        std::uint32_t group = none;
        /// Faces of a smoothing group are shaded as one surface; 0 are flat.
        std::uint32_t smoothing = 0;
    };
    /// In order of their faces; empty, or the first starts at face 0.
    std::vector<Part> parts{};
    std::vector<Material> materials{};
    std::vector<std::string> groups{};
};

/// The vertices that faces use, each once, in their order.
[[nodiscard]] std::vector<glm::dvec3> usedVertices(const Mesh &mesh);

/// A sphere round the vertices that faces use (stray vertices do not count); empty for a mesh without faces.
[[nodiscard]] Sphere boundingSphere(const Mesh &mesh);

}
