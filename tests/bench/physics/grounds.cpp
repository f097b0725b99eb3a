// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "grounds.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

#include "tests/bench/collideworkloads.h"

namespace romanesco::bench {

namespace {

constexpr double restitution = 0.5;

class Random
{
public:
    double uniform(double least, double greatest)
    {
        return std::uniform_real_distribution<double>(least, greatest)(m_random);
    }

    glm::dvec3 in(const Box &box)
    {
        const double x = uniform(box.least.x, box.greatest.x);
        const double y = uniform(box.least.y, box.greatest.y);
        return {x, y, uniform(box.least.z, box.greatest.z)};
    }

    /// By its length alone (Marsaglia 1972).
    glm::dvec3 direction()
    {
        for (;;) {
            const glm::dvec3 v = in({glm::dvec3(-1.0), glm::dvec3(1.0)});
            const double length = glm::length(v);
            if (length > 0.1 && length < 1.0) {
                return v / length;
            }
        }
    }

    std::mt19937_64 &engine() { return m_random; }

private:
    std::mt19937_64 m_random{7};
};

/// At random places of grids, one above the other, from what is wide enough for a ball and a half.
std::vector<glm::dvec3> layers(const Box &box, double radius, std::size_t count, Random &random)
{
    const double width = 3.0 * radius;
    const auto along = static_cast<std::size_t>(std::max(1.0, box.size().x / width));
    const auto across = static_cast<std::size_t>(std::max(1.0, box.size().z / width));
    std::vector<glm::dvec3> places;
    for (double height = box.greatest.y + width; places.size() < count; height += width) {
        std::vector<glm::dvec3> layer;
        for (std::size_t i = 0; i < along * across; ++i) {
            const double x = box.least.x + (static_cast<double>(i % along) + 0.5) * width;
            const double z = box.least.z + (static_cast<double>(i / along) + 0.5) * width;
            const double play = 0.5 * radius;
            const glm::dvec3 off{random.uniform(-play, play), random.uniform(-play, play), random.uniform(-play, play)};
            layer.push_back(glm::dvec3(x, height, z) + off);
        }
        std::ranges::shuffle(layer, random.engine());
        layer.resize(std::min(layer.size(), count - places.size()));
        places.insert(places.end(), layer.begin(), layer.end());
    }
    return places;
}

/// A floor and four walls round a box, as high as that.
Mesh trayMesh(const Box &box)
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({(i & 1) != 0 ? box.greatest.x : box.least.x,
                                 (i & 2) != 0 ? box.greatest.y : box.least.y,
                                 (i & 4) != 0 ? box.greatest.z : box.least.z});
    }
    mesh.faces = {{0, 1, 4}, {1, 5, 4}, {0, 1, 2}, {1, 3, 2}, {4, 5, 6},
                  {5, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

}

Ground groundOf(const std::string &name, std::uint64_t depth, const glm::dvec3 &angles)
{
    Workload made = workload(name, depth);
    AffineMap place = mapFromParts(glm::dvec3(0.0), angles, glm::dvec3(Ground::size / made.diagonal));
    place.translation = -place(made.box.centre());
    Box box = Box::ofNothing();
    for (glm::dvec3 &vertex : made.all.vertices) {
        vertex = place(vertex);
        box = box.with(vertex);
    }
    const std::size_t bytes = made.graph.memoryUse() + made.boxes.memoryUse();
    auto model = std::make_shared<const Model>(Model{std::make_shared<const Mesh>(std::move(made.mesh)),
                                                     std::move(made.graph),
                                                     std::move(made.boxes),
                                                     made.box,
                                                     {}});
    Scene scene;
    scene.items.push_back({.model = std::move(model), .worldFromModel = place});
    return {std::make_shared<const Scene>(std::move(scene)), std::move(made.all), box, made.seconds, bytes};
}

Ground inTray(Ground ground)
{
    const auto mesh = std::make_shared<const Mesh>(trayMesh(ground.box));
    FractalGraph graph = FractalGraph::ofMesh(boundingSphere(*mesh));
    BoxBounds boxes(graph, *mesh);
    Scene scene = *ground.scene;
    scene.items.push_back(
        {.model = std::make_shared<const Model>(Model{mesh, std::move(graph), std::move(boxes), ground.box, {}})});
    ground.scene = std::make_shared<const Scene>(std::move(scene));
    return ground;
}

std::vector<Ball> ballsOver(const Ground &ground, Start start, double radius, std::size_t count, double speed)
{
    Random random;
    std::vector<Ball> balls;
    const auto add = [&](const glm::dvec3 &position, const glm::dvec3 &velocity) {
        balls.push_back({.position = position, .velocity = velocity, .radius = radius, .restitution = restitution});
    };
    if (start == Start::Rain) {
        for (const glm::dvec3 &place : layers(ground.box, radius, count, random)) {
            add(place, glm::dvec3(0.0));
        }
    }
    Box above = ground.box;
    above.least.y = above.greatest.y + 1.5 * radius;
    above.greatest.y = above.least.y + 0.1 * Ground::size;
    while (balls.size() < count) {
        if (start == Start::Drop) {
            add(random.in(above), glm::dvec3(0.0));
        } else {
            const glm::dvec3 from = 0.6 * Ground::size * random.direction();
            add(from, speed * glm::normalize(random.in(ground.box) - from));
        }
    }
    return balls;
}

}
