// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <map>
#include <optional>

#include "anchor.h"

namespace romanesco {

/// Takes what is counted from places into the coordinates of one, however deep both are. What is small keeps its digits but
/// where the ways part far above both.
class Passages
{
public:
    /// It must outlive this.
    explicit Passages(const Surroundings &here)
        : m_here(here)
    {
    }

    /// A sphere that is counted from a place of the scene, or from the world where that is null. Nothing where the scene has no
    /// such place, or no double holds it. Cost: that of the way from place to place, once for each.
    [[nodiscard]] std::optional<Sphere> here(const Surroundings *from, const Sphere &sphere);

private:
    [[nodiscard]] std::optional<Anchor::Move> moveFrom(const Surroundings &from) const;

    const Surroundings &m_here;
    std::map<const Surroundings *, std::optional<Anchor::Move>> m_moves;
};

}
