// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "renderworkloads.h"
#include "tests/bench/tables.h"

namespace romanesco::bench {

/// Writes docs/rendering.md to the standard output: what was measured, as tables.
class RenderTables final : public Tables
{
public:
    /// What draws; the seconds from nothing to the first picture of appendix B; what was drawn, in that order, and at which
    /// depths besides.
    RenderTables(std::string machine, double coldSeconds, std::vector<Subject> subjects, std::vector<Subject> depths)
        : m_machine(std::move(machine))
        , m_coldSeconds(coldSeconds)
        , m_subjects(std::move(subjects))
        , m_depths(std::move(depths))
    {
    }

    void Finalize() override;

private:
    /// How many times less processor time a frame takes than in the dissertation's way.
    [[nodiscard]] double gain(const Subject &subject, Place place, int tolerance) const;
    [[nodiscard]] std::vector<Place> placesOf(const Subject &subject) const;
    [[nodiscard]] std::string error(const Subject &subject, Place place, const std::string &kind) const;
    /// The greatest tolerance whose picture is no farther off than the flattened one; -1 for none.
    [[nodiscard]] int asGoodAsFlattened(const Subject &subject, Place place) const;
    [[nodiscard]] double growth(const std::string &name, std::uint64_t from, std::uint64_t to) const;

    void writeMengerGoals(std::ostream &stream, const Subject &subject) const;
    void writeGoals(std::ostream &stream) const;
    void writeStarts(std::ostream &stream) const;
    void writeFrames(std::ostream &stream) const;
    void writeTolerances(std::ostream &stream) const;
    void writeErrors(std::ostream &stream) const;
    void writeDepths(std::ostream &stream) const;

    std::string m_machine;
    double m_coldSeconds;
    std::vector<Subject> m_subjects;
    std::vector<Subject> m_depths;
};

}
