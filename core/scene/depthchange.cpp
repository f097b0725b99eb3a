// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "depthchange.h"

#include <algorithm>
#include <utility>

#include "core/formats/fdoreader.h"
#include "sceneloader.h"

namespace romanesco {

DepthChange::DepthChange(const FileAccess &files, std::string digits)
    : m_files(files)
    , m_digits(std::move(digits))
{
}

std::string DepthChange::changed(std::string text) const
{
    const FdoResult read = m_digits.empty() ? FdoResult() : readFdo(text);
    if (!read.description || !read.description->depth) {
        return text; // where it has errors they are told when it is loaded
    }
    m_hasChanged = true;
    const SourceRange range = read.description->depth->range;
    return text.replace(range.begin, range.length(), m_digits);
}

std::expected<std::string, std::string> DepthChange::read(const std::filesystem::path &path) const
{
    auto text = m_files.read(path);
    return text && fileKind(path) == FileKind::Fdo ? changed(std::move(*text)) : text;
}

std::expected<void, std::string> DepthChange::check(const std::filesystem::path &path) const
{
    return m_files.check(path);
}

bool isConvergent(const Scene &scene)
{
    const auto converges = [](const BoundLayout::Stretch &stretch) {
        return stretch.sharedCount > 0 || stretch.ownCount == stretch.end - stretch.begin;
    };
    return std::ranges::all_of(scene.items, [&](const SceneItem &item) {
        return std::ranges::all_of(item.model->graph.layout().stretches(), converges);
    });
}

}
