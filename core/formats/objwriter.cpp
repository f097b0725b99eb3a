// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objwriter.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cstring>
#include <map>
#include <vector>

#include "binaryoutput.h"
#include "core/geometry/normals.h"
#include "numbertext.h"

namespace romanesco {

namespace {

/// More than any line of numbers or indices takes.
constexpr std::size_t mostLine = 256;
constexpr std::size_t mostFloat = 16;

/// " 0.8 0.2 0".
char *putColour(char *to, const glm::vec3 &colour)
{
    for (int i = 0; i < 3; ++i) {
        *to++ = ' ';
        to = std::to_chars(to, to + mostFloat, colour[i]).ptr;
    }
    return to;
}

/// An index from 1, as text: copied again and again, made once.
struct IndexText {
    std::array<char, 20> digits;
    std::uint32_t size;
};

/// The texts of the indices after `before`.
void number(std::vector<IndexText> &texts, std::size_t count, std::uint64_t before)
{
    texts.resize(count);
    for (IndexText &text : texts) {
        char *begin = text.digits.data();
        text.size = static_cast<std::uint32_t>(std::to_chars(begin, begin + text.digits.size(), ++before).ptr - begin);
    }
}

char *put(char *to, const IndexText &text)
{
    // all of it, since that takes three moves and no loop
    std::memcpy(to, text.digits.data(), text.digits.size());
    return to + text.size;
}

class ObjWriter
{
public:
    ObjWriter(const CopySource &copies, const ObjOptions &options, ByteSink &sink)
        : m_copies(copies)
        , m_options(options)
        , m_out(sink)
        , m_numbers(options.digits)
        , m_materials(copies.items())
    {
    }

    std::expected<void, std::string> write()
    {
        if (!m_options.comment.empty()) {
            m_out.append("# " + m_options.comment + "\n");
        }
        const bool hasMaterials = !m_options.materialLibrary.empty() && !m_materials.entries().empty();
        if (hasMaterials) {
            m_out.append("mtllib " + m_options.materialLibrary + "\n");
        }
        m_namesMaterials = hasMaterials;
        for (std::size_t item = 0; item < m_copies.items().size(); ++item) {
            beginMesh(*m_copies.items()[item].mesh);
            const auto visited = m_copies.visit(item, [&](const MeshCopy &copy) {
                writeCopy(copy);
                return m_out.isGood();
            });
            if (!visited) {
                return visited;
            }
        }
        return m_out.flush();
    }

private:
    void beginMesh(const Mesh &mesh)
    {
        m_mesh = &mesh;
        m_parts = partsOf(mesh);
        const auto [first, isNew] = m_firstTextureCoordinates.try_emplace(&mesh, m_textureCoordinates);
        number(m_textureIndices, mesh.textureCoordinates.size(), first->second);
        if (!isNew) {
            return;
        }
        for (const glm::dvec2 &coordinates : mesh.textureCoordinates) {
            endLine(putNumbers(m_out.room(mostLine), "vt", {&coordinates.x, 2}));
        }
        m_textureCoordinates += mesh.textureCoordinates.size();
    }

    void writeCopy(const MeshCopy &copy)
    {
        writeVertices(copy.worldFromMesh);
        if (!m_mesh->normals.empty()) {
            writeNormals(copy.worldFromMesh.linear);
        }
        number(m_vertexIndices, m_mesh->vertices.size(), m_vertices);
        number(m_normalIndices, m_mesh->normals.size(), m_normals);
        m_vertices += m_mesh->vertices.size();
        m_normals += m_mesh->normals.size();
        for (std::size_t i = 0; i < m_parts.size() && m_out.isGood(); ++i) {
            beginPart(m_parts[i], copy.branch);
            writeFaces(m_parts[i].firstFace, endOfPart(*m_mesh, m_parts, i), copy.isMirrored);
        }
    }

    void writeVertices(const AffineMap &map)
    {
        for (std::size_t i = 0; i < m_mesh->vertices.size() && m_out.isGood(); ++i) {
            const glm::dvec3 vertex = map(m_mesh->vertices[i]);
            char *to = putNumbers(m_out.room(mostLine), "v", {&vertex.x, 3});
            if (!m_mesh->colours.empty()) {
                to = putColour(to, m_mesh->colours[i]);
            }
            endLine(to);
        }
    }

    void writeNormals(const glm::dmat3 &linear)
    {
        const bool isSame = linear == glm::dmat3(1.0);
        const glm::dmat3 matrix = normalMatrix(linear);
        for (const glm::dvec3 &normal : m_mesh->normals) {
            const glm::dvec3 turned = isSame ? normal : transformedNormal(matrix, normal);
            endLine(putNumbers(m_out.room(mostLine), "vn", {&turned.x, 3}));
        }
    }

