// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "cut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace romanesco {

namespace {

/// Above this many states the table is emptied and the few on the way down are made anew.
constexpr std::size_t mostStates = 50'000;

constexpr unsigned allPlanes = 0b11111;

/// Nothing smaller is walked into, in pixels.
constexpr double leastTolerance = 1e-6;

/// In degrees; in units of the view.
constexpr double leastFieldOfView = 1e-6;
constexpr double leastViewHeight = 1e-9;

}

Projector::Projector(const Camera &camera, const Sphere &nearby, double reach, int viewWidth, int viewHeight)
    : projection(camera.projection)
    , position(camera.position)
{
    const double size = 2.0 * nearby.radius;
    const double distance = glm::distance(camera.position, nearby.centre);
    unit = std::max({size, distance, std::numeric_limits<double>::min()});
    cameraFromHere = glm::transpose(camera.worldFromCamera) / unit;
    range = (distance + std::max(reach, nearby.radius)) / unit;
    const bool isPerspective = projection == Projection::Perspective;
    // What is narrower has no more pixels that differ, and floats would end.
    const double angle = std::max(camera.fieldOfView, leastFieldOfView);
    scaleY = isPerspective ? 1.0 / std::tan(0.5 * angle * std::numbers::pi / 180.0)
                           : 2.0 * unit / std::max(camera.viewHeight, leastViewHeight * unit);
    scaleX = scaleY * viewHeight / viewWidth;
    pixels = 0.5 * scaleY * viewHeight;
    width = viewWidth;
    height = viewHeight;
}

/// As the shaders have it: reversed.
double Projector::depthOf(double z) const
{
    if (projection == Projection::Perspective) {
        return near / z;
    }
    return 0.5 - 0.5 * (isDeep() ? std::copysign(std::log1p(std::abs(z)) / std::log1p(range), z) : z / range);
}

bool Projector::isHidden(const Sphere &sphere, const DepthPyramid &drawn) const
{
    const bool isPerspective = projection == Projection::Perspective;
    const double front = sphere.centre.z - sphere.radius;
    if (isPerspective && front <= near) {
        return false;
    }
    // The sphere lies in the box round it, whose corners bound its picture.
    const double back = sphere.centre.z + sphere.radius;
    const glm::dvec2 low = glm::dvec2(sphere.centre) - sphere.radius;
    const glm::dvec2 high = glm::dvec2(sphere.centre) + sphere.radius;
    const glm::dvec2 least = isPerspective ? glm::min(low / front, low / back) : low;
    const glm::dvec2 most = isPerspective ? glm::max(high / front, high / back) : high;
    const glm::dvec2 scale(scaleX, scaleY);
    const glm::dvec2 size(width, height);
    const glm::dvec2 from = (0.5 + 0.5 * (scale * least + jitter)) * size - 1.0;
    const glm::dvec2 to = (0.5 + 0.5 * (scale * most + jitter)) * size + 1.0;
    // The card's depths are rounded.
    const double nearest = depthOf(front) * (1.0 + 1e-5);
    return drawn.isHidden(from.x, from.y, to.x, to.y, nearest);
}

AffineMap Projector::cameraFrom(const AffineMap &hereFromNode) const
{
    return {cameraFromHere * hereFromNode.linear, cameraFromHere * (hereFromNode.translation - position)};
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
    m_ready.clear();
    m_tints.clear();
    m_handedOut = false;

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
        m_open.push_back({state, planes, map, norm, marks, distanceTo(bound)});
    }
}

const std::vector<Instance> &Cut::next(std::size_t count)
{
    if (m_handedOut) {
        m_ready.clear();
        m_tints.clear();
    }
    for (std::size_t visits = 0; !m_open.empty() && m_ready.size() < count && visits < 4 * count; ++visits) {
        const Node node = m_open.back();
        m_open.pop_back();
        const std::size_t first = m_open.size();
        visit(node);
        if (m_drawn) {
            sortFrom(first);
        }
        // Those on the way down are made anew, which has to be worth it.
        if (m_table.stateCount() > std::max(mostStates, 2 * m_open.size())) {
            forgetStates();
        }
    }
    m_handedOut = true;
    m_instances += m_ready.size();
    m_memory = std::max(m_memory, memoryHeld());
    return m_ready;
}

std::size_t Cut::memoryHeld() const
{
    return m_open.capacity() * sizeof(Node) + m_ready.capacity() * sizeof(Instance) + m_tints.capacity() * sizeof(Tint)
        + m_table.memoryUse();
}

void Cut::forget()
{
    m_table.forget();
    // assigning {} would keep the memory
    m_open = std::vector<Node>();
    m_ready = std::vector<Instance>();
    m_tints = std::vector<Tint>();
}

void Cut::visit(const Node &node)
{
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
    if (isOutside(seen, planes) || isBehind(seen)) {
        return;
    }
    const FractalGraph &graph = m_model.graph;
    const AffineMap composed = node.map * graph.set(range.set).maps[map];
    const Marks marks = m_tinter.below(node.marks, range.set, map);
    if (isSmall(seen)) {
        place(composed, range.next, marks, false);
        return;
    }
    const double norm = std::min(node.norm * graph.facts(range.set)[map].norm, frobeniusNorm(composed.linear));
    m_open.push_back({range.next, planes, composed, norm, marks, distanceTo(seen)});
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

bool Cut::isBehind(const Sphere &sphere) const
{
    return m_drawn && !m_drawn->isEmpty() && m_projector.isHidden(sphere, *m_drawn);
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
    states.reserve(m_open.size());
    for (const Node &node : m_open) {
        states.push_back(node.state);
    }
    m_memory = std::max(m_memory, m_table.memoryUse());
    m_table.forgetAllBut(states);
    for (std::size_t i = 0; i < m_open.size(); ++i) {
        m_open[i].state = states[i];
    }
}

}
