// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace romanesco {

enum class ExportFormat { Obj, Ply, Stl, Glb };

/// By the extension, whatever its case.
[[nodiscard]] std::optional<ExportFormat> exportFormat(const std::filesystem::path &path);

struct ExportOptions {
    ExportFormat format = ExportFormat::Obj;
    /// Significant digits of each number in an OBJ, from 1 to 17; none for the shortest that read back alike.
    std::optional<int> digits = {};
    /// An OBJ has a group for each branch, in place of the groups of the meshes.
    bool isGrouped = false;
    /// Vertices that coincide are merged, and walls inside are dropped: see weld().
    bool isWelded = false;
    /// What the scene is called in the file; the item of a scene of one has its name from it too.
    std::string source = {};
};

}
