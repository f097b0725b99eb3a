// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "closestpoint.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

constexpr double unitRoundoff = std::numeric_limits<double>::epsilon() / 2;
/// In unitRoundoff·M, with vertices of at most √3·M: what is accepted, and what a plane's bound may be too high by. That
/// is √3 for the offsets from p, 3·√3 for the products, 4·√3 for the length and the division.
constexpr double largestGap = 32.0;
constexpr double certificateError = 16.0;

template<typename T>
using Vector = std::array<T, 3>;

template<typename T>
T dot(const Vector<T> &a, const Vector<T> &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template<typename T>
Vector<T> cross(const Vector<T> &a, const Vector<T> &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template<typename T>
Vector<T> combination(const T &s, const Vector<T> &a, const T &t, const Vector<T> &b)
{
    return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

template<typename T>
T length(const Vector<T> &a)
{
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// Squares below are not as precise as others: they underflow.
constexpr double shortest = 1e-280;

/// The vertices relative to p, which is the origin, in units in which the largest coordinate is about 1.
template<typename T>
struct Solver {
    using V = Vector<T>;
    std::array<V, 3> vertices;

    /// The point of the triangle nearest to the origin, up to rounding.
    V closest() const
    {
        V best = onEdge(0);
        const auto consider = [&best](const V &candidate) {
            if (dot(candidate, candidate) < dot(best, best)) {
                best = candidate;
            }
        };
        consider(onEdge(1));
        consider(onEdge(2));
        considerInterior(consider);
        return best;
    }

    V onEdge(std::size_t i) const
    {
        const V &a = vertices[i];
        const V &b = vertices[(i + 1) % 3];
        const V along = combination(T(1), b, T(-1), a);
        const T square = dot(along, along);
        const T way = -dot(a, along);
        if (!(square > 0) || way <= 0) {
            return a;
        }
        if (way >= square) {
            return b;
        }
        const T t = way / square;
        return combination(T(1) - t, a, t, b);
    }

    /// The foot on the plane where it is inside: as a convex combination of the vertices, so that it is a point of the
    /// triangle however badly the plane is known.
    template<typename Consider>
    void considerInterior(Consider &&consider) const
    {
        const auto &[a, b, c] = vertices;
        const V n = normal();
        const V weights{dot(n, cross(b, c)), dot(n, cross(c, a)), dot(n, cross(a, b))};
        const T sum = weights[0] + weights[1] + weights[2];
        if (weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0 && sum > 0) {
            const V foot = combination(T(weights[1] / sum), b, T(weights[2] / sum), c);
            consider(combination(T(weights[0] / sum), a, T(1), foot));
        }
    }

    /// Of the plane, from the two edges that are shortest together, which lose least; of no fixed length.
    V normal() const
    {
        std::size_t best = 0;
        T least = std::numeric_limits<T>::max();
        for (std::size_t i = 0; i < 3; ++i) {
            const V one = combination(T(1), vertices[(i + 1) % 3], T(-1), vertices[i]);
            const V other = combination(T(1), vertices[(i + 2) % 3], T(-1), vertices[i]);
            const T size = dot(one, one) + dot(other, other);
            if (size < least) {
                least = size;
                best = i;
            }
        }
        return cross(combination(T(1), vertices[(best + 1) % 3], T(-1), vertices[best]),
                     combination(T(1), vertices[(best + 2) % 3], T(-1), vertices[best]));
    }

    /// That no point of the triangle is nearer than this, as the plane across a direction proves.
    struct Bound {
        T distance{0};
        V direction{};
    };

    void improve(Bound &bound, const V &direction) const
    {
        const T square = dot(direction, direction);
        if (!(square > shortest)) { // a length of few digits would make the bound too high
            return;
        }
        const T least =
            std::min({dot(direction, vertices[0]), dot(direction, vertices[1]), dot(direction, vertices[2])});
        using std::sqrt;
        const T distance = least / sqrt(square);
        if (distance > bound.distance) {
            bound = {distance, direction};
        }
    }

    Bound bound(const V &answer) const
    {
        Bound best;
        const V n = normal();
        improve(best, answer);
        improve(best, n);
        improve(best, combination(T(-1), n, T(0), n));
        return best;
    }

    /// The same for an answer on an edge that is near: the way to it is rounded along the edge, and an edge is long.
    void improveAcrossEdges(Bound &bound, const V &answer) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const V along = combination(T(1), vertices[(i + 1) % 3], T(-1), vertices[i]);
            const T square = dot(along, along);
            if (square > 0) {
                improve(bound, combination(T(1), answer, T(-dot(answer, along) / square), along));
            }
        }
    }
};

template<typename T>
glm::dvec3 toDouble(const Vector<T> &v)
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// In units of 2^exponent.
struct Solution {
    glm::dvec3 offset{0.0};
    double distance = 0.0;
    double lower = 0.0;
    /// Across which a plane proves the lower one; of any length, 0 where none does.
    glm::dvec3 direction{0.0};
    int exponent = 0;
};

Solution solve(const Triangle &triangle, const glm::dvec3 &p)
{
    Solver<double> solver;
    double size = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            // each exact but for one rounding: relative to p, not to where both are
            const double offset = triangle[i][axis] - p[axis];
            solver.vertices[i][static_cast<std::size_t>(axis)] = offset;
            size = std::max(size, std::abs(offset));
        }
    }
    assert(std::isfinite(size) && "coordinates are finite and their differences too");
    if (size == 0.0) {
        return {};
    }
    int exponent = 0;
    (void)std::frexp(size, &exponent);
    for (Vector<double> &vertex : solver.vertices) {
        for (double &coordinate : vertex) {
            coordinate = std::ldexp(coordinate, -exponent);
        }
    }

    const double unit = unitRoundoff * std::ldexp(size, -exponent);
    const Vector<double> answer = solver.closest();
    const double distance = length(answer);
    auto bound = solver.bound(answer);
    const auto isProved = [&] { return distance - (bound.distance - certificateError * unit) <= largestGap * unit; };
    if (!isProved()) {
        solver.improveAcrossEdges(bound, answer);
    }
    if (!isProved()) {
        Solver<Quad> exact;
        for (std::size_t i = 0; i < 3; ++i) {
            std::ranges::copy(solver.vertices[i], exact.vertices[i].begin());
        }
        const Vector<Quad> better = exact.closest();
        const auto proved = exact.bound(better);
        return {toDouble(better), static_cast<double>(length(better)),
                static_cast<double>(proved.distance) - certificateError * unit, toDouble(proved.direction), exponent};
    }
    return {toDouble(answer), distance, bound.distance - certificateError * unit, toDouble(bound.direction), exponent};
}

}

ClosestPoint closestPoint(const Triangle &triangle, const glm::dvec3 &p)
{
    const Solution found = solve(triangle, p);
    return {p + std::ldexp(1.0, found.exponent) * found.offset, std::ldexp(found.distance, found.exponent),
            std::max(std::ldexp(found.lower, found.exponent), 0.0)};
}

glm::dvec3 separatingDirection(const Triangle &triangle, const glm::dvec3 &p)
{
    const glm::dvec3 direction = solve(triangle, p).direction;
    const double size = glm::length(direction);
    return size > 0.0 ? direction / size : direction;
}

}
