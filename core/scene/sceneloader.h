// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/file.h"
#include "core/formats/sdosyntax.h"
#include "core/text/diagnostic.h"
#include "modellibrary.h"
#include "scene.h"

namespace romanesco {

enum class FileKind { Fdo, Sdo, Obj, Other };
/// By the extension, whatever its case.
[[nodiscard]] FileKind fileKind(const std::filesystem::path &path);

/// A scene, or what keeps its text from being one.
struct SceneResult {
    /// Of the text that was loaded, sorted by place. What is wrong with a file that it names is an error at the place of
    /// the name, with notes that lead into the file; so are warnings of a mesh or its materials a warning there.
    Diagnostics diagnostics;
    /// Null after errors, and when stopped.
    std::shared_ptr<const Scene> scene;
};

/// Makes scenes from texts. Remembers what it made of the files that the last sound text named, so that a text that
/// changes does not read its meshes and fractals anew. One thread at a time.
class SceneLoader
{
public:
    /// files must outlive the loader. Without a decoder textures have no pixels, which who does not draw has no need of.
    explicit SceneLoader(const FileAccess &files, ImageDecoder decoder = {});

    /// text is an .fdo, .sdo or .obj text by the ending of path (.fdo where it tells nothing); paths in it are relative to
    /// path's folder. The token is looked at between the files and the steps of each.
    [[nodiscard]] SceneResult load(const std::filesystem::path &path, std::string_view text, std::stop_token stop = {});

private:
    void checkFiles(const SdoSyntax &syntax, const std::filesystem::path &folder, Diagnostics &diagnostics,
                    const std::stop_token &stop);
    [[nodiscard]] SceneResult loadObj(const std::filesystem::path &folder, std::string_view text,
                                      const std::stop_token &stop);
    [[nodiscard]] SceneResult loadFdo(const std::filesystem::path &folder, std::string_view text,
                                      const std::stop_token &stop);
    [[nodiscard]] SceneResult loadSdo(const std::filesystem::path &folder, std::string_view text,
                                      const std::stop_token &stop);

    ModelLibrary m_library;
};

}
