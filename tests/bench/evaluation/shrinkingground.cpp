// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "shrinkingground.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <glm/geometric.hpp>

#include "core/physics/scenephysics.h"

namespace romanesco::bench {

namespace {

Surface searched(const std::shared_ptr<const Scene> &scene, ColliderKind kind)
{
    auto made = surfaceOf(scene, {.kind = kind});
    if (!made) {
        std::fprintf(stderr, "%s\n", made.error().c_str());
        std::exit(1);
    }
    return std::move(*made);
}

}

ShrinkingGround shrinkingGround(const Scene &own)
{
    const Box box = extentOf(own.items);
    const double scale = ShrinkingGround::size / glm::length(box.size());
    auto placed = std::make_shared<Scene>(own);
    AffineMap &place = placed->items.front().worldFromModel;
    place = AffineMap{glm::dmat3(scale), -scale * box.centre()} * place;
    placed->extent = extentOf(placed->items);
    const std::shared_ptr<const Scene> scene = std::move(placed);
    return {scene, scene->extent, searched(scene, ColliderKind::Exact), searched(scene, ColliderKind::Greedy),
            searched(scene, ColliderKind::Octree)};
}

}
