// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <string_view>

#include "core/formats/objreader.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const ObjResult result = readObj(text);
    require(result.diagnostics.size() <= 1);
    requireSound(result.diagnostics, text);
    for (const auto &face : result.mesh.faces) {
        require(face[0] < result.mesh.vertices.size() && face[1] < result.mesh.vertices.size()
                && face[2] < result.mesh.vertices.size());
    }
    for (const glm::dvec3 &vertex : result.mesh.vertices) {
        require(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z));
    }
    require(!std::isnan(boundingSphere(result.mesh).radius));
    return 0;
}
