// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "neighbours.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// In radii of the bound of a node of the way: how near to the way's end its neighbours come, and how small a node is
/// that stands for that end.
constexpr double nearby = 1.0 / 64.0;
/// As large, beside a node of the way, are its neighbours at most.
constexpr double largest = 1.5;
constexpr std::size_t mostNodes = 32;
constexpr std::size_t mostDivided = 128;
/// Numbers hold what is here to as many bits, and the errors of ten thousands of products beside.
constexpr double bitsHere = 96.0;
constexpr double fewestBits = 8192.0;
constexpr double mostBits = 16384.0;
/// So many levels lie between those that are kept to go on from.
constexpr std::size_t levelsApart = 64;
constexpr std::size_t mostStates = 50'000;

double exponentAt(std::span<const WayLevel> way, std::size_t levels)
{
    return levels == 0 ? 0.0 : way[levels - 1].exponent;
}

/// In units of its node.
AffineMap ownSeen(std::span<const WayLevel> way, std::size_t levels)
{
    return {levels == 0 ? glm::dmat3(1.0) : way[levels - 1].linear, glm::dvec3(0.0)};
}

/// At least so far from a point: by planes between it and a box that is mapped, along the box's sides and across the way
/// to its middle.
double gapBetween(const AffineMap &map, const Box &box, const glm::dvec3 &point)
{
    const glm::dvec3 away = map(box.centre()) - point;
    const glm::dvec3 half = 0.5 * box.size();
    const glm::dvec3 a = half.x * map.linear[0];
    const glm::dvec3 b = half.y * map.linear[1];
    const glm::dvec3 c = half.z * map.linear[2];
    double gap = 0.0;
    for (const glm::dvec3 &normal : {away, glm::cross(a, b), glm::cross(b, c), glm::cross(c, a)}) {
        const double reach =
            std::abs(glm::dot(normal, a)) + std::abs(glm::dot(normal, b)) + std::abs(glm::dot(normal, c));
        const double length = glm::length(normal);
        if (length > 0.0) {
            gap = std::max(gap, (std::abs(glm::dot(normal, away)) - reach) / length);
        }
    }
    return gap;
}

}

Neighbours::Neighbours(std::shared_ptr<const Scene> scene)
    : m_scene(std::move(scene))
{
}

std::vector<Surroundings::Node> Neighbours::of(std::span<const WayLevel> way, std::size_t levels)
{
    assert(levels > 0 && levels <= way.size() && "a node of the way");
    setWay(way, levels);
    const Station &at = m_stations.back();
    std::vector<Surroundings::Node> nodes;
    if (at.nodes.empty()) {
        return nodes;
    }
    LongMap here = *at.own;
    for (const WayLevel &level : way.subspan(levels)) {
        here = here * level.map;
    }
    const double exponent = exponentAt(way, way.size()) - exponentAt(way, at.base);
    const double unit = operatorNorm(here.dividedBy(exponent).linear); // 1 but for what the exponent is off by
    for (const Node &node : at.nodes) {
        if (node.isTooLarge) {
            continue;
        }
        LongMap map = node.map;
        map.moveTo(here);
        const AffineMap seen = map.dividedBy(exponent);
        const std::vector<Step> steps = stepsTo(node);
        nodes.push_back({node.item,
                         node.state,
                         {seen.linear / unit, seen.translation / unit},
                         node.sharedSteps,
                         {steps.begin(), steps.end()},
                         false});
    }
    return nodes;
}

/// Goes on from the last station that the way still leads to.
void Neighbours::setWay(std::span<const WayLevel> way, std::size_t levels)
{
    const auto isSame = [](const Step &step, const WayLevel &level) { return step == level.step; };
    const auto shared = static_cast<std::size_t>(std::ranges::mismatch(m_way, way, isSame).in1 - m_way.begin());
    m_way.resize(shared);
    std::ranges::transform(way.subspan(shared), std::back_inserter(m_way), &WayLevel::step);
    m_least = std::min(0.0, std::ranges::min(way, {}, &WayLevel::exponent).exponent);
    const auto isVoid = [&](const Station &at) {
        return at.lookedAt > shared || at.levels > levels || (at.own && at.bits < bitsFrom(way, at.base));
    };
    while (!m_stations.empty() && isVoid(m_stations.back())) {
        dropLast();
    }
    const std::size_t first = std::min(firstOf(way), levels);
    if (m_stations.empty() || m_stations.back().levels < first) {
        m_stations.push_back({.levels = first, .trailCount = m_trails.size()});
    }
    while (m_stations.back().levels < levels) {
        advance(way);
    }
}

