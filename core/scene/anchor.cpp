// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "anchor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <ranges>
#include <utility>

#include <glm/geometric.hpp>

#include "neighbours.h"

namespace romanesco {

namespace {

/// A ball enters a node where it lies in so many times its bound: what stands before a corner of the surface, as far from
/// it as the node is large, lies outside the bound itself. It leaves where it leaves so many times.
constexpr double inside = 2.0;
constexpr double outside = 4.0;
/// Another node is worth a move where it is so much smaller.
constexpr double worthIt = 0.6;
/// What is near a point need not be below the node that the point is nearest to: so many nodes are followed down at a time,
/// from so many levels above the first in which the point lies, and while their size can be told from there.
constexpr std::size_t mostFollowed = 16;
constexpr int levelsAbove = 8;
constexpr double smallest = 1e-12;
/// Of what is so many times as large as what is here, the parts that are near would be off by a millionth of what is here;
/// and little is seen of it between all that is smaller.
constexpr double largest = 1e9;
constexpr std::size_t mostLevels = 1'000'000;
constexpr std::size_t mostStates = 50'000;

bool holds(const Sphere &bound, const glm::dvec3 &point, double radius, double times)
{
    return glm::distance(bound.centre, point) + radius <= times * bound.radius;
}

}

Anchor::Anchor(std::shared_ptr<const Scene> scene)
    : m_scene(std::move(scene))
    , m_neighbours(std::make_shared<Neighbours>(m_scene))
{
}

/// The table belongs to the item's graph.
void Anchor::setModel()
{
    m_table = m_levels.empty() ? nullptr
                               : std::make_shared<StateTable>(m_scene->items[m_levels.front().step.map].model->graph);
}

glm::dmat3 Anchor::linear() const
{
    return m_levels.empty() ? glm::dmat3(1.0) : m_levels.back().linear;
}

Sphere Anchor::bound() const
{
    if (m_levels.empty()) {
        const Box &extent = m_scene->extent;
        return {extent.centre(), 0.5 * glm::length(extent.size())};
    }
    const Sphere &own = m_levels.back().bound;
    return {linear() * own.centre, own.radius};
}

/// Of the node that so many levels lead to, in its axes and its unit; the world's are the items.
template<typename Use>
void Anchor::forEachChild(std::size_t levels, Use &&use) const
{
    if (levels == 0) {
        for (std::size_t i = 0; i < m_scene->items.size(); ++i) {
            const SceneItem &item = m_scene->items[i];
            const Child child{{0, static_cast<std::uint32_t>(i)},
                              item.worldFromModel,
                              Positions{0},
                              boundingSphere(item)};
            if (!child.bound.isEmpty()) {
                use(child);
            }
        }
        return;
    }
    if (m_table->stateCount() > mostStates) {
        m_table->forget();
    }
    const WayLevel &node = m_levels[levels - 1];
    const StateId state = m_table->find(node.state);
    const std::vector<Sphere> &bounds = m_table->childBounds(state);
    std::size_t number = 0;
    for (const ChildRange &range : m_table->expansion(state).ranges) {
        for (std::uint32_t map = range.firstMap; map < range.endMap; ++map, ++number) {
            const Sphere &bound = bounds[number];
            use(Child{{range.set, map},
                      m_table->graph().set(range.set).maps[map],
                      m_table->state(range.next).positions,
                      {node.linear * bound.centre, bound.radius}});
        }
    }
}

std::optional<Anchor::Move> Anchor::descend(const Child &child)
{
    const glm::dmat3 product = linear() * child.map.linear;
    const double ratio = operatorNorm(product);
    const Move move{ratio, linear() * child.map.translation};
    if (!(ratio > 0.0) || !std::isfinite(1.0 / ratio) || m_levels.size() >= mostLevels) {
        return std::nullopt;
    }
    const double exponent = (m_levels.empty() ? 0.0 : m_levels.back().exponent) + std::log2(ratio);
    m_levels.push_back({child.step, child.map, child.state, {}, product / ratio, ratio, exponent});
    if (m_levels.size() == 1) {
        setModel();
    }
    m_levels.back().bound = m_table->state(m_table->find(child.state)).bound;
    return move;
}

Anchor::Move Anchor::ascend()
{
    const WayLevel left = std::move(m_levels.back());
    m_levels.pop_back();
    if (m_levels.empty()) {
        setModel();
    }
    return {1.0 / left.ratio, -(linear() * left.map.translation) / left.ratio};
}

std::optional<Anchor> Anchor::at(std::shared_ptr<const Scene> scene, const ScenePlace &place)
{
    Anchor anchor(std::move(scene));
    const auto isThere = [&](const Step &step) { return anchor.enter(step); };
    const bool isPlace =
        isThere({0, static_cast<std::uint32_t>(place.item)}) && std::ranges::all_of(place.steps, isThere);
    return isPlace ? std::optional(std::move(anchor)) : std::nullopt;
}

std::vector<Anchor::Move> Anchor::goTo(const ScenePlace &place)
{
    std::vector<Step> path{{0, static_cast<std::uint32_t>(place.item)}};
    path.insert(path.end(), place.steps.begin(), place.steps.end());
    return goTo(path);
}

std::optional<ScenePlace> Anchor::place() const
{
    if (m_levels.empty()) {
        return std::nullopt;
    }
    ScenePlace place{m_levels.front().step.map};
    for (std::size_t i = 1; i < m_levels.size(); ++i) {
        place.steps.push_back(m_levels[i].step);
    }
    return place;
}

bool Anchor::enter(const Step &step)
{
    return enterWith(step).has_value();
}

std::optional<Anchor::Move> Anchor::enterWith(const Step &step)
{
    std::optional<Child> found;
    forEachChild(m_levels.size(), [&](const Child &child) {
        if (child.step == step) {
            found = child;
        }
    });
    return found ? descend(*found) : std::nullopt;
}

std::vector<Anchor::Move> Anchor::moveTo(std::shared_ptr<const Scene> scene)
{
    Anchor there(std::move(scene));
    for (const WayLevel &level : m_levels) {
        if (!there.enter(level.step)) {
            break;
        }
    }
    std::vector<Move> moves;
    while (m_levels.size() > there.m_levels.size()) {
        moves.push_back(ascend());
    }
    *this = std::move(there);
    return moves;
}

/// All children of the node above a level but the one that the way leads through, and the mesh that stands in that node.
/// size and origin are of the node above, as seen from here; origin is the level's own.
void Anchor::addSiblings(std::size_t level, double size, const glm::dvec3 &origin, Surroundings &found) const
{
    const bool isOnTheWay = level < m_levels.size();
    const glm::dmat3 axes = size * (level == 0 ? glm::dmat3(1.0) : m_levels[level - 1].linear);
    const glm::dvec3 through = isOnTheWay ? m_levels[level].map.translation : glm::dvec3(0.0);
    forEachChild(level, [&](const Child &child) {
        if (isOnTheWay && child.step == m_levels[level].step) {
            return;
        }
        // Differences first: what lies close to the way is seen from close by.
        const AffineMap map{axes * child.map.linear, axes * (child.map.translation - through) + origin};
        const std::size_t item = level == 0 ? child.step.map : m_levels.front().step.map;
        found.nodes.push_back({item, child.state, map, level == 0 ? 0 : level - 1, {}, false});
        if (level > 0) {
            found.nodes.back().steps.push_back(child.step);
        }
    });
    if (level > 0 && m_table->expansion(m_table->find(m_levels[level - 1].state)).hasLeaf) {
        found.nodes.push_back({m_levels.front().step.map,
                               m_levels[level - 1].state,
                               {axes, origin - axes * through},
                               level - 1,
                               {},
                               true});
    }
}

/// Below some nodes: of the ways down on which a ball stays within a share of the bounds, the one that ends at the smallest.
Anchor::Way Anchor::wayDown(StateTable &table, std::vector<Place> places, const glm::dvec3 &point, double radius)
{
    std::vector<std::size_t> open(places.size());
    std::ranges::iota(open, std::size_t(0));
    const auto start = std::ranges::max(places, {}, &Place::norm).norm;
    while (!open.empty()) {
        std::vector<Place> next;
        for (const std::size_t from : open) {
            const Place &at = places[from];
            const StateId state = table.find(at.state);
            const std::vector<Sphere> &bounds = table.childBounds(state);
            std::size_t number = 0;
            for (const ChildRange &range : table.expansion(state).ranges) {
                for (std::uint32_t map = range.firstMap; map < range.endMap; ++map, ++number) {
                    const double size = at.norm * bounds[number].radius;
                    const double share = (glm::distance(at.map(bounds[number].centre), point) + radius) / size;
                    if (share <= inside && size > smallest * start) {
                        const AffineMap below = at.map * table.graph().set(range.set).maps[map];
                        const double norm = operatorNorm(below.linear);
                        next.push_back(
                            {from, {range.set, map}, table.state(range.next).positions, below, norm, size, share});
                    }
                }
            }
        }
        std::ranges::sort(next, {}, &Place::share);
        next.resize(std::min(next.size(), mostFollowed));
        open.clear();
        for (Place &place : next) {
            open.push_back(places.size());
            places.push_back(std::move(place));
        }
    }
    std::size_t at = static_cast<std::size_t>(std::ranges::min_element(places, {}, &Place::size) - places.begin());
    Way way{{}, places[at].size, places[at].map, 0};
    for (; places[at].from != none; at = places[at].from) {
        way.steps.push_back(places[at].step);
    }
    way.start = places[at].step.map;
    std::ranges::reverse(way.steps);
    return way;
}

/// From here, in coordinates of here.
Anchor::Way Anchor::wayDown(const glm::dvec3 &point, double radius) const
{
    const auto holdsBall = [&](const Sphere &sphere) { return holds(sphere, point, radius, inside); };
    if (!isInWorld()) {
        const AffineMap map{linear(), glm::dvec3(0.0)};
        return wayDown(*m_table, {{none, {}, m_levels.back().state, map, 1.0, bound().radius, 0.0}}, point, radius);
    }
    Way best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < m_scene->items.size(); ++i) {
        const SceneItem &item = m_scene->items[i];
        const Sphere sphere = boundingSphere(item);
        if (sphere.isEmpty() || !holdsBall(sphere)) {
            continue;
        }
        StateTable table(item.model->graph);
        const AffineMap &map = item.worldFromModel;
        Way way = wayDown(table, {{none, {}, Positions{0}, map, operatorNorm(map.linear), sphere.radius, 0.0}}, point,
                          radius);
        if (way.size < best.size) {
            best = std::move(way);
            best.steps.insert(best.steps.begin(), {0, static_cast<std::uint32_t>(i)});
        }
    }
    return best;
}

