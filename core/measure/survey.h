// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>

#include "examination.h"
#include "share.h"

namespace romanesco {

/// What answers took, and how far off they were. The same in every run.
struct Survey {
    /// So many questions, from the first on; fewer than there are where they would take too many operations.
    std::size_t asked = 0;
    double faceTestsMean = 0.0;
    /// 99 of 100 answers took no more.
    double faceTestsP99 = 0.0;
    double nodeVisitsMean = 0.0;

    /// Off by more than these parts of the length, and by more than rounding.
    static constexpr std::array wrongBy{1e-6, 0.01, 0.1};
    std::array<Share, wrongBy.size()> wrong = {};
    /// The largest error, in parts of the length; 0 where it may be rounding.
    double worst = 0.0;
    /// Of the collisions, those that were not found.
    Share missed = {};
};

/// Asks a collider all that takes no more than so many operations, and one question at least. Once a stop is asked for, it
/// ends, and means nothing.
[[nodiscard]] Survey survey(const Collider &collider, const Examination &examination, std::uint64_t mostOperations,
                            const std::stop_token &stop = {});

}
