// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scene.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/fractal/extent.h"

namespace romanesco {

namespace {

/// Copies looked at in one direction, by all items together, and by each of many at least.
constexpr std::size_t wholeBudget = 20'000;
constexpr std::size_t leastBudget = 500;

bool isInPlace(const SceneItem &item)
{
    return item.worldFromModel == AffineMap{};
}

double reachOfSphere(const Sphere &sphere, const glm::dvec3 &direction)
{
    return sphere.isEmpty() ? -std::numeric_limits<double>::infinity()
                            : glm::dot(direction, sphere.centre) + glm::length(direction) * sphere.radius;
}

double reachOf(const SceneItem &item, const glm::dvec3 &direction, std::size_t budget)
{
    const Model &model = *item.model;
    const AffineMap &map = item.worldFromModel;
    const glm::dvec3 inModel = glm::transpose(map.linear) * direction;
    return reachAlong(model.graph, model.boxes, *model.mesh, inModel, budget) + glm::dot(direction, map.translation);
}

}

Scene sceneOf(std::shared_ptr<const Model> model)
{
    Scene scene;
    scene.extent = model->extent;
    scene.items.push_back({.model = std::move(model)});
    return scene;
}

Sphere boundingSphere(const SceneItem &item)
{
    const Sphere bound = item.model->graph.bound(0);
    return isInPlace(item) ? bound : transformed(item.worldFromModel, operatorNorm(item.worldFromModel.linear), bound);
}

Sphere boundingSphere(const Scene &scene)
{
    if (scene.items.size() == 1) {
        return boundingSphere(scene.items.front());
    }
    std::vector<Sphere> bounds;
    bounds.reserve(scene.items.size());
    for (const SceneItem &item : scene.items) {
        bounds.push_back(boundingSphere(item));
    }
    return enclosingSphere(bounds);
}

/// Items are searched from the one whose sphere reaches farthest on, until no sphere that is left can reach farther than
/// what was found.
double reachAlong(const std::vector<SceneItem> &items, const glm::dvec3 &direction)
{
    std::vector<std::pair<double, const SceneItem *>> order;
    order.reserve(items.size());
    for (const SceneItem &item : items) {
        order.emplace_back(reachOfSphere(boundingSphere(item), direction), &item);
    }
    std::ranges::stable_sort(order, std::greater(), &std::pair<double, const SceneItem *>::first);
    const std::size_t budget = std::max(leastBudget, wholeBudget / std::max<std::size_t>(items.size(), 1));
    double reach = -std::numeric_limits<double>::infinity();
    for (const auto &[most, item] : order) {
        if (most <= reach) {
            break;
        }
        reach = std::max(reach, reachOf(*item, direction, budget));
    }
    return reach;
}

Box extentOf(const std::vector<SceneItem> &items)
{
    Box box;
    if (items.empty()) {
        return box;
    }
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0.0);
        direction[axis] = 1.0;
        box.greatest[axis] = reachAlong(items, direction);
        box.least[axis] = -reachAlong(items, -direction);
    }
    return box;
}

}
