// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneloader.h"

#include <algorithm>
#include <cmath>
#include <format>

#include "core/formats/fdoreader.h"
#include "core/formats/objreader.h"
#include "core/fractal/extent.h"
#include "core/text/linemap.h"

namespace romanesco {

FileKind fileKind(const std::filesystem::path &path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return ending == ".fdo" ? FileKind::Fdo : ending == ".obj" ? FileKind::Obj : FileKind::Other;
}

SceneLoader::SceneLoader(const FileAccess &files)
    : m_files(files)
{
}

SceneResult SceneLoader::load(const std::filesystem::path &path, std::string_view text, std::stop_token stop)
{
    if (fileKind(path) == FileKind::Obj) {
        return loadObj(text);
    }
    FdoResult read = readFdo(text);
    SceneResult result{std::move(read.diagnostics), nullptr};
    if (!read.description || stop.stop_requested()) {
        return result;
    }
    const FractalDescription &description = *read.description;
    const std::shared_ptr<const Mesh> mesh = loadMesh(path.parent_path(), description, result.diagnostics);
    if (mesh && !stop.stop_requested()) {
        auto graph = FractalGraph::build(description, boundingSphere(*mesh));
        if (!graph) {
            result.diagnostics.push_back({DiagnosticCode::Overflow, graph.error(), {}});
        } else if (!stop.stop_requested() && !hasErrors(result.diagnostics)) {
            const Box box = extent(*graph, *mesh);
            Scene scene =
                sceneOf(std::make_shared<const Model>(Model{mesh, std::move(*graph), box, description.meshPath}));
            scene.depth = description.depth;
            result.scene = std::make_shared<const Scene>(std::move(scene));
        }
    }
    sortByPlace(result.diagnostics);
    return result;
}

SceneResult SceneLoader::loadObj(std::string_view text)
{
    ObjResult read = readObj(text);
    SceneResult result{std::move(read.diagnostics), nullptr};
    if (hasErrors(result.diagnostics)) {
        return result;
    }
    if (read.mesh.faces.empty()) {
        result.diagnostics.push_back({DiagnosticCode::MeshWithoutFaces, {0, 0}, {"the mesh"}});
        return result;
    }
    auto mesh = std::make_shared<const Mesh>(std::move(read.mesh));
    const Sphere base = boundingSphere(*mesh);
    if (!std::isfinite(base.radius * base.radius)) {
        result.diagnostics.push_back({DiagnosticCode::Overflow, {0, 0}, {}});
        return result;
    }
    FractalGraph graph = FractalGraph::ofMesh(base);
    const Box box = extent(graph, *mesh);
    Scene scene = sceneOf(std::make_shared<const Model>(Model{mesh, std::move(graph), box, {}}));
    scene.items.front().kind = SceneDescription::Kind::Object;
    result.scene = std::make_shared<const Scene>(std::move(scene));
    return result;
}

/// Errors of the mesh are errors at its path; the mesh's own place goes into the words.
std::shared_ptr<const Mesh> SceneLoader::loadMesh(const std::filesystem::path &folder,
                                                  const FractalDescription &description, Diagnostics &diagnostics)
{
    const auto fail = [&](DiagnosticCode code, std::vector<std::string> arguments) {
        diagnostics.push_back({code, description.meshRange, std::move(arguments)});
        return nullptr;
    };
    auto text = m_files.read(folder / description.meshPath);
    if (!text) {
        return fail(DiagnosticCode::CannotRead, {description.meshPath, text.error()});
    }
    if (m_mesh && *text == m_meshText) {
        return m_mesh;
    }
    ObjResult read = readObj(*text);
    if (hasErrors(read.diagnostics)) {
        const Diagnostic &first = read.diagnostics.front();
        const TextPosition at = LineMap(*text).position(first.range.begin);
        return fail(DiagnosticCode::BadMesh,
                    {description.meshPath, std::format("line {}, column {}: {}", at.line, at.column, first.message())});
    }
    if (read.mesh.faces.empty()) {
        return fail(DiagnosticCode::MeshWithoutFaces, {'"' + description.meshPath + '"'});
    }
    m_meshText = std::move(*text);
    m_mesh = std::make_shared<const Mesh>(std::move(read.mesh));
    return m_mesh;
}

}