void Neighbours::dropLast()
{
    m_stations.pop_back();
    m_trails.resize(m_stations.empty() ? 0 : m_stations.back().trailCount);
}

/// Numbers that would get too long begin farther down, and what parted above is forgotten; seldom, since all below is
/// then found anew.
std::size_t Neighbours::firstOf(std::span<const WayLevel> way) const
{
    if (-m_least <= mostBits) {
        return 0;
    }
    const double above = -fewestBits * (std::floor(-m_least / fewestBits) - 1.0);
    const auto isBelow = [&](const WayLevel &level) { return level.exponent <= above; };
    return static_cast<std::size_t>(std::ranges::find_if(way, isBelow) - way.begin()) + 1;
}

/// More than are needed now, so that as much again can follow.
unsigned Neighbours::bitsFrom(std::span<const WayLevel> way, std::size_t levels) const
{
    return std::bit_ceil(static_cast<unsigned>(exponentAt(way, levels) - m_least + bitsHere));
}

/// One level down.
void Neighbours::advance(std::span<const WayLevel> way)
{
    if (m_stations.back().levels % levelsApart == 0) {
        m_stations.push_back(m_stations.back());
    }
    Station &at = m_stations.back();
    const WayLevel &next = way[at.levels];
    const Target target = targetOf(way, at.levels);
    at.nodes = found(way, at, target);
    at.lookedAt = std::max(at.lookedAt, target.lookedAt);
    ++at.levels;
    at.trailCount = m_trails.size();
    if (at.nodes.empty()) {
        at.own.reset();
        return;
    }
    at.own = *at.own * next.map;
    for (Node &node : at.nodes) {
        node.map.moveTo(*at.own);
        node.seen = node.map.dividedBy(next.exponent - exponentAt(way, at.base));
    }
    at.own->moveToOrigin();
}

/// From the last of so many levels to the one below, whose neighbours are asked for. Only as much of the way is looked at as
/// is needed to tell where its end is, so that the answer is the same for other ends.
Neighbours::Target Neighbours::targetOf(std::span<const WayLevel> way, std::size_t levels)
{
    AffineMap at = ownSeen(way, levels);
    double size = 1.0;
    const double nextSize = way[levels].ratio * way[levels].bound.radius;
    for (std::size_t i = levels; i < way.size(); ++i) {
        at.translation += size * (at.linear * way[i].map.translation);
        at.linear = way[i].linear;
        size *= way[i].ratio;
        const Sphere &bound = way[i].bound;
        const double radius = size * bound.radius;
        if (radius <= nearby * nextSize || i + 1 == way.size()) {
            return {at.translation + size * (at.linear * bound.centre), radius + nearby * nextSize, largest * nextSize,
                    i + 1};
        }
    }
    std::unreachable();
}

/// The neighbours of the node below, from the origin of the one here.
std::vector<Neighbours::Node> Neighbours::found(std::span<const WayLevel> way, Station &at, const Target &target)
{
    std::vector<Node> open;
    for (Node &node : at.nodes) {
        node.gap = gapTo(target, node.item, node.state, node.seen);
        if (node.gap <= target.reach) {
            open.push_back(std::move(node));
        }
    }
    addSiblings(way, at, target, open);
    std::vector<Node> nodes;
    for (std::size_t divided = 0; !open.empty();) {
        Node node = std::move(open.back());
        open.pop_back();
        node.isTooLarge = sizeOf(node) > target.largest;
        if (node.isTooLarge && divided < mostDivided) {
            ++divided;
            divide(node, target, open);
        } else {
            nodes.push_back(std::move(node));
        }
    }
    if (nodes.size() > mostNodes) {
        std::ranges::nth_element(nodes, nodes.begin() + mostNodes, {}, &Node::gap);
        nodes.erase(nodes.begin() + mostNodes, nodes.end());
    }
    return nodes;
}

