// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "mesh.h"

namespace romanesco {

std::vector<glm::dvec3> usedVertices(const Mesh &mesh)
{
    std::vector<bool> isUsed(mesh.vertices.size());
    for (const Mesh::Face &face : mesh.faces) {
        for (const std::uint32_t index : face) {
            isUsed[index] = true;
        }
    }
    std::vector<glm::dvec3> vertices;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i]) {
            vertices.push_back(mesh.vertices[i]);
        }
    }
    return vertices;
}

Sphere boundingSphere(const Mesh &mesh)
{
    return enclosingSphere(usedVertices(mesh));
}

}
