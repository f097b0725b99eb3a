// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/fractal/statetable.h"

namespace romanesco {

/// What tells copies apart: their own materials; how many maps led to them; the outermost of these, or how far along
/// a chain of one map they begin; or the set of the innermost.
enum class Colouring { Materials, Depth, Branch, Set };

/// Copies that stand out: all that some steps from the root of an item of a scene lead to; without any the whole item.
struct Selection {
    std::size_t item = 0;
    std::vector<Step> steps;

    bool operator==(const Selection &) const = default;
};

/// Copies that stand out: all that a map leads to, wherever it is picked.
struct MapSelection {
    std::size_t item = 0;
    Step map;

    bool operator==(const MapSelection &) const = default;
};

/// How the copies of a scene are coloured.
struct CopyColours {
    Colouring colouring = Colouring::Materials;
    std::optional<Selection> selection;
    std::optional<MapSelection> map = {};

    bool operator==(const CopyColours &) const = default;
};

/// How surfaces are drawn.
struct Appearance {
    CopyColours colours{};
    /// By the normals that a mesh has; else each face as a plane.
    bool isSmooth = true;
    /// By the scene's lights, or one that rides with the camera; else surfaces have their own colour alone.
    bool isLit = true;
    bool hasTextures = true;
    /// With the edges of all triangles that are some pixels large.
    bool hasWires = false;

    bool operator==(const Appearance &) const = default;
};

}
