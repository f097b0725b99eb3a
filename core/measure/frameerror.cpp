// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "frameerror.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace romanesco {

FrameError errorOf(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> reference)
{
    assert(!picture.empty() && picture.size() == reference.size() && picture.size() % 3 == 0);
    std::uint64_t squares = 0;
    std::size_t off = 0;
    for (std::size_t at = 0; at < picture.size(); at += 3) {
        int most = 0;
        for (std::size_t i = at; i < at + 3; ++i) {
            const int difference = std::abs(int{picture[i]} - int{reference[i]});
            most = std::max(most, difference);
            squares += static_cast<std::uint64_t>(difference * difference);
        }
        off += most > FrameError::plain ? 1 : 0;
    }
    const auto colours = static_cast<double>(picture.size());
    return {std::sqrt(static_cast<double>(squares) / colours), 3.0 * static_cast<double>(off) / colours};
}

}
