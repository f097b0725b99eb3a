// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

#include "core/scene/scene.h"

namespace romanesco {

/// The first fractal of a scene, by itself at its place, so deep that no way down it ends before so many picks: where its
/// levels end, the whole stands in place of its mesh, as often as that. It is left as it is where it has as many levels
/// already, and where copies need not shrink the more maps lead to them. The error is a sentence: there is none, it grows
/// too large. Costs milliseconds.
[[nodiscard]] std::expected<std::shared_ptr<const Scene>, std::string> deepFractal(const Scene &scene,
                                                                                   std::uint64_t picks);

}
