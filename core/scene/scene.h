// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/fractal/fractalgraph.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// What is drawn: a base mesh and the graph of its copies. Immutable, so it is passed between threads as it is.
struct Scene {
    std::shared_ptr<const Mesh> mesh;
    FractalGraph graph;
    /// Holds the whole fractal.
    Box extent;
    /// As written in the text: the mesh's path, and the number that a depth slider moves.
    std::string meshPath;
    std::optional<FractalDescription::Depth> depth;
};

}
