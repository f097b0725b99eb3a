// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "spherebounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "fractalgraph.h"
#include "levelruns.h"

namespace romanesco {

namespace {

using Growth = SphereBounds::Growth;
using Node = BoundLayout::Node;
using Slot = LevelSequence::Slot;
using Stretch = BoundLayout::Stretch;

/// Bounds the work of the rounds that find invariant spheres: maps looked at in all, each some ten distances.
constexpr std::size_t mostMaps = 1'000'000;

Growth composed(const Growth &outer, const Growth &inner)
{
    return {outer.factor * inner.factor, outer.factor * inner.offset + outer.offset};
}

Growth power(Growth growth, std::uint64_t exponent)
{
    Growth result;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) {
            result = composed(result, growth);
        }
        growth = composed(growth, growth);
    }
    return result;
}

double reachOf(const Sphere &sphere)
{
    return sphere.isEmpty() ? 0.0 : glm::length(sphere.centre) + sphere.radius;
}

}

class SphereBounds::Builder
{
public:
    Builder(const FractalGraph &graph, const Sphere &base)
        : m_graph(graph)
        , m_layout(graph)
    {
        m_bounds.m_spheres.front() = base;
    }

    SphereBounds build()
    {
        for (std::size_t stretch = 0; stretch < m_layout.stretchCount(); ++stretch) {
            m_layout.begin(stretch);
            addOwn(stretch);
            if (!m_layout.isWhole(stretch) && !addShared(stretch)) {
                addGrown(stretch);
            }
        }
        m_bounds.m_layout = std::move(m_layout).build();
        return std::move(m_bounds);
    }

private:
    /// Until the levels have shrunk what the stretch is made of, and its way to where they lead, to little of their own
    /// size, or to nearly nothing.
    void addOwn(std::size_t stretch)
    {
        constexpr double little = 1.0 / 128.0;
        constexpr double nearlyNothing = 1e-12;
        const Stretch &place = m_layout.layout().stretches()[stretch];
        const Sphere whole = m_bounds.m_spheres[place.exit];
        const bool maySettle = m_layout.contracts(stretch) && !m_layout.isShortNest(stretch);
        double left = 1.0;
        while (m_layout.canAddOwn(stretch)) {
            const Sphere &made = m_bounds.m_spheres[place.entry];
            const double way = glm::distance(whole.centre, made.centre) + whole.radius;
            if (maySettle && (left * way <= little * made.radius || left <= nearlyNothing)) {
                break;
            }
            left *= m_layout.addOwn(stretch);
            const std::vector<Sphere> &content = contentOf(nextNode());
            m_bounds.m_spheres.push_back(content.size() == 1 ? content.front() : enclosingSphere(content));
        }
    }

    [[nodiscard]] Node nextNode() const { return static_cast<Node>(m_bounds.m_spheres.size()); }

    /// What the sphere of a node must hold: for each of its steps the maps of the next sphere, and that sphere itself
    /// where the level may be passed over.
    const std::vector<Sphere> &contentOf(Node node)
    {
        m_content.clear();
        for (const auto &[slot, next] : m_layout.layout().steps(node)) {
            const SetId id = m_graph.levels().set(slot);
            const TransformSet &set = m_graph.set(id);
            const Sphere &sphere = m_bounds.m_spheres[next];
            for (std::size_t i = 0; i < set.maps.size(); ++i) {
                m_content.push_back(transformed(set.maps[i], m_graph.facts(id)[i].norm, sphere));
            }
            if (set.holdsIdentity && next != node) {
                m_content.push_back(sphere);
            }
        }
        return m_content;
    }

    // ---- The invariant

    bool addShared(std::size_t stretch)
    {
        if (!m_layout.contracts(stretch)) {
            return false;
        }
        const Node first = nextNode();
        const Node before = first - 1;
        m_layout.addShared(stretch);
        m_bounds.m_spheres.resize(m_layout.layout().nodeCount(), m_bounds.m_spheres[before]);
        const bool isFound = findInvariant(std::span(m_bounds.m_spheres).subspan(first), first);
        if (!isFound) {
            m_bounds.m_spheres.resize(first);
        }
        return isFound;
    }

    /// Centres by iterating the content until they settle; radii for those centres by iterating the largest reach; then
    /// a margin, until each holds its content as it stands.
    bool findInvariant(std::span<Sphere> spheres, Node first)
    {
        std::size_t mapCount = 1;
        for (Node node = first; node < nextNode(); ++node) {
            mapCount += contentOf(node).size();
        }
        const int rounds = static_cast<int>(std::clamp<std::size_t>(mostMaps / mapCount, 4, 400));
        for (int round = 0; round < rounds; ++round) {
            double change = 0.0;
            for (std::size_t i = 0; i < spheres.size(); ++i) {
                const Sphere next = enclosingSphere(contentOf(first + static_cast<Node>(i)));
                const double moved =
                    glm::distance(next.centre, spheres[i].centre) + std::abs(next.radius - spheres[i].radius);
                change = std::max(change, moved / next.radius);
                spheres[i] = next;
            }
            if (!std::isfinite(change)) {
                return false;
            }
            if (change <= 1e-3) {
                break;
            }
        }
        for (int round = 0; round < rounds; ++round) {
            double change = 0.0;
            for (std::size_t i = 0; i < spheres.size(); ++i) {
                const double radius = enclosingRadius(spheres[i].centre, contentOf(first + static_cast<Node>(i)));
                change = std::max(change, std::abs(radius - spheres[i].radius) / radius);
                spheres[i].radius = radius;
            }
            if (!(change > 1e-6)) {
                break;
            }
        }
        for (double margin = 1e-5; margin < 2.0; margin *= 4.0) {
            for (Sphere &sphere : spheres) {
                sphere.radius *= 1.0 + margin;
            }
            if (settle(spheres, first)) {
                return true;
            }
        }
        return false;
    }

