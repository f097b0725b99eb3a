// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "boundedstates.h"
#include "collider.h"
#include "descent.h"
#include "equalproducts.h"
#include "lanes.h"
#include "metcopies.h"
#include "nearest.h"

namespace romanesco {

/// Finds the nearest face of a graph's copies by going down into the nearest box first, past those that are no nearer than
/// what was found (Land and Doig 1960). Frames say how: LocalFrames or RelativeFrames.
///
/// A branch that is too small for p to tell its points apart, or for the excess to matter, is not gone down further: the
/// middle of its box is found then, without a face. Every distance that is dropped is kept in mind, as the bound below
/// which nothing is. Of copies that coincide one is gone down into: as EqualProducts has it, which costs nothing, and
/// after some visits as MetCopies has it, which misses few.
template<typename Frames>
class BranchAndBound final
{
public:
    /// All must outlive it. excess: how much farther than the least a distance may be, in parts of it.
    BranchAndBound(const FractalGraph &graph, const BoxBounds &boxes, const HullBounds &hulls,
                   const EqualProducts &products, Positions beginsAt, Frames frames, double excess)
        : m_states(graph, boxes, hulls, std::move(beginsAt))
        , m_products(products)
        , m_frames(std::move(frames))
        , m_excess(excess)
        , m_nearer((1.0 - 4.0 * epsilon) / (1.0 + excess))
        , m_visitsBeforeMet(products.isEmpty() ? visitsBeforeMetElsewhere : visitsBeforeMet)
        , m_met(products)
    {
    }

