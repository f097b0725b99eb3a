// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

/// cos and sin of an angle in degrees. The angle is reduced modulo 360 exactly, whatever its size, and multiples of
/// 90 degrees give exactly 0, 1 or -1.
struct CosSin {
    double cosine;
    double sine;
};
[[nodiscard]] CosSin cosSinOfDegrees(double degrees);

/// R(x,y,z) = pitch(x)·yaw(y)·roll(z) in left-handed coordinates; the columns are right, up and forward:
///   pitch(a) = [1 0 0; 0 c s; 0 -s c]   yaw(a) = [c 0 -s; 0 1 0; s 0 c]   roll(a) = [c s 0; -s c 0; 0 0 1]
[[nodiscard]] glm::dmat3 rotationFromDegrees(const glm::dvec3 &degrees);
/// The same from angles in radians, of any size.
[[nodiscard]] glm::dmat3 rotationFromRadians(const glm::dvec3 &radians);

/// The angles of a rotation in radians: yaw within ±π/2, the others within ±π. Where yaw is straight up or down all of
/// the turn about that axis is pitch, and roll is 0.
[[nodiscard]] glm::dvec3 radiansOf(const glm::dmat3 &rotation);

}
