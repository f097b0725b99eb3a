// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ball.h"
#include "core/geometry/box.h"

namespace romanesco {

/// So many balls like one, above a box, which is where gravity comes from: in layers, none touching another. Where in a layer is
/// by chance, the same for the same seed.
[[nodiscard]] std::vector<Ball> rainOver(const Box &box, const glm::dvec3 &gravity, const Ball &like, std::size_t count,
                                         std::uint64_t seed);

}
