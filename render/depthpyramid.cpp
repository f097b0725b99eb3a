// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "depthpyramid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace romanesco {

namespace {

constexpr int firstSide = 1;
/// Squares a side of a rectangle covers at the level that is looked at.
constexpr int mostSquares = 4;

}

void DepthPyramid::build(std::span<const float> depths, int width, int height)
{
    assert(depths.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) && width > 0
           && "as many depths as pixels");
    m_levels.clear();
    const auto squares = [](int pixels, int side) { return (pixels + side - 1) / side; };
    const auto add = [&](std::span<const float> below, int belowWidth, int belowHeight, int side) {
        Level level{squares(belowWidth, side), squares(belowHeight, side), {}};
        level.farthest.assign(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height), 1.0f);
        for (int y = 0; y < belowHeight; ++y) {
            const float *row = below.data() + static_cast<std::ptrdiff_t>(y) * belowWidth;
            float *to = level.farthest.data() + static_cast<std::ptrdiff_t>(y / side) * level.width;
            for (int x = 0; x < belowWidth; ++x) {
                to[x / side] = std::min(to[x / side], row[x]);
            }
        }
        m_levels.push_back(std::move(level));
    };
    add(depths, width, height, firstSide);
    while (m_levels.back().width > 1 || m_levels.back().height > 1) {
        const Level below = m_levels.back();
        add(below.farthest, below.width, below.height, 2);
    }
}

bool DepthPyramid::isHidden(const Footprint &footprint) const
{
    if (m_levels.empty()) {
        return false;
    }
    const auto &[left, bottom, right, top, nearest] = footprint;
    double side = firstSide;
    std::size_t number = 0;
    while (number + 1 < m_levels.size() && std::max(right - left, top - bottom) > (mostSquares - 1) * side) {
        side *= 2.0;
        ++number;
    }
    const Level &level = m_levels[number];
    const auto square = [&](double pixel, int count) {
        return static_cast<int>(std::clamp(std::floor(pixel / side), 0.0, double(count - 1)));
    };
    const int firstX = square(left, level.width);
    const int lastX = square(right, level.width);
    const int lastY = square(top, level.height);
    for (int y = square(bottom, level.height); y <= lastY; ++y) {
        for (int x = firstX; x <= lastX; ++x) {
            if (nearest >= level.farthest[static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width)
                                          + static_cast<std::size_t>(x)]) {
                return false;
            }
        }
    }
    return true;
}

std::size_t DepthPyramid::memoryUse() const
{
    std::size_t bytes = 0;
    for (const Level &level : m_levels) {
        bytes += level.farthest.capacity() * sizeof(float);
    }
    return bytes;
}

}
