// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "tests/core/geometry/triangletruth.h"

/// The oracle of rays: where a line meets the plane of a triangle, and whether that is inside, in numbers of enough digits.
namespace romanesco::test::truth {

template<typename T>
Vector<T> cross(const Vector<T> &a, const Vector<T> &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template<typename T>
struct Meeting {
    T t;
    /// How far inside the triangle, as seen along the ray: at most so far it is to its nearest side; outside below 0.
    T inside;
    /// Of the angle between the ray and the normal.
    T cosine;
    /// Its longest side by its least height, as seen along the ray or longer.
    T thinness;
};

/// Nothing where the ray runs along the plane, or there is none.
template<typename T>
std::optional<Meeting<T>> meeting(const std::array<Vector<T>, 3> &triangle, const Vector<T> &origin,
                                  const Vector<T> &direction)
{
    using std::abs;
    using std::max;
    using std::min;
    using std::sqrt;
    const Vector<T> normal = cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
    const T slope = dot(normal, direction);
    if (slope == 0) {
        return std::nullopt;
    }
    const T t = dot(normal, difference(triangle[0], origin)) / slope;
    Vector<T> point = origin;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] += t * direction[axis];
    }
    const T area = sqrt(dot(normal, normal));
    const T cosine = abs(slope) / area / sqrt(dot(direction, direction));
    std::optional<T> inside;
    T longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector<T> side = difference(triangle[(i + 1) % 3], triangle[i]);
        const T height = dot(normal, cross(side, difference(point, triangle[i]))) / area / sqrt(dot(side, side));
        longest = max(longest, T(dot(side, side)));
        inside = inside ? min(*inside, height) : height;
    }
    return Meeting<T>{t, T(*inside * cosine), cosine, T(longest / (area * cosine))};
}

}
