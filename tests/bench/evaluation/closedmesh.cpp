// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "closedmesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <glm/geometric.hpp>

namespace romanesco::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hull = CGAL::Surface_mesh<Kernel::Point_3>;

class Random
{
public:
    double uniform(double least, double greatest)
    {
        return std::uniform_real_distribution<double>(least, greatest)(m_random);
    }

    /// By its length alone (Marsaglia 1972).
    glm::dvec3 direction()
    {
        for (;;) {
            const double z = uniform(-1, 1);
            const double y = uniform(-1, 1);
            const glm::dvec3 v{uniform(-1, 1), y, z};
            const double length = glm::length(v);
            if (length > 0.1 && length < 1.0) {
                return v / length;
            }
        }
    }

private:
    std::mt19937_64 m_random{7};
};

/// Waves along random directions, each octave of half the length and six tenths of the height: within -1 and 1.
class Noise
{
public:
    Noise(double frequency, int octaves, Random &random)
    {
        constexpr int wavesAnOctave = 6;
        double sum = 0.0;
        double height = 1.0;
        for (int i = 0; i < octaves * wavesAnOctave; ++i) {
            const double length = frequency * random.uniform(0.7, 1.4);
            const glm::dvec3 along = length * random.direction();
            m_waves.push_back({along, random.uniform(0, 6.3), height});
            sum += height;
            if (i % wavesAnOctave == wavesAnOctave - 1) {
                frequency *= 2.0;
                height *= 0.6;
            }
        }
        for (Wave &wave : m_waves) {
            wave.height /= sum;
        }
    }

    double operator()(const glm::dvec3 &p) const
    {
        double sum = 0.0;
        for (const Wave &wave : m_waves) {
            sum += wave.height * std::sin(glm::dot(wave.along, p) + wave.phase);
        }
        return sum;
    }

private:
    struct Wave {
        glm::dvec3 along;
        double phase;
        double height;
    };
    std::vector<Wave> m_waves;
};

Mesh hullOf(std::vector<Kernel::Point_3> points)
{
    Hull hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    Mesh mesh;
    for (const auto vertex : hull.vertices()) {
        const Kernel::Point_3 &point = hull.point(vertex);
        mesh.vertices.push_back({point.x(), point.y(), point.z()});
    }
    for (const auto face : hull.faces()) {
        Mesh::Face corners{};
        std::size_t count = 0;
        for (const auto vertex : hull.vertices_around_face(hull.halfedge(face))) {
            assert(count < corners.size() && "a hull of points by chance has triangles alone");
            corners[count++] = static_cast<std::uint32_t>(vertex);
        }
        mesh.faces.push_back(corners);
    }
    return mesh;
}

/// Turned about the height, the more the higher it is.
glm::dvec3 twisted(const glm::dvec3 &p, double angleAUnit)
{
    const double angle = angleAUnit * p.y;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
}

/// The height wound round a circle. What is within its radius from the axis of height stays apart.
glm::dvec3 bent(const glm::dvec3 &p, double radius)
{
    const double angle = p.y / radius;
    const double from = radius - p.x;
    return {radius - from * std::cos(angle), from * std::sin(angle), p.z};
}

/// How far the boulder reaches in a direction.
double boulderReach(const glm::dvec3 &direction, const Noise &noise)
{
    const double value = noise(direction);
    return 1.0 + 0.9 * value - 0.5 * std::abs(value);
}

/// How far the stump reaches in a direction: a rounded cylinder, with seven roots below.
double stumpReach(const glm::dvec3 &u, const Noise &noise, const Noise &bark)
{
    const double across = std::hypot(u.x, u.z);
    const double stem = 1.0 / std::pow(std::pow(across / 0.7, 8.0) + std::pow(std::abs(u.y), 8.0), 0.125);
    const double turn = std::atan2(u.z, u.x);
    const double low = std::clamp(0.2 - u.y, 0.0, 1.0);
    const double roots = across * low * low * (0.9 + 0.9 * std::cos(7.0 * turn + 2.0 * noise(u)));
    const glm::dvec3 alongStem{8.0 * u.x, u.y, 8.0 * u.z};
    return stem * (1.0 + 0.25 * noise(u) + 0.16 * across * bark(alongStem)) + roots;
}

void warp(Mesh &mesh, Form form, Random &random)
{
    const Noise noise(2.5, 7, random);
    const Noise bark(3.0, 4, random);
    for (glm::dvec3 &p : mesh.vertices) {
        const glm::dvec3 u = glm::normalize(p);
        p = form == Form::Boulder ? bent(twisted(boulderReach(u, noise) * u * glm::dvec3(1.0, 1.4, 0.8), 1.1), 2.8)
                                  : bent(twisted(stumpReach(u, noise, bark) * u, 0.4), 6.0);
    }
}

double signedVolume(const Mesh &mesh)
{
    double volume = 0.0;
    for (const auto &[a, b, c] : mesh.faces) {
        volume += glm::dot(mesh.vertices[a], glm::cross(mesh.vertices[b], mesh.vertices[c])) / 6.0;
    }
    return volume;
}

}

Mesh closedMesh(std::uint32_t faces, Form form)
{
    assert(faces >= 4 && faces % 2 == 0 && "a triangulated sphere of n vertices has 2n - 4 faces");
    Random random;
    std::vector<Kernel::Point_3> points;
    for (std::uint32_t i = 0; i < faces / 2 + 2; ++i) {
        const glm::dvec3 u = random.direction();
        points.emplace_back(u.x, u.y, u.z);
    }
    Mesh mesh = hullOf(std::move(points));
    warp(mesh, form, random);
    return mesh;
}

std::string flawOf(const Mesh &mesh)
{
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<Edge> edges;
    std::vector<bool> isUsed(mesh.vertices.size(), false);
    for (const Mesh::Face &face : mesh.faces) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            edges.emplace_back(face[i], face[(i + 1) % face.size()]);
            isUsed[face[i]] = true;
        }
    }
    std::ranges::sort(edges);
    if (std::ranges::adjacent_find(edges) != edges.end()) {
        return "two faces have an edge in the same direction";
    }
    const auto hasOther = [&](const Edge &edge) {
        return std::ranges::binary_search(edges, Edge(edge.second, edge.first));
    };
    if (!std::ranges::all_of(edges, hasOther)) {
        return "an edge has one face alone";
    }
    if (std::ranges::find(isUsed, false) != isUsed.end()) {
        return "a vertex has no face";
    }
    // Euler: V - E + F = 2, each edge being there twice
    if (2 * (mesh.vertices.size() + mesh.faces.size()) != edges.size() + 4) {
        return "it is not one surface without holes through it";
    }
    return signedVolume(mesh) > 0.0 ? std::string() : "its faces look inwards";
}

}
