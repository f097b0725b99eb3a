// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

namespace romanesco {

/// How many of a sample are so, and what that tells of all.
struct Share {
    std::size_t count = 0;
    std::size_t of = 0;

    /// From 0 to 1; the sample must hold something, here and below.
    [[nodiscard]] double value() const;

    struct Interval {
        double least = 0.0;
        double greatest = 1.0;
    };
    /// Where the share of all is, in 95 of 100 samples (Wilson 1927). That of 0 of 1,600 ends at 0.24 %, and none of
    /// 1,600 is wider than 4.9 %.
    [[nodiscard]] Interval interval() const;
};

}
