// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <string>

#include "copysource.h"
#include "core/base/bytesink.h"

namespace romanesco {

/// What a binary STL file holds at most.
constexpr std::uint64_t mostStlFaces = 0xFFFF'FFFF;

constexpr std::uint64_t stlBytesOfFace = 50;

/// Writes copies as binary STL, in memory that does not grow with their number: triangles with a normal each, of length
/// 1, or 0 where the triangle has no area. Coordinates pass unchanged but for being rounded to floats; comment is cut to
/// what the header holds. Refused, before a byte is written, for more faces than a file can hold; the error is else the
/// source's or the sink's, or tells that a coordinate is beyond floats.
[[nodiscard]] std::expected<void, std::string> writeStl(const CopySource &copies, const std::string &comment,
                                                        ByteSink &sink);

}
