// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

namespace romanesco {

/// Where something may be seen: a rectangle of pixels, both ends included, and the depth that nothing of it is nearer than.
struct Footprint {
    double left;
    double bottom;
    double right;
    double top;
    double nearest;
};

/// How far a picture can be seen into: of squares of pixels, by powers of two, the farthest depth that is drawn there. What
/// lies behind it all over cannot be seen (Greene, Kass and Miller 1993). Depths are reversed: 1 near, 0 far.
class DepthPyramid
{
public:
    /// Row by row from the bottom. Cost: once through the pixels.
    void build(std::vector<float> depths, int width, int height);
    /// What it was built of, to be used again; nothing is built then.
    [[nodiscard]] std::vector<float> takeDepths();
    void clear() { m_levels.clear(); }
    [[nodiscard]] bool isEmpty() const { return m_levels.empty(); }

    /// What reaches out of the picture is judged by what is inside. At most sixteen squares are looked at. Where nothing
    /// was built nothing is hidden.
    [[nodiscard]] bool isHidden(const Footprint &footprint) const;

    [[nodiscard]] std::size_t memoryUse() const;

private:
    struct Level {
        int width = 0;
        int height = 0;
        std::vector<float> farthest;
    };

    [[nodiscard]] static Level above(const Level &below);

    /// The first is of pixels, each next of squares of twice the side.
    std::vector<Level> m_levels;
};

}
