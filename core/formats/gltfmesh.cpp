// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "gltfmesh.h"

#include <algorithm>
#include <map>

namespace romanesco {

namespace {

/// Finds the vertices that corners share.
class PrimitiveBuilder
{
public:
    PrimitiveBuilder(const Mesh &mesh, std::uint32_t material, bool isTextured)
        : m_mesh(mesh)
    {
        m_primitive.hasTextureCoordinates = isTextured;
        m_primitive.material = material;
    }

    void add(std::uint32_t face)
    {
        Mesh::Face &indices = m_primitive.faces.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const GltfPrimitive::Vertex vertex{m_mesh.faces[face][corner],
                                               indexAt(m_mesh.faceTextureCoordinates, face, corner),
                                               indexAt(m_mesh.faceNormals, face, corner)};
            const auto size = static_cast<std::uint32_t>(m_primitive.vertices.size());
            const auto [known, isNew] = m_known.try_emplace(vertex, size);
            if (isNew) {
                m_primitive.vertices.push_back(vertex);
            }
            indices[corner] = known->second;
        }
    }

    GltfPrimitive take()
    {
        const auto &vertices = m_primitive.vertices;
        m_primitive.hasNormals = !std::ranges::contains(vertices, Mesh::none, &GltfPrimitive::Vertex::normal);
        m_primitive.hasTextureCoordinates |=
            std::ranges::any_of(vertices, [](const auto &v) { return v.textureCoordinates != Mesh::none; });
        m_primitive.hasColours = !m_mesh.colours.empty();
        return std::move(m_primitive);
    }

private:
    static std::uint32_t indexAt(const std::vector<Mesh::Face> &indices, std::uint32_t face, std::size_t corner)
    {
        return indices.empty() ? Mesh::none : indices[face][corner];
    }

    const Mesh &m_mesh;
    GltfPrimitive m_primitive;
    std::map<GltfPrimitive::Vertex, std::uint32_t> m_known;
};

}

std::vector<GltfPrimitive> primitivesOf(const Mesh &mesh, const MaterialTable &materials)
{
    const std::vector<Mesh::Part> parts = partsOf(mesh);
    std::map<std::uint32_t, PrimitiveBuilder> builders;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::uint32_t material = materials.entryOf(mesh, parts[i].material);
        const bool isTextured =
            material != Mesh::none && !materials.entries()[material].material->diffuseTexture.empty();
        PrimitiveBuilder &builder = builders.try_emplace(material, mesh, material, isTextured).first->second;
        for (std::uint32_t face = parts[i].firstFace; face < endOfPart(mesh, parts, i); ++face) {
            builder.add(face);
        }
    }
    std::vector<GltfPrimitive> primitives;
    for (auto &[material, builder] : builders) {
        GltfPrimitive primitive = builder.take();
        if (!primitive.faces.empty()) {
            primitives.push_back(std::move(primitive));
        }
    }
    return primitives;
}

}
