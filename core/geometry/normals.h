// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

/// Whether the map turns things inside out, as a mirror does. A map that is flat within rounding (its columns, each of
/// length 1, span less than 1e-13) does not.
[[nodiscard]] bool isMirrored(const glm::dmat3 &matrix);

/// Takes normals along with a linear map: the inverse transpose up to a positive factor, which also flat maps have (as
/// the cofactors). What points outwards of a solid points outwards of its image, mirrored
/// or not. Zero where all is mapped to a line.
[[nodiscard]] glm::dmat3 normalMatrix(const glm::dmat3 &linear);

/// Of length 1 and along matrix·normal, or the normal as it is where that has no direction.
[[nodiscard]] glm::dvec3 transformedNormal(const glm::dmat3 &matrix, const glm::dvec3 &normal);

}
