// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objtexts.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <format>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

namespace {

/// Between 0 and 1, the same on every system.
double uniform(std::mt19937_64 &random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A Delaunay triangulation of the unit sphere: the convex hull of its vertices.
class Hull
{
public:
    /// An octahedron.
    Hull()
        : m_vertices{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}
    {
        for (const Corners &corners : {Corners{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}}) {
            m_triangles.push_back({corners, {}});
        }
        for (const Corners &corners : {Corners{2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}) {
            m_triangles.push_back({corners, {}});
        }
        // across the edges from the second, third and first corner on
        for (std::uint32_t i = 0; i < 4; ++i) {
            m_triangles[i].neighbours = {(i + 1) % 4, (i + 3) % 4, i + 4};
            m_triangles[i + 4].neighbours = {(i + 3) % 4 + 4, (i + 1) % 4 + 4, i};
        }
    }

    /// Lawson 1977: splits the triangle, then flips edges until all are Delaunay again.
    void insert(std::uint32_t triangle, const glm::dvec3 &point)
    {
        const auto apex = static_cast<std::uint32_t>(m_vertices.size());
        m_vertices.push_back(point);
        const auto [a, b, c] = m_triangles[triangle].corners;
        const auto [acrossA, acrossB, acrossC] = m_triangles[triangle].neighbours;
        const auto second = static_cast<std::uint32_t>(m_triangles.size());
        const std::uint32_t third = second + 1;
        m_triangles[triangle] = {{apex, b, c}, {acrossA, second, third}};
        m_triangles.push_back({{apex, c, a}, {acrossB, third, triangle}});
        m_triangles.push_back({{apex, a, b}, {acrossC, triangle, second}});
        relink(acrossB, triangle, second);
        relink(acrossC, triangle, third);
        m_pending = {triangle, second, third};
        while (!m_pending.empty()) {
            const std::uint32_t next = m_pending.back();
            m_pending.pop_back();
            flipIfNeeded(next);
        }
    }

    using Corners = std::array<std::uint32_t, 3>;
    [[nodiscard]] std::size_t triangleCount() const { return m_triangles.size(); }
    [[nodiscard]] const Corners &corners(std::size_t triangle) const { return m_triangles[triangle].corners; }
    [[nodiscard]] const std::vector<glm::dvec3> &vertices() const { return m_vertices; }

private:
    struct Triangle {
        Corners corners;
        /// Each across the edge that lies opposite the corner.
        Corners neighbours;
    };

    void relink(std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
    {
        for (std::uint32_t &neighbour : m_triangles[triangle].neighbours) {
            if (neighbour == from) {
                neighbour = to;
                return;
            }
        }
    }

    /// The edge opposite the first corner of a triangle, which is the point that was inserted.
    void flipIfNeeded(std::uint32_t triangle)
    {
        const auto [p, b, c] = m_triangles[triangle].corners;
        const std::uint32_t other = m_triangles[triangle].neighbours[0];
        Triangle &across = m_triangles[other];
        std::size_t k = 0;
        while (across.neighbours[k] != triangle) {
            ++k;
        }
        const std::uint32_t d = across.corners[k];
        const glm::dvec3 normal = glm::cross(m_vertices[b] - m_vertices[p], m_vertices[c] - m_vertices[p]);
        if (glm::dot(normal, m_vertices[d] - m_vertices[p]) <= 0) {
            return;
        }
        const std::uint32_t acrossC = across.neighbours[(k + 1) % 3]; // the corners there are d, c, b
        const std::uint32_t acrossB = across.neighbours[(k + 2) % 3];
        const auto [unused, besideB, besideC] = m_triangles[triangle].neighbours;
        m_triangles[triangle] = {{p, b, d}, {acrossC, other, besideC}};
        across = {{p, d, c}, {acrossB, besideB, triangle}};
        relink(acrossC, other, triangle);
        relink(besideB, triangle, other);
        m_pending.push_back(triangle);
        m_pending.push_back(other);
    }

    std::vector<glm::dvec3> m_vertices;
    std::vector<Triangle> m_triangles;
    std::vector<std::uint32_t> m_pending;
};

Hull randomHull(std::size_t faces, std::mt19937_64 &random)
{
    Hull hull;
    while (hull.triangleCount() < faces) {
        const auto triangle = static_cast<std::uint32_t>(random() % hull.triangleCount());
        const auto &[a, b, c] = hull.corners(triangle);
        const double u = 0.1 + uniform(random);
        const double v = 0.1 + uniform(random);
        const double w = 0.1 + uniform(random);
        const auto &at = hull.vertices();
        hull.insert(triangle, glm::normalize(u * at[a] + v * at[b] + w * at[c]));
    }
    return hull;
}

/// Bulges of some sizes, and a little noise.
glm::dvec3 displaced(const glm::dvec3 &p, std::mt19937_64 &random)
{
    const double bulge = 1 + 0.3 * std::sin(3 * p.x + 2 * p.y) * std::cos(4 * p.z - p.y)
        + 0.05 * std::sin(17 * p.x) * std::sin(19 * p.y + 5 * p.z);
    return p * (10 * bulge * (1 + 0.001 * uniform(random)));
}

/// Appends to a text; std::format would make a string for each line.
template<typename... Arguments>
void add(std::string &text, std::format_string<Arguments...> words, Arguments &&...arguments)
{
    std::format_to(std::back_inserter(text), words, std::forward<Arguments>(arguments)...);
}

}

std::string objText(std::size_t faces, ObjStyle style)
{
    std::mt19937_64 random(20250607);
    const Hull hull = randomHull(faces, random);
    const bool isExport = style == ObjStyle::Export;
    std::string text = "# a closed surface\no surface\n";
    for (const glm::dvec3 &vertex : hull.vertices()) {
        const glm::dvec3 p = displaced(vertex, random);
        if (isExport) {
            add(text, "v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
        } else {
            add(text, "v {:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
        }
    }
    if (isExport) {
        for (const glm::dvec3 &p : hull.vertices()) {
            add(text, "vt {:.6f} {:.6f}\n", 0.5 + std::atan2(p.z, p.x) / 6.283185307179586, 0.5 + 0.5 * p.y);
        }
        for (const glm::dvec3 &p : hull.vertices()) {
            add(text, "vn {:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z);
        }
        text += "s 1\n";
    }
    for (std::size_t i = 0; i < hull.triangleCount(); ++i) {
        const auto [a, b, c] = hull.corners(i);
        if (isExport) {
            add(text, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a + 1, b + 1, c + 1);
        } else {
            add(text, "f {} {} {}\n", a + 1, b + 1, c + 1);
        }
    }
    return text;
}

}
