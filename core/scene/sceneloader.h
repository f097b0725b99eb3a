// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/file.h"
#include "core/text/diagnostic.h"
#include "scene.h"

namespace romanesco {

enum class FileKind { Fdo, Obj, Other };
/// By the extension, whatever its case.
[[nodiscard]] FileKind fileKind(const std::filesystem::path &path);

/// A scene, or what keeps its text from being one.
struct SceneResult {
    /// Of the text that was loaded, sorted by place.
    Diagnostics diagnostics;
    /// Null after errors, and when stopped.
    std::shared_ptr<const Scene> scene;
};

/// Makes scenes from texts. Remembers the last mesh, so that a text that changes does not read its mesh anew. One
/// thread at a time.
class SceneLoader
{
public:
    /// files must outlive the loader.
    explicit SceneLoader(const FileAccess &files);

    /// text is an .fdo or .obj text by the ending of path; paths in it are relative to path's folder.
    [[nodiscard]] SceneResult load(const std::filesystem::path &path, std::string_view text, std::stop_token stop = {});

private:
    [[nodiscard]] SceneResult loadObj(std::string_view text);
    [[nodiscard]] std::shared_ptr<const Mesh> loadMesh(const std::filesystem::path &folder,
                                                       const FractalDescription &description, Diagnostics &diagnostics);

    const FileAccess &m_files;
    std::string m_meshText;
    std::shared_ptr<const Mesh> m_mesh;
};

}
