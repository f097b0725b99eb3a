// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <vector>

#include "copyring.h"
#include "core/geometry/image.h"
#include "core/geometry/mesh.h"
#include "glresources.h"
#include "mesharrays.h"

namespace romanesco {

/// Where the vertex shader reads what.
namespace attribute {
constexpr GLuint position = 0;
/// Three rows.
constexpr GLuint copy = 1;
constexpr GLuint tint = 4;
constexpr GLuint normal = 5;
constexpr GLuint textureCoordinates = 6;
constexpr GLuint colour = 7;
}

/// A base mesh on the card, as MeshArrays has it: three indices a face, and of attributes those that the mesh has.
struct GpuMesh {
    GlVertexArray array;
    GlBuffer positions;
    GlBuffer normals;
    GlBuffer textureCoordinates;
    GlBuffer colours;
    GlBuffer faces;
    std::vector<MeshArrays::Part> parts;
    std::size_t faceCount = 0;
    std::size_t bytes = 0;
};

/// base is the sphere round the mesh. Copies will be read from the ring.
[[nodiscard]] GpuMesh upload(const Mesh &mesh, const Sphere &base, const CopyRing &ring);

/// With all its smaller versions, to be repeated.
[[nodiscard]] GlTexture upload(const Image &image);

}
