// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include "core/geometry/mesh.h"
#include "glresources.h"

namespace romanesco {

/// A base mesh on the card: three floats a vertex, in units of the sphere round the mesh, and three indices a face.
struct GpuMesh {
    GlBuffer vertices;
    GlBuffer faces;
    GLsizei indexCount = 0;
    std::size_t faceCount = 0;
    std::size_t bytes = 0;
};

/// base is the sphere round the mesh: in its units floats suffice wherever the mesh lies and however large it is.
[[nodiscard]] GpuMesh upload(const Mesh &mesh, const Sphere &base);

}
