// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneloader.h"

#include <set>
#include <utility>

#include "core/formats/lineparser.h"
#include "core/formats/sdoreader.h"
#include "core/geometry/computable.h"

namespace romanesco {

FileKind fileKind(const std::filesystem::path &path)
{
    const std::string ending = path.extension().string();
    return hasEnding(ending, ".fdo") ? FileKind::Fdo
        : hasEnding(ending, ".sdo")  ? FileKind::Sdo
        : hasEnding(ending, ".obj")  ? FileKind::Obj
                                     : FileKind::Other;
}

namespace {

std::optional<SavedView> viewIn(std::string_view text)
{
    auto found = findView(text);
    return found ? std::optional(std::move(found->first)) : std::nullopt;
}

}

SceneLoader::SceneLoader(const FileAccess &files, ImageDecoder decoder)
    : m_library(files, std::move(decoder))
{
}

SceneResult SceneLoader::load(const std::filesystem::path &path, std::string_view text, std::stop_token stop)
{
    m_library.beginRound();
    switch (fileKind(path)) {
    case FileKind::Obj:
        return loadObj(path.parent_path(), text, stop);
    case FileKind::Sdo:
        return loadSdo(path.parent_path(), text, stop);
    case FileKind::Fdo:
    case FileKind::Other:
        break;
    }
    return loadFdo(path.parent_path(), text, stop);
}

SceneResult SceneLoader::loadObj(const std::filesystem::path &folder, std::string_view text,
                                 const std::stop_token &stop)
{
    ModelLibrary::TextResult object = m_library.object(folder, text, stop);
    SceneResult result{std::move(object.diagnostics), nullptr};
    if (object.model) {
        Scene scene = sceneOf(std::move(object.model));
        scene.items.front().kind = SceneDescription::Kind::Object;
        result.scene = std::make_shared<const Scene>(std::move(scene));
    }
    return result;
}

SceneResult SceneLoader::loadFdo(const std::filesystem::path &folder, std::string_view text,
                                 const std::stop_token &stop)
{
    ModelLibrary::Fractal fractal = m_library.fractal(folder, text, stop);
    SceneResult result{std::move(fractal.diagnostics), nullptr};
    if (fractal.namesItsMesh) {
        m_library.dropUnused();
    }
    if (fractal.model) {
        Scene scene = sceneOf(std::move(fractal.model));
        scene.depth = fractal.depth;
        scene.view = viewIn(text);
        result.scene = std::make_shared<const Scene>(std::move(scene));
    }
    return result;
}

SceneResult SceneLoader::loadSdo(const std::filesystem::path &folder, std::string_view text,
                                 const std::stop_token &stop)
{
    const SdoSyntax syntax{std::string(text)};
    SdoResult read = describeSdo(syntax);
    SceneResult result{std::move(read.diagnostics), nullptr};
    if (!read.description) {
        checkFiles(syntax, folder, result.diagnostics, stop);
        sortByPlace(result.diagnostics);
        return result;
    }
    const SceneDescription &description = *read.description;
    Scene scene;
    std::set<std::string> remarked;
    for (const SceneDescription::Item &item : description.items) {
        const auto [model, trouble] =
            stop.stop_requested() ? ModelLibrary::ModelResult() : m_library.model(folder / item.path, stop);
        // an error at each place, a warning once
        if (trouble && (!model || remarked.insert(item.path).second)) {
            result.diagnostics.push_back(remark(*trouble, item.path, item.pathRange));
        }
        if (!model && trouble) {
            continue;
        }
        if (!model) {
            return result;
        }
        const SceneItem placed{model, item.worldFromModel, item.kind, item.path, item.restitution, item.velocity};
        const Sphere bound = boundingSphere(placed);
        if (!isComputable(bound.centre, bound.radius)) {
            result.diagnostics.push_back({DiagnosticCode::Overflow, item.pathRange, {}});
        }
        scene.items.push_back(placed);
    }
    m_library.dropUnused();
    scene.camera = description.camera;
    if (scene.camera && !isComputable(scene.camera->position)) {
        result.diagnostics.push_back({DiagnosticCode::Overflow, scene.camera->range, {}});
    }
    if (!hasErrors(result.diagnostics) && !stop.stop_requested()) {
        scene.view = viewIn(text);
        scene.lights = description.lights;
        scene.extent = extentOf(scene.items);
        result.scene = std::make_shared<const Scene>(std::move(scene));
    }
    sortByPlace(result.diagnostics);
    return result;
}

/// Of a text with errors: what its good lines name is looked for all the same, so that all that is wrong is told at once.
void SceneLoader::checkFiles(const SdoSyntax &syntax, const std::filesystem::path &folder, Diagnostics &diagnostics,
                             const std::stop_token &stop)
{
    for (std::size_t line = 0; line < syntax.lineCount() && !stop.stop_requested(); ++line) {
        const PlacedFile *file = syntax.line(line).file();
        if (!file || syntax.line(line).isBad) {
            continue;
        }
        const std::string path(unquoted(syntax.words(line, file->path)));
        if (const auto trouble = m_library.model(folder / path, stop).trouble) {
            diagnostics.push_back(remark(*trouble, path, syntax.range(line, file->path)));
        }
    }
}

}
