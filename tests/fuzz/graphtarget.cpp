// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include "core/formats/fdoreader.h"
#include "core/fractal/counts.h"
#include "core/fractal/extent.h"
#include "core/fractal/statetable.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

namespace {

/// Some states from the root on, the first child of each.
void look(const FractalGraph &graph)
{
    StateTable table(graph);
    StateId state = table.root();
    for (int i = 0; i < 20; ++i) {
        const Expansion &expansion = table.expansion(state);
        require(expansion.hasLeaf || !expansion.ranges.empty());
        if (expansion.ranges.empty()) {
            break;
        }
        state = expansion.ranges.front().next;
        require(!std::isnan(table.state(state).bound.radius));
    }
}

}

/// What follows from a text that is right; one that is not is fuzz_fdo's.
int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const FdoResult result = readFdo(std::string_view(reinterpret_cast<const char *>(data), size));
    if (!result.description) {
        return -1; // not worth keeping as a seed
    }
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces.push_back({0, 1, 2}); // GCC 14 with its address sanitizer warns of a list, wrongly
    const auto graph = FractalGraph::build(*result.description, boundingSphere(mesh));
    if (graph) {
        require(std::isfinite(graph->bound(0).radius));
        look(*graph);
        const BoxBounds boxes(*graph, mesh);
        const Box box = extent(*graph, boxes, mesh, 1'000);
        require(box.least.x <= box.greatest.x && box.least.y <= box.greatest.y && box.least.z <= box.greatest.z);
        require(!instancesAsWritten(*graph).toString().empty());
    }
    return 0;
}
