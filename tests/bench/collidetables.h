// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tables.h"

namespace romanesco::bench {

/// A fractal of tests/data/collide as bench_collide asks it.
struct Subject {
    std::string name;
    /// For people.
    std::string title;
    /// At which it is written out.
    std::uint64_t depth;
    /// Nodes that are to be visited on the mean, near the surface and 40 levels deep; 0 where nothing is asked for.
    double goal = 0.0;
};

constexpr std::array<std::uint64_t, 6> depths{5, 6, 8, 10, 20, 40};

/// Writes docs/colliders.md to the standard output: what was measured, as tables.
/// Benchmarks are named NAME-DEPTH/PLACE/KIND, and depth/NAME-DEPTH/PLACE/KIND where only the graph was asked.
class CollideTables final : public Tables
{
public:
    /// In that order.
    explicit CollideTables(std::vector<Subject> subjects)
        : m_subjects(std::move(subjects))
    {
    }

    void Finalize() override;

private:
    [[nodiscard]] std::string ofPlaces(const std::string &subject, const std::string &kind,
                                       const std::string &what) const;
    [[nodiscard]] std::string wrong(const std::string &run) const;
    [[nodiscard]] double mostUpTo(const Subject &subject, std::uint64_t first, std::uint64_t last,
                                  const std::string &what) const;

    void writeRatios(std::ostream &stream) const;
    void writeSubject(std::ostream &stream, const Subject &subject) const;
    void writeGoals(std::ostream &stream) const;
    void writeDepths(std::ostream &stream, const Subject &subject) const;

    std::vector<Subject> m_subjects;
};

}
