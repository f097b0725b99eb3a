// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "passages.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

std::optional<Sphere> Passages::here(const Surroundings *from, const Sphere &sphere)
{
    std::optional<Sphere> moved = sphere;
    if (from) {
        auto found = m_moves.find(from);
        if (found == m_moves.end()) {
            found = m_moves.emplace(from, moveFrom(*from)).first;
        }
        moved = found->second.transform(
            [&](const Anchor::Move &move) { return Sphere{move(sphere.centre), sphere.radius / move.scale}; });
    }
    if (!from || m_here.path.empty()) {
        moved = moved.transform([&](const Sphere &inWorld) {
            return Sphere{m_here.hereFromWorld(inWorld.centre), inWorld.radius * std::exp2(-m_here.unitExponent)};
        });
    }
    return moved;
}

/// To the place that all is taken to; to the world where that is at the root of its item or above.
std::optional<Anchor::Move> Passages::moveFrom(const Surroundings &from) const
{
    auto anchor = Anchor::at(m_here.scene, {from.pathItem, from.path});
    if (!anchor) {
        return std::nullopt;
    }
    const auto moves = m_here.path.empty() ? anchor->leave() : anchor->goTo({m_here.pathItem, m_here.path});
    Anchor::Move all;
    for (const Anchor::Move &move : moves) {
        all.offset += all.scale * move.offset;
        all.scale *= move.scale;
    }
    const bool isNumber =
        all.scale > 0.0 && std::isfinite(1.0 / all.scale) && std::isfinite(glm::dot(all.offset, all.offset));
    return isNumber ? std::optional(all) : std::nullopt;
}

}
