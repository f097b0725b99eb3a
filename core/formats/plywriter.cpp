// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "plywriter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "binaryoutput.h"

namespace romanesco {

namespace {

/// What the header says, in doubles where it may be more than a file can hold.
struct Extent {
    double vertices = 0.0;
    double faces = 0.0;
    bool hasColours = false;
};

Extent extentOf(const CopySource &copies)
{
    Extent extent;
    for (const CopySource::Item &item : copies.items()) {
        const auto count = static_cast<double>(item.copyCount);
        extent.vertices += count * static_cast<double>(item.mesh->vertices.size());
        extent.faces += count * static_cast<double>(item.mesh->faces.size());
        extent.hasColours = extent.hasColours || !item.mesh->colours.empty();
    }
    return extent;
}

std::string headerText(const Extent &extent, const std::string &comment)
{
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    text += comment.empty() ? "" : "comment " + comment + "\n";
    text += "element vertex " + std::to_string(static_cast<std::uint64_t>(extent.vertices))
        + "\nproperty double x\nproperty double y\nproperty double z\n";
    text += extent.hasColours ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "";
    text += "element face " + std::to_string(static_cast<std::uint64_t>(extent.faces))
        + "\nproperty list uchar uint vertex_indices\nend_header\n";
    return text;
}

char *putColour(char *to, const glm::vec3 &colour)
{
    for (int i = 0; i < 3; ++i) {
        to = putBinary(to, static_cast<std::uint8_t>(std::lround(std::clamp(colour[i], 0.0F, 1.0F) * 255.0F)));
    }
    return to;
}

class PlyWriter
{
public:
    PlyWriter(const CopySource &copies, ByteSink &sink)
        : m_copies(copies)
        , m_extent(extentOf(copies))
        , m_out(sink)
    {
    }

    std::expected<void, std::string> write(const std::string &comment)
    {
        if (m_extent.vertices > static_cast<double>(mostPlyVertices)) {
            return std::unexpected("a PLY file holds at most 4294967296 vertices");
        }
        m_out.append(headerText(m_extent, comment));
        for (const auto pass : {&PlyWriter::writeVertices, &PlyWriter::writeFaces}) {
            for (std::size_t item = 0; item < m_copies.items().size(); ++item) {
                const Mesh &mesh = *m_copies.items()[item].mesh;
                const auto visited = m_copies.visit(item, [&](const MeshCopy &copy) {
                    (this->*pass)(mesh, copy);
                    return m_out.isGood();
                });
                if (!visited) {
                    return visited;
                }
            }
        }
        return m_out.flush();
    }

private:
    void writeVertices(const Mesh &mesh, const MeshCopy &copy)
    {
        for (std::size_t i = 0; i < mesh.vertices.size() && m_out.isGood(); ++i) {
            const glm::dvec3 vertex = copy.worldFromMesh(mesh.vertices[i]);
            char *to = m_out.room(plyBytesOfVertex(true));
            to = putBinary(putBinary(putBinary(to, vertex.x), vertex.y), vertex.z);
            if (m_extent.hasColours) {
                to = putColour(to, mesh.colours.empty() ? glm::vec3(1.0F) : mesh.colours[i]);
            }
            m_out.take(to);
        }
    }

    void writeFaces(const Mesh &mesh, const MeshCopy &copy)
    {
        const std::array<std::size_t, 3> order = cornerOrder(copy.isMirrored);
        for (std::size_t face = 0; face < mesh.faces.size() && m_out.isGood(); ++face) {
            char *to = putBinary(m_out.room(plyBytesOfFace), std::uint8_t{3});
            for (const std::size_t corner : order) {
                to = putBinary(to, static_cast<std::uint32_t>(m_firstVertex + mesh.faces[face][corner]));
            }
            m_out.take(to);
        }
        m_firstVertex += mesh.vertices.size();
    }

    const CopySource &m_copies;
    Extent m_extent;
    BufferedOutput m_out;
    /// Of the copy whose faces are written.
    std::uint64_t m_firstVertex = 0;
};

}

std::expected<void, std::string> writePly(const CopySource &copies, const std::string &comment, ByteSink &sink)
{
    return PlyWriter(copies, sink).write(comment);
}

}
