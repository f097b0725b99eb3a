// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "raywalk.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/geometry/sizes.h"
#include "nearest.h"

namespace romanesco {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// What a step may put a frame off by, of the numbers that are added: nine products and sums, with a margin.
constexpr double errorOfStep = 8.0 * epsilon;
/// Copies smaller than that share of the numbers that they are placed by are hardly more than points.
constexpr double leastShare = 64.0 * epsilon;
/// How far a stand-in may reach out of its bound, in parts of the bound's radius (see standIn()), and away from what it
/// stands for: bounds hold those of what is below, boxes only that itself.
constexpr double beyondBound = 0.1 + 1e-6;
constexpr double beyondContent = 2.1 + 1e-6;
constexpr double greatestCoordinate = 1e150;
constexpr std::size_t mostBytesOfStates = 64'000'000;

/// Not of what is NaN.
[[maybe_unused]] bool areComputable(const glm::dvec3 &v)
{
    return glm::all(glm::lessThanEqual(glm::abs(v), glm::dvec3(greatestCoordinate)));
}

/// Scaled first, so that no square is none.
double lengthOf(const glm::dvec3 &v)
{
    const double size = greatestSize(v);
    return size * glm::length(v / size);
}

/// Against a direction; a face without a normal looks back along it.
glm::dvec3 normalAgainst(const glm::dvec3 &direction, const Triangle &triangle)
{
    const glm::dvec3 a = triangle[1] - triangle[0];
    const glm::dvec3 b = triangle[2] - triangle[0];
    const glm::dvec3 normal = glm::cross(a / greatestSize(a), b / greatestSize(b));
    const double length = lengthOf(normal);
    if (!(length > 0.0)) {
        return -direction;
    }
    return glm::dot(normal, direction) > 0.0 ? -normal / length : normal / length;
}

bool isLater(double way, double otherWay)
{
    return way > otherWay;
}

}

void clear(RayHit &hit)
{
    std::vector<Step> choices = std::move(hit.choices); // for its memory
    choices.clear();
    clear<RayHit>(hit);
    hit.choices = std::move(choices);
}

RayWalk::RayWalk(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &mesh, const FaceTree &tree)
    : m_graph(graph)
    , m_boxes(boxes)
    , m_mesh(mesh)
    , m_tree(tree)
    , m_table(graph)
{
}

void RayWalk::cast(const Ray &ray, std::span<const RayRoot> roots, RayHit &hit)
{
    assert(areComputable(ray.origin) && areComputable(ray.direction) && "squares are numbers");
    assert(greatestSize(ray.direction) > 0.0 && "a ray leads somewhere");
    assert((ray.least >= 0.0 || ray.spread == 0.0) && "before its origin a ray has no width");
    assert(ray.least <= ray.greatest && "t begins before it ends");
    assert(ray.width >= 0.0 && ray.spread >= 0.0 && "nothing is narrower than a line");
    begin(ray, roots);
    while (!m_open.empty() && m_open.front().way <= m_best.way && m_cost.nodeVisits < ray.nodeBudget
           && !ray.stop.stop_requested()) {
        visit(takeNearest());
    }
    report(ray, hit);
}

void RayWalk::begin(const Ray &ray, std::span<const RayRoot> roots)
{
    if (memoryOfStates() > mostBytesOfStates) {
        m_table.forget();
        m_boxOfState.clear();
    }
    m_frames.clear();
    m_open.clear();
    m_cost = {};
    double reach = 0.0;
    for (const RayRoot &root : roots) {
        m_frames.push_back(rootFrame(root, ray.origin));
        reach = std::max(reach, m_frames.back().magnitude);
    }
    // a power of two, so that nothing is rounded
    m_unit = reach > 0.0 && std::isfinite(reach) ? std::ldexp(1.0, std::ilogb(reach)) : 1.0;
    const double length = lengthOf(ray.direction);
    m_direction = glm::normalize(ray.direction / greatestSize(ray.direction));
    m_onTriangles.emplace(m_direction);
    m_wayOfT = length / m_unit;
    m_least = ray.least * m_wayOfT;
    m_best = {.way = ray.greatest * m_wayOfT};
    m_width = ray.width / m_unit;
    m_spread = ray.spread / length;
    // no face of a mesh that is a single point can be met
    for (std::uint32_t i = 0; i < roots.size() && m_graph.base().radius > 0.0; ++i) {
        openRoot(i);
    }
}

RayWalk::Frame RayWalk::rootFrame(const RayRoot &root, const glm::dvec3 &origin)
{
    Frame frame;
    frame.map = {root.rayFromState.linear, root.rayFromState.translation - origin};
    frame.norm = operatorNorm(frame.map.linear);
    frame.state = m_table.find(root.positions);
    frame.isMeshOnly = root.isMeshOnly;
    const Sphere &bound = boundOf(frame);
    frame.magnitude = sumOfSizes(frame.map.translation) + frame.norm * (sumOfSizes(bound.centre) + bound.radius);
    return frame;
}

