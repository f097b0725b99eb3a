// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/formats/mtlreader.h"
#include "core/formats/objreader.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

namespace {

bool isFinite(const auto &values)
{
    for (int i = 0; i < values.length(); ++i) {
        if (!std::isfinite(values[i])) {
            return false;
        }
    }
    return true;
}

bool isShare(const auto &values)
{
    for (int i = 0; i < values.length(); ++i) {
        if (!(values[i] >= 0 && values[i] <= 1)) {
            return false;
        }
    }
    return true;
}

/// All indices are below a size, or none where that is allowed.
void requireIndices(const std::vector<Mesh::Face> &faces, std::size_t size, bool mayBeNone)
{
    for (const Mesh::Face &face : faces) {
        for (const std::uint32_t index : face) {
            require(index < size || (mayBeNone && index == Mesh::none));
        }
    }
}

/// What a mesh promises, whatever it was read from.
void requireSound(const Mesh &mesh)
{
    requireIndices(mesh.faces, mesh.vertices.size(), false);
    requireIndices(mesh.faceTextureCoordinates, mesh.textureCoordinates.size(), true);
    requireIndices(mesh.faceNormals, mesh.normals.size(), true);
    const auto isBeside = [](const auto &list, const auto &other) {
        return list.empty() || list.size() == other.size();
    };
    require(isBeside(mesh.colours, mesh.vertices));
    require(isBeside(mesh.faceTextureCoordinates, mesh.faces) && isBeside(mesh.faceNormals, mesh.faces));
    // lists that no corner names are not kept
    require(mesh.faceTextureCoordinates.empty() == mesh.textureCoordinates.empty());
    require(mesh.faceNormals.empty() == mesh.normals.empty());
    require(std::ranges::all_of(mesh.vertices, [](const auto &v) { return isFinite(v); }));
    require(std::ranges::all_of(mesh.textureCoordinates, [](const auto &v) { return isFinite(v); }));
    require(std::ranges::all_of(mesh.normals, [](const auto &v) { return isFinite(v); }));
    require(std::ranges::all_of(mesh.colours, [](const auto &colour) { return isShare(colour); }));
    require(!std::isnan(boundingSphere(mesh).radius));
}

void requireSoundParts(const Mesh &mesh)
{
    std::vector<bool> hasFaces(mesh.materials.size() + mesh.groups.size());
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const Mesh::Part &part = mesh.parts[i];
        require(i == 0 ? part.firstFace == 0 : part.firstFace > mesh.parts[i - 1].firstFace);
        require(part.firstFace < mesh.faces.size());
        require(part.material < mesh.materials.size() || part.material == Mesh::none);
        require(part.group < mesh.groups.size() || part.group == Mesh::none);
        if (part.material != Mesh::none) {
            hasFaces[part.material] = true;
        }
        if (part.group != Mesh::none) {
            hasFaces[mesh.materials.size() + part.group] = true;
        }
    }
    require(std::ranges::find(hasFaces, false) == hasFaces.end());
}

void requireSoundMtl(std::string_view text)
{
    const MtlResult result = readMtl(text);
    requireSound(result.diagnostics, text);
    for (const auto &[material, texturePlace] : result.materials) {
        require(isShare(material.diffuse) && isShare(material.specular) && isShare(material.emission));
        require(isShare(glm::vec<1, float>(material.opacity)) && material.shininess >= 0 && material.shininess <= 1e6F);
        require(texturePlace.begin <= texturePlace.end && texturePlace.end <= text.size());
        require(material.diffuseTexture.empty() == (texturePlace.length() == 0));
    }
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const ObjResult result = readObj(text);
    require(std::ranges::count_if(result.diagnostics, &Diagnostic::isError) <= 1);
    requireSound(result.diagnostics, text);
    requireSound(result.mesh);
    requireSoundParts(result.mesh);
    require(result.sources.materialPlaces.size() == result.mesh.materials.size());
    for (const SourceRange place : result.sources.materialPlaces) {
        require(text.substr(place.begin, place.length()).starts_with("usemtl"));
    }
    for (const ObjResult::Sources::Library &library : result.sources.libraries) {
        require(text.substr(library.place.begin, library.place.length()).starts_with("mtllib"));
    }
    requireSoundMtl(text);
    return 0;
}
