// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "modellibrary.h"

#include <algorithm>
#include <iterator>

#include "core/formats/fdoreader.h"
#include "core/formats/lineparser.h"
#include "core/formats/objreader.h"
#include "core/fractal/extent.h"
#include "core/geometry/computable.h"
#include "meshlooks.h"

namespace romanesco {

namespace {

std::shared_ptr<const Model> modelOf(std::shared_ptr<const Mesh> mesh, FractalGraph graph, std::string meshPath)
{
    BoxBounds boxes(graph, *mesh);
    const Box box = extent(graph, boxes, *mesh);
    return std::make_shared<const Model>(
        Model{std::move(mesh), std::move(graph), std::move(boxes), box, std::move(meshPath)});
}

/// Nothing where it reaches beyond what can be computed with.
std::shared_ptr<const Model> modelOfMesh(std::shared_ptr<const Mesh> mesh)
{
    const Sphere base = boundingSphere(*mesh);
    if (!isComputable(base.centre, base.radius)) {
        return nullptr;
    }
    return modelOf(std::move(mesh), FractalGraph::ofMesh(base), {});
}

}

ModelLibrary::ModelLibrary(const FileAccess &files, ImageDecoder decoder)
    : m_files(files)
    , m_textures(files, std::move(decoder))
{
}

void ModelLibrary::beginRound()
{
    for (auto &[path, entry] : m_entries) {
        entry.isUsed = false;
    }
    m_textures.beginRound();
}

void ModelLibrary::dropUnused()
{
    std::erase_if(m_entries, [](const auto &known) { return !known.second.isUsed; });
    m_textures.dropUnused();
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
    entry.hasLooks = false;
    if (text) {
        entry.text = std::move(*text);
    } else {
        entry.trouble = FileTrouble{DiagnosticCode::CannotRead, text.error(), {}};
    }
    return entry;
}

ModelLibrary::MeshResult ModelLibrary::mesh(const std::filesystem::path &path, const std::stop_token &stop)
{
    Entry &file = entry(path);
    if (!file.mesh && !file.trouble) {
        readMesh(file, path.parent_path(), stop);
    } else if (file.mesh && !file.hasLooks) {
        renewLooks(file, path.parent_path());
    }
    return {file.mesh, file.mesh ? file.remarks : file.trouble};
}

void ModelLibrary::readMesh(Entry &entry, const std::filesystem::path &folder, const std::stop_token &stop)
{
    ObjResult read = readObj(entry.text, stop);
    if (stop.stop_requested()) {
        return;
    }
    if (hasErrors(read.diagnostics)) {
        entry.trouble = troubleOf(read.diagnostics, entry.text);
    } else if (read.mesh.faces.empty()) {
        entry.trouble = FileTrouble{DiagnosticCode::MeshWithoutFaces, {}, {}};
    } else {
        entry.sources = std::move(read.sources);
        entry.warnings = std::move(read.diagnostics);
        read.mesh.materials = findLooks(entry, folder, read.mesh.materials);
        entry.mesh = std::make_shared<const Mesh>(std::move(read.mesh));
    }
}

/// The files that describe materials may have changed where the mesh has not.
void ModelLibrary::renewLooks(Entry &entry, const std::filesystem::path &folder)
{
    std::vector<Material> materials = findLooks(entry, folder, entry.mesh->materials);
    if (materials != entry.mesh->materials) {
        Mesh mesh = *entry.mesh;
        mesh.materials = std::move(materials);
        entry.mesh = std::make_shared<const Mesh>(std::move(mesh));
        entry.model.reset();
    }
}

std::vector<Material> ModelLibrary::findLooks(Entry &entry, const std::filesystem::path &folder,
                                              const std::vector<Material> &named)
{
    MeshLooks looks = looksOf(m_files, m_textures, folder, named, entry.sources);
    Diagnostics all = entry.warnings;
    std::ranges::move(looks.diagnostics, std::back_inserter(all));
    sortByPlace(all);
    entry.remarks = all.empty() ? std::nullopt : std::optional(remarksOf(all, entry.text));
    entry.hasLooks = true;
    return std::move(looks.materials);
}

ModelLibrary::ModelResult ModelLibrary::model(const std::filesystem::path &path, const std::stop_token &stop)
{
    Entry &file = entry(path);
    if (!hasEnding(path.generic_string(), ".obj")) {
        if (!file.trouble) {
            readFractal(file, path.parent_path(), stop);
        }
        return {file.model, file.trouble};
    }
    const MeshResult made = mesh(path, stop);
    if (made.mesh && !file.model) {
        file.model = modelOfMesh(made.mesh);
        if (!file.model) {
            return {nullptr, FileTrouble{DiagnosticCode::Overflow, {}, {}}};
        }
    }
    return {file.model, made.trouble};
}

ModelLibrary::TextResult ModelLibrary::object(const std::filesystem::path &folder, std::string_view text,
                                              const std::stop_token &stop)
{
    ObjResult read = readObj(text, stop);
    TextResult result{std::move(read.diagnostics), nullptr};
    if (hasErrors(result.diagnostics) || stop.stop_requested()) {
        return result;
    }
    if (read.mesh.faces.empty()) {
        result.diagnostics.push_back({DiagnosticCode::MeshWithoutFaces, {0, 0}, {"the mesh"}});
        return result;
    }
    MeshLooks looks = looksOf(m_files, m_textures, folder, read.mesh.materials, read.sources);
    read.mesh.materials = std::move(looks.materials);
    std::ranges::move(looks.diagnostics, std::back_inserter(result.diagnostics));
    result.model = modelOfMesh(std::make_shared<const Mesh>(std::move(read.mesh)));
    if (!result.model) {
        result.diagnostics.push_back({DiagnosticCode::Overflow, {0, 0}, {}});
    }
    sortByPlace(result.diagnostics);
    return result;
}

/// What was made of a text stays good while the mesh that it names does.
void ModelLibrary::readFractal(Entry &entry, const std::filesystem::path &folder, const std::stop_token &stop)
{
    if (entry.model) {
        if (mesh(folder / entry.model->meshPath, stop).mesh == entry.model->mesh) {
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
        checkMeshes(syntax, folder, result.diagnostics, stop);
        sortByPlace(result.diagnostics);
        return result;
    }
    const FractalDescription &description = *read.description;
    result.depth = description.depth;
    result.namesItsMesh = true;
    const auto [base, trouble] = mesh(folder / description.meshPath, stop);
    if (trouble) {
        result.diagnostics.push_back(remark(*trouble, description.meshPath, description.meshRange));
    }
    if (base && !stop.stop_requested()) {
        auto graph = FractalGraph::build(description, boundingSphere(*base));
        if (!graph) {
            result.diagnostics.push_back({DiagnosticCode::Overflow, graph.error(), {}});
        } else if (!stop.stop_requested() && !hasErrors(result.diagnostics)) {
            result.model = modelOf(base, std::move(*graph), description.meshPath);
        }
    }
    sortByPlace(result.diagnostics);
    return result;
}

/// Of a text with errors nobody knows which mesh it needs, and all that is wrong is to be told at once.
void ModelLibrary::checkMeshes(const FdoSyntax &syntax, const std::filesystem::path &folder, Diagnostics &diagnostics,
                               const std::stop_token &stop)
{
    for (std::size_t line = 0; line < syntax.lineCount() && !stop.stop_requested(); ++line) {
        const auto *object = std::get_if<ObjectDeclaration>(&syntax.line(line).declaration);
        if (!object || !object->value.isMesh || syntax.line(line).isBad) {
            continue;
        }
        const LineRange quoted = object->value.inner.range;
        const std::string path(unquoted(syntax.words(line, quoted)));
        if (const auto trouble = mesh(folder / path, stop).trouble) {
            diagnostics.push_back(remark(*trouble, path, syntax.range(line, quoted)));
        }
    }
}

}
