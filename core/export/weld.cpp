// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "core/formats/binaryoutput.h"
#include "core/formats/materialtable.h"
#include "vertexgrid.h"

namespace romanesco {

namespace {

using Result = std::expected<void, std::string>;
using Failure = std::unexpected<std::string>;

constexpr double roundingError = 1e-13;
constexpr double shareOfEdge = 1e-6;
constexpr std::size_t betweenStops = 4'096;

double largestOf(const glm::dvec3 &v)
{
    const glm::dvec3 size = glm::abs(v);
    return std::max({size.x, size.y, size.z});
}

/// Things sorted by the vertex of the least number that they have, by counting.
template<typename Thing>
class ByVertex
{
public:
    /// things(take) calls take(vertex, thing) for each, the same ones both times that it is called.
    template<typename Things>
    ByVertex(std::size_t vertexCount, const Things &things)
        : m_first(vertexCount + 2)
    {
        things([&](std::uint32_t vertex, const Thing &) { ++m_first[vertex + 2]; });
        for (std::size_t i = 2; i < m_first.size(); ++i) {
            m_first[i] += m_first[i - 1];
        }
        m_things.resize(m_first.back());
        things([&](std::uint32_t vertex, const Thing &thing) { m_things[m_first[vertex + 1]++] = thing; });
    }

    [[nodiscard]] std::span<Thing> of(std::size_t vertex)
    {
        return {m_things.data() + m_first[vertex], m_things.data() + m_first[vertex + 1]};
    }

private:
    std::vector<std::uint32_t> m_first;
    std::vector<Thing> m_things;
};

class Welder
{
public:
    Welder(const CopySource &copies, const std::stop_token &stop)
        : m_copies(copies)
        , m_stop(stop)
        , m_materials(copies.items())
    {
    }

    std::expected<Welded, std::string> weld()
    {
        if (Result measured = measure(); !measured) {
            return Failure(measured.error());
        }
        if (Result gathered = gather(); !gathered) {
            return Failure(gathered.error());
        }
        dropWalls();
        dropUnusedVertices();
        countOpenEdges();
        if (m_stop.stop_requested()) {
            return Failure("cancelled");
        }
        return Welded{std::move(m_mesh), m_report};
    }

private:
    Result visitAll(const auto &take) const
    {
        for (std::size_t item = 0; item < m_copies.items().size(); ++item) {
            const Mesh &mesh = *m_copies.items()[item].mesh;
            const Result visited = m_copies.visit(item, [&](const MeshCopy &copy) {
                take(mesh, copy);
                return true;
            });
            if (!visited) {
                return visited;
            }
        }
        return {};
    }

    /// How near is the same.
    Result measure()
    {
        double greatest = 0.0;
        const Result first = visitAll([&](const Mesh &mesh, const MeshCopy &copy) {
            for (const glm::dvec3 &vertex : mesh.vertices) {
                greatest = std::max(greatest, largestOf(copy.worldFromMesh(vertex)));
            }
        });
        const double rounding = roundingError * greatest;
        bool isLost = false;
        m_shortestEdge = std::numeric_limits<double>::infinity();
        const Result second = !first ? first : visitAll([&](const Mesh &mesh, const MeshCopy &copy) {
            m_corners.clear();
            for (const glm::dvec3 &vertex : mesh.vertices) {
                m_corners.push_back(copy.worldFromMesh(vertex));
            }
            double longest = 0.0;
            for (const Mesh::Face &face : mesh.faces) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const double edge = largestOf(m_corners[face[i]] - m_corners[face[(i + 1) % 3]]);
                    longest = std::max(longest, edge);
                    m_shortestEdge = edge > rounding ? std::min(m_shortestEdge, edge) : m_shortestEdge;
                }
            }
            // flat copies have edges of no length, and only those of scale 0 have no others
            isLost = isLost || (longest <= rounding && copy.worldFromMesh.linear != glm::dmat3(0.0));
        });
        if (!second) {
            return second;
        }
        if (std::isinf(m_shortestEdge)) {
            m_shortestEdge = std::max(8.0 * rounding, std::numeric_limits<double>::min()); // nothing but points
        }
        m_report.tolerance = std::max(rounding, shareOfEdge * m_shortestEdge);
        return isLost || 4.0 * m_report.tolerance > m_shortestEdge
            ? Failure("the smallest copies are hardly larger than the rounding error of coordinates")
            : Result();
    }

