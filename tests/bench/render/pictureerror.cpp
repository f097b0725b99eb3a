// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "pictureerror.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace romanesco::bench {

namespace {

constexpr int plain = 16;

}

PictureError errorOf(const Picture &picture, const Picture &reference)
{
    double sum = 0.0;
    double squares = 0.0;
    std::size_t off = 0;
    for (std::size_t at = 0; at < reference.pixels.size(); at += 3) {
        int most = 0;
        for (std::size_t i = at; i < at + 3; ++i) {
            const int difference = std::abs(int{picture.pixels.at(i)} - int{reference.pixels[i]});
            most = std::max(most, difference);
            sum += difference;
            squares += double(difference) * difference;
        }
        off += most > plain ? 1 : 0;
    }
    const auto count = static_cast<double>(reference.pixels.size());
    return {sum / count, std::sqrt(squares / count), 3.0 * static_cast<double>(off) / count};
}

}
