// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "gpumesh.h"

#include <array>
#include <vector>

namespace romanesco {

GpuMesh upload(const Mesh &mesh, const Sphere &base)
{
    std::vector<std::array<float, 3>> vertices;
    vertices.reserve(mesh.vertices.size());
    const double scale = base.radius > 0.0 ? 1.0 / base.radius : 1.0;
    for (const glm::dvec3 &vertex : mesh.vertices) {
        const glm::dvec3 unit = (vertex - base.centre) * scale;
        vertices.push_back({static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)});
    }
    const std::size_t vertexBytes = vertices.size() * sizeof(vertices[0]);
    const std::size_t faceBytes = mesh.faces.size() * sizeof(mesh.faces[0]);
    GpuMesh made{makeBuffer(), makeBuffer(), static_cast<GLsizei>(mesh.faces.size() * 3), mesh.faces.size(),
                 vertexBytes + faceBytes};
    glNamedBufferStorage(made.vertices, static_cast<GLsizeiptr>(vertexBytes), vertices.data(), 0);
    glNamedBufferStorage(made.faces, static_cast<GLsizeiptr>(faceBytes), mesh.faces.data(), 0);
    return made;
}

}
