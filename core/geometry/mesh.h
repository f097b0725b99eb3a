// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "sphere.h"

namespace romanesco {

/// Triangles over shared vertices, in the mesh's own units. Every index is below vertices.size().
struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

/// A sphere round the vertices that faces use (stray vertices do not count); empty for a mesh without faces.
[[nodiscard]] Sphere boundingSphere(const Mesh &mesh);

}
