// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QString>

#include <glm/vec3.hpp>

#include "core/scene/surroundings.h"

namespace romanesco {

/// A number of the world that is known as value ± error in units of 2^exponent, with as many digits as are true: "0.25",
/// "1.3e-2000".
[[nodiscard]] QString trueDigits(double value, double error, double exponent = 0.0);

/// Where something is in the world: "(1, 2, 3)", each coordinate with as many digits as are true. point and error are in the
/// coordinates of the place.
[[nodiscard]] QString worldPlace(const Surroundings &place, const glm::dvec3 &point, double error);

/// A direction, in four decimals: "(0, 1, 0)".
[[nodiscard]] QString directionWords(const glm::dvec3 &direction);

}