    void closest(const Query &query, Hit &hit)
    {
        assert(std::isfinite(query.p.x + query.p.y + query.p.z) && "no face is nearest to a point that is nowhere");
        begin(query);
        const StateId root = m_states.begin();
        if (const Box &all = m_states.bounds(root).box; !all.isEmpty()) {
            visit(root, m_states.isMesh(root), m_frames.begin(query, all));
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
    /// Most searches end before fine hulls pay, unless they go deep.
    static constexpr std::size_t levelsBeforeFine = 8;
    static constexpr std::uint64_t visitsBeforeFine = 32;
    /// Keeping what was met costs a little, and saves nothing before some comes again: where copies coincide, soon.
    static constexpr std::uint64_t visitsBeforeMet = 12;
    static constexpr std::uint64_t visitsBeforeMetElsewhere = 256;
    /// Deeper units would not be numbers.
    static constexpr double leastUnit = 1e-290;

    /// What the distance to a child was found by. A better one is asked only of what seems nearest.
    enum class Tightness : std::uint8_t { OfBox, OfCoarseHull, Final };

    /// What is known of a state for every search.
    struct Known {
        std::span<const DescentStep> children;
        typename Frames::Children bounds;
        /// Beside the children, of the states that they lead to.
        struct Below {
            const BoundedStates::Bounds *bounds;
            bool isMesh;
        };
        std::vector<Below> below;
        /// At first.
        std::vector<Tightness> tightness;
    };

    /// A state that is being looked at. Its children are at so great distances or more, in its frame's unit; infinite where
    /// they were visited.
    struct Node {
        const Known *known;
        Frame frame;
        /// How far off distances are, in the model's unit.
        double error;
        std::size_t firstDistance;
    };

    void begin(const Query &query)
    {
        if (m_states.forgetIfLarge()) {
            m_known.clear();
        }
        m_nodes.clear();
        m_path.clear();
        m_distances.clear();
        m_tightness.clear();
        m_met.begin();
        m_apart = 0.0;
        m_cost = {};
        m_found = Found::Nothing;
        m_best = query.radius;
        m_lower = infinity;
        m_deepest = 0;
        m_isMoving = query.motion.has_value();
    }

    /// Whether something at a distance, which may be off by so much, in the model's unit, can be nearer than what was found.
    /// What is as near but for rounding is not: there may be millions of it. Errors grow on the way down, so it is that of
    /// what was found that counts, which is at the end of one: else what is nearer by less would be gone down to where
    /// it no longer seems so, again and again. Only what was found is relaxed: nothing within the radius is missed.
    [[nodiscard]] bool isNearer(double distance, double error) const
    {
        if (m_found == Found::Nothing) {
            return distance - error <= m_best;
        }
        return distance + std::max(error, m_bestFrame.error) < m_best * m_nearer;
    }

    /// What a branch or a mesh has to be within, in the model's unit. What is off by rounding may be that of a query before,
    /// which has become the radius.
    [[nodiscard]] double limitFor(const Frame &frame) const
    {
        return m_found == Found::Nothing ? m_best + 2.0 * frame.error : m_best;
    }
    [[nodiscard]] bool isWithin(double distance, double limit) const
    {
        return m_found == Found::Nothing ? distance <= limit : distance < limit;
    }

    void drop(double distance, double error) { m_lower = std::min(m_lower, distance - error); }

    /// The nearest child of the node that was entered last; back where none is near enough.
    void goOn()
    {
        const Node &node = m_nodes.back();
        const std::size_t child = leastOf(std::span(m_distances).subspan(node.firstDistance));
        double &inFrame = m_distances[node.firstDistance + child];
        const double distance = inFrame * node.frame.unit;
        if (!isNearer(distance, node.error) || inFrame == infinity) {
            drop(distance, node.error);
            leave();
            return;
        }
        const DescentStep &step = node.known->children[child];
        Tightness &tightness = m_tightness[node.firstDistance + child];
        if (tightness == Tightness::OfBox) {
            raiseToHulls(node, child / laneCount);
            return;
        }
        if (tightness == Tightness::OfCoarseHull
            && (m_path.size() >= levelsBeforeFine || m_cost.nodeVisits >= visitsBeforeFine)) {
            const double finer =
                m_frames.fineDistanceTo(node.frame, step, *node.known->below[child].bounds, m_best / node.frame.unit);
            inFrame = std::max(inFrame, finer);
            tightness = Tightness::Final;
            return;
        }
        inFrame = infinity;
        if (step.isToMesh()) {
            measure(node.frame);
        } else {
            goDown(node, step, node.known->below[child], distance);
        }
    }

    /// What seems nearest may be farther, and not the nearest.
    void raiseToHulls(const Node &node, std::size_t block)
    {
        const std::size_t first = node.firstDistance + block * laneCount;
        m_frames.raiseToHulls(node.frame, node.known->bounds, block, &m_distances[first]);
        for (std::size_t i = first; i < first + laneCount; ++i) {
            m_tightness[i] = m_tightness[i] == Tightness::OfBox ? Tightness::OfCoarseHull : m_tightness[i];
        }
    }

    void goDown(const Node &node, const DescentStep &step, const typename Known::Below &below, double distance)
    {
        const BoundedStates::Bounds &bounds = *below.bounds;
        const Frame frame = m_frames.child(node.frame, step, node.error);
        if (m_isMoving && m_frames.isBehind(frame, bounds.box)) {
            return;
        }
        const double size = m_frames.sizeOf(frame, bounds) * frame.unit;
        if (size <= std::max(epsilon / 2.0 * distance, frame.error) || frame.unit < leastUnit) {
            settle(step, frame, bounds.box, distance, distance);
        } else if (size <= m_excess * distance && distance + size < m_best && !m_isMoving) {
            settle(step, frame, bounds.box, distance, distance + size);
        } else if (m_cost.nodeVisits < m_visitsBeforeMet || !wasMet(step, frame, bounds.box, size)) {
            m_path.push_back(step);
            visit(step.state, below.isMesh, frame);
        }
    }

    /// What was met is done with: nothing of it is nearer than what is kept in mind, and nothing here but by what the two
    /// are apart.
    bool wasMet(const DescentStep &step, const Frame &frame, const Box &box, double size)
    {
        const std::optional<double> apart = m_met.findOrKeep(step, frame, box, size);
        m_apart += apart.value_or(0.0);
        return apart.has_value();
    }

    void visit(StateId state, bool isMesh, const Frame &frame)
    {
        if (isMesh) {
            measure(frame);
            stepBack();
        } else {
            enter(state, frame);
        }
    }

    /// All points of the branch are alike, seen from p: no nearer than the least distance, at most as far as the greatest.
    void settle(const DescentStep &step, const Frame &frame, const Box &box, double least, double greatest)
    {
        ++m_cost.nodeVisits;
        drop(least, frame.error);
        if (isWithin(greatest, limitFor(frame))) {
            m_best = greatest;
            m_found = Found::Branch;
            m_bestFrame = frame;
            m_bestBox = box;
            m_bestPath.assign(m_path.begin(), m_path.end());
            m_bestPath.push_back(step);
        }
    }

    void enter(StateId state, const Frame &frame)
    {
        ++m_cost.nodeVisits;
        m_deepest = std::max(m_deepest, m_path.size());
        const Known &known = knownOf(state);
        if (known.children.empty()) {
            stepBack();
            return;
        }
        const std::size_t first = m_distances.size();
        const double error =
            m_frames.errorOf(frame, known.bounds) + m_products.error() * m_frames.magnitudeOf(frame, known.bounds);
        m_nodes.push_back({&known, frame, error, first});
        m_distances.resize(first + known.tightness.size());
        m_frames.distancesTo(frame, known.bounds, m_distances.data() + first);
        std::fill(m_distances.begin() + static_cast<std::ptrdiff_t>(first + known.children.size()), m_distances.end(),
                  infinity);
        m_tightness.insert(m_tightness.end(), known.tightness.begin(), known.tightness.end());
        m_products.leaveOut(m_path, known.children, m_distances.data() + first);
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
                const bool isMesh = step.isToMesh() || m_states.isMesh(step.state);
                const auto &bounds = step.isToMesh() ? m_states.meshBounds() : m_states.bounds(step.state);
                known.below.push_back({&bounds, isMesh});
                known.tightness[i] = bounds.hulls ? Tightness::OfBox : Tightness::Final;
            }
        }
        return known;
    }