    char *putNumbers(char *to, std::string_view keyword, std::span<const double> numbers)
    {
        to += keyword.copy(to, keyword.size());
        for (const double number : numbers) {
            *to++ = ' ';
            to = m_numbers.write(to, number);
        }
        return to;
    }

    void endLine(char *to)
    {
        *to++ = '\n';
        m_out.take(to);
    }

    /// What holds for all faces from here on, where it changes.
    void beginPart(const Mesh::Part &part, std::string_view branch)
    {
        const std::uint32_t material = m_namesMaterials ? m_materials.entryOf(*m_mesh, part.material) : Mesh::none;
        if (material != m_material && material != Mesh::none) {
            m_out.append("usemtl " + m_materials.entries()[material].name + "\n");
            m_material = material;
        }
        const std::string_view group = !branch.empty() ? branch
            : part.group == Mesh::none                 ? std::string_view("default")
                                                       : std::string_view(m_mesh->groups[part.group]);
        if (group != m_group) {
            m_group = group;
            m_out.append("g " + m_group + "\n");
        }
        if (part.smoothing != m_smoothing) {
            m_smoothing = part.smoothing;
            m_out.append("s " + std::to_string(m_smoothing) + "\n");
        }
    }

    void writeFaces(std::uint32_t first, std::uint32_t end, bool isMirrored)
    {
        const std::array<std::size_t, 3> corners = cornerOrder(isMirrored);
        for (std::uint32_t face = first; face < end && m_out.isGood(); ++face) {
            char *to = m_out.room(mostLine);
            *to++ = 'f';
            for (const std::size_t corner : corners) {
                *to++ = ' ';
                to = put(to, m_vertexIndices[m_mesh->faces[face][corner]]);
                to = putAttributes(to, face, corner);
            }
            endLine(to);
        }
    }

    /// "/2", "//3", "/2/3" or nothing.
    char *putAttributes(char *to, std::uint32_t face, std::size_t corner) const
    {
        const auto index = [&](const std::vector<Mesh::Face> &indices) {
            return indices.empty() ? Mesh::none : indices[face][corner];
        };
        const std::uint32_t texture = index(m_mesh->faceTextureCoordinates);
        const std::uint32_t normal = index(m_mesh->faceNormals);
        if (texture != Mesh::none) {
            *to++ = '/';
            to = put(to, m_textureIndices[texture]);
        } else if (normal != Mesh::none) {
            *to++ = '/';
        }
        if (normal != Mesh::none) {
            *to++ = '/';
            to = put(to, m_normalIndices[normal]);
        }
        return to;
    }

    const CopySource &m_copies;
    const ObjOptions &m_options;
    BufferedOutput m_out;
    NumberText m_numbers;
    MaterialTable m_materials;
    bool m_namesMaterials = false;

    /// Written so far.
    std::uint64_t m_vertices = 0;
    std::uint64_t m_normals = 0;
    std::uint64_t m_textureCoordinates = 0;
    std::map<const Mesh *, std::uint64_t> m_firstTextureCoordinates;

    /// Of the mesh at hand, and of its copy.
    const Mesh *m_mesh = nullptr;
    std::vector<Mesh::Part> m_parts;
    std::vector<IndexText> m_vertexIndices;
    std::vector<IndexText> m_textureIndices;
    std::vector<IndexText> m_normalIndices;

    /// What the last lines of their kind said.
    std::uint32_t m_material = Mesh::none;
    std::string m_group = "default";
    std::uint32_t m_smoothing = 0;
};

std::string numberText(float value)
{
    std::array<char, mostFloat> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string colourText(const glm::vec3 &colour)
{
    std::array<char, 3 * (mostFloat + 1)> text;
    return {text.data(), putColour(text.data(), colour)};
}

/// As seen from a folder, with / on every system.
std::string pathFrom(const std::filesystem::path &folder, const std::filesystem::path &path)
{
    return std::filesystem::absolute(path).lexically_proximate(std::filesystem::absolute(folder)).generic_string();
}

}

std::expected<void, std::string> writeObj(const CopySource &copies, const ObjOptions &options, ByteSink &sink)
{
    return ObjWriter(copies, options, sink).write();
}

std::string mtlText(const MaterialTable &materials, const std::filesystem::path &folder)
{
    std::string text;
    for (const auto &[name, material] : materials.entries()) {
        text += "newmtl " + name + "\nKd" + colourText(material->diffuse) + "\nKs" + colourText(material->specular)
            + "\nKe" + colourText(material->emission) + "\nNs " + numberText(material->shininess) + "\nd "
            + numberText(material->opacity) + "\n";
        if (!material->diffuseTexture.empty()) {
            text += "map_Kd " + pathFrom(folder, material->diffuseTexture) + "\n";
        }
    }
    return text;
}

}
