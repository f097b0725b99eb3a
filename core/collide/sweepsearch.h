// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "boundedstates.h"
#include "collider.h"
#include "descent.h"
#include "equalproducts.h"
#include "facesweep.h"
#include "lanes.h"
#include "nearest.h"
#include "sweeping.h"

namespace romanesco {

/// Finds what a moving sphere touches first of a graph's copies, as BranchAndBound finds what is nearest: going down into
/// what may be touched first, past what is touched later than what was found. Frames say how: LocalSweep or RelativeSweep.
///
/// The sphere is grown by what a frame may be off, so that every way is proved: no point of what it leads to is touched
/// before, but for what is exactly rounding. A branch that is smaller than that is touched as a point.
template<typename Frames>
class SweepSearch
{
public:
    /// All must outlive it.
    SweepSearch(const FractalGraph &graph, const BoxBounds &boxes, const HullBounds &hulls,
                const EqualProducts &products, Positions beginsAt, Frames frames)
        : m_states(graph, boxes, hulls, std::move(beginsAt))
        , m_products(products)
        , m_frames(std::move(frames))
    {
    }

    void sweep(const Sweep &sweep, Touch &touch)
    {
        const Path path(sweep);
        begin(path);
        const Box &box = m_states.bounds(m_states.begin()).box;
        const Frame frame = m_frames.begin(path, box);
        const bool isOfNumbers = std::isfinite(frame.error()); // else no double holds all of it
        if (!isOfNumbers) {
            drop(0.0);
        } else if (!box.isEmpty()) {
            visit({.state = m_states.begin()}, frame, 0.0);
            while (!m_nodes.empty() && m_cost.nodeVisits < sweep.nodeBudget && !sweep.stop.stop_requested()) {
                goOn();
            }
        }
        clear(touch);
        touch.promise = isOfNumbers && m_nodes.empty() ? Promise::Exact : Promise::UpperBound;
        giveUp();
        report(sweep, path, touch);
    }

private:
    using Frame = typename Frames::Frame;

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    /// Most searches end before fine hulls pay.
    static constexpr std::uint64_t visitsBeforeFine = 64;
    /// Deeper units would not be numbers.
    static constexpr double leastUnit = 1e-290;

    /// What the way to a child was found by. A better one is asked only of what seems to be touched first.
    enum class Tightness : std::uint8_t { OfGrownBox, OfBox, OfCoarseHull, Final };

    /// What is known of a state for every search.
    struct Known {
        std::span<const DescentStep> children;
        typename Frames::Children bounds;
        /// At first, in whole lanes.
        std::vector<Tightness> tightness;
    };

    /// A state that is being looked at. Its children are not touched before their ways; infinite where they were visited.
    struct Node {
        const Known *known;
        Frame frame;
        /// That of the ways.
        double error;
        std::size_t firstWay;
    };

    void begin(const Path &path)
    {
        if (m_states.forgetIfLarge()) {
            m_known.clear();
        }
        m_nodes.clear();
        m_path.clear();
        m_ways.clear();
        m_tightness.clear();
        m_cost = {};
        m_isFound = false;
        m_until = path.length;
        m_slack = path.slack;
        m_lower = infinity;
    }

    void drop(double way) { m_lower = std::min(m_lower, way); }

    /// The child of the node that was entered last that may be touched first; back where none is early enough.
    void goOn()
    {
        const Node &node = m_nodes.back();
        const std::size_t child = leastOf(std::span(m_ways).subspan(node.firstWay));
        double &way = m_ways[node.firstWay + child];
        if (way > m_until || way == infinity) {
            drop(way);
            leave();
            return;
        }
        if (tighten(node, child)) {
            return;
        }
        const DescentStep &step = node.known->children[child];
        const double from = std::exchange(way, infinity);
        if (step.isToMesh()) {
            measure(node.frame, from);
        } else {
            goDown(node, step, from);
        }
    }

    /// What seems to be first may be later. False where that is known as well as can be.
    bool tighten(const Node &node, std::size_t child)
    {
        const DescentStep &step = node.known->children[child];
        const BoundedStates::Bounds &bounds = step.isToMesh() ? m_states.meshBounds() : m_states.bounds(step.state);
        double &way = m_ways[node.firstWay + child];
        Tightness &tightness = m_tightness[node.firstWay + child];
        switch (tightness) {
        case Tightness::OfGrownBox:
            if constexpr (!Frames::waysAreToBoxes) {
                way = std::max(way, m_frames.wayToBox(node.frame, step, bounds.box, node.error, way, m_until));
            }
            tightness = bounds.hulls ? Tightness::OfBox : Tightness::Final;
            return true;
        case Tightness::OfBox:
            raiseToHulls(node, child / laneCount);
            return true;
        case Tightness::OfCoarseHull:
            if (m_cost.nodeVisits < visitsBeforeFine) {
                return false;
            }
            way = std::max(way, m_frames.wayToFine(node.frame, step, *bounds.hulls, node.error, way, m_until));
            tightness = Tightness::Final;
            return true;
        case Tightness::Final:
            break;
        }
        return false;
    }

    /// Of those beside it that have come so far too.
    void raiseToHulls(const Node &node, std::size_t block)
    {
        const std::size_t first = node.firstWay + block * laneCount;
        m_frames.raiseToHulls(node.frame, node.known->bounds, block, node.error, &m_ways[first]);
        for (std::size_t i = first; i < first + laneCount; ++i) {
            m_tightness[i] = m_tightness[i] == Tightness::OfBox ? Tightness::OfCoarseHull : m_tightness[i];
        }
    }