std::vector<Anchor::Move> Anchor::follow(const glm::dvec3 &point, double radius)
{
    Anchor other = *this;
    glm::dvec3 p = point;
    double r = radius;
    double unit = 1.0;
    const auto take = [&](const Move &move) {
        p = move(p);
        r /= move.scale;
        unit *= move.scale;
    };
    for (int above = 0; !other.isInWorld() && !holds(other.bound(), p, r, 0.5) && above < levelsAbove;) {
        above += holds(other.bound(), p, r, inside) ? 1 : 0;
        take(other.ascend());
    }
    const Way way = other.wayDown(p, r);
    const bool isLeft = !isInWorld() && !holds(bound(), point, radius, outside);
    const double size = way.steps.empty() && !other.isInWorld() ? other.bound().radius : way.size;
    const double least = isLeft ? unit * size : std::min(unit * size, bound().radius);
    if (const auto move = goAcross(point, radius, other.m_levels.size(), worthIt * least)) {
        return {*move};
    }
    if (!isLeft && !(unit * size < worthIt * bound().radius) && !(isInWorld() && !way.steps.empty())) {
        return {};
    }
    std::vector<Step> path;
    path.reserve(other.m_levels.size() + way.steps.size());
    for (const WayLevel &level : other.m_levels) {
        path.push_back(level.step);
    }
    path.insert(path.end(), way.steps.begin(), way.steps.end());
    return goTo(path);
}

