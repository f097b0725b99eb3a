// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "depthpyramid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace romanesco {

namespace {

/// Squares a side of a rectangle covers at the level that is looked at.
constexpr int mostSquares = 4;

}

void DepthPyramid::build(std::vector<float> depths, int width, int height)
{
    assert(depths.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) && width > 0
           && "as many depths as pixels");
    m_levels.clear();
    m_levels.push_back({width, height, std::move(depths)});
    while (m_levels.back().width > 1 || m_levels.back().height > 1) {
        m_levels.push_back(above(m_levels.back()));
    }
}

/// Half as wide and high, rounded up.
DepthPyramid::Level DepthPyramid::above(const Level &below)
{
    Level level{(below.width + 1) / 2, (below.height + 1) / 2, {}};
    level.farthest.assign(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height), 1.0f);
    for (int y = 0; y < below.height; ++y) {
        const float *row = below.farthest.data() + static_cast<std::ptrdiff_t>(y) * below.width;
        float *to = level.farthest.data() + static_cast<std::ptrdiff_t>(y / 2) * level.width;
        for (int x = 0; x < below.width; ++x) {
            to[x / 2] = std::min(to[x / 2], row[x]);
        }
    }
    return level;
}

std::vector<float> DepthPyramid::takeDepths()
{
    std::vector<float> depths = m_levels.empty() ? std::vector<float>() : std::move(m_levels.front().farthest);
    m_levels.clear();
    return depths;
}

bool DepthPyramid::isHidden(const Footprint &footprint) const
{
    if (m_levels.empty()) {
        return false;
    }
    const auto &[left, bottom, right, top, nearest] = footprint;
    double side = 1.0;
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
