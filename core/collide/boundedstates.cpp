// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "boundedstates.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Those left over repeat the last.
std::vector<LanesOfPoint> inLanes(std::span<const glm::dvec3> points)
{
    std::vector<LanesOfPoint> lanes(blocksFor(points.size()));
    for (std::size_t i = 0; i < lanes.size() * laneCount; ++i) {
        setLane(lanes[i / laneCount], i % laneCount, points[std::min(i, points.size() - 1)]);
    }
    return lanes;
}

/// What searches keep for a child, about.
constexpr std::size_t bytesOfChild = 600;

}

BoundedStates::BoundedStates(const FractalGraph &graph, const BoxBounds &boxes, const HullBounds &hulls,
                             Positions begin)
    : m_graph(graph)
    , m_boxes(boxes)
    , m_hulls(hulls)
    , m_table(graph)
    , m_beginsAt(std::move(begin))
    , m_begin(m_table.find(m_beginsAt))
    , m_mesh{.box = boxes.at(graph, graph.levels().levelCount())}
{
}

const BoundedStates::Bounds &BoundedStates::bounds(StateId state)
{
    while (m_bounds.size() <= state) {
        const Positions &positions = m_table.state(static_cast<StateId>(m_bounds.size())).positions;
        Bounds bounds{Box::ofNothing(), 0.0, positions.size() == 1 ? m_hulls.at(m_graph, positions.front()) : nullptr};
        for (const Position position : positions) {
            bounds.box = bounds.box.with(m_boxes.at(m_graph, position));
        }
        bounds.size = bounds.box.isEmpty() ? 0.0 : glm::length(bounds.box.size());
        if (bounds.hulls) {
            bounds.corners = inLanes(bounds.hulls->fine.corners);
            m_bytes += bounds.corners.size() * sizeof(LanesOfPoint);
        }
        m_bounds.push_back(std::move(bounds));
    }
    return m_bounds[state];
}

std::span<const DescentStep> BoundedStates::children(StateId state)
{
    if (m_known.size() <= state) {
        m_known.resize(state + 1);
    }
    Known &known = m_known[state];
    if (!known.isExpanded) {
        known = {true, listChildren(state)};
        m_bytes += known.children.size() * bytesOfChild;
    }
    return known.children;
}

std::vector<DescentStep> BoundedStates::listChildren(StateId state)
{
    const Expansion &expansion = m_table.expansion(state);
    std::vector<DescentStep> children;
    if (expansion.hasLeaf && !m_mesh.box.isEmpty()) {
        children.push_back(DescentStep::toMesh());
    }
    for (const ChildRange &range : expansion.ranges) {
        for (std::uint32_t map = range.firstMap; map < range.endMap && !bounds(range.next).box.isEmpty(); ++map) {
            children.push_back({range.set, map, range.next});
        }
    }
    return children;
}

bool BoundedStates::isMesh(StateId state)
{
    return m_table.expansion(state).ranges.empty();
}

bool BoundedStates::forgetIfLarge()
{
    const std::size_t bytes = m_table.memoryUse() + m_bytes;
    if (std::exchange(m_hasForgotten, false)) {
        m_mostBytes = std::max(m_mostBytes, 2 * bytes);
    }
    if (bytes <= m_mostBytes) {
        return false;
    }
    m_table.forget();
    m_begin = m_table.find(m_beginsAt);
    m_bounds.clear();
    m_known.clear();
    m_bytes = 0;
    m_hasForgotten = true;
    return true;
}

void BoundedStates::fillAddress(std::span<const DescentStep> path, Address &address)
{
    m_reached.clear();
    for (const DescentStep &step : path) {
        const Positions &positions = m_table.state(step.state).positions;
        address.push_back({positions.front() - 1, step.map});
        if (m_graph.setsShareMaps()) {
            m_reached.push_back(positions);
        }
    }
    if (m_graph.setsShareMaps()) {
        placePicks(m_graph, m_reached, address);
    }
}

}
