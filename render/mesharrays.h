// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/mesh.h"

namespace romanesco {

/// A base mesh as a graphics card takes it: arrays beside one another, a row for each corner that differs, in units of the
/// sphere round the mesh. Attributes that the mesh does not have are empty.
struct MeshArrays {
    std::vector<std::array<float, 3>> positions;
    /// Of length 1, or 0 where a face is flat.
    std::vector<std::array<float, 3>> normals;
    /// The image's first row, its top, is at 0.
    std::vector<std::array<float, 2>> textureCoordinates;
    std::vector<std::array<float, 3>> colours;
    std::vector<Mesh::Face> faces;

    /// Faces of one material; each material has one part at most.
    struct Part {
        std::size_t firstFace = 0;
        std::size_t faceCount = 0;
        /// In Mesh::materials, or Mesh::none.
        std::uint32_t material = Mesh::none;
    };
    std::vector<Part> parts;
};

/// base is the sphere round the mesh: in its units floats suffice wherever the mesh lies and however large it is. Normals
/// are the mesh's own; faces of a smoothing group that have none get the mean of the group's planes round each vertex,
/// by angle (Thürmer and Wüthrich 1998). Cost: linear in the mesh but for finding equal corners.
[[nodiscard]] MeshArrays arraysOf(const Mesh &mesh, const Sphere &base);

}
