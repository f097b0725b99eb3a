// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <random>
#include <utility>

#include <QTest>

#include "core/geometry/closestpoint.h"
#include "tests/core/geometry/triangletruth.h"
#include "tests/core/geometry/wild.h"

/// Triangles of every shape, and the truth of their distances.
namespace romanesco::test {

inline Real trueDistance(const Triangle &triangle, const glm::dvec3 &p)
{
    return truth::distance<Real>({exact(triangle[0]), exact(triangle[1]), exact(triangle[2])}, exact(p));
}

inline double largestOffset(const Triangle &triangle, const glm::dvec3 &p)
{
    double size = 0.0;
    for (const glm::dvec3 &vertex : triangle) {
        for (int axis = 0; axis < 3; ++axis) {
            size = std::max(size, std::abs(vertex[axis] - p[axis]));
        }
    }
    return size;
}

class Draw
{
public:
    explicit Draw(std::uint32_t seed)
        : m_engine(seed)
    {
    }

    double number(double least, double greatest)
    {
        return std::uniform_real_distribution<double>(least, greatest)(m_engine);
    }
    glm::dvec3 vector(double size = 1.0) { return {number(-size, size), number(-size, size), number(-size, size)}; }
    double size(int least, int greatest) { return std::pow(10.0, number(least, greatest)); }

private:
    std::mt19937 m_engine;
};

enum class Shape { Plain, Far, Needle, Sliver, Segment, Point, NearPlane };

/// A row for each.
inline void addShapes()
{
    QTest::addColumn<Shape>("shape");
    QTest::newRow("plain") << Shape::Plain;
    QTest::newRow("far from the origin") << Shape::Far;
    QTest::newRow("one short edge") << Shape::Needle;
    QTest::newRow("three vertices nearly in a row") << Shape::Sliver;
    QTest::newRow("three vertices in a row") << Shape::Segment;
    QTest::newRow("one point") << Shape::Point;
    QTest::newRow("seen from near its plane") << Shape::NearPlane;
}

/// A triangle of that shape and a point.
inline std::pair<Triangle, glm::dvec3> trianglePoint(Shape shape, Draw &draw)
{
    Triangle triangle{draw.vector(), draw.vector(), draw.vector()};
    glm::dvec3 p = draw.vector(draw.size(-3, 2));
    const glm::dvec3 along = triangle[1] - triangle[0];
    switch (shape) {
    case Shape::Plain:
        break;
    case Shape::Far: {
        const glm::dvec3 away = draw.vector(draw.size(3, 12));
        triangle = {triangle[0] + away, triangle[1] + away, triangle[2] + away};
        p += away;
        break;
    }
    case Shape::Needle:
        triangle[2] = triangle[1] + draw.vector(draw.size(-17, -3));
        break;
    case Shape::Sliver:
        triangle[2] = triangle[0] + draw.number(-1.0, 2.0) * along + draw.vector(draw.size(-17, -3));
        break;
    case Shape::Segment:
        triangle[2] = triangle[0] + (draw.number(0.0, 1.0) < 0.5 ? 0.5 : 2.0) * along;
        break;
    case Shape::Point:
        triangle[1] = triangle[2] = triangle[0];
        break;
    case Shape::NearPlane:
        p = triangle[0] + draw.number(-1.0, 2.0) * along + draw.number(-1.0, 2.0) * (triangle[2] - triangle[0])
            + draw.vector(draw.size(-20, -6));
        break;
    }
    return {triangle, p};
}

}
