// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "trs.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

constexpr double largestCosine = 1e-6;

/// The length, which neither overflows nor vanishes in between.
double lengthOf(const glm::dvec3 &v)
{
    return std::hypot(v.x, v.y, v.z);
}

/// Gives axes without a direction one at right angles to the others, so that all turn to the right.
void complete(std::array<glm::dvec3, 3> &axes, const glm::dvec3 &lengths)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const std::size_t last = (i + 2) % 3;
        if (lengths[static_cast<int>(i)] > 0.0) {
            continue;
        }
        const bool hasNext = lengths[static_cast<int>(next)] > 0.0 || next < i;
        const bool hasLast = lengths[static_cast<int>(last)] > 0.0 || last < i;
        if (hasNext && hasLast) {
            axes[i] = glm::cross(axes[next], axes[last]);
        } else if (hasNext || hasLast) {
            const glm::dvec3 &known = hasNext ? axes[next] : axes[last];
            // the axis that lies farthest from the one that is known
            glm::dvec3 other(0.0);
            other[std::abs(known.x) < 0.6 ? 0 : 1] = 1.0;
            axes[i] = glm::normalize(glm::cross(known, other));
        } else {
            axes[i] = glm::dvec3(i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0);
        }
    }
}

}

std::optional<Trs> trsOf(const AffineMap &map)
{
    Trs trs{map.translation, {1.0, 0.0, 0.0, 0.0}, {}};
    std::array<glm::dvec3, 3> axes;
    for (int i = 0; i < 3; ++i) {
        trs.scale[i] = lengthOf(map.linear[i]);
        axes[static_cast<std::size_t>(i)] = trs.scale[i] > 0.0 ? map.linear[i] / trs.scale[i] : glm::dvec3(0.0);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > largestCosine) {
            return std::nullopt;
        }
    }
    complete(axes, trs.scale);
    if (glm::dot(axes[0], glm::cross(axes[1], axes[2])) < 0.0) {
        axes[2] = -axes[2];
        trs.scale.z = -trs.scale.z;
    }
    trs.rotation = glm::normalize(glm::quat_cast(glm::dmat3(axes[0], axes[1], axes[2])));
    return trs;
}

}
