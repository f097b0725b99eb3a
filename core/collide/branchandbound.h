// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "collider.h"
#include "core/fractal/boxbounds.h"
#include "core/fractal/fractalgraph.h"
#include "core/fractal/hullbounds.h"
#include "core/fractal/statetable.h"
#include "descent.h"
#include "nearest.h"

namespace romanesco {

/// Finds the nearest face of a graph's copies by going down into the nearest box first, past those that are no nearer than
/// what was found (Land and Doig 1960). Frames say how: LocalFrames or RelativeFrames.
///
/// A branch that is too small for p to tell its points apart is not gone down further: the middle of its box is found
/// then, without a face. Every distance that is dropped is kept in mind, as the bound below which nothing is.
template<typename Frames>
class BranchAndBound final : public Search
{
public:
    /// The graph, the boxes and the hulls must outlive it. excess: how much farther than the least a distance may be, in parts of it.
    BranchAndBound(const FractalGraph &graph, const BoxBounds &boxes, const HullBounds &hulls, Frames frames,
                   double excess)
        : m_graph(graph)
        , m_boxes(boxes)
        , m_hulls(hulls)
        , m_frames(std::move(frames))
        , m_excess(excess)
        , m_table(graph)
        , m_meshBox(boxes.at(graph, graph.levels().levelCount()))
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        assert(std::isfinite(query.p.x + query.p.y + query.p.z) && "no face is nearest to a point that is nowhere");
        begin(query);
        if (!boundsOf(m_table.root()).box.isEmpty()) {
            visit({.state = m_table.root()}, m_frames.begin(query.p));
            while (!m_nodes.empty() && m_cost.nodeVisits < query.nodeBudget && !query.stop.stop_requested()) {
                goOn();
            }
        }
        giveUp();
        report(query, hit);
    }

private:
    using Frame = typename Frames::Frame;

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();
    /// Most searches end before fine hulls pay.
    static constexpr std::uint64_t visitsBeforeFine = 64;
    static constexpr std::size_t mostTableBytes = 64'000'000;
    /// Of a candidate: the base mesh itself.
    static constexpr std::uint32_t leaf = std::numeric_limits<std::uint32_t>::max();
    /// Deeper units would not be numbers.
    static constexpr double leastUnit = 1e-290;

    enum class Tightness : std::uint8_t { OfBox, OfCoarseHull, Final };

    /// What a node leads to, at so great a distance or more, in its frame's unit.
    struct Candidate {
        double distance;
        std::uint32_t range;
        std::uint32_t map;
        /// What the distance was found by. A better one is asked only of what seems nearest.
        Tightness tightness;
    };

    /// Round all that a state leads to.
    struct Bounds {
        Box box;
        const HullBounds::Hulls *hulls;
    };

    /// A state that is being looked at.
    struct Node {
        StateId state;
        Frame frame;
        std::size_t firstCandidate;
    };

    void begin(const Query &query)
    {
        if (m_table.memoryUse() > mostTableBytes) {
            m_table.forget();
            m_stateBounds.clear();
        }
        m_nodes.clear();
        m_path.clear();
        m_candidates.clear();
        m_cost = {};
        m_found = Found::Nothing;
        m_best = query.radius;
        m_lower = infinity;
        m_deepest = 0;
    }

    /// Whether something at a distance, which may be off by so much, in the model's unit, can be nearer than what was found.
    /// What is as near but for rounding is not: there may be millions of it. Only what was found is relaxed: nothing
    /// within the radius is missed.
    [[nodiscard]] bool isNearer(double distance, double error) const
    {
        return m_found == Found::Nothing ? distance - error <= m_best
                                         : distance + error < m_best * (1.0 - 4.0 * epsilon) / (1.0 + m_excess);
    }

    void drop(double distance, double error) { m_lower = std::min(m_lower, distance - error); }

    [[nodiscard]] double errorOf(const Node &node, const Candidate &candidate)
    {
        if (candidate.range == leaf) {
            return node.frame.error;
        }
        const ChildRange &range = m_table.expansion(node.state).ranges[candidate.range];
        return m_frames.errorOf(node.frame, range.set, boundsOf(range.next).box);
    }