    void goDown(const Node &node, const DescentStep &step, double way)
    {
        const BoundedStates::Bounds &bounds = m_states.bounds(step.state);
        const Frame frame = m_frames.child(node.frame, step, node.error);
        if (m_frames.sizeOf(frame, bounds) <= frame.error() || frame.unit() < leastUnit) {
            settle(step, frame, bounds.box);
        } else {
            m_path.push_back(step);
            visit(step, frame, way);
        }
    }

    void visit(const DescentStep &step, const Frame &frame, double way)
    {
        if (m_states.isMesh(step.state)) {
            measure(frame, way);
            stepBack();
        } else {
            enter(step.state, frame);
        }
    }

    /// All points of the branch are alike.
    void settle(const DescentStep &step, const Frame &frame, const Box &box)
    {
        ++m_cost.nodeVisits;
        m_frames.measure(frame, box, m_until, m_latest);
        m_path.push_back(step);
        take(frame);
        stepBack();
    }

    void measure(const Frame &frame, double from)
    {
        ++m_cost.nodeVisits;
        m_frames.measure(frame, from, m_until, m_slack, m_latest);
        m_cost.faceTests += m_latest.faceTests;
        take(frame);
    }

    /// What is touched no more than that earlier than what was found is passed over.
    [[nodiscard]] double slackOf(const Frame &frame) const { return m_slack + 2.0 * frame.error(); }

    void take(const Frame &frame)
    {
        drop(m_latest.lower);
        if (m_latest.way < infinity) {
            m_until = earlierThan(m_latest.way, slackOf(frame));
            m_isFound = true;
            m_first = m_latest;
            m_firstFrame = frame;
            m_firstPath.assign(m_path.begin(), m_path.end());
        }
    }

    void enter(StateId state, const Frame &frame)
    {
        ++m_cost.nodeVisits;
        const Known &known = knownOf(state);
        if (known.children.empty()) {
            stepBack();
            return;
        }
        const double error =
            m_frames.errorOf(frame, known.bounds) + m_products.error() * m_frames.magnitudeOf(frame, known.bounds);
        const std::size_t first = m_ways.size();
        m_nodes.push_back({&known, frame, error, first});
        m_ways.resize(first + known.tightness.size());
        m_tightness.insert(m_tightness.end(), known.tightness.begin(), known.tightness.end());
        m_frames.waysTo(frame, known.bounds, error, m_ways.data() + first);
        std::fill(m_ways.begin() + static_cast<std::ptrdiff_t>(first + known.children.size()), m_ways.end(), infinity);
        m_products.leaveOut(m_path, known.children, m_ways.data() + first);
    }

    const Known &knownOf(StateId state)
    {
        if (m_known.size() <= state) {
            m_known.resize(state + 1);
        }
        Known &known = m_known[state];
        if (known.children.empty()) {
            known.children = m_states.children(state);
            known.bounds = m_frames.boundsOf(known.children, m_states);
            known.tightness.resize(blocksFor(known.children.size()) * laneCount, Tightness::Final);
            for (std::size_t i = 0; i < known.children.size(); ++i) {
                const DescentStep &step = known.children[i];
                const bool hasHulls = !step.isToMesh() && m_states.bounds(step.state).hulls != nullptr;
                known.tightness[i] = !Frames::waysAreToBoxes ? Tightness::OfGrownBox
                    : hasHulls                               ? Tightness::OfBox
                                                             : Tightness::Final;
            }
        }
        return known;
    }

    void leave()
    {
        m_ways.resize(m_nodes.back().firstWay);
        m_tightness.resize(m_nodes.back().firstWay);
        m_nodes.pop_back();
        stepBack();
    }

    void stepBack()
    {
        if (!m_path.empty()) { // no step leads to the root
            m_path.pop_back();
        }
    }

    /// What is left when the budget is spent may be touched as early as its ways.
    void giveUp()
    {
        while (!m_nodes.empty()) {
            drop(std::ranges::min(std::span(m_ways).subspan(m_nodes.back().firstWay)));
            leave();
        }
    }

    void report(const Sweep &sweep, const Path &path, Touch &touch)
    {
        touch.cost = m_cost;
        if (m_isFound) {
            touch.face = m_first.face;
            touch.time = path.timeOf(m_frames.finish(m_firstFrame, m_first, m_firstPath, slackOf(m_firstFrame), touch));
            m_states.fillAddress(m_firstPath, touch.address);
        }
        prove(touch, path, m_lower, sweep);
    }

    BoundedStates m_states;
    const EqualProducts &m_products;
    Frames m_frames;
    /// By state.
    std::deque<Known> m_known;

    /// From the root to where the search is, a step between two nodes; what is of each node after that of the one above.
    std::vector<Node> m_nodes;
    std::vector<DescentStep> m_path;
    std::vector<double> m_ways;
    std::vector<Tightness> m_tightness;

    /// What is touched later does not count: the path's length, or a little less than what was found.
    double m_until = infinity;
    double m_slack = 0.0;
    double m_lower = infinity;
    SearchCost m_cost;

    SweptFace m_latest;
    bool m_isFound = false;
    SweptFace m_first;
    Frame m_firstFrame;
    std::vector<DescentStep> m_firstPath;
};

}
