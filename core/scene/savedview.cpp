// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "savedview.h"

#include <algorithm>
#include <format>

#include "core/formats/sdosyntax.h"
#include "core/geometry/computable.h"
#include "scene.h"

namespace romanesco {

namespace {

constexpr std::string_view opening = "# view: ";
std::string vectorWords(const glm::dvec3 &v)
{
    return std::format("({}, {}, {})", v.x, v.y, v.z);
}

std::string cameraWords(const SceneDescription::Camera &camera)
{
    return std::format("{} {} {} {}", vectorWords(camera.position), vectorWords(camera.rotation), camera.view,
                       camera.isOrthographic ? "orthographic" : "perspective");
}

std::optional<SceneDescription::Camera> cameraFrom(std::string_view words)
{
    const std::string line = "c " + std::string(words);
    const SdoLine read = parseSdoLine(line, 0);
    const auto *camera = std::get_if<CameraLine>(&read.declaration);
    if (!camera || read.isBad || hasErrors(read.diagnostics) || read.range.end != line.size()
        || !isComputable(camera->position.value, camera->isOrthographic ? camera->view.value : 0.0)) {
        return std::nullopt;
    }
    return SceneDescription::Camera{camera->position.value,
                                    camera->rotation.value,
                                    camera->isOrthographic,
                                    camera->view.value,
                                    {}};
}

bool take(std::string_view &words, std::string_view expected)
{
    const bool isThere = words.starts_with(expected);
    words.remove_prefix(isThere ? expected.size() : 0);
    return isThere;
}

std::optional<SavedView> viewFrom(std::string_view line)
{
    SavedView view;
    if (!take(line, opening)) {
        return std::nullopt;
    }
    view.isEndless = take(line, "endless, ");
    if (take(line, "in ")) {
        const std::size_t end = line.find("at ");
        if (end == std::string_view::npos) {
            return std::nullopt;
        }
        view.place = scenePlaceFromText(line.substr(0, end));
        if (!view.place) {
            return std::nullopt;
        }
        line.remove_prefix(end + 3);
    }
    const auto camera = cameraFrom(line);
    if (!camera) {
        return std::nullopt;
    }
    view.camera = *camera;
    return view;
}

/// The camera's declaration in an .sdo text, whatever else is wrong with that.
std::optional<SourceRange> cameraIn(std::string_view text)
{
    const SdoSyntax syntax{std::string(text)};
    for (std::size_t line = 0; line < syntax.lineCount(); ++line) {
        if (std::holds_alternative<CameraLine>(syntax.line(line).declaration)) {
            return syntax.range(line, syntax.line(line).range);
        }
    }
    return std::nullopt;
}

}

std::string cameraLine(const SceneDescription::Camera &camera)
{
    return "c " + cameraWords(camera);
}

std::string viewLine(const SavedView &view)
{
    std::string line(opening);
    line += view.isEndless ? "endless, " : "";
    if (view.place) {
        line += "in " + textOf(*view.place);
        line += "at ";
    }
    return line + cameraWords(view.camera);
}

std::optional<std::pair<SavedView, SourceRange>> findView(std::string_view text)
{
    std::size_t begin = text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        if (auto view = viewFrom(text.substr(begin, end - begin))) {
            return std::pair(std::move(*view), SourceRange{begin, end});
        }
        begin = end + 1;
    }
    return std::nullopt;
}

TextEdits editsToSave(const SavedView &view, const SceneDescription::Camera &inWorld, std::string_view text, bool isSdo)
{
    const auto found = findView(text);
    const std::optional<SourceRange> camera = isSdo ? cameraIn(text) : std::nullopt;
    const bool isCameraAll = isSdo && !view.place && !view.isEndless;
    std::string top;
    TextEdits edits;
    const auto put = [&](std::optional<SourceRange> range, std::string line) {
        if (range) {
            edits.push_back({*range, std::move(line)});
        } else {
            top += line + "\n";
        }
    };
    if (!isCameraAll) {
        put(found ? std::optional(found->second) : std::nullopt, viewLine(view));
    } else if (found) {
        // with its line end
        const std::string_view rest = text.substr(found->second.end);
        const std::size_t lineEnd = rest.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest.size(), 1);
        edits.push_back({{found->second.begin, found->second.end + lineEnd}, {}});
    }
    if (isSdo) {
        put(camera, cameraLine(inWorld));
    }
    std::ranges::sort(edits, {}, [](const TextEdit &edit) { return edit.range.begin; });
    if (!top.empty()) {
        const std::size_t start = text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
        edits.insert(edits.begin(), {{start, start}, top});
    }
    return edits;
}

}
