// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include "core/collide/colliderkind.h"
#include "core/geometry/box.h"
#include "core/physics/surface.h"
#include "core/scene/scene.h"

namespace romanesco::bench {

/// A scene that balls fall on, scaled to a diagonal of `size`, its middle at the origin; searched in three ways.
struct ShrinkingGround {
    static constexpr double size = 10.0;

    std::shared_ptr<const Scene> scene;
    Box box;
    Surface exact;
    Surface greedy;
    Surface octree;

    /// Exact, Greedy or Octree.
    [[nodiscard]] const Surface &surface(ColliderKind kind) const
    {
        return kind == ColliderKind::Exact ? exact : kind == ColliderKind::Greedy ? greedy : octree;
    }
};

/// Of a scene of one item. Ends the program where a collider cannot be built.
[[nodiscard]] ShrinkingGround shrinkingGround(const Scene &scene);

}
