// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "mesh.h"

namespace romanesco {

Sphere boundingSphere(const Mesh &mesh)
{
    std::vector<bool> used(mesh.vertices.size());
    for (const auto &face : mesh.faces) {
        for (const std::uint32_t index : face) {
            used[index] = true;
        }
    }
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) {
            points.push_back(mesh.vertices[i]);
        }
    }
    return enclosingSphere(points);
}

}