void RayWalk::openRoot(std::uint32_t number)
{
    Frame &frame = m_frames[number];
    frame.map.linear /= m_unit;
    frame.map.translation /= m_unit;
    frame.norm /= m_unit;
    frame.magnitude /= m_unit;
    const Sphere &bound = boundOf(frame);
    open({.frame = number, .magnitude = frame.magnitude, .state = frame.state, .isRoot = true},
         {frame.map(bound.centre), frame.norm * bound.radius}, errorOf(frame));
}

const Sphere &RayWalk::boundOf(const Frame &frame) const
{
    return frame.isMeshOnly ? m_graph.base() : m_table.state(frame.state).bound;
}

double RayWalk::errorOf(const Frame &frame)
{
    return errorOfStep * (frame.depth + 1) * frame.magnitude;
}

/// The radius below which what the ray comes to at a way is small.
double RayWalk::smallAt(double way, double magnitude) const
{
    return std::max(m_width + m_spread * std::max(way, m_least), leastShare * magnitude);
}

/// At least that of all that is in a sphere and small.
double RayWalk::greatestSmall(const Sphere &bound, double magnitude) const
{
    return std::min(bound.radius, smallAt(glm::dot(bound.centre, m_direction) + bound.radius, magnitude));
}

/// Keeps what the ray may meet. bound: of all of it, which may be off by an error.
void RayWalk::open(Open child, const Sphere &bound, double error)
{
    child.isSmall = bound.radius < smallAt(glm::dot(bound.centre, m_direction), child.magnitude);
    const double beyond = beyondBound * greatestSmall(bound, child.magnitude);
    const WaySpan ways = waysWithin({bound.centre, bound.radius + beyond + error}, m_direction);
    if (isReached(ways)) {
        child.way = std::max(ways.from, m_least);
        m_open.push_back(child);
        std::ranges::push_heap(m_open, isLater, &Open::way);
    }
}

/// Within what is asked for, and before the best.
bool RayWalk::isReached(const WaySpan &ways) const
{
    return !ways.isEmpty() && ways.to >= m_least && ways.from <= m_best.way;
}

RayWalk::Open RayWalk::takeNearest()
{
    std::ranges::pop_heap(m_open, isLater, &Open::way);
    const Open nearest = m_open.back();
    m_open.pop_back();
    return nearest;
}

/// The number of its frame, which is composed now unless it is a root's.
std::uint32_t RayWalk::frameOf(const Open &open)
{
    if (open.isRoot) {
        return open.frame;
    }
    const Frame &parent = m_frames[open.frame];
    const auto &[set, map] = open.choice;
    Frame frame{.map = parent.map * m_graph.set(set).maps[map],
                .magnitude = open.magnitude,
                .depth = parent.depth + 1,
                .parent = open.frame,
                .choice = open.choice,
                .state = open.state};
    frame.norm = std::min(parent.norm * m_graph.facts(set)[map].norm, frobeniusNorm(frame.map.linear));
    m_frames.push_back(frame);
    return static_cast<std::uint32_t>(m_frames.size() - 1);
}

void RayWalk::visit(const Open &open)
{
    ++m_cost.nodeVisits;
    const std::uint32_t number = frameOf(open);
    const Frame frame = m_frames[number];
    if (frame.isMeshOnly) {
        measure(number, frame.map, false);
        return;
    }
    const Sphere &bound = boundOf(frame);
    if (open.isSmall) {
        const Sphere &base = m_graph.base();
        const Sphere &fitted = standIn(base, bound);
        const double scale = fitted.radius / base.radius;
        measure(number, frame.map * AffineMap{glm::dmat3(scale), fitted.centre - scale * base.centre}, true);
        return;
    }
    const Sphere seen{frame.map(bound.centre), frame.norm * bound.radius};
    const double beyond = beyondContent * greatestSmall(seen, frame.magnitude);
    const RayInFrame inFrame(frame.map, m_direction, errorOf(frame) + beyond);
    if (!isReached(inFrame.waysWithin(boxOf(frame.state)))) {
        return;
    }
    if (m_table.expansion(frame.state).hasLeaf) {
        measure(number, frame.map, false);
    }
    openChildren(number);
}