    void leave()
    {
        m_distances.resize(m_nodes.back().firstDistance);
        m_tightness.resize(m_nodes.back().firstDistance);
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
        const double limit = limitFor(frame);
        m_frames.measure(frame, limit / frame.unit, found);
        m_cost.faceTests += found.faceTests;
        drop(found.lower * frame.unit, frame.error);
        const double distance = found.distance * frame.unit;
        if (found.face != Mesh::none && isWithin(distance, limit)) {
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
        while (!m_nodes.empty()) {
            const Node &node = m_nodes.back();
            const auto distances = std::span(m_distances).subspan(node.firstDistance);
            drop(std::ranges::min(distances) * node.frame.unit, node.error);
            leave();
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
            m_states.fillAddress(m_bestPath, hit.address);
        }
        // each level's scale is rounded too
        const double rounded = 1.0 - 64.0 * epsilon * static_cast<double>(m_deepest + 1);
        assert((m_found != Found::Face || m_lower * rounded <= hit.distance + 2.0 * m_bestFrame.error)
               && "nothing is nearer than what is proved");
        if (hit.isFound()) {
            hit.distance = std::min(hit.distance, query.radius); // farther by rounding alone
        }
        hit.lower = std::clamp(m_lower * rounded - m_apart, 0.0, std::min(hit.distance, query.radius));
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

    BoundedStates m_states;
    const EqualProducts &m_products;
    Frames m_frames;
    const double m_excess;
    /// What is nearer by less than rounding, or than the excess, is not.
    const double m_nearer;
    /// By state.
    std::deque<Known> m_known;

    /// From the root to where the search is, a step between two nodes; what is of each node after that of the one above.
    std::vector<Node> m_nodes;
    std::vector<DescentStep> m_path;
    std::vector<double> m_distances;
    std::vector<Tightness> m_tightness;
    const std::uint64_t m_visitsBeforeMet;
    MetCopies<Frames> m_met;
    std::size_t m_deepest = 0;
    bool m_isMoving = false;
    bool m_isCutShort = false;

    enum class Found { Nothing, Face, Branch };
    Found m_found = Found::Nothing;
    /// The distance of what was found; the radius before.
    double m_best = infinity;
    Frame m_bestFrame;
    LeafHit m_bestLeaf;
    Box m_bestBox;
    std::vector<DescentStep> m_bestPath;

    double m_lower = infinity;
    /// How much nearer than that what was met before may be.
    double m_apart = 0.0;
    SearchCost m_cost;
};

}
