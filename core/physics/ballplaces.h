// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/anchor.h"
#include "core/scene/scenecollider.h"
#include "world.h"

namespace romanesco {

/// A ball that is counted from a place, or from the world where that is null, in the world: as exactly as its coordinates
/// can say.
[[nodiscard]] Ball inWorld(const Ball &ball, const Surroundings *place);

/// The places that the balls of a world are counted from, so that one of 1e-30 of the scene is stepped as accurately, in its
/// own radii, as one of the scene's size.
///
/// A ball is counted from another node where coordinates are too coarse for it, or where it may come so far within a step
/// that a place does not know what is there (see Surroundings). Places are searched exactly, or approximately where the
/// world is; other kinds of colliders know only the world.
class BallPlaces
{
public:
    explicit BallPlaces(const std::shared_ptr<const Scene> &scene);

    /// By its number in the world; 0 is the world itself.
    [[nodiscard]] const Anchor &anchor(std::uint32_t place) const { return m_anchors[place]; }
    /// Null in the world.
    [[nodiscard]] const std::shared_ptr<const Surroundings> &surroundings(std::uint32_t place) const
    {
        return m_surroundings[place];
    }

    /// The number of a node's place, which it has from now on. The error is a sentence: there is no such node, or what
    /// SceneCollider cannot do.
    [[nodiscard]] std::expected<std::uint32_t, std::string> enter(World &world, const ScenePlace &place,
                                                                  const std::stop_token &stop = {});

    /// Counts the balls from a number on, those that are awake, from where they should be; whether that is coarse is not asked
    /// of each at each step. Before a step. Cost: nanoseconds a ball that stays, some hundred microseconds for another.
    void follow(World &world, std::size_t first = 0);

    /// The world's surface is another, of the same scene or another; balls stay at their places, as far as there are any.
    void setScene(World &world, const std::shared_ptr<const Scene> &scene);

private:
    [[nodiscard]] bool isFarOut(const World &world, const BallState &ball) const;
    [[nodiscard]] bool isTooCoarse(const World &world, const BallState &ball) const;
    std::expected<std::uint32_t, std::string> placeOf(World &world, Anchor anchor, const std::stop_token &stop);
    std::expected<void, std::string> makeWhole(const World &world, const std::stop_token &stop);
    void setSurface(World &world, std::uint32_t place);

    /// Without what balls are.
    std::shared_ptr<const Scene> m_scene;
    /// Of all of the scene; made when the first place needs it.
    std::shared_ptr<const SceneCollider> m_whole;
    /// By place.
    std::vector<Anchor> m_anchors;
    std::vector<std::shared_ptr<const Surroundings>> m_surroundings;
};

}
