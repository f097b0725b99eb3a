// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

#include "copysource.h"
#include "core/base/bytesink.h"
#include "materialtable.h"

namespace romanesco {

struct ObjOptions {
    /// What the file says of itself in its first line.
    std::string comment = {};
    /// Significant digits of each number, from 1 to 17; none for the shortest that read back as the same double.
    std::optional<int> digits = {};
    /// File name of the materials, which mtlText() makes; without one materials are left out.
    std::string materialLibrary = {};
};

/// Writes copies as Wavefront OBJ, in memory that does not grow with their number. Coordinates pass unchanged. Each copy
/// has vertices of its own, which its faces share; normals go along with it, and the faces of a mirrored copy are turned,
/// so that they look outwards still. Texture coordinates stand once for each mesh. Parts keep their material, their
/// smoothing, and their group; where a copy has a branch, that is its group. The error is the sink's or the source's.
/// Cost: about 1.5 ns a byte.
[[nodiscard]] std::expected<void, std::string> writeObj(const CopySource &copies, const ObjOptions &options,
                                                        ByteSink &sink);

/// The materials as a Wavefront MTL file in a folder, from where the paths of textures start.
[[nodiscard]] std::string mtlText(const MaterialTable &materials, const std::filesystem::path &folder);

}
