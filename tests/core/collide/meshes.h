// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "core/geometry/mesh.h"
#include "tests/core/collide/bruteforce.h"

/// Meshes to collide with, and points to ask from.
namespace romanesco::test {

/// 2·rings·(rings - 1) faces, about as long as wide but at the poles.
inline Mesh ball(int rings)
{
    Mesh mesh;
    const auto at = [&](int ring, int step) { return static_cast<std::uint32_t>(ring * rings + step % rings); };
    for (int ring = 0; ring < rings; ++ring) {
        const double u = 3.14159265 * (ring + 0.5) / rings;
        for (int step = 0; step < rings; ++step) {
            const double v = 6.2831853 * step / rings;
            mesh.vertices.push_back({std::sin(u) * std::cos(v), std::cos(u), std::sin(u) * std::sin(v)});
        }
    }
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int step = 0; step < rings; ++step) {
            mesh.faces.push_back({at(ring, step), at(ring, step + 1), at(ring + 1, step)});
            mesh.faces.push_back({at(ring + 1, step), at(ring, step + 1), at(ring + 1, step + 1)});
        }
    }
    return mesh;
}

/// A flat plate of cells by cells squares, in whole numbers: ties everywhere.
inline Mesh plate(std::uint32_t cells)
{
    Mesh mesh;
    for (std::uint32_t i = 0; i <= cells; ++i) {
        for (std::uint32_t j = 0; j <= cells; ++j) {
            mesh.vertices.push_back({i, 0, j});
        }
    }
    for (std::uint32_t i = 0; i < cells; ++i) {
        for (std::uint32_t j = 0; j < cells; ++j) {
            const std::uint32_t corner = i * (cells + 1) + j;
            mesh.faces.push_back({corner, corner + 1, corner + cells + 1});
            mesh.faces.push_back({corner + 1, corner + cells + 2, corner + cells + 1});
        }
    }
    return mesh;
}

/// Triangles that share nothing, with a middle in [-1, 1]^3 and `size` to each side of it; width is that of their third
/// vertex, as a share.
inline Mesh soup(std::mt19937_64 &random, std::uint32_t count, double size, double width = 1.0)
{
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 middle = randomPoint(random, 1.0);
        mesh.vertices.push_back(middle + randomPoint(random, size));
        mesh.vertices.push_back(middle + randomPoint(random, size));
        mesh.vertices.push_back(mesh.vertices.back() + randomPoint(random, size * width));
        mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

inline glm::dvec3 randomVertex(std::mt19937_64 &random, const Mesh &mesh)
{
    return mesh.vertices[mesh.faces[random() % mesh.faces.size()][random() % 3]];
}

inline glm::dvec3 randomPointOnFace(std::mt19937_64 &random, const Mesh &mesh)
{
    const Mesh::Face &face = mesh.faces[random() % mesh.faces.size()];
    const double s = uniform(random, 0, 1);
    const double t = uniform(random, 0, 1 - s);
    return (1 - s - t) * mesh.vertices[face[0]] + s * mesh.vertices[face[1]] + t * mesh.vertices[face[2]];
}

enum class Place { Uniform, Near, OnFaces, AtVertices, Far };

/// Points to ask about a mesh from.
class Places
{
public:
    explicit Places(const Mesh &mesh)
        : m_mesh(mesh)
        , m_around(boundingSphere(mesh))
    {
    }

    glm::dvec3 operator()(std::mt19937_64 &random, Place place) const
    {
        const auto [centre, radius] = m_around;
        switch (place) {
        case Place::Uniform:
            return centre + randomPoint(random, 1.5 * radius);
        case Place::Near:
            return randomPointOnFace(random, m_mesh)
                + randomPoint(random, radius * std::pow(10.0, uniform(random, -4, -1)));
        case Place::OnFaces:
            return randomPointOnFace(random, m_mesh);
        case Place::AtVertices:
            return randomVertex(random, m_mesh);
        case Place::Far:
            return centre + randomPoint(random, radius * std::pow(10.0, uniform(random, 2, 9)));
        }
        return {};
    }

private:
    const Mesh &m_mesh;
    Sphere m_around;
};

inline Wide distanceToFace(const Mesh &mesh, const Mesh::Face &face, const glm::dvec3 &p)
{
    return truth::distance<Wide>(
        {wide(mesh.vertices[face[0]]), wide(mesh.vertices[face[1]]), wide(mesh.vertices[face[2]])}, wide(p));
}

inline Wide distanceToMesh(const Mesh &mesh, const glm::dvec3 &p)
{
    Wide least = std::numeric_limits<double>::infinity();
    for (const Mesh::Face &face : mesh.faces) {
        least = std::min(least, distanceToFace(mesh, face, p));
    }
    return least;
}

/// From p to a vertex, along an axis.
inline double largestOffset(const Mesh &mesh, const glm::dvec3 &p)
{
    double largest = 0.0;
    for (const Mesh::Face &face : mesh.faces) {
        for (const std::uint32_t index : face) {
            for (int axis = 0; axis < 3; ++axis) {
                largest = std::max(largest, std::abs(mesh.vertices[index][axis] - p[axis]));
            }
        }
    }
    return largest;
}

}
