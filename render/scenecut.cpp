// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenecut.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <ranges>
#include <utility>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Above this, what was made of a model does not wait for the next pass.
constexpr std::size_t mostBytesAtRest = 24'000'000;

}

SceneCut::SceneCut(const Scene &scene)
    : m_scene(scene)
{
    std::map<const Model *, std::size_t> known;
    for (const SceneItem &item : scene.items) {
        const auto [place, isNew] = known.try_emplace(item.model.get(), m_parts.size());
        if (isNew) {
            m_parts.emplace_back(Cut(*item.model));
        }
        m_partOf.push_back(place->second);
    }
}

void SceneCut::begin(const Projector &projector, std::shared_ptr<const Surroundings> surroundings,
                     double pixelTolerance, const CopyColours &colours, bool leavesOutBalls)
{
    assert(surroundings->scene.get() == &m_scene && "the place lies in the scene");
    dropSpent();
    m_projector = projector;
    m_tolerance = pixelTolerance;
    m_colours = colours;
    m_surroundings = std::move(surroundings);
    m_runs.clear();
    const auto sameItem = [](const auto &a, const auto &b) { return a.item == b.item; };
    for (const auto &run : m_surroundings->nodes | std::views::chunk_by(sameItem)) {
        if (!leavesOutBalls || m_scene.items[run.front().item].kind != SceneDescription::Kind::Ball) {
            m_runs.emplace_back(run);
        }
    }
    m_isItemBegun = false;
    m_instances = 0;
    m_visited = 0;
    m_hidden = 0;
    m_isInDoubt = false;
    std::ranges::sort(m_runs, {}, [&](const auto &run) { return nearestOf(run); });
    m_memory = m_bytes;
}

const std::vector<Instance> &SceneCut::next(std::size_t count)
{
    dropSpent();
    Part &part = m_parts[m_partOf[item()]];
    if (!std::exchange(m_isItemBegun, true)) {
        beginItem(part.cut);
    }
    // The counts of a cut that begins are none.
    m_instances -= part.cut.instanceCount();
    m_visited -= part.cut.statesVisited();
    m_hidden -= part.cut.hiddenCount();
    const std::vector<Instance> &instances = part.cut.next(count);
    m_instances += part.cut.instanceCount();
    m_visited += part.cut.statesVisited();
    m_hidden += part.cut.hiddenCount();
    m_isInDoubt = part.cut.isInDoubt();
    m_tints = &part.cut.tints();
    const std::size_t others = m_bytes - part.bytes;
    m_memory = std::max(m_memory, others + part.cut.memoryUse());
    part.bytes = part.cut.memoryHeld();
    m_bytes = others + part.bytes;
    if (part.cut.isComplete()) {
        finishItem();
    }
    return instances;
}

/// From the camera to the bound of the nearest of an item's nodes, in units of the view.
double SceneCut::nearestOf(std::span<const Surroundings::Node> nodes) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Surroundings::Node &node : nodes) {
        const AffineMap map = m_projector.cameraFrom(node.hereFromNode);
        const FractalGraph &graph = m_scene.items[node.item].model->graph;
        const Sphere bound = transformed(map, operatorNorm(map.linear), graph.bound(node.state.front()));
        nearest = std::min(nearest, glm::length(bound.centre) - bound.radius);
    }
    return nearest;
}

void SceneCut::setDepths(const Depths *depths)
{
    for (Part &part : m_parts) {
        part.cut.setDepths(depths);
    }
}

void SceneCut::beginItem(Cut &cut)
{
    const bool isOnPath = m_surroundings->pathItem == item();
    cut.setTinter(
        Tinter(model().graph, m_colours, item(), isOnPath ? std::span(m_surroundings->path) : std::span<const Step>()));
    cut.begin(m_projector, m_runs.front(), m_tolerance);
}

void SceneCut::finishItem()
{
    Part &part = m_parts[m_partOf[item()]];
    if (m_parts.size() > 1 && m_bytes > mostBytesAtRest) {
        m_spent = &part; // its copies are still looked at
    }
    m_runs.pop_front();
    m_isItemBegun = false;
}

void SceneCut::dropSpent()
{
    if (Part *part = std::exchange(m_spent, nullptr)) {
        part->cut.forget();
        m_bytes -= part->bytes;
        part->bytes = part->cut.memoryHeld();
        m_bytes += part->bytes;
    }
}

}
