// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "address.h"

#include <cassert>

#include "fractalgraph.h"

namespace romanesco {

AffineMap mapOf(const FractalGraph &graph, std::span<const Pick> address)
{
    AffineMap map;
    for (const Pick &pick : address) {
        assert(pick.position < graph.levels().levelCount() && "a pick is made from one of the levels");
        const TransformSet &set = graph.setAt(graph.levels().locate(pick.position).slot);
        assert(pick.map < set.maps.size() && "a pick is one of the maps of its level");
        map = map * set.maps[pick.map];
    }
    return map;
}

}