void RayWalk::openChildren(std::uint32_t number)
{
    const Frame frame = m_frames[number];
    const std::vector<Sphere> &bounds = m_table.childBounds(frame.state);
    std::size_t child = 0;
    for (const ChildRange &range : m_table.expansion(frame.state).ranges) {
        for (std::uint32_t map = range.firstMap; map < range.endMap; ++map, ++child) {
            const Sphere &bound = bounds[child];
            const Sphere seen{frame.map(bound.centre), frame.norm * bound.radius};
            const double inFrame =
                sumOfSizes(m_graph.set(range.set).maps[map].translation) + sumOfSizes(bound.centre) + bound.radius;
            const double magnitude = std::max(frame.magnitude, sumOfSizes(seen.centre) + frame.norm * inFrame);
            open({.frame = number, .magnitude = magnitude, .choice = {range.set, map}, .state = range.next}, seen,
                 errorOf(frame) + errorOfStep * magnitude);
        }
    }
}

/// The faces of a copy of the base mesh, nearest boxes first.
void RayWalk::measure(std::uint32_t frame, const AffineMap &map, bool isStandIn)
{
    const std::span<const FaceTree::Node> nodes = m_tree.nodes();
    const RayInFrame inFrame(map, m_direction, errorOf(m_frames[frame]));
    std::size_t count = 0;
    const auto wait = [&](std::uint32_t node) {
        const WaySpan ways = inFrame.waysWithin(nodes[node].box);
        if (isReached(ways)) {
            m_waiting[count++] = {ways.from, node};
        }
    };
    wait(0);
    while (count > 0) {
        const Waiting next = m_waiting[--count];
        if (next.way > m_best.way) {
            continue;
        }
        const FaceTree::Node &node = nodes[next.node];
        if (node.faceCount == 0) {
            const std::size_t before = count;
            wait(node.first);
            wait(node.first + 1);
            if (count == before + 2 && m_waiting[before].way < m_waiting[before + 1].way) {
                std::swap(m_waiting[before], m_waiting[before + 1]);
            }
            continue;
        }
        for (const std::uint32_t face : m_tree.faces().subspan(node.first, node.faceCount)) {
            measureFace(frame, map, face, isStandIn);
        }
    }
}

void RayWalk::measureFace(std::uint32_t frame, const AffineMap &map, std::uint32_t face, bool isStandIn)
{
    ++m_cost.faceTests;
    Triangle triangle = triangleOf(m_mesh, face);
    std::ranges::transform(triangle, triangle.begin(), map);
    const std::optional<double> way = m_onTriangles->wayTo(triangle);
    if (!way || *way < m_least) {
        return;
    }
    if (m_best.frame == none ? *way <= m_best.way : *way < m_best.way) {
        m_best = {*way, frame, face, triangle, isStandIn};
    }
}

const Box &RayWalk::boxOf(StateId state)
{
    if (m_boxOfState.size() <= state) {
        m_boxOfState.resize(m_table.stateCount());
    }
    std::optional<Box> &box = m_boxOfState[state];
    if (!box) {
        box = Box::ofNothing();
        for (const Position position : m_table.state(state).positions) {
            box = box->with(m_boxes.at(m_graph, position));
        }
    }
    return *box;
}

void RayWalk::report(const Ray &ray, RayHit &hit)
{
    clear(hit);
    hit.cost = m_cost;
    const bool isCutShort = !m_open.empty() && m_open.front().way <= m_best.way;
    hit.promise = isCutShort ? Promise::UpperBound : Promise::Exact;
    hit.lower = (isCutShort ? m_open.front().way : m_best.way) / m_wayOfT;
    if (m_best.frame == none) {
        return;
    }
    hit.t = std::clamp(m_best.way / m_wayOfT, ray.least, ray.greatest);
    hit.point = ray.origin + m_best.way * m_unit * m_direction;
    hit.direction = normalAgainst(m_direction, m_best.triangle);
    hit.face = m_best.face;
    hit.isStandIn = m_best.isStandIn;
    reportPicks(hit);
}

void RayWalk::reportPicks(RayHit &hit)
{
    m_reached.clear();
    std::uint32_t at = m_best.frame;
    for (; m_frames[at].parent != none; at = m_frames[at].parent) {
        const Frame &frame = m_frames[at];
        const Positions &positions = m_table.state(frame.state).positions;
        hit.choices.push_back(frame.choice);
        hit.address.push_back({positions.front() - 1, frame.choice.map});
        if (m_graph.setsShareMaps()) {
            m_reached.push_back(positions);
        }
    }
    hit.root = at;
    std::ranges::reverse(hit.choices);
    std::ranges::reverse(hit.address);
    std::ranges::reverse(m_reached);
    if (m_graph.setsShareMaps()) {
        placePicks(m_graph, m_reached, hit.address);
    }
}

std::size_t RayWalk::memoryOfStates() const
{
    return m_table.memoryUse() + m_boxOfState.capacity() * sizeof(m_boxOfState.front());
}

std::size_t RayWalk::memoryUse() const
{
    return sizeof(*this) + memoryOfStates() + m_frames.capacity() * sizeof(Frame) + m_open.capacity() * sizeof(Open)
        + m_reached.capacity() * sizeof(Positions);
}

}