    /// The nearest candidate of the node that was entered last; back where none is near enough.
    void goOn()
    {
        const Node &node = m_nodes.back();
        const auto candidates = m_candidates.begin() + static_cast<std::ptrdiff_t>(node.firstCandidate);
        const auto nearest = std::ranges::min_element(candidates, m_candidates.end(), {}, &Candidate::distance);
        if (nearest == m_candidates.end()) {
            leave();
            return;
        }
        const Candidate next = *nearest;
        const double distance = next.distance * node.frame.unit;
        const double error = errorOf(node, next);
        if (!isNearer(distance, error)) {
            dropFarther(node);
            return;
        }
        if (next.tightness == Tightness::OfBox
            || (next.tightness == Tightness::OfCoarseHull && m_cost.nodeVisits >= visitsBeforeFine)) {
            tighten(node, *nearest);
            return;
        }
        *nearest = m_candidates.back();
        m_candidates.pop_back();
        if (next.range == leaf) {
            measure(node.frame);
        } else {
            goDown(node, next);
        }
    }

    /// What seems nearest may be farther, and not the nearest.
    void tighten(const Node &node, Candidate &candidate)
    {
        const ChildRange &range = m_table.expansion(node.state).ranges[candidate.range];
        const HullBounds::Hulls &hulls = *boundsOf(range.next).hulls;
        const bool isFirst = candidate.tightness == Tightness::OfBox;
        const double distance = isFirst ? m_frames.roughDistanceTo(node.frame, range.set, candidate.map, hulls)
                                        : m_frames.fineDistanceTo(node.frame, range.set, candidate.map, hulls);
        candidate.distance = std::max(candidate.distance, distance);
        candidate.tightness = isFirst ? Tightness::OfCoarseHull : Tightness::Final;
    }

    /// Each for itself: one that is farther than the nearest may be off by more, and be nearer in truth.
    void dropFarther(const Node &node)
    {
        const auto first = m_candidates.begin() + static_cast<std::ptrdiff_t>(node.firstCandidate);
        const auto isFarther = [&](const Candidate &candidate) {
            const double distance = candidate.distance * node.frame.unit;
            const double error = errorOf(node, candidate);
            if (isNearer(distance, error)) {
                return false;
            }
            drop(distance, error);
            return true;
        };
        m_candidates.erase(std::remove_if(first, m_candidates.end(), isFarther), m_candidates.end());
    }

    void goDown(const Node &node, const Candidate &candidate)
    {
        const ChildRange &range = m_table.expansion(node.state).ranges[candidate.range];
        const Box &box = boundsOf(range.next).box;
        const Frame frame = m_frames.child(node.frame, range.set, candidate.map, box);
        const DescentStep step{range.set, candidate.map, range.next};
        const double size = m_frames.sizeOf(frame, box) * frame.unit;
        const double distance = candidate.distance * node.frame.unit;
        if (size <= std::max(epsilon / 2.0 * distance, frame.error) || frame.unit < leastUnit) {
            settle(step, frame, box, distance);
        } else {
            m_path.push_back(step);
            visit(step, frame);
        }
    }

    void visit(const DescentStep &step, const Frame &frame)
    {
        if (m_table.expansion(step.state).ranges.empty()) {
            measure(frame);
            stepBack();
        } else {
            enter(step, frame);
        }
    }

    /// All points of the branch are alike, seen from p.
    void settle(const DescentStep &step, const Frame &frame, const Box &box, double distance)
    {
        ++m_cost.nodeVisits;
        drop(distance, frame.error);
        if (m_found == Found::Nothing ? distance <= m_best : distance < m_best) {
            m_best = distance;
            m_found = Found::Branch;
            m_bestFrame = frame;
            m_bestBox = box;
            m_bestPath.assign(m_path.begin(), m_path.end());
            m_bestPath.push_back(step);
        }
    }

    void enter(const DescentStep &step, const Frame &frame)
    {
        ++m_cost.nodeVisits;
        m_deepest = std::max(m_deepest, m_path.size());
        m_nodes.push_back({step.state, frame, m_candidates.size()});
        const Expansion &expansion = m_table.expansion(step.state);
        if (expansion.hasLeaf) {
            consider({m_frames.distanceTo(frame, m_meshBox), leaf, 0, Tightness::Final}, frame, frame.error);
        }
        for (std::uint32_t i = 0; i < expansion.ranges.size(); ++i) {
            const ChildRange &range = expansion.ranges[i];
            const auto [box, hulls] = boundsOf(range.next);
            const double error = m_frames.errorOf(frame, range.set, box);
            for (std::uint32_t map = range.firstMap; map < range.endMap && !box.isEmpty(); ++map) {
                const double distance = m_frames.distanceTo(frame, range.set, map, box);
                consider({distance, i, map, hulls ? Tightness::OfBox : Tightness::Final}, frame, error);
            }
        }
    }

