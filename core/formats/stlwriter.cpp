// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "stlwriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "binaryoutput.h"

namespace romanesco {

namespace {

constexpr std::size_t headerBytes = 80;

char *put(char *to, const glm::vec3 &v)
{
    return putBinary(putBinary(putBinary(to, v.x), v.y), v.z);
}

/// Along (b - a) x (c - a), of length 1; zero for a triangle without an area.
glm::vec3 normalOf(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c)
{
    glm::dvec3 u = b - a;
    glm::dvec3 v = c - a;
    // else the product of two tiny edges would vanish
    const double size =
        std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z), std::abs(v.x), std::abs(v.y), std::abs(v.z), 1e-300});
    u /= size;
    v /= size;
    const glm::dvec3 normal = glm::cross(u, v);
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F);
}

class StlWriter
{
public:
    StlWriter(const CopySource &copies, ByteSink &sink)
        : m_copies(copies)
        , m_out(sink)
    {
    }

    std::expected<void, std::string> write(const std::string &comment)
    {
        std::uint64_t faces = 0;
        for (const CopySource::Item &item : m_copies.items()) {
            const std::uint64_t most = item.mesh->faces.empty() ? mostStlFaces : mostStlFaces / item.mesh->faces.size();
            faces += std::min(item.copyCount, most + 1) * item.mesh->faces.size();
            if (faces > mostStlFaces) {
                return std::unexpected("an STL file holds at most 4294967295 faces");
            }
        }
        writeHeader(comment, static_cast<std::uint32_t>(faces));
        for (std::size_t item = 0; item < m_copies.items().size(); ++item) {
            const Mesh &mesh = *m_copies.items()[item].mesh;
            const auto visited = m_copies.visit(item, [&](const MeshCopy &copy) {
                writeCopy(mesh, copy);
                return m_out.isGood() && !m_isBeyondFloats;
            });
            if (!visited) {
                return visited;
            }
            if (m_isBeyondFloats) {
                return std::unexpected("a coordinate is beyond what STL's floats hold (3.4e38)");
            }
        }
        return m_out.flush();
    }

private:
    /// A header that starts with "solid" would be taken for an STL text.
    void writeHeader(const std::string &comment, std::uint32_t faces)
    {
        std::string header = comment.starts_with("solid") ? "STL of " + comment : comment;
        header.resize(headerBytes, ' ');
        m_out.append(header);
        m_out.take(putBinary(m_out.room(sizeof(faces)), faces));
    }

    void writeCopy(const Mesh &mesh, const MeshCopy &copy)
    {
        const std::array<std::size_t, 3> order = cornerOrder(copy.isMirrored);
        m_vertices.clear();
        for (const glm::dvec3 &vertex : mesh.vertices) {
            m_vertices.push_back(copy.worldFromMesh(vertex));
        }
        for (std::size_t face = 0; face < mesh.faces.size() && m_out.isGood(); ++face) {
            std::array<glm::dvec3, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = m_vertices[mesh.faces[face][order[i]]];
            }
            char *to = m_out.room(stlBytesOfFace);
            to = put(to, normalOf(corners[0], corners[1], corners[2]));
            for (const glm::dvec3 &corner : corners) {
                const glm::vec3 rounded(corner);
                m_isBeyondFloats = m_isBeyondFloats || !std::isfinite(rounded.x + rounded.y + rounded.z);
                to = put(to, rounded);
            }
            m_out.take(putBinary(to, std::uint16_t{0}));
        }
    }

    const CopySource &m_copies;
    BufferedOutput m_out;
    /// Of the copy at hand, in the world.
    std::vector<glm::dvec3> m_vertices;
    bool m_isBeyondFloats = false;
};

}

std::expected<void, std::string> writeStl(const CopySource &copies, const std::string &comment, ByteSink &sink)
{
    return StlWriter(copies, sink).write(comment);
}

}
