// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "modellibrary.h"

#include <algorithm>
#include <cmath>
#include <format>

#include "core/formats/fdoreader.h"
#include "core/formats/lineparser.h"
#include "core/formats/objreader.h"
#include "core/fractal/extent.h"
#include "core/text/linemap.h"

namespace romanesco {

namespace {

constexpr std::size_t mostNotes = 10;

/// Errors of a text become one sentence and a note for each of the first.
FileTrouble troubleOf(const Diagnostics &diagnostics, std::string_view text)
{
    const LineMap lines(text);
    FileTrouble trouble{DiagnosticCode::BadMesh, {}, {}};
    std::size_t errors = 0;
    for (const Diagnostic &diagnostic : diagnostics) {
        if (!diagnostic.isError() || ++errors > mostNotes) {
            continue;
        }
        const TextPosition at = lines.position(diagnostic.range.begin);
        trouble.notes.push_back({diagnostic.code, diagnostic.range, diagnostic.arguments, {}, at});
        if (errors == 1) {
            trouble.reason = std::format("line {}, column {}: {}", at.line, at.column, diagnostic.message());
        }
        std::ranges::copy_if(diagnostic.notes, std::back_inserter(trouble.notes),
                             [](const Note &note) { return !note.file.empty(); });
    }
    if (errors > 1) {
        trouble.reason = std::format("{} errors, the first in {}", errors, trouble.reason);
    }
    return trouble;
}

}

Diagnostic remark(const FileTrouble &trouble, const std::string &name, SourceRange place)
{
    Diagnostic diagnostic{trouble.code, place, {name, trouble.reason}, {}, trouble.notes};
    if (trouble.code == DiagnosticCode::MeshWithoutFaces) {
        diagnostic.arguments = {'"' + name + '"'};
    } else if (trouble.code == DiagnosticCode::Overflow) {
        diagnostic.arguments.clear();
    }
    for (Note &note : diagnostic.notes) {
        note.file = seenFrom(name, note.file);
    }
    return diagnostic;
}

std::shared_ptr<const Model> modelOfMesh(std::shared_ptr<const Mesh> mesh)
{
    const Sphere base = boundingSphere(*mesh);
    if (!std::isfinite(base.radius * base.radius)) {
        return nullptr;
    }
    FractalGraph graph = FractalGraph::ofMesh(base);
    const Box box = extent(graph, *mesh);
    return std::make_shared<const Model>(Model{std::move(mesh), std::move(graph), box, {}});
}

ModelLibrary::ModelLibrary(const FileAccess &files)
    : m_files(files)
{
}

void ModelLibrary::beginRound()
{
    for (auto &[path, entry] : m_entries) {
        entry.isUsed = false;
    }
}

void ModelLibrary::dropUnused()
{
    std::erase_if(m_entries, [](const auto &known) { return !known.second.isUsed; });
}

/// Its bytes as they are in this round; what was made of other bytes is gone.
ModelLibrary::Entry &ModelLibrary::entry(const std::filesystem::path &path)
{
    Entry &entry = m_entries[path];
    if (entry.isUsed) {
        return entry;
    }
    auto text = m_files.read(path);
    if (!text || !entry.isRead || *text != entry.text) {
        entry = {};
    }
    entry.isUsed = true;
    entry.isRead = text.has_value();
    entry.trouble.reset();
    if (text) {
        entry.text = std::move(*text);
    } else {
        entry.trouble = FileTrouble{DiagnosticCode::CannotRead, text.error(), {}};
    }
    return entry;
}

std::expected<std::shared_ptr<const Mesh>, FileTrouble> ModelLibrary::mesh(const std::filesystem::path &path)
{
    Entry &file = entry(path);
    if (!file.mesh && !file.trouble) {
        readMesh(file);
    }
    if (file.mesh) {
        return file.mesh;
    }
    return std::unexpected(*file.trouble);
}

void ModelLibrary::readMesh(Entry &entry)
{
    ObjResult read = readObj(entry.text);
    if (hasErrors(read.diagnostics)) {
        entry.trouble = troubleOf(read.diagnostics, entry.text);
    } else if (read.mesh.faces.empty()) {
        entry.trouble = FileTrouble{DiagnosticCode::MeshWithoutFaces, {}, {}};
    } else {
        entry.mesh = std::make_shared<const Mesh>(std::move(read.mesh));
    }
}

ModelLibrary::ModelResult ModelLibrary::model(const std::filesystem::path &path, const std::stop_token &stop)
{
    Entry &file = entry(path);
    if (!file.trouble) {
        if (hasEnding(path.generic_string(), ".obj")) {
            if (const auto made = mesh(path); made && !file.model) {
                file.model = modelOfMesh(*made);
                if (!file.model) {
                    file.trouble = FileTrouble{DiagnosticCode::Overflow, {}, {}};
                }
            }
        } else {
            readFractal(file, path.parent_path(), stop);
        }
    }
    if (file.trouble) {
        return std::unexpected(*file.trouble);
    }
    return file.model;
}

/// What was made of a text stays good while the mesh that it names does.
void ModelLibrary::readFractal(Entry &entry, const std::filesystem::path &folder, const std::stop_token &stop)
{
    if (entry.model) {
        const auto known = mesh(folder / entry.model->meshPath);
        if (known && *known == entry.model->mesh) {
            return;
        }
        entry.model.reset();
    }
    const Fractal made = fractal(folder, entry.text, stop);
    entry.model = made.model;
    if (hasErrors(made.diagnostics)) {
        entry.trouble = troubleOf(made.diagnostics, entry.text);
    }
}

ModelLibrary::Fractal ModelLibrary::fractal(const std::filesystem::path &folder, std::string_view text,
                                            const std::stop_token &stop)
{
    const FdoSyntax syntax{std::string(text)};
    FdoResult read = describeFdo(syntax, resolveFdo(syntax));
    Fractal result;
    result.diagnostics = std::move(read.diagnostics);
    if (!read.description || stop.stop_requested()) {
        checkMeshes(syntax, folder, result.diagnostics);
        sortByPlace(result.diagnostics);
        return result;
    }
    const FractalDescription &description = *read.description;
    result.depth = description.depth;
    result.namesItsMesh = true;
    const auto base = mesh(folder / description.meshPath);
    if (!base) {
        result.diagnostics.push_back(remark(base.error(), description.meshPath, description.meshRange));
    } else if (!stop.stop_requested()) {
        auto graph = FractalGraph::build(description, boundingSphere(**base));
        if (!graph) {
            result.diagnostics.push_back({DiagnosticCode::Overflow, graph.error(), {}});
        } else if (!stop.stop_requested() && !hasErrors(result.diagnostics)) {
            const Box box = extent(*graph, **base);
            result.model = std::make_shared<const Model>(Model{*base, std::move(*graph), box, description.meshPath});
        }
    }
    sortByPlace(result.diagnostics);
    return result;
}

/// Of a text with errors nobody knows which mesh it needs, and all that is wrong is to be told at once.
void ModelLibrary::checkMeshes(const FdoSyntax &syntax, const std::filesystem::path &folder, Diagnostics &diagnostics)
{
    for (std::size_t line = 0; line < syntax.lineCount(); ++line) {
        const auto *object = std::get_if<ObjectDeclaration>(&syntax.line(line).declaration);
        if (!object || !object->value.isMesh || syntax.line(line).isBad) {
            continue;
        }
        const LineRange quoted = object->value.inner.range;
        const std::string path(unquoted(syntax.words(line, quoted)));
        if (const auto base = mesh(folder / path); !base) {
            diagnostics.push_back(remark(base.error(), path, syntax.range(line, quoted)));
        }
    }
}

}
