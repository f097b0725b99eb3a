// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "support.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/sizes.h"

namespace romanesco {

namespace {

using Node = BoundLayout::Node;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// As glm::length(), but squares neither underflow nor overflow.
double lengthOf(const glm::dvec3 &v)
{
    if (const double square = glm::dot(v, v); square > 1e-280 && square < 1e280) {
        return std::sqrt(square);
    }
    const double largest = greatestSize(v);
    return largest > 0.0 ? largest * glm::length(v / largest) : 0.0;
}

Support ofSphere(const Sphere &sphere, const glm::dvec3 &direction)
{
    const double centre = glm::dot(direction, sphere.centre);
    const double reach = lengthOf(direction) * sphere.radius;
    return {centre - reach, centre + reach};
}

/// Something touches each side of the reached box, no farther back than the outer box on the other axes.
Support ofBox(const BoxRange &box, const glm::dvec3 &direction)
{
    Support support{-infinity, 0.0};
    double least = 0.0;
    double mostGained = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = direction[axis];
        if (along == 0.0) { // infinite sides do not matter then
            continue;
        }
        const bool isUp = along > 0.0;
        const double nearest = along * (isUp ? box.outer.least[axis] : box.outer.greatest[axis]);
        const double reached = along * (isUp ? box.reached.greatest[axis] : box.reached.least[axis]);
        support.greatest += along * (isUp ? box.outer.greatest[axis] : box.outer.least[axis]);
        least += nearest;
        mostGained = std::max(mostGained, reached - nearest);
    }
    support.least = std::isnan(least + mostGained) ? -infinity : least + mostGained;
    return support;
}

}

Support SupportSearch::known(Node node, const glm::dvec3 &direction) const
{
    const Sphere &sphere = m_graph.bounds().ofNode(node);
    if (sphere.isEmpty()) {
        return {-infinity, -infinity};
    }
    const Support inSphere = ofSphere(sphere, direction);
    const Support inBox = ofBox(m_boxes[node], direction);
    return {std::max(inSphere.least, inBox.least), std::min(inSphere.greatest, inBox.greatest)};
}

/// A copy of a node.
struct SupportSearch::Candidate {
    double greatest;
    Node node;
    int depth;
    /// Nothing more can be found out about it.
    bool isFinal;
    /// In the node's frame; and what it has reached before.
    glm::dvec3 direction;
    double offset;
    /// For the rounding: the first direction's length times the norms, and the sum of what was added up.
    double norm;
    double size;
    /// The last node passed over since the last map, in m_passed; 0 for none.
    std::uint32_t passed;

    /// A direction is off by less than 6u for each map, relative to the norms (u is half of epsilon); what it is multiplied
    /// with and added up, by less than 6u more.
    [[nodiscard]] double rounding(const Sphere &sphere) const
    {
        return 4.0 * epsilon * (depth + 1) * (size + norm * (sumOfSizes(sphere.centre) + sphere.radius));
    }
};

/// Small, for it is moved about.
struct SupportSearch::Open {
    double greatest;
    std::uint32_t candidate;

    auto operator<=>(const Open &other) const { return greatest <=> other.greatest; }
    bool operator==(const Open &other) const { return greatest == other.greatest; }
};

SupportSearch::SupportSearch(const FractalGraph &graph, const Mesh &mesh, std::span<const Box> boxes)
    : m_graph(graph)
    , m_fans(graph.setCount())
    , m_vertices(usedVertices(mesh))
    , m_boxes(graph.layout().nodeCount())
{
    for (SetId id = 0; id < graph.setCount(); ++id) {
        std::unordered_map<AffineMap, std::size_t, AffineMapHash> fans;
        for (std::size_t i = 0; i < graph.set(id).maps.size(); ++i) {
            const AffineMap &map = graph.set(id).maps[i];
            const auto [known, isNew] = fans.try_emplace({map.linear, glm::dvec3(0.0)}, m_fans[id].size());
            if (isNew) {
                m_fans[id].push_back({map.linear, graph.facts(id)[i].norm, 0.0, {}});
            }
            Fan &fan = m_fans[id][known->second];
            fan.translationSize = std::max(fan.translationSize, sumOfSizes(map.translation));
            fan.translations.push_back(map.translation);
        }
    }
    for (std::size_t node = 0; node < boxes.size(); ++node) {
        m_boxes[node].outer = boxes[node];
    }
    for (Node node = 0; node < graph.layout().nodeCount(); ++node) {
        std::vector<SetId> &sets = m_sets.emplace_back();
        for (const BoundLayout::Step &step : graph.layout().steps(node)) {
            if (graph.setAt(step.slot).holdsIdentity) {
                sets.push_back(graph.canonical(graph.levels().set(step.slot)));
            }
        }
        std::ranges::sort(sets);
    }
    Box box = Box::ofNothing();
    for (const glm::dvec3 &vertex : m_vertices) {
        box = box.with(vertex);
    }
    m_boxes[BoundLayout::end] = {box, box};
}

SupportSearch::~SupportSearch() = default;

