// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "collideworkloads.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/formats/fdoreader.h"
#include "core/formats/objreader.h"
#include "core/fractal/copies.h"
#include "core/fractal/statetable.h"

namespace romanesco::bench {

namespace {

constexpr int queryCount = 1'500;

std::string textOf(const std::string &file)
{
    std::ifstream stream(ROMANESCO_SOURCE_DIR "/tests/data/collide/" + file);
    if (!stream) {
        std::fprintf(stderr, "cannot read %s\n", file.c_str());
        std::exit(1);
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

FractalDescription described(std::string text, std::uint64_t depth)
{
    const SourceRange digits = readFdo(text).description.value().depth.value().range;
    text.replace(digits.begin, digits.length(), std::to_string(depth));
    return readFdo(text).description.value();
}

Mesh writtenOut(const FractalGraph &graph, const Mesh &mesh)
{
    Mesh all;
    CopyWalk copies(graph);
    while (copies.next()) {
        append(all, mesh, copies.modelFromBase());
    }
    return all;
}

Box boxRound(const std::vector<glm::dvec3> &points)
{
    Box box = Box::ofNothing();
    for (const glm::dvec3 &point : points) {
        box = box.with(point);
    }
    return box;
}

Box scaled(const Box &box, double factor)
{
    const glm::dvec3 half = 0.5 * factor * box.size();
    return {box.centre() - half, box.centre() + half};
}

class Asker
{
public:
    Asker(const Workload &workload, const Collider &exact)
        : m_workload(workload)
        , m_box(workload.box)
        , m_search(exact.search())
        , m_states(workload.graph)
    {
    }

    glm::dvec3 point(Place place)
    {
        return place == Place::Uniform ? inside(scaled(m_box, 1.5)) : place == Place::Near ? nearFace() : inPocket();
    }

private:
    double uniform(double least, double greatest)
    {
        return std::uniform_real_distribution<double>(least, greatest)(m_random);
    }

    glm::dvec3 inside(const Box &box)
    {
        return box.least + glm::dvec3(uniform(0, 1), uniform(0, 1), uniform(0, 1)) * box.size();
    }

    /// A corner and the edges from it.
    struct Face {
        glm::dvec3 corner;
        std::array<glm::dvec3, 2> edges;
    };

    Face face(const Mesh &mesh, const AffineMap &map)
    {
        const Mesh::Face &face = mesh.faces[m_random() % mesh.faces.size()];
        const glm::dvec3 &corner = mesh.vertices[face[0]];
        return {map(corner),
                {map.linear * (mesh.vertices[face[1]] - corner), map.linear * (mesh.vertices[face[2]] - corner)}};
    }

    /// By picks that are equally likely, as long as there are any.
    AffineMap copy()
    {
        AffineMap map;
        for (StateId state = m_states.root();;) {
            const Expansion &expansion = m_states.expansion(state);
            std::vector<std::pair<const AffineMap *, StateId>> children;
            for (const ChildRange &range : expansion.ranges) {
                for (std::uint32_t i = range.firstMap; i < range.endMap; ++i) {
                    children.emplace_back(&m_workload.graph.set(range.set).maps[i], range.next);
                }
            }
            if (children.empty()) {
                return map;
            }
            const auto &[child, next] = children[m_random() % children.size()];
            map = map * *child;
            state = next;
        }
    }

    glm::dvec3 nearFace()
    {
        const bool isWrittenOut = !m_workload.all.faces.empty();
        const Face near = isWrittenOut ? face(m_workload.all, {}) : face(m_workload.mesh, copy());
        const double s = std::sqrt(uniform(0, 1));
        const double t = uniform(0, 1);
        const glm::dvec3 on = near.corner + s * (1 - t) * near.edges[0] + s * t * near.edges[1];
        const glm::dvec3 normal = glm::normalize(glm::cross(near.edges[0], near.edges[1]));
        const double away = m_workload.diagonal * std::pow(10.0, uniform(-3, -1.3));
        return on + (m_random() % 2 == 0 ? away : -away) * normal;
    }

    glm::dvec3 inPocket()
    {
        const Box around = scaled(m_box, 0.9);
        glm::dvec3 best = inside(scaled(m_box, 0.8));
        double distance = distanceFrom(best);
        for (int i = 0; i < 12; ++i) {
            const glm::dvec3 move = inside({glm::dvec3(-1.0), glm::dvec3(1.0)});
            const glm::dvec3 next = glm::clamp(best + 0.1 * m_workload.diagonal * move, around.least, around.greatest);
            if (distanceFrom(next) > distance) {
                best = next;
                distance = distanceFrom(next);
            }
        }
        return best;
    }

    double distanceFrom(const glm::dvec3 &p)
    {
        m_search->closest({p}, m_hit);
        return m_hit.distance;
    }

    const Workload &m_workload;
    Box m_box;
    std::unique_ptr<Search> m_search;
    Hit m_hit;
    StateTable m_states;
    std::mt19937_64 m_random{1};
};

}

void append(Mesh &all, const Mesh &mesh, const AffineMap &map)
{
    const auto before = static_cast<std::uint32_t>(all.vertices.size());
    for (const glm::dvec3 &vertex : mesh.vertices) {
        all.vertices.push_back(map(vertex));
    }
    for (const Mesh::Face &face : mesh.faces) {
        all.faces.push_back({face[0] + before, face[1] + before, face[2] + before});
    }
}

Workload deepWorkload(const std::string &name, std::uint64_t depth)
{
    const FractalDescription description = described(textOf(name + ".fdo"), depth);
    Mesh mesh = readObj(textOf(description.meshPath)).mesh;
    const auto begin = std::chrono::steady_clock::now();
    FractalGraph graph = FractalGraph::build(description, boundingSphere(mesh)).value();
    BoxBounds boxes(graph, mesh);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const Box box = boxes.at(graph, 0);
    return {std::move(mesh), std::move(graph), std::move(boxes), seconds, {}, box, glm::length(box.size())};
}

Workload workload(const std::string &name, std::uint64_t depth)
{
    Workload workload = deepWorkload(name, depth);
    workload.all = writtenOut(workload.graph, workload.mesh);
    workload.box = boxRound(workload.all.vertices);
    workload.diagonal = glm::length(workload.box.size());
    return workload;
}

std::vector<glm::dvec3> queries(const Workload &workload, const Collider &exact, Place place)
{
    Asker asker(workload, exact);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < queryCount; ++i) {
        points.push_back(asker.point(place));
    }
    return points;
}

}