/// Those of an item's nodes in whose bounds a ball lies and to which the way parts above so many levels; the steps are their
/// numbers.
std::vector<Anchor::Place> Anchor::placesAcross(const Surroundings &all, std::span<const Surroundings::Node> nodes,
                                                const glm::dvec3 &point, double radius, std::size_t levels)
{
    const FractalGraph &graph = all.scene->items[nodes.front().item].model->graph;
    std::vector<Place> places;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const Surroundings::Node &node = nodes[i];
        const Sphere &own = graph.bound(node.state.front());
        const bool isAcross = node.item != all.pathItem || node.sharedSteps + 1 < levels;
        if (!isAcross || node.isMeshOnly || own.isEmpty()) {
            continue;
        }
        const double norm = operatorNorm(node.hereFromNode.linear);
        const double size = norm * own.radius;
        const double share = (glm::distance(node.hereFromNode(own.centre), point) + radius) / size;
        if (share <= inside) {
            places.push_back({none, {0, i}, node.state, node.hereFromNode, norm, size, share});
        }
    }
    std::ranges::sort(places, {}, &Place::share);
    places.resize(std::min(places.size(), mostFollowed));
    return places;
}

/// To a node that is smaller than that, on a way that parts from this one above so many levels. Its place is known from here:
/// up to where the ways part and down again it would be lost.
std::optional<Anchor::Move> Anchor::goAcross(const glm::dvec3 &point, double radius, std::size_t levels, double size)
{
    if (levels == 0) {
        return std::nullopt;
    }
    const auto all = surroundings();
    const auto sameItem = [](const auto &a, const auto &b) { return a.item == b.item; };
    std::optional<Way> best;
    const Surroundings::Node *from = nullptr;
    for (const auto &run : all->nodes | std::views::chunk_by(sameItem)) {
        std::vector<Place> places = placesAcross(*all, run, point, radius, levels);
        if (places.empty()) {
            continue;
        }
        StateTable table(m_scene->items[run.front().item].model->graph);
        Way way = wayDown(table, std::move(places), point, radius);
        if (way.size < size) {
            size = way.size;
            from = &run[way.start];
            best = std::move(way);
        }
    }
    if (!best) {
        return std::nullopt;
    }
    Anchor there(m_scene);
    there.m_neighbours = m_neighbours;
    bool isThere = there.enter({0, static_cast<std::uint32_t>(from->item)});
    const auto goOn = [&](const Step &step) { isThere = isThere && there.enter(step); };
    std::ranges::for_each(std::span(all->path).first(from->sharedSteps), goOn);
    std::ranges::for_each(from->steps, goOn);
    std::ranges::for_each(best->steps, goOn);
    if (!isThere) {
        return std::nullopt;
    }
    *this = std::move(there);
    return Move{operatorNorm(best->map.linear), best->map.translation};
}