    void consider(const Candidate &candidate, const Frame &frame, double error)
    {
        const double distance = candidate.distance * frame.unit;
        if (isNearer(distance, error)) {
            m_candidates.push_back(candidate);
        } else {
            drop(distance, error);
        }
    }

    void leave()
    {
        m_candidates.resize(m_nodes.back().firstCandidate);
        m_nodes.pop_back();
        stepBack();
    }

    void stepBack()
    {
        if (!m_path.empty()) { // no step leads to the root
            m_path.pop_back();
        }
    }

    void measure(const Frame &frame)
    {
        ++m_cost.nodeVisits;
        LeafHit found;
        m_frames.measure(frame, m_best / frame.unit, found);
        m_cost.faceTests += found.faceTests;
        drop(found.lower * frame.unit, frame.error);
        const double distance = found.nearest.distance * frame.unit;
        if (found.face != Mesh::none && (distance < m_best || (m_found == Found::Nothing && distance <= m_best))) {
            m_best = distance;
            m_found = Found::Face;
            m_bestFrame = frame;
            m_bestLeaf = found;
            m_bestPath.assign(m_path.begin(), m_path.end());
        }
    }

    /// What is left when the budget is spent may be as near as its boxes.
    void giveUp()
    {
        m_isCutShort = !m_nodes.empty();
        for (std::size_t i = 0; i < m_nodes.size(); ++i) {
            const std::size_t end = i + 1 < m_nodes.size() ? m_nodes[i + 1].firstCandidate : m_candidates.size();
            for (std::size_t j = m_nodes[i].firstCandidate; j < end; ++j) {
                drop(m_candidates[j].distance * m_nodes[i].frame.unit, errorOf(m_nodes[i], m_candidates[j]));
            }
        }
    }

    void report(const Query &query, Hit &hit)
    {
        clear(hit);
        hit.cost = m_cost;
        if (m_found == Found::Face) {
            hit.face = m_bestLeaf.face;
            m_frames.finish(m_bestFrame, m_bestLeaf, m_bestPath, hit);
        } else if (m_found == Found::Branch) {
            hit.face = Mesh::none;
            m_frames.finish(m_bestFrame, m_bestBox, m_bestPath, hit);
        }
        if (m_found != Found::Nothing) {
            fillAddress(hit.address);
        }
        // each level's scale is rounded too
        const double rounded = 1.0 - 64.0 * epsilon * static_cast<double>(m_deepest + 1);
        hit.lower = std::clamp(m_lower * rounded, 0.0, std::min(hit.distance, query.radius));
        promise(hit);
    }

    void promise(Hit &hit) const
    {
        if (!m_isCutShort) {
            hit.promise = m_excess > 0.0 ? Promise::Within : Promise::Exact;
            hit.excess = m_excess;
        } else if (hit.lower > 0.0 && hit.isFound()) {
            hit.promise = Promise::Within;
            hit.excess = hit.distance / hit.lower - 1.0;
        } else {
            hit.promise = Promise::UpperBound;
        }
    }

    void fillAddress(Address &address)
    {
        m_reached.clear();
        for (const DescentStep &step : m_bestPath) {
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

    const Bounds &boundsOf(StateId state)
    {
        while (m_stateBounds.size() <= state) {
            const Positions &positions = m_table.state(static_cast<StateId>(m_stateBounds.size())).positions;
            Bounds bounds{Box::ofNothing(), positions.size() == 1 ? m_hulls.at(m_graph, positions.front()) : nullptr};
            for (const Position position : positions) {
                bounds.box = bounds.box.with(m_boxes.at(m_graph, position));
            }
            m_stateBounds.push_back(bounds);
        }
        return m_stateBounds[state];
    }

    const FractalGraph &m_graph;
    const BoxBounds &m_boxes;
    const HullBounds &m_hulls;
    Frames m_frames;
    const double m_excess;
    StateTable m_table;
    /// By state.
    std::vector<Bounds> m_stateBounds;
    Box m_meshBox;

    /// From the root to where the search is, a step between two nodes; the candidates of each node after those of the one
    /// above.
    std::vector<Node> m_nodes;
    std::vector<DescentStep> m_path;
    std::vector<Candidate> m_candidates;
    std::size_t m_deepest = 0;
    bool m_isCutShort = false;

    enum class Found { Nothing, Face, Branch };
    Found m_found = Found::Nothing;
    /// The distance of what was found; the radius before.
    double m_best = infinity;
    Frame m_bestFrame;
    LeafHit m_bestLeaf;
    Box m_bestBox;
    std::vector<DescentStep> m_bestPath;
    std::vector<Positions> m_reached;

    double m_lower = infinity;
    SearchCost m_cost;
};

}
