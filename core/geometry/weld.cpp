// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "weld.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <compare>
#include <cstdint>
#include <ranges>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

using Face = Mesh::Face;
using Cell = std::array<double, 3>;

struct CellHash {
    std::size_t operator()(const Cell &cell) const
    {
        std::size_t hash = 0;
        for (const double part : cell) {
            hash = (hash ^ std::hash<double>()(part)) * 0x9E37'79B9'7F4A'7C15;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

/// Vertices that stay, in the cells of a grid twice as wide as the tolerance: what is near a point lies in its cell or
/// in those next to it on the sides to which it leans, eight in all.
class Grid
{
public:
    Grid(const std::vector<glm::dvec3> &vertices, double tolerance)
        : m_vertices(vertices)
        , m_tolerance(tolerance)
        , m_next(vertices.size(), Mesh::none)
    {
    }

    /// The first vertex that stays near the one with this number; if there is none, this one, which stays then.
    std::uint32_t representative(std::uint32_t vertex)
    {
        const glm::dvec3 scaled = m_vertices[vertex] / (2.0 * m_tolerance);
        const glm::dvec3 cell = glm::floor(scaled);
        const glm::dvec3 lean = glm::sign(scaled - cell - 0.5);
        std::uint32_t first = vertex;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 side(corner & 1 ? lean.x : 0.0, corner & 2 ? lean.y : 0.0, corner & 4 ? lean.z : 0.0);
            first = std::min(first, firstNear(keyOf(cell + side), vertex));
        }
        if (first == vertex) {
            const auto [known, isNew] = m_cells.try_emplace(keyOf(cell), vertex);
            if (!isNew) {
                m_next[vertex] = std::exchange(known->second, vertex);
            }
        }
        return first;
    }

private:
    /// -0 is 0.
    static Cell keyOf(const glm::dvec3 &cell) { return {cell.x + 0.0, cell.y + 0.0, cell.z + 0.0}; }

    [[nodiscard]] std::uint32_t firstNear(const Cell &cell, std::uint32_t vertex) const
    {
        std::uint32_t first = vertex;
        const auto known = m_cells.find(cell);
        for (std::uint32_t other = known == m_cells.end() ? Mesh::none : known->second; other != Mesh::none;
             other = m_next[other]) {
            if (other < first && glm::distance(m_vertices[other], m_vertices[vertex]) <= m_tolerance) {
                first = other;
            }
        }
        return first;
    }

    const std::vector<glm::dvec3> &m_vertices;
    double m_tolerance;
    /// The last vertex of each cell, and the one before each.
    std::unordered_map<Cell, std::uint32_t, CellHash> m_cells;
    std::vector<std::uint32_t> m_next;
};

bool isSliver(const Face &face)
{
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// Turned so that the least corner is first, which keeps the way it looks.
Face turned(Face face)
{
    std::ranges::rotate(face, std::ranges::min_element(face));
    return face;
}

/// A face with its corners in ascending order.
struct SortedFace {
    Face corners;
    std::uint32_t face;
    auto operator<=>(const SortedFace &) const = default;
};

/// Marks as many of the faces on the same three vertices that look one way as look the other. The range is of such faces.
template<typename Range>
void markBackToBack(const Range &group, const std::vector<Face> &faces, std::vector<bool> &isDropped)
{
    const auto isForward = [&](const SortedFace &sorted) { return turned(faces[sorted.face]) == sorted.corners; };
    const std::ptrdiff_t forward = std::ranges::count_if(group, isForward);
    const std::ptrdiff_t pairs = std::min(forward, std::ranges::ssize(group) - forward);
    std::array<std::ptrdiff_t, 2> left{pairs, pairs};
    for (const SortedFace &sorted : group) {
        std::ptrdiff_t &count = left[isForward(sorted) ? 1 : 0];
        if (count > 0) {
            isDropped[sorted.face] = true;
            --count;
        }
    }
}

void markWalls(const std::vector<Face> &faces, std::vector<bool> &isDropped)
{
    std::vector<SortedFace> order;
    order.reserve(faces.size());
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        if (!isDropped[i]) {
            order.push_back({faces[i], i});
            std::ranges::sort(order.back().corners);
        }
    }
    std::ranges::sort(order);
    for (auto begin = order.begin(); begin != order.end();) {
        const auto end =
            std::find_if(begin, order.end(), [&](const SortedFace &other) { return other.corners != begin->corners; });
        markBackToBack(std::ranges::subrange(begin, end), faces, isDropped);
        begin = end;
    }
}

/// Whether each edge is passed as often from one end as from the other.
bool isClosed(const std::vector<Face> &faces)
{
    std::vector<std::pair<std::uint64_t, int>> passes;
    passes.reserve(3 * faces.size());
    for (const Face &face : faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint64_t from = face[i];
            const std::uint64_t to = face[(i + 1) % 3];
            passes.emplace_back(std::min(from, to) << 32 | std::max(from, to), from < to ? 1 : -1);
        }
    }
    std::ranges::sort(passes);
    for (auto begin = passes.begin(); begin != passes.end();) {
        std::int64_t sum = 0;
        const auto end =
            std::find_if(begin, passes.end(), [&](const auto &pass) { return pass.first != begin->first; });
        std::for_each(begin, end, [&](const auto &pass) { sum += pass.second; });
        if (sum != 0) {
            return false;
        }
        begin = end;
    }
    return !faces.empty();
}

template<typename Value>
void dropMarked(std::vector<Value> &list, const std::vector<bool> &isDropped)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!isDropped[i]) {
            list[kept++] = list[i];
        }
    }
    list.resize(kept);
}