/// What the ways here and there have in common stays as it is: each move rounds.
std::vector<Anchor::Move> Anchor::goTo(std::span<const Step> path)
{
    const auto isSame = [](const WayLevel &level, const Step &step) { return level.step == step; };
    const auto common = std::ranges::mismatch(m_levels, path, isSame).in1 - m_levels.begin();
    std::vector<Move> moves;
    while (m_levels.size() > static_cast<std::size_t>(common)) {
        moves.push_back(ascend());
    }
    for (const Step &step : path.subspan(static_cast<std::size_t>(common))) {
        const auto move = enterWith(step);
        if (!move) {
            break;
        }
        moves.push_back(*move);
    }
    return moves;
}

std::shared_ptr<const Surroundings> Anchor::surroundings() const
{
    Surroundings found;
    found.scene = m_scene;
    found.nearby = bound();
    for (std::size_t i = 1; i < m_levels.size(); ++i) {
        found.path.push_back(m_levels[i].step);
    }
    double size = 1.0;
    glm::dvec3 origin(0.0);
    if (!m_levels.empty()) {
        found.pathItem = m_levels.front().step.map;
        const WayLevel &own = m_levels.back();
        found.nodes.push_back(
            {m_levels.front().step.map, own.state, {own.linear, glm::dvec3(0.0)}, found.path.size(), {}, false});
    }
    std::size_t level = m_levels.size();
    while (level > 0 && size <= largest) {
        --level;
        size /= m_levels[level].ratio;
        addSiblings(level, size, origin, found);
        const glm::dmat3 above = level == 0 ? glm::dmat3(1.0) : m_levels[level - 1].linear;
        origin -= size * (above * m_levels[level].map.translation);
    }
    if (level > 0) {
        std::ranges::move(m_neighbours->of(m_levels, level), std::back_inserter(found.nodes));
    }
    if (m_levels.empty()) {
        addSiblings(0, size, origin, found);
    }
    found.measureReach();
    const auto itemOf = [](const Surroundings::Node &node) { return node.item; };
    std::ranges::stable_sort(found.nodes, {}, itemOf);
    found.unitExponent = m_levels.empty() ? 0.0 : m_levels.back().exponent;
    glm::dmat3 worldFromAbove(1.0);
    for (const WayLevel &way : m_levels) {
        found.origin += worldFromAbove * way.map.translation;
        worldFromAbove = worldFromAbove * way.map.linear;
    }
    return std::make_shared<const Surroundings>(std::move(found));
}

}
