// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "cgalcollider.h"

#include <cstdlib>
#include <vector>

#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#include <CGAL/Simple_cartesian.h>
#include <glm/geometric.hpp>

#include "heap.h"

namespace romanesco::bench {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;

Kernel::Point_3 pointOf(const glm::dvec3 &p)
{
    return {p.x, p.y, p.z};
}

Triangles trianglesOf(const Mesh &mesh)
{
    Triangles triangles;
    triangles.reserve(mesh.faces.size());
    for (const Mesh::Face &face : mesh.faces) {
        triangles.emplace_back(pointOf(mesh.vertices[face[0]]), pointOf(mesh.vertices[face[1]]),
                               pointOf(mesh.vertices[face[2]]));
    }
    return triangles;
}

}

class CgalCollider::Tree
{
public:
    explicit Tree(const Mesh &mesh)
        : m_triangles(trianglesOf(mesh))
        , m_tree(m_triangles.cbegin(), m_triangles.cend())
    {
        m_tree.build();
        m_tree.accelerate_distance_queries();
    }

    [[nodiscard]] const Triangles &triangles() const { return m_triangles; }
    [[nodiscard]] const AabbTree &tree() const { return m_tree; }

private:
    Triangles m_triangles;
    AabbTree m_tree;
};

class CgalCollider::Descent final : public Search
{
public:
    explicit Descent(const Tree &tree)
        : m_tree(tree)
    {
    }

    /// It has no such question, and nobody asks.
    void sweep(const Sweep &, Touch &) override { std::abort(); }

    void closest(const Query &query, Hit &hit) override
    {
        const auto [point, triangle] = m_tree.tree().closest_point_and_primitive(pointOf(query.p));
        hit = {};
        hit.promise = Promise::None;
        hit.point = {point.x(), point.y(), point.z()};
        hit.face = static_cast<std::uint32_t>(triangle - m_tree.triangles().cbegin());
        hit.distance = glm::distance(query.p, hit.point);
        hit.direction = (query.p - hit.point) / hit.distance;
    }

private:
    const Tree &m_tree;
};

CgalCollider::CgalCollider(const Mesh &all)
{
    const std::size_t before = heapInUse();
    m_tree = std::make_unique<Tree>(all);
    m_bytes = heapInUse() - before;
}

CgalCollider::~CgalCollider() = default;

std::unique_ptr<Search> CgalCollider::search() const
{
    return std::make_unique<Descent>(*m_tree);
}

}
