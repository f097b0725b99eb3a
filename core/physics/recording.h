// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene/scenecollider.h"
#include "core/scene/sceneplace.h"
#include "world.h"

namespace romanesco {

/// All that a run of a world depends on beside its scene, and what it came to: enough to run it again.
struct Recording {
    /// Its time step, gravity, shrinking and manner; the number of threads changes nothing.
    World::Options world = {};
    SceneCollider::Options collider = {};
    /// World::stateHash() before the first step, which tells whether the scene is the same.
    std::uint64_t startHash = 0;

    /// A ball that comes in, in the world's coordinates or those of a place.
    struct Drop {
        Ball ball;
        std::optional<ScenePlace> place = {};
    };
    /// Of the balls that there are then.
    struct Removal {
        std::size_t ball = 0;
    };
    /// Before the step of that number, counted from 0: a ball comes in, the surface is searched another way, a ball goes, or
    /// there are other rules (see World::setRules()).
    struct Input {
        std::uint64_t step = 0;
        std::variant<Drop, SceneCollider::Options, Removal, World::Options> what;
    };
    /// In order.
    std::vector<Input> inputs = {};

    std::uint64_t steps = 0;
    std::uint64_t endHash = 0;
};

/// Lines of words; numbers have all their digits.
[[nodiscard]] std::string textOf(const Recording &recording);

/// Reads what textOf() writes. The error is a sentence that begins with the number of a line.
[[nodiscard]] std::expected<Recording, std::string> recordingFromText(std::string_view text);

}
