// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>

#include "core/formats/copysource.h"

namespace romanesco {

/// Welding holds all faces in memory, some 80 bytes each.
constexpr std::uint64_t mostWeldedFaces = 10'000'000;

/// What welding found.
struct WeldReport {
    /// Vertices that differ by no more in any coordinate are one.
    double tolerance = 0.0;
    std::uint64_t mergedVertices = 0;
    /// Faces that lay between two solids.
    std::uint64_t droppedWalls = 0;
    /// Faces of which two corners became one, and those that were there already.
    std::uint64_t droppedFaces = 0;
    /// Edges that are not passed as often in one direction as in the other: holes and rims.
    std::uint64_t openEdges = 0;

    [[nodiscard]] bool isClosed() const { return openEdges == 0; }
};

struct Welded {
    /// Without normals: they belonged to the single copies.
    Mesh mesh;
    WeldReport report;
};

/// All copies as one mesh. Vertices that coincide become one; of faces that then coincide one is kept, or none where two
/// look to opposite sides, since such a wall lies inside; vertices that no face needs are dropped. Colours are those of
/// the first vertex of several; texture coordinates, materials, smoothing and groups (a copy's branch in place of its
/// mesh's own) stay with their faces.
///
/// They coincide within a millionth of the shortest edge of any copy, or, where that is more, within the rounding error of
/// coordinates, 1e-13 of the greatest. Where that error comes near the shortest edge welding is refused, as it is beyond
/// mostWeldedFaces. A vertex joins the first within reach, so that chains of them do not run together. Cost: three
/// visits, and linear in what they give.
[[nodiscard]] std::expected<Welded, std::string> weld(const CopySource &copies, const std::stop_token &stop);

}
