// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>

#include "core/fractal/fractalgraph.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// The faces of all copies, those of equal words once. The error is a sentence: they are more than `most`, or too many to
/// be counted. Cost: see instancesDistinct().
[[nodiscard]] std::expected<std::uint64_t, std::string> faceCount(const FractalGraph &graph, const Mesh &mesh,
                                                                  std::uint64_t most);

/// All copies as one mesh, without looks, where a map places them. The graph is of that mesh. The error is a sentence: more
/// faces than `most`, which is 10^9 or less, or cancelled. Cost: some hundredths of a microsecond and up to 84 bytes a face.
[[nodiscard]] std::expected<Mesh, std::string> writtenOut(const FractalGraph &graph, const Mesh &mesh,
                                                          const AffineMap &worldFromModel, std::uint64_t most,
                                                          const std::stop_token &stop = {});

}