    Result gather()
    {
        VertexGrid grid(m_report.tolerance, m_shortestEdge);
        const bool hasColours =
            std::ranges::any_of(m_copies.items(), [](const auto &item) { return !item.mesh->colours.empty(); });
        const Result visited = visitAll([&](const Mesh &mesh, const MeshCopy &copy) {
            m_numbers.clear();
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                const std::size_t before = grid.points().size();
                m_numbers.push_back(grid.add(copy.worldFromMesh(mesh.vertices[i])));
                if (grid.points().size() == before) {
                    ++m_report.mergedVertices;
                } else if (hasColours) {
                    m_mesh.colours.push_back(mesh.colours.empty() ? glm::vec3(1.0F) : mesh.colours[i]);
                }
            }
            addFaces(mesh, copy);
        });
        m_mesh.vertices = grid.take();
        for (const MaterialTable::Entry &entry : m_materials.entries()) {
            m_mesh.materials.push_back(*entry.material);
            m_mesh.materials.back().name = entry.name;
        }
        return visited;
    }

    void addFaces(const Mesh &mesh, const MeshCopy &copy)
    {
        const std::uint32_t firstTexture = firstTextureOf(mesh);
        const std::array<std::size_t, 3> order = cornerOrder(copy.isMirrored);
        const std::vector<Mesh::Part> parts = partsOf(mesh);
        for (std::size_t part = 0; part < parts.size(); ++part) {
            beginPart(mesh, parts[part], copy.branch);
            for (std::uint32_t at = parts[part].firstFace; at < endOfPart(mesh, parts, part); ++at) {
                Mesh::Face face;
                Mesh::Face texture{Mesh::none, Mesh::none, Mesh::none};
                for (std::size_t i = 0; i < 3; ++i) {
                    face[i] = m_numbers[mesh.faces[at][order[i]]];
                    if (!mesh.faceTextureCoordinates.empty()) {
                        const std::uint32_t index = mesh.faceTextureCoordinates[at][order[i]];
                        texture[i] = index == Mesh::none ? Mesh::none : firstTexture + index;
                    }
                }
                if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
                    ++m_report.droppedFaces;
                    continue;
                }
                m_mesh.faces.push_back(face);
                m_mesh.faceTextureCoordinates.push_back(texture);
            }
        }
    }

    /// Texture coordinates of a mesh stand once, before those of the meshes that come later.
    std::uint32_t firstTextureOf(const Mesh &mesh)
    {
        const auto size = static_cast<std::uint32_t>(m_mesh.textureCoordinates.size());
        const auto [known, isNew] = m_firstTextures.try_emplace(&mesh, size);
        if (isNew) {
            m_mesh.textureCoordinates.insert(m_mesh.textureCoordinates.end(), mesh.textureCoordinates.begin(),
                                             mesh.textureCoordinates.end());
        }
        return known->second;
    }

    void beginPart(const Mesh &mesh, const Mesh::Part &part, std::string_view branch)
    {
        const std::string_view group = !branch.empty() ? branch
            : part.group == Mesh::none                 ? std::string_view()
                                                       : std::string_view(mesh.groups[part.group]);
        const Mesh::Part next{static_cast<std::uint32_t>(m_mesh.faces.size()), m_materials.entryOf(mesh, part.material),
                              groupNamed(group), part.smoothing};
        const auto looks = [](const Mesh::Part &p) { return std::tuple(p.material, p.group, p.smoothing); };
        if (m_mesh.parts.empty() || looks(m_mesh.parts.back()) != looks(next)) {
            m_mesh.parts.push_back(next);
        }
    }

    std::uint32_t groupNamed(std::string_view name)
    {
        if (name.empty()) {
            return Mesh::none;
        }
        const auto [known, isNew] =
            m_groups.try_emplace(std::string(name), static_cast<std::uint32_t>(m_mesh.groups.size()));
        if (isNew) {
            m_mesh.groups.emplace_back(name);
        }
        return known->second;
    }

    /// A face by its corners in ascending order, and whether they turn the other way.
    struct Side {
        std::uint32_t middle;
        std::uint32_t last;
        std::uint32_t face;
        bool isReversed;

        [[nodiscard]] bool isSamePlace(const Side &other) const { return middle == other.middle && last == other.last; }
    };

    /// Of faces in one place the first is kept, or none where they look to both sides.
    void dropWalls()
    {
        ByVertex<Side> sides(m_mesh.vertices.size(), [&](const auto &take) {
            for (std::uint32_t i = 0; i < m_mesh.faces.size() && !isStopped(i); ++i) {
                Mesh::Face face = m_mesh.faces[i];
                std::ranges::rotate(face, std::ranges::min_element(face));
                const bool isReversed = face[1] > face[2];
                take(face[0], {std::min(face[1], face[2]), std::max(face[1], face[2]), i, isReversed});
            }
        });
        std::vector<bool> isDropped(m_mesh.faces.size());
        for (std::size_t vertex = 0; vertex < m_mesh.vertices.size() && !isStopped(vertex); ++vertex) {
            const std::span<Side> all = sides.of(vertex);
            std::ranges::sort(all, {}, [](const Side &s) { return std::tuple(s.middle, s.last, s.face); });
            for (std::size_t i = 0; i < all.size();) {
                std::size_t end = i + 1;
                bool isWall = false;
                for (; end < all.size() && all[end].isSamePlace(all[i]); ++end) {
                    isWall = isWall || all[end].isReversed != all[i].isReversed;
                    isDropped[all[end].face] = true;
                }
                isDropped[all[i].face] = isWall;
                (isWall ? m_report.droppedWalls : m_report.droppedFaces) += end - i - (isWall ? 0 : 1);
                i = end;
            }
        }
        keepFaces(isDropped);
    }

    void keepFaces(const std::vector<bool> &isDropped)
    {
        std::uint32_t kept = 0;
        std::size_t part = 0;
        for (std::uint32_t i = 0; i < isDropped.size() && !isStopped(i); ++i) {
            for (; part < m_mesh.parts.size() && m_mesh.parts[part].firstFace == i; ++part) {
                m_mesh.parts[part].firstFace = kept;
            }
            if (!isDropped[i]) {
                m_mesh.faces[kept] = m_mesh.faces[i];
                m_mesh.faceTextureCoordinates[kept++] = m_mesh.faceTextureCoordinates[i];
            }
        }
        for (; part < m_mesh.parts.size(); ++part) {
            m_mesh.parts[part].firstFace = kept;
        }
        m_mesh.faces.resize(kept);
        m_mesh.faceTextureCoordinates.resize(m_mesh.textureCoordinates.empty() ? 0 : kept);
    }

    void dropUnusedVertices()
    {
        std::vector<std::uint32_t> numbers(m_mesh.vertices.size(), Mesh::none);
        for (const Mesh::Face &face : m_mesh.faces) {
            for (const std::uint32_t vertex : face) {
                numbers[vertex] = 0;
            }
        }
        std::uint32_t kept = 0;
        for (std::size_t i = 0; i < numbers.size() && !isStopped(i); ++i) {
            if (numbers[i] == 0) {
                m_mesh.vertices[kept] = m_mesh.vertices[i];
                if (!m_mesh.colours.empty()) {
                    m_mesh.colours[kept] = m_mesh.colours[i];
                }
                numbers[i] = kept++;
            }
        }
        m_mesh.vertices.resize(kept);
        m_mesh.colours.resize(m_mesh.colours.empty() ? 0 : kept);
        for (Mesh::Face &face : m_mesh.faces) {
            for (std::uint32_t &vertex : face) {
                vertex = numbers[vertex];
            }
        }
    }

    /// The other end of an edge, and whether it leads there.
    struct Way {
        std::uint32_t end;
        bool isForward;
    };

    void countOpenEdges()
    {
        ByVertex<Way> ways(m_mesh.vertices.size(), [&](const auto &take) {
            for (std::size_t i = 0; i < m_mesh.faces.size() && !isStopped(i); ++i) {
                const Mesh::Face &face = m_mesh.faces[i];
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const auto [least, greatest] = std::minmax(face[corner], face[(corner + 1) % 3]);
                    take(least, {greatest, face[corner] == least});
                }
            }
        });
        for (std::size_t vertex = 0; vertex < m_mesh.vertices.size() && !isStopped(vertex); ++vertex) {
            const std::span<Way> all = ways.of(vertex);
            std::ranges::sort(all, {}, &Way::end);
            for (std::size_t i = 0; i < all.size();) {
                std::int64_t sum = 0;
                const std::uint32_t end = all[i].end;
                for (; i < all.size() && all[i].end == end; ++i) {
                    sum += all[i].isForward ? 1 : -1;
                }
                m_report.openEdges += sum != 0 ? 1 : 0;
            }
        }
    }

    /// After a stop the loops end, and what they would have made is not used.
    [[nodiscard]] bool isStopped(std::size_t step) const { return step % betweenStops == 0 && m_stop.stop_requested(); }

    const CopySource &m_copies;
    const std::stop_token &m_stop;
    MaterialTable m_materials;
    double m_shortestEdge = 0.0;
    Mesh m_mesh;
    WeldReport m_report;
    std::map<const Mesh *, std::uint32_t> m_firstTextures;
    std::map<std::string, std::uint32_t> m_groups;
    /// Of the copy at hand: its vertices in the world, and their numbers.
    std::vector<glm::dvec3> m_corners;
    std::vector<std::uint32_t> m_numbers;
};

}

std::expected<Welded, std::string> weld(const CopySource &copies, const std::stop_token &stop)
{
    std::uint64_t faces = 0;
    for (const CopySource::Item &item : copies.items()) {
        const std::uint64_t ofMesh = std::max<std::size_t>(item.mesh->faces.size(), 1);
        faces += std::min(item.copyCount, mostWeldedFaces / ofMesh + 1) * ofMesh;
        if (faces > mostWeldedFaces) {
            return Failure("welding holds all faces in memory, at most " + std::to_string(mostWeldedFaces));
        }
    }
    return Welder(copies, stop).weld();
}

}
