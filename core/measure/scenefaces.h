// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/count.h"
#include "core/fractal/statetable.h"
#include "core/scene/scene.h"
#include "queryplaces.h"

namespace romanesco {

/// Of all items, in their distinct copies; nothing where they are too many sets to count (see instancesDistinct()).
[[nodiscard]] std::optional<Count> facesOf(const std::vector<SceneItem> &items);

/// The faces of all objects and fractals of a scene, none written out: an item, then down its levels, then a face of the base
/// mesh. Items and faces are equally likely, and so is at each level all that may come next, the end of the word included.
/// What is smaller than a billionth of the whole is a point.
class SceneFaces final : public FaceSource
{
public:
    /// The scene must outlive it, and the size is that of the whole.
    SceneFaces(const Scene &scene, double size);

    [[nodiscard]] bool isEmpty() const { return m_items.empty(); }
    /// Not of an empty one.
    Face draw(std::mt19937_64 &random) override;

private:
    struct Placed {
        const SceneItem *item;
        StateTable *states;
    };

    double m_leastSize;
    std::map<const Model *, std::unique_ptr<StateTable>> m_states;
    /// With faces.
    std::vector<Placed> m_items;
};

}