/// What is small before what is tested closely, and that before anything long is computed.
template<typename Use>
void Neighbours::forEachChild(std::size_t item, const Positions &state, const AffineMap &seen, const Target &target,
                              Use &&use)
{
    StateTable &table = tableOf(item);
    const double norm = operatorNorm(seen.linear);
    const StateId id = table.find(state);
    const std::vector<Sphere> &bounds = table.childBounds(id);
    std::size_t number = 0;
    for (const ChildRange &range : table.expansion(id).ranges) {
        const Positions &below = table.state(range.next).positions;
        for (std::uint32_t i = range.firstMap; i < range.endMap; ++i, ++number) {
            const Sphere &bound = bounds[number];
            if (bound.isEmpty()
                || glm::distance(seen(bound.centre), target.middle) - norm * bound.radius > target.reach) {
                continue;
            }
            const AffineMap &map = table.graph().set(range.set).maps[i];
            const AffineMap childSeen = seen * map;
            const double gap = gapTo(target, item, below, childSeen);
            if (gap <= target.reach) {
                use(Child{item, {range.set, i}, map, below}, childSeen, gap);
            }
        }
    }
}

/// Of the way's next node.
void Neighbours::addSiblings(std::span<const WayLevel> way, Station &at, const Target &target, std::vector<Node> &nodes)
{
    const AffineMap seen = ownSeen(way, at.levels);
    const auto add = [&](const Child &child, const AffineMap &childSeen, double gap, std::size_t shared,
                         std::uint32_t trail) {
        if (!at.own) {
            at.base = at.levels;
            at.bits = bitsFrom(way, at.base);
            at.own = LongMap(seen.linear, at.bits);
        }
        nodes.push_back({child.item, child.state, shared, trail, *at.own * child.map, childSeen, gap});
    };
    const Step &taken = way[at.levels].step;
    if (at.levels > 0) {
        forEachChild(way.front().step.map, way[at.levels - 1].state, seen, target,
                     [&](const Child &child, const AffineMap &childSeen, double gap) {
                         if (child.step != taken) {
                             m_trails.push_back({child.step, noTrail});
                             add(child, childSeen, gap, at.levels - 1, static_cast<std::uint32_t>(m_trails.size() - 1));
                         }
                     });
        return;
    }
    for (std::size_t i = 0; i < m_scene->items.size(); ++i) {
        const AffineMap &map = m_scene->items[i].worldFromModel;
        const Positions root{0};
        const double gap = gapTo(target, i, root, map);
        if (i != taken.map && gap <= target.reach && !m_scene->items[i].model->graph.bound(0).isEmpty()) {
            add({i, {}, map, root}, map, gap, 0, noTrail);
        }
    }
}

void Neighbours::divide(const Node &node, const Target &target, std::vector<Node> &nodes)
{
    forEachChild(
        node.item, node.state, node.seen, target, [&](const Child &child, const AffineMap &childSeen, double gap) {
            m_trails.push_back({child.step, node.trail});
            const auto trail = static_cast<std::uint32_t>(m_trails.size() - 1);
            nodes.push_back({child.item, child.state, node.sharedSteps, trail, node.map * child.map, childSeen, gap});
        });
}

double Neighbours::gapTo(const Target &target, std::size_t item, const Positions &state, const AffineMap &seen)
{
    const Model &model = *m_scene->items[item].model;
    Box box = Box::ofNothing();
    for (const Position position : state) {
        box = box.with(model.boxes.at(model.graph, position));
    }
    return gapBetween(seen, box, target.middle);
}

double Neighbours::sizeOf(const Node &node)
{
    StateTable &table = tableOf(node.item);
    return operatorNorm(node.seen.linear) * table.state(table.find(node.state)).bound.radius;
}

/// After those that the way shares.
std::vector<Step> Neighbours::stepsTo(const Node &node) const
{
    std::vector<Step> steps;
    for (std::uint32_t trail = node.trail; trail != noTrail; trail = m_trails[trail].above) {
        steps.push_back(m_trails[trail].step);
    }
    std::ranges::reverse(steps);
    return steps;
}

StateTable &Neighbours::tableOf(std::size_t item)
{
    const Model *model = m_scene->items[item].model.get();
    StateTable &table = m_tables.try_emplace(model, model->graph).first->second;
    if (table.stateCount() > mostStates) {
        table.forget();
    }
    return table;
}

}
