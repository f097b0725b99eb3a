// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "triangledistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

constexpr double unitRoundoff = std::numeric_limits<double>::epsilon() / 2;
/// Both in unitRoundoff·M. The gap is what the vertices may be on this side of the plane. Beside it, the error counts
/// rounding: √3 for the offsets from p, 3·√3 for the products, 4·√3 for the lengths.
constexpr double largestGap = 16.0;
constexpr double largestError = 32.0;

/// Fourth powers of these are still numbers; squares below the last are not as precise as others.
constexpr double leastSize = 1e-70;
constexpr double greatestSize = 1e70;
constexpr double leastSquare = 1e-280;

double largestOffset(const glm::dvec3 &a)
{
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

struct Nearest {
    glm::dvec3 point;
    /// In which a plane has the whole triangle beyond it.
    glm::dvec3 direction;
};

Nearest at(const glm::dvec3 &point)
{
    return {point, point};
}

/// On the edge from a to b, divided as the two numbers are, which are the square of its length together.
Nearest between(const glm::dvec3 &a, const glm::dvec3 &b, double fromA, double toB)
{
    const glm::dvec3 edge = b - a;
    const double perSquare = 1.0 / (fromA + toB);
    const glm::dvec3 point = a + fromA * perSquare * edge;
    // close to the edge, the way to the point is but rounding: as far as it goes along, that is taken off
    return {point, point - glm::dot(point, edge) * perSquare * edge};
}

/// The point of a triangle nearest to the origin; or NaN, or a point of the triangle that is not the nearest. The
/// weights of its vertices are from 0 to 1, so that it is within rounding of the triangle.
Nearest nearestToOrigin(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c)
{
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double d1 = -glm::dot(ab, a);
    const double d2 = -glm::dot(ac, a);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return at(a);
    }
    const double d3 = -glm::dot(ab, b);
    const double d4 = -glm::dot(ac, b);
    if (d3 >= 0.0 && d4 <= d3) {
        return at(b);
    }
    const double weightC = d1 * d4 - d3 * d2;
    if (weightC <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return between(a, b, d1, -d3);
    }
    const double d5 = -glm::dot(ab, c);
    const double d6 = -glm::dot(ac, c);
    if (d6 >= 0.0 && d5 <= d6) {
        return at(c);
    }
    const double weightB = d5 * d2 - d1 * d6;
    if (weightB <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return between(a, c, d2, -d6);
    }
    const double weightA = d3 * d6 - d5 * d4;
    if (weightA <= 0.0 && d4 >= d3 && d5 >= d6) {
        return between(b, c, d4 - d3, d5 - d6);
    }
    if (!(weightA >= 0.0 && weightB >= 0.0 && weightC >= 0.0)) {
        return at(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    }
    const double share = 1.0 / (weightA + weightB + weightC);
    // close to the face, the way to the point is but rounding
    const glm::dvec3 normal = glm::cross(ab, ac);
    return {a + weightB * share * ab + weightC * share * ac, glm::dot(normal, a) < 0.0 ? -normal : normal};
}

}

std::optional<TriangleSeparation> quickSeparation(const Triangle &triangle, const glm::dvec3 &p)
{
    const glm::dvec3 a = triangle[0] - p;
    const glm::dvec3 b = triangle[1] - p;
    const glm::dvec3 c = triangle[2] - p;
    const double size = std::max({largestOffset(a), largestOffset(b), largestOffset(c)});
    if (size < leastSize || size > greatestSize) {
        return std::nullopt;
    }
    const auto [nearest, direction] = nearestToOrigin(a, b, c);
    const double distance = glm::length(nearest);
    const double square = glm::dot(direction, direction);
    const double beyond = std::min({glm::dot(direction, a), glm::dot(direction, b), glm::dot(direction, c)});
    const double gap = largestGap * unitRoundoff * size;
    const TriangleDistance found{distance, largestError * unitRoundoff * size};
    if (distance <= gap) {
        return TriangleSeparation{found};
    }
    const double length = std::sqrt(square);
    // both false for NaN
    if (square >= leastSquare && (distance - gap) * length <= beyond) {
        return TriangleSeparation{found, direction / length};
    }
    return std::nullopt;
}

std::optional<TriangleDistance> quickDistance(const Triangle &triangle, const glm::dvec3 &p)
{
    const auto found = quickSeparation(triangle, p);
    return found ? std::optional(found->distance) : std::nullopt;
}

TriangleDistance distanceTo(const Triangle &triangle, const glm::dvec3 &p)
{
    if (const auto quick = quickDistance(triangle, p)) {
        return *quick;
    }
    double size = 0.0;
    for (const glm::dvec3 &vertex : triangle) {
        size = std::max(size, largestOffset(vertex - p));
    }
    return {closestPoint(triangle, p).distance, largestError * unitRoundoff * size};
}

}
