// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "cut.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace romanesco {

namespace {

/// Above this many states the table is emptied and the few on the way down are made anew.
constexpr std::size_t mostStates = 50'000;

constexpr unsigned allPlanes = 0b11111;

/// Nothing smaller is walked into, in pixels.
constexpr double leastTolerance = 1e-6;

}

Cut::Cut(const Model &model)
    : m_model(model)
    , m_table(model.graph)
{
}

void Cut::begin(const Projector &projector, std::span<const Surroundings::Node> nodes, double pixelTolerance)
{
    m_projector = projector;
    m_tolerance = std::max(pixelTolerance, leastTolerance);
    m_instances = 0;
    m_visited = 0;
    m_memory = 0;
    m_open.clear();
    m_doubtful.clear();
    m_isRestInDoubt = false;
    m_siftedAt = 0;
    m_ready.clear();
    m_tints.clear();
    m_handedOut = false;
    m_hidden = 0;

    // |x| <= z / scaleX for perspective, |x| <= 1 / scaleX for orthographic, and so for y; z >= near.
    const bool isPerspective = projector.projection == Projection::Perspective;
    const auto side = [&](glm::dvec3 inwards, double scale) {
        return isPerspective ? Plane{glm::normalize(inwards * scale + glm::dvec3(0, 0, 1)), 0.0}
                             : Plane{inwards, 1.0 / scale};
    };
    m_planes = {side({1, 0, 0}, projector.scaleX), side({-1, 0, 0}, projector.scaleX),
                side({0, 1, 0}, projector.scaleY), side({0, -1, 0}, projector.scaleY),
                isPerspective ? Plane{{0, 0, 1}, -projector.near} : Plane{{0, 0, 1}, projector.range}};

    if (m_model.graph.base().isEmpty()) {
        return;
    }
    for (const Surroundings::Node &node : nodes) {
        addRoot(node);
    }
    sortFrom(0);
}

void Cut::addRoot(const Surroundings::Node &node)
{
    const AffineMap map = m_projector.cameraFrom(node.hereFromNode);
    const double norm = operatorNorm(map.linear);
    const StateId state = m_table.find(node.state);
    const Sphere &own = node.isMeshOnly ? m_model.graph.base() : m_table.state(state).bound;
    const Sphere bound = transformed(map, norm, own);
    unsigned planes = allPlanes;
    if (isOutside(bound, planes)) {
        return;
    }
    const Marks marks = m_tinter.at(node);
    if (node.isMeshOnly || isSmall(bound)) {
        place(map, state, marks, node.isMeshOnly);
    } else {
        m_open.push_back({state, planes, map, norm, marks, distanceTo(bound), false, true});
    }
}

const std::vector<Instance> &Cut::next(std::size_t count)
{
    if (m_handedOut) {
        m_ready.clear();
        m_tints.clear();
    }
    if (m_doubtful.size() >= mostDoubtful && m_depths && m_depths->looks != m_siftedAt) {
        sift();
    }
    for (std::size_t visits = 0; !m_open.empty() && m_ready.size() < count && visits < 4 * count; ++visits) {
        const Node node = m_open.back();
        m_open.pop_back();
        if (!isToBeSeen(node)) {
            continue;
        }
        const std::size_t first = m_open.size();
        visit(node);
        if (m_depths) {
            sortFrom(first);
        }
        // Those on the way down are made anew, which has to be worth it.
        if (m_table.stateCount() > std::max(mostStates, 2 * (m_open.size() + m_doubtful.size()))) {
            forgetStates();
        }
    }
    if (m_open.empty() && !m_doubtful.empty()) {
        takeUp(m_doubtful.size());
        m_isRestInDoubt = true;
    }
    m_handedOut = true;
    m_instances += m_ready.size();
    m_memory = std::max(m_memory, memoryHeld());
    return m_ready;
}

std::size_t Cut::memoryHeld() const
{
    return (m_open.capacity() + m_doubtful.capacity()) * sizeof(Node) + m_boxes.capacity() * sizeof(m_boxes[0])
        + m_ready.capacity() * sizeof(Instance) + m_tints.capacity() * sizeof(Tint) + m_table.memoryUse();
}

void Cut::forget()
{
    m_table.forget();
    // assigning {} would keep the memory
    m_open = std::vector<Node>();
    m_doubtful = std::vector<Node>();
    m_boxes = std::vector<std::optional<Box>>();
    m_ready = std::vector<Instance>();
    m_tints = std::vector<Tint>();
}

/// Makes room for more that is put off.
void Cut::sift()
{
    m_siftedAt = m_depths->looks;
    m_hidden += std::erase_if(m_doubtful, [&](const Node &node) {
        const std::optional<Footprint> footprint = m_projector.footprint(node.map, boxOf(node.state));
        return m_depths->drawn.isHidden(*footprint);
    });
    if (m_doubtful.size() > mostDoubtful / 2) {
        takeUp(m_doubtful.size() / 2);
    }
}

/// The first that were put off are walked next: what is near them is drawn by now.
void Cut::takeUp(std::size_t count)
{
    const std::size_t first = m_open.size();
    const auto end = m_doubtful.begin() + static_cast<std::ptrdiff_t>(count);
    std::ranges::for_each(m_doubtful.begin(), end, [](Node &node) { node.mayBePutOff = false; });
    m_open.insert(m_open.end(), m_doubtful.begin(), end);
    m_doubtful.erase(m_doubtful.begin(), end);
    sortFrom(first);
}

