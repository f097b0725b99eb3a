// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneraywalk.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <format>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/collide/nearest.h"
#include "core/collide/raybounds.h"

namespace romanesco {

namespace {

/// How much farther what stands for small parts may reach than they do (see standIn()).
constexpr double standInsBeyond = 1.11;
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

double lengthOf(const glm::dvec3 &v)
{
    return std::hypot(v.x, v.y, v.z);
}

}

SceneRayWalk::Part::Part(const Model &model, FaceTree &&faces)
    : tree(std::move(faces))
    , walk(model.graph, model.boxes, *model.mesh, tree)
{
}

std::expected<SceneRayWalk, std::string> SceneRayWalk::create(std::shared_ptr<const Scene> scene,
                                                              const std::stop_token &stop)
{
    SceneRayWalk made(std::move(scene));
    std::map<const Model *, Part *> partOf;
    for (const SceneItem &item : made.m_scene->items) {
        Part *&part = partOf[item.model.get()];
        if (!part) {
            auto tree = FaceTree::build(*item.model->mesh, stop);
            if (!tree) {
                return std::unexpected(item.path.empty() ? tree.error()
                                                         : std::format("{}: {}", item.path, tree.error()));
            }
            made.m_parts.push_back(std::make_unique<Part>(*item.model, std::move(*tree)));
            part = made.m_parts.back().get();
        }
        Sphere bound = boundingSphere(item);
        bound.radius *= standInsBeyond;
        made.m_placed.push_back({part, bound});
    }
    return made;
}

void SceneRayWalk::cast(const Ray &ray, RayHit &hit)
{
    const double length = lengthOf(ray.direction);
    assert(length > 0.0 && "a ray leads somewhere");
    listItems(ray, ray.direction / length);
    clear(hit);
    hit.lower = ray.greatest;
    Ray left = ray;
    while (!m_waiting.empty()) {
        const Waiting next = takeNearest();
        const double t = next.way / length;
        if (t > left.greatest) {
            break; // and all that wait are farther
        }
        if (left.nodeBudget == 0 || ray.stop.stop_requested()) {
            hit.promise = Promise::UpperBound;
            hit.lower = std::min(hit.lower, t);
            break;
        }
        m_root.front().rayFromState = m_scene->items[next.item].worldFromModel;
        m_placed[next.item].part->walk.cast(left, m_root, m_ofItem);
        left.nodeBudget -= std::min(left.nodeBudget, m_ofItem.cost.nodeVisits);
        take(next.item, hit);
        left.greatest = std::min(left.greatest, hit.t);
    }
}

void SceneRayWalk::cast(const Ray &ray, const Surroundings &from, RayHit &hit)
{
    assert(from.scene == m_scene && "the place lies in the scene");
    clear(hit);
    hit.lower = ray.greatest;
    Ray left = ray;
    for (std::size_t first = 0; first < from.nodes.size();) {
        const std::size_t item = from.nodes[first].item;
        m_roots.clear();
        for (std::size_t i = first; i < from.nodes.size() && from.nodes[i].item == item; ++i) {
            const Surroundings::Node &node = from.nodes[i];
            m_roots.push_back({node.state, node.hereFromNode, node.isMeshOnly});
        }
        m_placed[item].part->walk.cast(left, m_roots, m_ofItem);
        m_ofItem.root += first;
        left.nodeBudget -= std::min(left.nodeBudget, m_ofItem.cost.nodeVisits);
        take(item, hit);
        left.greatest = std::min(left.greatest, hit.t);
        first += m_roots.size();
    }
}

/// Those that the ray may meet.
void SceneRayWalk::listItems(const Ray &ray, const glm::dvec3 &direction)
{
    m_waiting.clear();
    const double length = lengthOf(ray.direction);
    for (std::size_t i = 0; i < m_placed.size(); ++i) {
        const Sphere &bound = m_placed[i].bound;
        const double error = rounding * (lengthOf(bound.centre) + lengthOf(ray.origin) + bound.radius);
        const WaySpan ways = waysWithin({bound.centre - ray.origin, bound.radius + error}, direction);
        if (!bound.isEmpty() && !ways.isEmpty() && ways.to >= ray.least * length) {
            m_waiting.push_back({std::max(ways.from, ray.least * length), i});
        }
    }
    std::ranges::make_heap(m_waiting, std::greater(), [](const Waiting &w) { return std::pair(w.way, w.item); });
}

SceneRayWalk::Waiting SceneRayWalk::takeNearest()
{
    std::ranges::pop_heap(m_waiting, std::greater(), [](const Waiting &w) { return std::pair(w.way, w.item); });
    const Waiting nearest = m_waiting.back();
    m_waiting.pop_back();
    return nearest;
}

/// The nearer of what was met, and what is proved of both.
void SceneRayWalk::take(std::size_t item, RayHit &hit)
{
    const double lower = std::min(hit.lower, m_ofItem.lower);
    const SearchCost cost{hit.cost.faceTests + m_ofItem.cost.faceTests, hit.cost.nodeVisits + m_ofItem.cost.nodeVisits};
    const bool isCutShort = hit.promise == Promise::UpperBound || m_ofItem.promise == Promise::UpperBound;
    if (m_ofItem.t < hit.t) {
        std::swap(hit, m_ofItem);
        m_item = item;
    }
    hit.lower = lower;
    hit.cost = cost;
    hit.promise = isCutShort ? Promise::UpperBound : Promise::Exact;
}

std::size_t SceneRayWalk::memoryUse() const
{
    std::size_t bytes = sizeof(*this) + m_placed.capacity() * sizeof(Placed) + m_waiting.capacity() * sizeof(Waiting);
    for (const auto &part : m_parts) {
        bytes += part->tree.memoryUse() + part->walk.memoryUse();
    }
    return bytes;
}

}
