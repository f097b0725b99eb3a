// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <string>

#include "copysource.h"
#include "core/base/bytesink.h"

namespace romanesco {

/// Indices in a PLY file have 32 bits.
constexpr std::uint64_t mostPlyVertices = 0x1'0000'0000;

/// What vertices and faces take beside the header.
[[nodiscard]] constexpr std::uint64_t plyBytesOfVertex(bool hasColours)
{
    return hasColours ? 27 : 24;
}
constexpr std::uint64_t plyBytesOfFace = 13;

/// Writes copies as binary PLY, least significant byte first, in memory that does not grow with their number, for which the
/// copies are visited twice: all vertices as doubles, unchanged, then all faces. Each copy has vertices of its own, which
/// its faces share. Vertices have colours (bytes) where a mesh has them. Normals, texture coordinates and materials are
/// left out. Refused, before a byte is written, for more vertices than indices can name; the error is else the source's or
/// the sink's.
[[nodiscard]] std::expected<void, std::string> writePly(const CopySource &copies, const std::string &comment,
                                                        ByteSink &sink);

}
