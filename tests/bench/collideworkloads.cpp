// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "collideworkloads.h"

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
        const auto before = static_cast<std::uint32_t>(all.vertices.size());
        for (const glm::dvec3 &vertex : mesh.vertices) {
            all.vertices.push_back(copies.modelFromBase()(vertex));
        }
        for (const Mesh::Face &face : mesh.faces) {
            all.faces.push_back({face[0] + before, face[1] + before, face[2] + before});
        }
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
        , m_box(boxRound(workload.all.vertices))
        , m_search(exact.search())
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

    glm::dvec3 nearFace()
    {
        const Mesh::Face &face = m_workload.all.faces[m_random() % m_workload.all.faces.size()];
        const std::array corners{m_workload.all.vertices[face[0]], m_workload.all.vertices[face[1]],
                                 m_workload.all.vertices[face[2]]};
        const double s = std::sqrt(uniform(0, 1));
        const double t = uniform(0, 1);
        const glm::dvec3 on = (1 - s) * corners[0] + s * (1 - t) * corners[1] + s * t * corners[2];
        const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
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
    std::mt19937_64 m_random{1};
};

}

Workload workload(const std::string &name, std::uint64_t depth)
{
    const FractalDescription description = described(textOf(name + ".fdo"), depth);
    Mesh mesh = readObj(textOf(description.meshPath)).mesh;
    FractalGraph graph = FractalGraph::build(description, boundingSphere(mesh)).value();
    Mesh all = writtenOut(graph, mesh);
    const double diagonal = glm::length(boxRound(all.vertices).size());
    return {std::move(mesh), std::move(graph), std::move(all), diagonal};
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
