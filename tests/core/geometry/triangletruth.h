// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

/// The oracle of distances to triangles, in numbers of enough digits.
namespace romanesco::test::truth {

template<typename T>
using Vector = std::array<T, 3>;

template<typename T>
T dot(const Vector<T> &a, const Vector<T> &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template<typename T>
Vector<T> difference(const Vector<T> &a, const Vector<T> &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// By the normal equations of each vertex, edge and face: the least of the squares whose foot is inside.
template<typename T>
T distance(const std::array<Vector<T>, 3> &triangle, const Vector<T> &p)
{
    std::optional<T> least;
    const auto consider = [&](const T &square) {
        if (!least || square < *least) {
            least = square < 0 ? T(0) : square;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector<T> toPoint = difference(p, triangle[i]);
        const Vector<T> u = difference(triangle[(i + 1) % 3], triangle[i]);
        const Vector<T> v = difference(triangle[(i + 2) % 3], triangle[i]);
        const T uu = dot(u, u);
        const T vv = dot(v, v);
        const T uv = dot(u, v);
        const T up = dot(u, toPoint);
        const T vp = dot(v, toPoint);
        consider(dot(toPoint, toPoint));
        if (up >= 0 && up <= uu && uu > 0) {
            consider(T(dot(toPoint, toPoint) - up * up / uu));
        }
        const T determinant = uu * vv - uv * uv;
        const T s = vv * up - uv * vp;
        const T t = uu * vp - uv * up;
        // of a flat one the determinant is rounding alone
        if (determinant > 256 * std::numeric_limits<T>::epsilon() * uu * vv && s >= 0 && t >= 0
            && s + t <= determinant) {
            consider(T(dot(toPoint, toPoint) - (s * up + t * vp) / determinant));
        }
    }
    return sqrt(*least);
}

/// The way to p from the point of a triangle that is nearest to it: of the feet on its vertices, edges and face. Of one
/// that is flat, but for what the digits tell of its plane, the edges are enough.
template<typename T>
Vector<T> wayFrom(const std::array<Vector<T>, 3> &triangle, const Vector<T> &p)
{
    std::optional<Vector<T>> nearest;
    const auto consider = [&](const Vector<T> &way) {
        if (!nearest || dot(way, way) < dot(*nearest, *nearest)) {
            nearest = way;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector<T> way = difference(p, triangle[i]);
        const Vector<T> u = difference(triangle[(i + 1) % 3], triangle[i]);
        const Vector<T> v = difference(triangle[(i + 2) % 3], triangle[i]);
        const auto after = [&](const T &s, const T &t) {
            return Vector<T>{way[0] - s * u[0] - t * v[0], way[1] - s * u[1] - t * v[1], way[2] - s * u[2] - t * v[2]};
        };
        consider(way);
        const T uu = dot(u, u);
        const T vv = dot(v, v);
        const T uv = dot(u, v);
        if (dot(u, way) >= 0 && dot(u, way) <= uu && uu > 0) {
            consider(after(dot(u, way) / uu, T(0)));
        }
        const T determinant = uu * vv - uv * uv;
        const T s = vv * dot(u, way) - uv * dot(v, way);
        const T t = uu * dot(v, way) - uv * dot(u, way);
        if (determinant > 1e-24 * uu * vv && s >= 0 && t >= 0 && s + t <= determinant) {
            consider(after(s / determinant, t / determinant));
        }
    }
    return *nearest;
}

}
