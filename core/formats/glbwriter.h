// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "copysource.h"
#include "core/base/bytesink.h"

namespace romanesco {

/// Sizes and places in a GLB have 32 bits.
constexpr std::uint64_t mostGlbBytes = 0xFFFF'FFFF;
/// What a copy takes of an item whose copies are instances.
constexpr std::uint64_t glbBytesOfInstance = 40;
/// What a copy of the mesh takes where it is not.
[[nodiscard]] std::uint64_t glbBytesOfCopy(const Mesh &mesh);

struct GlbOptions {
    /// What the file says of itself.
    std::string comment = {};
    /// The bytes of an image; nothing where it cannot be read. Asked for once each.
    std::function<std::optional<std::string>(const std::filesystem::path &)> readImage = {};
};

struct GlbReport {
    /// Copies that are written out with all their vertices.
    std::uint64_t bakedCopies = 0;
    /// Images that are left out: they cannot be read, or are neither PNG nor JPEG.
    std::uint64_t missingImages = 0;
};

/// Writes copies as binary glTF 2.0, in memory that does not grow with their number. Of an item whose copies are all
/// translation, rotation and scale (see trsOf()) the mesh stands in the file once, with EXT_mesh_gpu_instancing, which
/// readers must know; mirrored copies have a node of their own, whose scale is negative. Other items are baked: one
/// mesh of all copies. glTF is right-handed: z is negated, and faces are turned so that they look outwards still. All
/// numbers are floats. A material becomes metallic-roughness without metal; PNG and JPEG textures are embedded.
///
/// Copies are visited several times: to find out which they are and how far they reach, and for each part of the file.
/// Refused, before a byte is written, for what GLB or floats cannot hold; the error is else the source's or the sink's.
[[nodiscard]] std::expected<GlbReport, std::string> writeGlb(const CopySource &copies, const GlbOptions &options,
                                                             ByteSink &sink);

}