/// Neither behind what is drawn nor, at first, behind what was drawn before: that may be gone, and is put off.
bool Cut::isToBeSeen(const Node &node)
{
    if (!m_depths || (m_depths->drawn.isEmpty() && m_depths->before.isEmpty())) {
        return true;
    }
    const std::optional<Footprint> footprint = m_projector.footprint(node.map, boxOf(node.state));
    if (!footprint) {
        return true;
    }
    if (m_depths->drawn.isHidden(*footprint)) {
        ++m_hidden;
        return false;
    }
    const bool isDoubtful =
        node.mayBePutOff && m_doubtful.size() < mostDoubtful && m_depths->before.isHidden(*footprint);
    if (isDoubtful) {
        m_doubtful.push_back(node);
    }
    return !isDoubtful;
}

const Box &Cut::boxOf(StateId state)
{
    if (state >= m_boxes.size()) {
        m_boxes.resize(state + 1);
    }
    std::optional<Box> &box = m_boxes[state];
    if (!box) {
        box = Box::ofNothing();
        for (const Position position : m_table.state(state).positions) {
            box = box->with(m_model.boxes.at(m_model.graph, position));
        }
    }
    return *box;
}

void Cut::visit(const Node &node)
{
    if (node.isSmall) {
        place(node.map, node.state, node.marks, false);
        return;
    }
    ++m_visited;
    const Expansion &expansion = m_table.expansion(node.state);
    if (expansion.hasLeaf) {
        place(node.map, node.state, node.marks, true);
    }
    const std::vector<Sphere> &bounds = m_table.childBounds(node.state);
    std::size_t child = 0;
    for (const ChildRange &range : expansion.ranges) {
        for (std::uint32_t map = range.firstMap; map < range.endMap; ++map, ++child) {
            addChild(node, range, map, bounds[child]);
        }
    }
}

/// The child's bound is tested before its map is composed: most children are out of view or small.
void Cut::addChild(const Node &node, const ChildRange &range, std::uint32_t map, const Sphere &bound)
{
    const Sphere seen{node.map(bound.centre), node.norm * bound.radius};
    unsigned planes = node.planes;
    if (isOutside(seen, planes)) {
        return;
    }
    const FractalGraph &graph = m_model.graph;
    const AffineMap composed = node.map * graph.set(range.set).maps[map];
    const double norm = std::min(node.norm * graph.facts(range.set)[map].norm, frobeniusNorm(composed.linear));
    const Node below{range.next,       planes,        composed,        norm, m_tinter.below(node.marks, range.set, map),
                     distanceTo(seen), isSmall(seen), node.mayBePutOff};
    if (!below.isSmall) {
        m_open.push_back(below);
    } else if (isToBeSeen(below)) {
        place(composed, range.next, below.marks, false);
    }
}

/// Of the base mesh, moved to the unit sphere; isWhole is false where it stands for more than itself.
void Cut::place(const AffineMap &map, StateId state, const Marks &marks, bool isWhole)
{
    const Sphere &base = m_model.graph.base();
    const auto &[centre, radius] = isWhole ? base : standIn(base, m_table.state(state).bound);
    const glm::dvec3 translation = map(centre);
    Instance &instance = m_ready.emplace_back();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            instance.rows[row][column] = static_cast<float>(map.linear[column][row] * radius);
        }
        instance.rows[row][3] = static_cast<float>(translation[row]);
    }
    if (m_tinter.isNeeded()) {
        m_tints.push_back(m_tinter.tint(marks));
    }
}

/// Planes that the sphere lies wholly inside of are taken off for all below it.
bool Cut::isOutside(const Sphere &sphere, unsigned &planes) const
{
    for (unsigned i = 0; i < m_planes.size(); ++i) {
        if (!(planes & (1u << i))) {
            continue;
        }
        const double inside = glm::dot(m_planes[i].normal, sphere.centre) + m_planes[i].offset;
        if (inside < -sphere.radius) {
            return true;
        }
        if (inside >= sphere.radius) {
            planes &= ~(1u << i);
        }
    }
    return false;
}

bool Cut::isSmall(const Sphere &sphere) const
{
    const bool isPerspective = m_projector.projection == Projection::Perspective;
    const double distance = isPerspective ? std::max(sphere.centre.z, m_projector.near) : 1.0;
    return 2.0 * sphere.radius * m_projector.pixels < m_tolerance * distance;
}

double Cut::distanceTo(const Sphere &sphere) const
{
    return m_projector.projection == Projection::Perspective ? glm::length(sphere.centre) : sphere.centre.z;
}

/// The nearest is the last, which is looked at first.
void Cut::sortFrom(std::size_t first)
{
    std::sort(m_open.begin() + static_cast<std::ptrdiff_t>(first), m_open.end(),
              [](const Node &a, const Node &b) { return a.distance > b.distance; });
}

void Cut::forgetStates()
{
    std::vector<StateId> states;
    states.reserve(m_open.size() + m_doubtful.size());
    for (const std::vector<Node> *nodes : {&m_open, &m_doubtful}) {
        std::ranges::transform(*nodes, std::back_inserter(states), &Node::state);
    }
    m_memory = std::max(m_memory, m_table.memoryUse());
    m_table.forgetAllBut(states);
    m_boxes.clear();
    auto state = states.begin();
    for (std::vector<Node> *nodes : {&m_open, &m_doubtful}) {
        for (Node &node : *nodes) {
            node.state = *state++;
        }
    }
}

}
