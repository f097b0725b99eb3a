// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "childhulls.h"

#include <algorithm>
#include <limits>

namespace romanesco {

static_assert(HullsOfFew::cornerCount == HullBounds::mostCoarseCorners);

std::vector<HullsOfFew> hullsOf(std::span<const DescentStep> children, BoundedStates &states)
{
    const auto hullsAt = [&](const DescentStep &step) {
        return step.isToMesh() ? nullptr : states.bounds(step.state).hulls;
    };
    if (std::ranges::none_of(children, hullsAt)) {
        return {};
    }
    std::vector<HullsOfFew> result(blocksFor(children.size()));
    for (std::size_t i = 0; i < children.size(); ++i) {
        HullsOfFew &block = result[i / laneCount];
        const std::size_t lane = i % laneCount;
        block.error[lane] = std::numeric_limits<double>::infinity();
        if (const HullBounds::Hulls *hulls = hullsAt(children[i])) {
            const auto &[set, map, next] = children[i];
            const AffineMap &parentFromChild = states.graph().set(set).maps[map];
            const auto &corners = hulls->coarse.corners;
            setLane(block.centre, lane, parentFromChild(hulls->centre));
            block.cornersUsed = std::max(block.cornersUsed, corners.size());
            for (std::size_t k = 0; k < block.corners.size(); ++k) {
                setLane(block.corners[k], lane, parentFromChild.linear * corners[k < corners.size() ? k : 0]);
            }
            block.error[lane] = states.graph().facts(set)[map].norm * hulls->coarse.error;
        }
    }
    return result;
}

}
