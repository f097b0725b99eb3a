// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

#include <glm/vec3.hpp>

#include "tests/bench/tables.h"

namespace romanesco::bench {

/// A fractal of tests/data/collide as bench_physics lets balls fall on it.
struct Subject {
    std::string name;
    /// For people.
    std::string title;
    std::uint64_t depth;
    /// In degrees: so that much of it looks up, and nothing is level.
    glm::dvec3 angles;
};

inline const std::array<Subject, 3> subjects{{{"two-sets", "two sets of 7", 3, {90, 0, 0}},
                                              {"menger", "Menger", 4, {20, 0, 30}},
                                              {"rotated-tree", "rotated tree", 7, {0, 0, 0}}}};
/// In parts of the ground's size.
constexpr std::array radii{0.002, 0.01, 0.05};
/// Steps a second.
constexpr std::array<unsigned, 2> rates{240, 60};
inline const std::array<std::string, 2> engines{"ours", "bullet"};
constexpr std::array<std::size_t, 5> crowds{1'000, 2'000, 3'000, 5'000, 10'000};

[[nodiscard]] std::string dropRun(const Subject &subject, double radius, unsigned rate, const std::string &engine);
[[nodiscard]] std::string crowdRun(const std::string &name, std::size_t balls, bool areSolid);
[[nodiscard]] std::string shotRun(const std::string &engine);

/// Writes docs/physics.md to the standard output: what was measured, as tables.
class PhysicsTables final : public Tables
{
public:
    void Finalize() override;

private:
    void writeDrops(std::ostream &stream) const;
    void writeMeans(std::ostream &stream) const;
    void writeMaking(std::ostream &stream) const;
    void writeCrowds(std::ostream &stream) const;
    void writeShots(std::ostream &stream) const;
};

}
