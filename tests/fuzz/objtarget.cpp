// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/formats/objreader.h"
#include "core/text/linemap.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

namespace {

/// Always on, unlike assert().
void require(bool holds)
{
    if (!holds) {
        std::abort();
    }
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const ObjResult result = readObj(text);
    require(result.diagnostics.size() <= 1);
    for (const Diagnostic &diagnostic : result.diagnostics) {
        require(diagnostic.range.begin <= diagnostic.range.end && diagnostic.range.end <= size);
        require(!toLines(diagnostic, "a.obj", LineMap(text)).empty());
    }
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
