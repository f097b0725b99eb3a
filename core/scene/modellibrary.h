// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
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
#include "core/text/diagnostic.h"
#include "model.h"

namespace romanesco {

/// What is wrong with a file that a text names: a remark of that text but for the file's name and the place.
struct FileTrouble {
    DiagnosticCode code;
    /// "no such file"; "3 errors, the first in line 4, column 2: …". Empty where the code says it all.
    std::string reason;
    /// The first errors in the file, and in the files that it names; file is empty or relative to its folder.
    std::vector<Note> notes;
};

/// At the place where a text names the file so.
[[nodiscard]] Diagnostic remark(const FileTrouble &trouble, const std::string &name, SourceRange place);

/// A mesh by itself; nothing where it reaches beyond what can be computed with.
[[nodiscard]] std::shared_ptr<const Model> modelOfMesh(std::shared_ptr<const Mesh> mesh);

/// The models of files. Each file is read once in a round and made into a model once, however often it is named; what
/// was made of it is kept for the next rounds as long as its bytes stay the same. One thread at a time.
class ModelLibrary
{
public:
    /// files must outlive the library.
    explicit ModelLibrary(const FileAccess &files);

    /// From here on files are looked at anew.
    void beginRound();
    /// Forgets the files that were not asked for in this round.
    void dropUnused();

    /// Of an .fdo or .obj file, by its ending. Null when stopped.
    using ModelResult = std::expected<std::shared_ptr<const Model>, FileTrouble>;
    [[nodiscard]] ModelResult model(const std::filesystem::path &path, const std::stop_token &stop);

    /// Of an .fdo text that lies, or will lie, in a folder.
    struct Fractal {
        /// Sorted by place.
        Diagnostics diagnostics;
        /// Null after errors, and when stopped.
        std::shared_ptr<const Model> model;
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
        bool isUsed = false;
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const Model> model;
        /// Of this round.
        std::optional<FileTrouble> trouble;
    };

    [[nodiscard]] Entry &entry(const std::filesystem::path &path);
    [[nodiscard]] std::expected<std::shared_ptr<const Mesh>, FileTrouble> mesh(const std::filesystem::path &path);
    void readMesh(Entry &entry);
    void checkMeshes(const FdoSyntax &syntax, const std::filesystem::path &folder, Diagnostics &diagnostics);
    void readFractal(Entry &entry, const std::filesystem::path &folder, const std::stop_token &stop);

    const FileAccess &m_files;
    /// A map: entries stay where they are while others come.
    std::map<std::filesystem::path, Entry> m_entries;
};

}
