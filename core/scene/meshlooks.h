// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/file.h"
#include "core/formats/objreader.h"
#include "textures.h"

namespace romanesco {

/// The materials of a mesh as MTL files describe them.
struct MeshLooks {
    std::vector<Material> materials;
    /// Warnings of the OBJ text, with notes that lead into the MTL files.
    Diagnostics diagnostics;
};

/// Reads the MTL files that an OBJ text in a folder names ("\\" is "/" too). The first material of a name counts; what is
/// missing or wrong costs a warning and leaves the default's look. named has the names.
[[nodiscard]] MeshLooks looksOf(const FileAccess &files, Textures &textures, const std::filesystem::path &folder,
                                const std::vector<Material> &named, const ObjResult::Sources &sources);

}
