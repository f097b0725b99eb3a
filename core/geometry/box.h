// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/vec3.hpp>

namespace romanesco {

/// An axis-aligned box, from least to greatest corner.
struct Box {
    glm::dvec3 least{0.0};
    glm::dvec3 greatest{0.0};

    [[nodiscard]] glm::dvec3 centre() const { return 0.5 * least + 0.5 * greatest; }
    [[nodiscard]] glm::dvec3 size() const { return greatest - least; }
};

}
