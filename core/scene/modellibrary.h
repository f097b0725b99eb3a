// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/file.h"
#include "core/formats/fdosyntax.h"
#include "core/formats/fractaldescription.h"
#include "core/formats/objreader.h"
#include "core/text/diagnostic.h"
#include "filetrouble.h"
#include "model.h"
#include "textures.h"

namespace romanesco {

/// The models of files, with the looks that MTL files give their meshes. Each file is read once in a round and made into
/// a model once, however often it is named; what was made of it is kept for the next rounds as long as its bytes stay the
/// same. One thread at a time.
class ModelLibrary
{
public:
    /// files must outlive the library. Without a decoder textures have no pixels.
    explicit ModelLibrary(const FileAccess &files, ImageDecoder decoder = {});

    /// From here on files are looked at anew.
    void beginRound();
    /// Forgets the files that were not asked for in this round.
    void dropUnused();

    struct ModelResult {
        /// Null after errors, and when stopped.
        std::shared_ptr<const Model> model;
        /// An error where there is no model; else what there is to warn of.
        std::optional<FileTrouble> trouble;
    };
    /// Of an .fdo or .obj file, by its ending.
    [[nodiscard]] ModelResult model(const std::filesystem::path &path, const std::stop_token &stop);

    struct TextResult {
        /// Sorted by place.
        Diagnostics diagnostics;
        /// Null after errors, and when stopped.
        std::shared_ptr<const Model> model;
    };
    /// Of an .obj text that lies, or will lie, in a folder.
    [[nodiscard]] TextResult object(const std::filesystem::path &folder, std::string_view text,
                                    const std::stop_token &stop);

    /// Of an .fdo text that lies, or will lie, in a folder.
    struct Fractal : TextResult {
        std::optional<FractalDescription::Depth> depth;
        /// The text is sound enough to say which mesh it needs.
        bool namesItsMesh = false;
    };
    [[nodiscard]] Fractal fractal(const std::filesystem::path &folder, std::string_view text,
                                  const std::stop_token &stop);

private:
    struct Entry {
        std::string text;
        bool isRead = false;
        std::shared_ptr<const Model> model;

        // of an .obj
        std::shared_ptr<const Mesh> mesh;
        ObjResult::Sources sources;
        Diagnostics warnings;

        // of this round
        bool isUsed = false;
        std::optional<FileTrouble> trouble;
        bool hasLooks = false;
        std::optional<FileTrouble> remarks;
    };
    struct MeshResult {
        /// Null after an error, and when stopped.
        std::shared_ptr<const Mesh> mesh;
        std::optional<FileTrouble> trouble;
    };

    [[nodiscard]] Entry &entry(const std::filesystem::path &path);
    [[nodiscard]] MeshResult mesh(const std::filesystem::path &path, const std::stop_token &stop);
    void readMesh(Entry &entry, const std::filesystem::path &folder, const std::stop_token &stop);
    void renewLooks(Entry &entry, const std::filesystem::path &folder);
    [[nodiscard]] std::vector<Material> findLooks(Entry &entry, const std::filesystem::path &folder,
                                                  const std::vector<Material> &named);
    void readFractal(Entry &entry, const std::filesystem::path &folder, const std::stop_token &stop);
    void checkMeshes(const FdoSyntax &syntax, const std::filesystem::path &folder, Diagnostics &diagnostics,
                     const std::stop_token &stop);

    const FileAccess &m_files;
    Textures m_textures;
    /// A map: entries stay where they are while others come.
    std::map<std::filesystem::path, Entry> m_entries;
};

}
