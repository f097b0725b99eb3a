// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "dynamicfractal.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/computable.h"

namespace romanesco {

namespace {

constexpr std::size_t mostSteps = 2000;
/// Of the distance from the origin: little more is told apart in the world's coordinates.
constexpr double finest = 1e-15;

std::vector<AffineMap> iterationOf(const FractalGraph &graph)
{
    StateTable table(graph);
    std::vector<AffineMap> iteration;
    for (const ChildRange &range : table.expansion(table.root()).ranges) {
        const std::vector<AffineMap> &maps = graph.set(range.set).maps;
        iteration.insert(iteration.end(), maps.begin() + range.firstMap, maps.begin() + range.endMap);
    }
    return iteration;
}

bool isWithinRadius(const glm::dvec3 &point, const AffineMap &map, const Mesh &mesh)
{
    const double distance = glm::distance(point, map.translation);
    return std::ranges::any_of(mesh.vertices,
                               [&](const glm::dvec3 &v) { return glm::length(map.linear * v) > distance; });
}

Sphere boundAt(const AffineMap &map, const Model &model)
{
    return transformed(map, operatorNorm(map.linear), model.graph.bound(0));
}

bool canStandAt(const AffineMap &map, const Model &model)
{
    const Sphere bound = boundAt(map, model);
    return operatorNorm(map.linear) >= finest * glm::length(map.translation)
        && isComputable(bound.centre, bound.radius);
}

/// All that a fractal's M has been, from its place on.
std::vector<AffineMap> wayTo(const glm::dvec3 &camera, const SceneItem &item)
{
    const Model &model = *item.model;
    const std::vector<AffineMap> iteration = iterationOf(model.graph);
    std::vector<AffineMap> way{item.worldFromModel};
    while (!iteration.empty() && way.size() <= mostSteps) {
        const AffineMap &m = way.back();
        const auto fromCamera = [&](const AffineMap &t) { return glm::distance(m(t.translation), camera); };
        const AffineMap closest = m * *std::ranges::min_element(iteration, {}, fromCamera);
        if (!isWithinRadius(camera, closest, *model.mesh) || !canStandAt(closest, model)) {
            break;
        }
        way.push_back(closest);
    }
    return way;
}

}

std::shared_ptr<const Surroundings> dynamicSurroundings(std::shared_ptr<const Scene> scene, const glm::dvec3 &camera,
                                                        std::size_t trail)
{
    assert(scene && "a camera is somewhere");
    Surroundings all = *Anchor(std::move(scene)).surroundings();
    const double least = finest * all.nearby.radius; // the card's floats would end
    for (Surroundings::Node &node : all.nodes) {
        const SceneItem &item = all.scene->items[node.item];
        const std::vector<AffineMap> way = wayTo(camera, item);
        const std::size_t steps = way.size() - 1;
        const std::size_t drawn = steps - std::min(trail, steps);
        node.hereFromNode = way[drawn];
        // Nothing that is drawn is smaller, and to a smaller near plane the card's floats could not clip it.
        const Position levels = item.model->graph.levels().levelCount();
        const std::size_t smallest = steps - drawn > levels ? drawn + static_cast<std::size_t>(levels) : steps;
        Sphere last = boundAt(way[smallest], *item.model);
        last.radius = std::max(last.radius, least);
        if (steps > 0 && last.radius < all.nearby.radius) {
            all.nearby = last;
        }
    }
    all.measureReach();
    return std::make_shared<const Surroundings>(std::move(all));
}

}