class SupportSearch::Search
{
public:
    Search(SupportSearch &parts, std::size_t &budget)
        : m_parts(parts)
        , m_graph(parts.m_graph)
        , m_budget(budget)
        , m_candidates(parts.m_candidates)
        , m_open(parts.m_open)
    {
        m_candidates.clear();
        m_open.clear();
    }

    Support run(Node node, const glm::dvec3 &direction, double tolerance)
    {
        const Support whole = m_parts.known(node, direction);
        if (node != BoundLayout::end && m_graph.layout().steps(node).empty()) {
            return whole;
        }
        m_least = whole.least;
        expand({whole.greatest, node, 0, false, direction, 0.0, lengthOf(direction), 0.0, 0});
        while (!m_open.empty() && !m_candidates[m_open.front().candidate].isFinal && m_budget > 0
               && !(m_open.front().greatest - m_least <= tolerance)) {
            const Candidate candidate = m_candidates[m_open.front().candidate];
            std::ranges::pop_heap(m_open);
            m_open.pop_back();
            expand(candidate);
        }
        const double greatest = m_open.empty() ? -infinity : m_open.front().greatest;
        return {std::min(m_least, greatest), greatest};
    }

private:
    void expand(const Candidate &parent)
    {
        if (parent.node == BoundLayout::end) {
            measure(parent);
            return;
        }
        for (const auto &[slot, next] : m_graph.layout().steps(parent.node)) {
            const SetId set = m_graph.canonical(m_graph.levels().set(slot));
            if (!isPassed(set, parent.passed)) {
                addMaps(parent, set, next);
            }
        }
        m_passed.push_back({parent.node, parent.passed});
        const auto passed = static_cast<std::uint32_t>(m_passed.size() - 1);
        for (const auto &[slot, next] : m_graph.layout().steps(parent.node)) {
            if (m_graph.setAt(slot).holdsIdentity && next != parent.node) {
                Candidate candidate = parent;
                candidate.node = next;
                candidate.passed = passed;
                add(parent, candidate);
            }
        }
    }

    void addMaps(const Candidate &parent, SetId set, Node next)
    {
        for (const Fan &fan : m_parts.m_fans[set]) {
            double farthest = -infinity;
            for (const glm::dvec3 &translation : fan.translations) {
                farthest = std::max(farthest, glm::dot(parent.direction, translation));
            }
            look(fan.translations.size());
            add(parent,
                {parent.greatest, next, parent.depth + 1, false, glm::transpose(fan.linear) * parent.direction,
                 parent.offset + farthest, parent.norm * fan.norm, parent.size + parent.norm * fan.translationSize, 0});
        }
    }

    /// A map of a set that was passed over has been looked at where it was met first, with more to follow: else the same
    /// copies would be met in exponentially many ways.
    [[nodiscard]] bool isPassed(SetId set, std::uint32_t passed) const
    {
        while (passed != 0 && !std::ranges::binary_search(m_parts.m_sets[m_passed[passed].node], set)) {
            passed = m_passed[passed].before;
        }
        return passed != 0;
    }

    void add(const Candidate &parent, Candidate candidate)
    {
        const Sphere &sphere = m_graph.bounds().ofNode(candidate.node);
        if (sphere.isEmpty()) {
            return;
        }
        const Support support = m_parts.known(candidate.node, candidate.direction);
        const double rounding = candidate.rounding(sphere);
        candidate.greatest = std::min(parent.greatest, candidate.offset + support.greatest + rounding);
        candidate.isFinal = candidate.node != BoundLayout::end && m_graph.layout().steps(candidate.node).empty();
        m_least = std::max(m_least, candidate.offset + support.least - rounding);
        open(candidate);
        look(1);
    }

    void measure(Candidate leaf)
    {
        double reach = -infinity;
        for (const glm::dvec3 &vertex : m_parts.m_vertices) {
            reach = std::max(reach, glm::dot(leaf.direction, vertex));
        }
        look(1 + m_parts.m_vertices.size() / 4);
        const double rounding = leaf.rounding(m_graph.base());
        leaf.greatest = std::min(leaf.greatest, leaf.offset + reach + rounding);
        leaf.isFinal = true;
        m_least = std::max(m_least, leaf.offset + reach - rounding);
        open(leaf);
    }

    void open(const Candidate &candidate)
    {
        m_open.push_back({candidate.greatest, static_cast<std::uint32_t>(m_candidates.size())});
        std::ranges::push_heap(m_open);
        m_candidates.push_back(candidate);
    }

    void look(std::size_t count) { m_budget -= std::min(m_budget, count); }

    const SupportSearch &m_parts;
    const FractalGraph &m_graph;
    std::size_t &m_budget;
    struct Passed {
        Node node;
        std::uint32_t before;
    };

    std::vector<Candidate> &m_candidates;
    /// A heap.
    std::vector<Open> &m_open;
    std::vector<Passed> m_passed{{0, 0}};
    double m_least = -infinity;
};

Support SupportSearch::search(Node node, const glm::dvec3 &direction, double tolerance, std::size_t &budget)
{
    return Search(*this, budget).run(node, direction, tolerance);
}

}
