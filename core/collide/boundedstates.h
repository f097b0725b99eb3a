// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "core/fractal/address.h"
#include "core/fractal/boxbounds.h"
#include "core/fractal/fractalgraph.h"
#include "core/fractal/hullbounds.h"
#include "core/fractal/statetable.h"
#include "descent.h"
#include "lanes.h"

namespace romanesco {

/// The states of a graph as a search meets them, with what bounds all that they lead to. Made as they are asked for, each
/// only once. It begins at any of them. One thread uses it; graph, boxes and hulls must outlive it.
class BoundedStates
{
public:
    struct Bounds {
        /// Of nothing where the state leads to no face.
        Box box;
        /// From corner to corner.
        double size = 0.0;
        /// Null where the box is as good.
        const HullBounds::Hulls *hulls = nullptr;
        /// The corners of the fine one.
        std::vector<LanesOfPoint> corners = {};
    };

    BoundedStates(const FractalGraph &graph, const BoxBounds &boxes, const HullBounds &hulls, Positions begin);

    [[nodiscard]] const FractalGraph &graph() const { return m_graph; }
    [[nodiscard]] StateId begin() const { return m_begin; }
    [[nodiscard]] const Bounds &bounds(StateId state);
    /// Of the base mesh, in its frame.
    [[nodiscard]] const Bounds &meshBounds() const { return m_mesh; }

    /// What follows a state, without what has no face. References stay valid until states are forgotten.
    [[nodiscard]] std::span<const DescentStep> children(StateId state);
    /// Whether a state is the base mesh and nothing else.
    [[nodiscard]] bool isMesh(StateId state);

    /// Back to where it begins where it holds more than some tens of megabytes, and than twice what it grew to by one search:
    /// every other StateId is void then. Whether so. Asked before each search.
    bool forgetIfLarge();

    /// The address of a way from where it begins.
    void fillAddress(std::span<const DescentStep> path, Address &address);

private:
    [[nodiscard]] std::vector<DescentStep> listChildren(StateId state);

    const FractalGraph &m_graph;
    const BoxBounds &m_boxes;
    const HullBounds &m_hulls;
    StateTable m_table;
    Positions m_beginsAt;
    StateId m_begin;
    Bounds m_mesh;

    struct Known {
        bool isExpanded = false;
        std::vector<DescentStep> children;
    };
    /// By state.
    std::deque<Bounds> m_bounds;
    std::deque<Known> m_known;
    /// Of what grows with them.
    std::size_t m_bytes = 0;
    std::size_t m_mostBytes = 64'000'000;
    bool m_hasForgotten = false;
    std::vector<Positions> m_reached;
};

}
