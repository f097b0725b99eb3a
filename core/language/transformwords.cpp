// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>

#include <glm/matrix.hpp>

#include "core/geometry/affinemap.h"
#include "hover.h"
#include "plainwords.h"

namespace romanesco {

namespace {

std::string kindWords(const glm::dmat3 &linear, const glm::dvec3 &scale, double determinant)
{
    // the determinant of what is only small may be 0 too
    if (scale.x == 0.0 || scale.y == 0.0 || scale.z == 0.0) {
        return "flat: it has no inverse";
    }
    return std::format("{}{}", isSimilarity(linear) ? "a similarity" : "not a similarity",
                       determinant < 0.0 ? ", mirrored" : "");
}

}

std::vector<std::string> transformWords(const TransformParts &parts)
{
    const auto [linear, translation] = mapFromParts(parts.position, parts.rotation, parts.scale);
    std::vector<std::string> lines{"position " + plainWords(parts.position),
                                   "rotation " + plainWords(parts.rotation) + " degrees",
                                   "scale " + plainWords(parts.scale)};
    for (int row = 0; row < 3; ++row) {
        const glm::dvec3 entries(linear[0][row], linear[1][row], linear[2][row]);
        lines.push_back(std::format("[{} | {}]", plainWords(entries), plainWords(translation[row])));
    }
    const double determinant = glm::determinant(linear);
    lines.push_back(
        std::format("operator norm {}, determinant {}", plainWords(operatorNorm(linear)), plainWords(determinant)));
    lines.push_back(kindWords(linear, parts.scale, determinant));
    return lines;
}

}
