// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <vector>

#include "core/collide/writtenout.h"
#include "core/physics/ballstep.h"
#include "core/scene/scene.h"
#include "tests/core/geometry/triangletruth.h"

/// The oracle of the laws of physics.
namespace romanesco::test {

/// Every face of a scene, and how near ways and points come to them: by trying each in long doubles, but for those that a
/// sphere round some tells to be farther.
class WrittenSurface
{
public:
    using Vector = truth::Vector<long double>;
    using Triangle = std::array<Vector, 3>;

    explicit WrittenSurface(const std::vector<SceneItem> &items)
    {
        for (const SceneItem &item : items) {
            const Mesh mesh = writtenOut(item.model->graph, *item.model->mesh, item.worldFromModel, 10'000'000).value();
            for (const Mesh::Face &face : mesh.faces) {
                m_triangles.push_back(
                    {longOf(mesh.vertices[face[0]]), longOf(mesh.vertices[face[1]]), longOf(mesh.vertices[face[2]])});
            }
        }
        constexpr std::size_t most = 32;
        for (std::size_t i = 0; i < m_triangles.size(); ++i) {
            m_spheres.push_back(around(i, i + 1));
            if (i % most == 0) {
                m_chunks.push_back(around(i, std::min(i + most, m_triangles.size())));
            }
        }
    }

    [[nodiscard]] const std::vector<Triangle> &triangles() const { return m_triangles; }

    /// The least distance of a straight way; `most` where that is less.
    [[nodiscard]] double distance(const glm::dvec3 &from, const glm::dvec3 &to, double most) const
    {
        long double least = most;
        forNear(
            from, to, [&]() { return static_cast<double>(least); },
            [&](const Triangle &triangle) { least = std::min(least, distance(triangle, longOf(from), longOf(to))); });
        return static_cast<double>(least);
    }

    /// The direction from the nearest point of each face that is within a distance to p, which is not on one.
    [[nodiscard]] std::vector<glm::dvec3> directions(const glm::dvec3 &p, double distance) const
    {
        std::vector<glm::dvec3> found;
        forNear(
            p, p, [&]() { return distance; },
            [&](const Triangle &triangle) {
                const Vector way = truth::wayFrom(triangle, longOf(p));
                const long double length = lengthOf(way);
                if (length <= distance) {
                    found.emplace_back(way[0] / length, way[1] / length, way[2] / length);
                }
            });
        return found;
    }

private:
    /// Round some faces.
    struct Around {
        std::size_t first;
        std::size_t last;
        glm::dvec3 centre;
        double radius;
    };

    static Vector longOf(const glm::dvec3 &v) { return {v.x, v.y, v.z}; }

    [[nodiscard]] Around around(std::size_t first, std::size_t last) const
    {
        Around sphere{first, last, glm::dvec3(0.0), 0.0};
        const auto each = [&](const auto &use) {
            for (std::size_t i = first; i < last; ++i) {
                for (const Vector &v : m_triangles[i]) {
                    use(glm::dvec3(v[0], v[1], v[2]));
                }
            }
        };
        each([&](const glm::dvec3 &v) { sphere.centre += v / (3.0 * static_cast<double>(last - first)); });
        each([&](const glm::dvec3 &v) {
            sphere.radius = std::max(sphere.radius, glm::distance(v, sphere.centre) * (1.0 + 1e-12));
        });
        return sphere;
    }

    /// All faces that may be within a reach, which may become less, from a straight way.
    template<typename Reach, typename Use>
    void forNear(const glm::dvec3 &from, const glm::dvec3 &to, const Reach &reach, const Use &use) const
    {
        const glm::dvec3 way = to - from;
        const double square = glm::dot(way, way);
        const auto isNear = [&](const Around &sphere) {
            const double along =
                square > 0.0 ? std::clamp(glm::dot(sphere.centre - from, way) / square, 0.0, 1.0) : 0.0;
            return glm::distance(from + along * way, sphere.centre) <= (reach() + sphere.radius) * (1.0 + 1e-9);
        };
        for (const Around &chunk : m_chunks) {
            if (isNear(chunk)) {
                for (std::size_t i = chunk.first; i < chunk.last; ++i) {
                    if (isNear(m_spheres[i])) {
                        use(m_triangles[i]);
                    }
                }
            }
        }
    }

    static long double distance(const Triangle &triangle, const Vector &from, const Vector &to)
    {
        if (crosses(triangle, from, to)) {
            return 0.0L;
        }
        long double least = std::min(distance(triangle, from), distance(triangle, to));
        for (std::size_t i = 0; i < 3; ++i) {
            least = std::min(least, distance(triangle[i], triangle[(i + 1) % 3], from, to));
        }
        return least;
    }

    static long double lengthOf(const Vector &v) { return std::sqrt(truth::dot(v, v)); }

    static long double distance(const Triangle &triangle, const Vector &p)
    {
        return lengthOf(truth::wayFrom(triangle, p));
    }

    static Vector cross(const Vector &a, const Vector &b)
    {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /// Whether a way goes through a face, not along it: of a tetrahedron's volumes all three round the way have one sign.
    static bool crosses(const Triangle &triangle, const Vector &from, const Vector &to)
    {
        const Vector normal =
            cross(truth::difference(triangle[1], triangle[0]), truth::difference(triangle[2], triangle[0]));
        const long double before = truth::dot(normal, truth::difference(from, triangle[0]));
        const long double after = truth::dot(normal, truth::difference(to, triangle[0]));
        if ((before > 0.0L) == (after > 0.0L)) {
            return false;
        }
        const Vector way = truth::difference(to, from);
        bool isAbove = true;
        bool isBelow = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const long double volume = truth::dot(
                way, cross(truth::difference(triangle[i], from), truth::difference(triangle[(i + 1) % 3], from)));
            isAbove = isAbove && volume >= 0.0L;
            isBelow = isBelow && volume <= 0.0L;
        }
        return isAbove || isBelow;
    }

    /// Of two lines where both feet are within: the ends are tried with the faces.
    static long double distance(const Vector &a, const Vector &b, const Vector &from, const Vector &to)
    {
        const Vector edge = truth::difference(b, a);
        const Vector way = truth::difference(to, from);
        const Vector between = truth::difference(from, a);
        const long double ee = truth::dot(edge, edge);
        const long double ww = truth::dot(way, way);
        const long double ew = truth::dot(edge, way);
        const long double determinant = ee * ww - ew * ew;
        const long double s = truth::dot(edge, between) * ww - truth::dot(way, between) * ew;
        const long double t = truth::dot(edge, between) * ew - truth::dot(way, between) * ee;
        long double square = std::numeric_limits<long double>::infinity();
        if (determinant > 1e-30L * ee * ww && s >= 0.0L && s <= determinant && t >= 0.0L && t <= determinant) {
            const Vector n = cross(edge, way);
            const long double off = truth::dot(n, between);
            square = off * off / truth::dot(n, n);
        }
        for (const Vector &end : {a, b}) { // from the edge's ends to the way
            const Vector toEnd = truth::difference(end, from);
            const long double along = ww > 0.0L ? std::clamp(truth::dot(toEnd, way) / ww, 0.0L, 1.0L) : 0.0L;
            const Vector off{toEnd[0] - along * way[0], toEnd[1] - along * way[1], toEnd[2] - along * way[2]};
            square = std::min(square, truth::dot(off, off));
        }
        return std::sqrt(square);
    }

    std::vector<Triangle> m_triangles;
    /// Each face's, and those of some faces after one another.
    std::vector<Around> m_spheres;
    std::vector<Around> m_chunks;
};

}
