// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <string>

#include "core/fractal/boxbounds.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// What an .fdo or an .obj file holds: a base mesh and the graph of its copies, in coordinates of their own. Immutable.
struct Model {
    std::shared_ptr<const Mesh> mesh;
    FractalGraph graph;
    BoxBounds boxes;
    /// Holds the whole fractal.
    Box extent;
    /// The mesh's path as the .fdo writes it; empty for a mesh by itself.
    std::string meshPath;
};

}