/// Parts start at the first of their faces that stays; those without any go.
void dropFromParts(std::vector<Mesh::Part> &parts, const std::vector<bool> &isDropped)
{
    std::vector<Mesh::Part> kept;
    std::uint32_t faces = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t end = i + 1 < parts.size() ? parts[i + 1].firstFace : isDropped.size();
        const auto begin = isDropped.begin() + parts[i].firstFace;
        const auto count = std::count(begin, isDropped.begin() + static_cast<std::ptrdiff_t>(end), false);
        if (count > 0) {
            kept.push_back(parts[i]);
            kept.back().firstFace = faces;
        }
        faces += static_cast<std::uint32_t>(count);
    }
    parts = std::move(kept);
}

void dropFaces(Mesh &mesh, const std::vector<bool> &isDropped)
{
    dropMarked(mesh.faces, isDropped);
    dropMarked(mesh.faceTextureCoordinates, isDropped);
    dropMarked(mesh.faceNormals, isDropped);
    dropFromParts(mesh.parts, isDropped);
}

void dropUnusedVertices(Mesh &mesh)
{
    std::vector<bool> isDropped(mesh.vertices.size(), true);
    for (const Face &face : mesh.faces) {
        for (const std::uint32_t vertex : face) {
            isDropped[vertex] = false;
        }
    }
    std::vector<std::uint32_t> number(mesh.vertices.size());
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        number[i] = kept;
        kept += isDropped[i] ? 0 : 1;
    }
    for (Face &face : mesh.faces) {
        for (std::uint32_t &vertex : face) {
            vertex = number[vertex];
        }
    }
    dropMarked(mesh.vertices, isDropped);
    dropMarked(mesh.colours, isDropped);
}

}

bool weld(Mesh &mesh, double tolerance, Weld &result, const std::stop_token &stop)
{
    assert(tolerance > 0.0 && "coinciding needs a distance");
    const std::size_t before = mesh.vertices.size();
    std::vector<std::uint32_t> representative(before);
    {
        Grid grid(mesh.vertices, tolerance);
        for (std::uint32_t i = 0; i < before; ++i) {
            representative[i] = grid.representative(i);
            if (i % 65'536 == 0 && stop.stop_requested()) {
                return false;
            }
        }
    }
    std::vector<bool> isDropped;
    result = {};
    for (Face &face : mesh.faces) {
        face = {representative[face[0]], representative[face[1]], representative[face[2]]};
        isDropped.push_back(isSliver(face));
        result.droppedSlivers += isDropped.back() ? 1 : 0;
    }
    if (stop.stop_requested()) {
        return false;
    }
    markWalls(mesh.faces, isDropped);
    if (stop.stop_requested()) {
        return false;
    }
    const auto dropped = static_cast<std::size_t>(std::ranges::count(isDropped, true));
    result.droppedWalls = dropped - result.droppedSlivers;
    dropFaces(mesh, isDropped);
    dropUnusedVertices(mesh);
    result.droppedVertices = before - mesh.vertices.size();
    result.isClosed = isClosed(mesh.faces);
    return true;
}

}
