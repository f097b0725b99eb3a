// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "meshlooks.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/formats/mtlreader.h"
#include "filetrouble.h"

namespace romanesco {

namespace {

class LookFinder
{
public:
    LookFinder(const FileAccess &files, Textures &textures, const std::filesystem::path &folder,
               const std::vector<Material> &named, const ObjResult::Sources &sources)
        : m_files(files)
        , m_textures(textures)
        , m_folder(folder)
        , m_named(named)
        , m_sources(sources)
    {
        assert(named.size() == sources.materialPlaces.size() && "each material has its place");
    }

    MeshLooks find();

private:
    void readLibrary(const ObjResult::Sources::Library &library);
    void findTexture(Material &material, const std::filesystem::path &folder, SourceRange place,
                     Diagnostics &diagnostics);
    void remarkOnMissing();

    const FileAccess &m_files;
    Textures &m_textures;
    const std::filesystem::path &m_folder;
    const std::vector<Material> &m_named;
    const ObjResult::Sources &m_sources;
    MeshLooks m_looks;
    /// The materials that are not found yet, by name.
    std::unordered_map<std::string_view, std::size_t> m_missing;
    bool m_areAllRead = true;
};

MeshLooks LookFinder::find()
{
    for (const Material &material : m_named) {
        m_missing.emplace(material.name, m_looks.materials.size());
        m_looks.materials.emplace_back().name = material.name;
    }
    for (const ObjResult::Sources::Library &library : m_sources.libraries) {
        readLibrary(library);
    }
    // of files that could not be read nobody knows what they hold
    if (!m_missing.empty() && m_areAllRead) {
        remarkOnMissing();
    }
    return std::move(m_looks);
}

void LookFinder::readLibrary(const ObjResult::Sources::Library &library)
{
    std::string name = library.name;
    std::ranges::replace(name, '\\', '/');
    const std::filesystem::path path = m_folder / name;
    const auto text = m_files.read(path);
    if (!text) {
        m_areAllRead = false;
        m_looks.diagnostics.push_back({DiagnosticCode::ObjLibraryUnread, library.place, {library.name, text.error()}});
        return;
    }
    MtlResult read = readMtl(*text);
    m_areAllRead = m_areAllRead && !(read.materials.empty() && hasErrors(read.diagnostics));
    for (auto &[material, texturePlace] : read.materials) {
        const auto missing = m_missing.find(material.name);
        if (missing == m_missing.end()) {
            continue;
        }
        findTexture(material, path.parent_path(), texturePlace, read.diagnostics);
        m_looks.materials[missing->second] = std::move(material);
        m_missing.erase(missing);
    }
    if (!read.diagnostics.empty()) {
        m_looks.diagnostics.push_back(remark(remarksOf(read.diagnostics, *text), name, library.place));
    }
}

/// Its path becomes that of a file, or empty.
void LookFinder::findTexture(Material &material, const std::filesystem::path &folder, SourceRange place,
                             Diagnostics &diagnostics)
{
    if (material.diffuseTexture.empty()) {
        return;
    }
    const std::filesystem::path path = folder / material.diffuseTexture;
    if (const Textures::Found found = m_textures.find(path); !found) {
        diagnostics.push_back(
            {DiagnosticCode::MtlTextureUnusable, place, {material.diffuseTexture.string(), found.error()}});
        material.diffuseTexture.clear();
    } else {
        material.diffuseTexture = path;
        material.diffuseImage = *found;
    }
}

/// At the first, one warning for all.
void LookFinder::remarkOnMissing()
{
    const auto index = [](const auto &missing) { return missing.second; };
    const auto [name, first] = *std::ranges::min_element(m_missing, {}, index);
    std::string which = "material \"" + std::string(name) + "\" is";
    if (m_missing.size() > 1) {
        which = "material \"" + std::string(name) + "\" and " + std::to_string(m_missing.size() - 1) + " more are";
    }
    m_looks.diagnostics.push_back({DiagnosticCode::ObjUnknownMaterials, m_sources.materialPlaces[first], {which}});
}

}

MeshLooks looksOf(const FileAccess &files, Textures &textures, const std::filesystem::path &folder,
                  const std::vector<Material> &named, const ObjResult::Sources &sources)
{
    return LookFinder(files, textures, folder, named, sources).find();
}

}
