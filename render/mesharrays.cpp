// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "mesharrays.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

std::array<float, 3> asFloats(const glm::dvec3 &v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// What keeps its length near 1 however long it was; zero stays.
glm::dvec3 unitOf(const glm::dvec3 &v)
{
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return size > 0.0 && std::isfinite(size) ? glm::normalize(v / size) : glm::dvec3(0.0);
}

class Builder
{
public:
    Builder(const Mesh &mesh, const Sphere &base)
        : m_mesh(mesh)
        , m_base(base)
        , m_scale(base.radius > 0.0 ? 1.0 / base.radius : 1.0)
    {
    }

    MeshArrays build()
    {
        findNormals();
        const bool hasCorners = !m_normals.empty() || !m_mesh.faceTextureCoordinates.empty();
        hasCorners ? addCorners() : addVertices();
        sortByMaterial();
        return std::move(m_made);
    }

private:
    /// A vertex with its texture coordinates and its normal, by their numbers.
    using Corner = std::array<std::uint32_t, 3>;
    struct Hash {
        std::size_t operator()(const Corner &corner) const
        {
            std::size_t seed = 0;
            for (const std::uint32_t number : corner) {
                seed = (seed ^ number) * 0x9e3779b97f4a7c15u;
                seed ^= seed >> 32;
            }
            return seed;
        }
    };

    [[nodiscard]] glm::dvec3 placed(std::uint32_t vertex) const
    {
        return (m_mesh.vertices[vertex] - m_base.centre) * m_scale;
    }

    /// The face behind the last of a part.
    [[nodiscard]] std::size_t endOf(std::size_t part) const
    {
        return part + 1 < m_mesh.parts.size() ? m_mesh.parts[part + 1].firstFace : m_mesh.faces.size();
    }

    // ---- Normals

    void findNormals()
    {
        const auto isSmoothed = [](const Mesh::Part &part) { return part.smoothing != 0; };
        const bool anySmoothed = std::ranges::any_of(m_mesh.parts, isSmoothed);
        if (m_mesh.faceNormals.empty() && !anySmoothed) {
            return;
        }
        for (const glm::dvec3 &normal : m_mesh.normals) {
            m_normals.push_back(unitOf(normal));
        }
        m_faceNormals = m_mesh.faceNormals;
        m_faceNormals.resize(m_mesh.faces.size(), {Mesh::none, Mesh::none, Mesh::none});
        if (anySmoothed) {
            smooth();
        }
    }

    /// Sums of the planes that meet at a vertex in a smoothing group.
    void smooth()
    {
        const std::size_t own = m_normals.size();
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
        for (std::size_t i = 0; i < m_mesh.parts.size(); ++i) {
            const Mesh::Part &part = m_mesh.parts[i];
            for (std::size_t face = part.firstFace; part.smoothing != 0 && face < endOf(i); ++face) {
                const glm::dvec3 plane = planeOf(m_mesh.faces[face]);
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    std::uint32_t &normal = m_faceNormals[face][corner];
                    if (normal != Mesh::none) {
                        continue;
                    }
                    const auto next = static_cast<std::uint32_t>(m_normals.size());
                    const auto [found, isNew] = known.try_emplace({m_mesh.faces[face][corner], part.smoothing}, next);
                    if (isNew) {
                        m_normals.emplace_back(0.0);
                    }
                    normal = found->second;
                    m_normals[normal] += plane * angleAt(m_mesh.faces[face], corner);
                }
            }
        }
        for (std::size_t i = own; i < m_normals.size(); ++i) {
            m_normals[i] = unitOf(m_normals[i]);
        }
    }

    [[nodiscard]] glm::dvec3 planeOf(const Mesh::Face &face) const
    {
        const glm::dvec3 a = placed(face[0]);
        return unitOf(glm::cross(placed(face[1]) - a, placed(face[2]) - a));
    }

    [[nodiscard]] double angleAt(const Mesh::Face &face, std::size_t corner) const
    {
        const glm::dvec3 at = placed(face[corner]);
        const glm::dvec3 u = unitOf(placed(face[(corner + 1) % 3]) - at);
        const glm::dvec3 v = unitOf(placed(face[(corner + 2) % 3]) - at);
        return std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
    }

    // ---- Rows

    void addVertices()
    {
        for (std::uint32_t vertex = 0; vertex < m_mesh.vertices.size(); ++vertex) {
            addRow({vertex, Mesh::none, Mesh::none});
        }
        m_made.faces = m_mesh.faces;
    }

    void addCorners()
    {
        std::unordered_map<Corner, std::uint32_t, Hash> known;
        m_made.faces.reserve(m_mesh.faces.size());
        for (std::size_t face = 0; face < m_mesh.faces.size(); ++face) {
            Mesh::Face made{};
            for (std::size_t i = 0; i < 3; ++i) {
                const Corner corner{m_mesh.faces[face][i], numberAt(m_mesh.faceTextureCoordinates, face, i),
                                    numberAt(m_faceNormals, face, i)};
                const auto next = static_cast<std::uint32_t>(m_made.positions.size());
                const auto [found, isNew] = known.try_emplace(corner, next);
                if (isNew) {
                    addRow(corner);
                }
                made[i] = found->second;
            }
            m_made.faces.push_back(made);
        }
    }

    static std::uint32_t numberAt(const std::vector<Mesh::Face> &numbers, std::size_t face, std::size_t corner)
    {
        return numbers.empty() ? Mesh::none : numbers[face][corner];
    }

    void addRow(const Corner &corner)
    {
        const auto &[vertex, texture, normal] = corner;
        m_made.positions.push_back(asFloats(placed(vertex)));
        if (!m_normals.empty()) {
            m_made.normals.push_back(asFloats(normal == Mesh::none ? glm::dvec3(0.0) : m_normals[normal]));
        }
        if (!m_mesh.faceTextureCoordinates.empty()) {
            const glm::dvec2 at = texture == Mesh::none ? glm::dvec2(0.0) : m_mesh.textureCoordinates[texture];
            m_made.textureCoordinates.push_back({static_cast<float>(at.x), static_cast<float>(1.0 - at.y)});
        }
        if (!m_mesh.colours.empty()) {
            const glm::vec3 &colour = m_mesh.colours[vertex];
            m_made.colours.push_back({colour.x, colour.y, colour.z});
        }
    }

    // ---- Parts

    [[nodiscard]] std::vector<std::uint32_t> materialsOfFaces() const
    {
        std::vector<std::uint32_t> materials(m_mesh.faces.size(), Mesh::none);
        for (std::size_t i = 0; i < m_mesh.parts.size(); ++i) {
            std::fill(materials.begin() + m_mesh.parts[i].firstFace,
                      materials.begin() + static_cast<std::ptrdiff_t>(endOf(i)), m_mesh.parts[i].material);
        }
        return materials;
    }

    void sortByMaterial()
    {
        const std::vector<std::uint32_t> materials = materialsOfFaces();
        std::vector<std::size_t> order(materials.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t face) { return materials[face]; });
        std::vector<Mesh::Face> sorted;
        sorted.reserve(order.size());
        for (const std::size_t face : order) {
            if (m_made.parts.empty() || m_made.parts.back().material != materials[face]) {
                m_made.parts.push_back({sorted.size(), 0, materials[face]});
            }
            ++m_made.parts.back().faceCount;
            sorted.push_back(m_made.faces[face]);
        }
        m_made.faces = std::move(sorted);
    }

    const Mesh &m_mesh;
    const Sphere &m_base;
    double m_scale;
    /// The mesh's own, then those of smoothing groups; empty where all faces are flat.
    std::vector<glm::dvec3> m_normals;
    std::vector<Mesh::Face> m_faceNormals;
    MeshArrays m_made;
};

}

MeshArrays arraysOf(const Mesh &mesh, const Sphere &base)
{
    return Builder(mesh, base).build();
}

}