    /// Enlarges what does not hold its content until all do. What `#` passes on unchanged leaves no room for rounding, so
    /// that a margin on all alike is not enough; what maps pass on has shrunk, so that this ends soon.
    bool settle(std::span<Sphere> spheres, Node first)
    {
        constexpr int rounds = 64;
        for (int round = 0; round < rounds; ++round) {
            bool isSettled = true;
            for (std::size_t i = 0; i < spheres.size(); ++i) {
                const double needed = enclosingRadius(spheres[i].centre, contentOf(first + static_cast<Node>(i)));
                if (!std::isfinite(needed)) {
                    return false;
                }
                if (needed > spheres[i].radius) {
                    spheres[i].radius = needed;
                    isSettled = false;
                }
            }
            if (isSettled) {
                return true;
            }
        }
        return false;
    }

    // ---- Growth

    void addGrown(std::size_t index)
    {
        if (m_bounds.m_slotGrowth.empty()) {
            findSlotGrowth();
            findPassGrowth();
        }
        m_layout.addGrown(index);
        const Stretch &stretch = m_layout.layout().stretches()[index];
        m_bounds.m_spheres.push_back(m_bounds.grown(m_graph.levels(), stretch.begin, stretch));
    }

    void findSlotGrowth()
    {
        const LevelSequence &levels = m_graph.levels();
        for (Slot slot = 0; slot < levels.slotCount(); ++slot) {
            const TransformSet &set = m_graph.setAt(slot);
            Growth growth{set.holdsIdentity ? 1.0 : 0.0, 0.0};
            for (std::size_t i = 0; i < set.maps.size(); ++i) {
                growth.factor = std::max(growth.factor, m_graph.facts(levels.set(slot))[i].norm);
                growth.offset = std::max(growth.offset, glm::length(set.maps[i].translation));
            }
            m_bounds.m_slotGrowth.push_back(growth);
        }
    }

    void findPassGrowth()
    {
        // Inner repeats have greater numbers than those round them.
        const std::vector<LevelSequence::Repeat> &repeats = m_graph.levels().repeats();
        m_bounds.m_passGrowth.resize(repeats.size());
        for (std::size_t i = repeats.size(); i-- > 0;) {
            Growth growth;
            for (const LevelRun &run : runsOfPass(m_graph.levels(), static_cast<std::uint32_t>(i))) {
                growth = composed(growth, m_bounds.growthOf(run));
            }
            m_bounds.m_passGrowth[i] = growth;
        }
    }

    const FractalGraph &m_graph;
    BoundLayout::Builder m_layout;
    SphereBounds m_bounds;
    std::vector<Sphere> m_content;
};

SphereBounds::SphereBounds(const FractalGraph &graph, const Sphere &base)
    : SphereBounds(Builder(graph, base).build())
{
}

Sphere SphereBounds::at(const LevelSequence &levels, Position position) const
{
    const std::optional<Node> node = m_layout.nodeAt(levels, position);
    return node ? m_spheres[*node] : grown(levels, position, m_layout.stretchAt(position));
}

Growth SphereBounds::growthOf(const LevelRun &run) const
{
    return run.repeat == 0 ? m_slotGrowth[run.slot] : power(m_passGrowth[run.repeat], run.passes);
}

/// From a position to the end of its stretch: slots singly, passes of a repeat by powers.
Sphere SphereBounds::grown(const LevelSequence &levels, Position position, const Stretch &stretch) const
{
    Growth growth;
    for (const LevelRun &run : runsBetween(levels, position, stretch.end)) {
        growth = composed(growth, growthOf(run));
    }
    const Sphere &after = m_spheres[stretch.exit];
    if (after.isEmpty()) {
        return after;
    }
    const double radius = growth.factor * reachOf(after) + growth.offset;
    return {glm::dvec3(0.0), std::isnan(radius) ? std::numeric_limits<double>::infinity() : radius * (1.0 + 1e-9)};
}

std::size_t SphereBounds::memoryUse() const
{
    return m_layout.memoryUse() + m_spheres.capacity() * sizeof(Sphere)
        + (m_slotGrowth.capacity() + m_passGrowth.capacity()) * sizeof(Growth);
}

}
