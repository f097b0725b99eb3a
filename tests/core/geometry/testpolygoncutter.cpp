// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/polygoncutter.h"

#include <bit>
#include <functional>
#include <limits>

#include <QTest>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <rapidcheck.h>

#include "tests/core/geometry/polygons.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Triangles = std::vector<CornerTriangle>;

/// Why these are no triangulation of a simple polygon that turns left; nothing where they are one. least is the least area
/// of a triangle that is no mistake, and a rounding error is 1e-13 of the whole.
QString fault(const Polygon &polygon, std::span<const CornerTriangle> triangles, double least = -1e-13)
{
    const auto count = static_cast<std::uint32_t>(polygon.size());
    if (triangles.size() + 2 != polygon.size()) {
        return QStringLiteral("%1 triangles of %2 corners").arg(triangles.size()).arg(count);
    }
    const double whole = twiceArea(polygon);
    double sum = 0.0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const CornerTriangle &triangle : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (triangle[i] >= count) {
                return QStringLiteral("there is no corner %1").arg(triangle[i]);
            }
            ++edges[{triangle[i], triangle[(i + 1) % 3]}];
        }
        const std::array<glm::dvec2, 3> corners{polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]};
        const double area = twiceArea(corners);
        if (!(area >= least * whole)) {
            return QStringLiteral("triangle %1 %2 %3 has an area of %4")
                .arg(triangle[0])
                .arg(triangle[1])
                .arg(triangle[2])
                .arg(area / whole);
        }
        sum += std::abs(area);
    }
    for (const auto &[edge, times] : edges) {
        const bool isSide = edge.second == (edge.first + 1) % count;
        if (times != 1 || edges.contains({edge.second, edge.first}) == isSide) {
            return QStringLiteral("edge %1 %2 has something wrong on its sides").arg(edge.first).arg(edge.second);
        }
    }
    return std::abs(sum - whole) <= 1e-12 * whole ? QString()
                                                  : QStringLiteral("the areas differ by %1").arg(sum / whole - 1);
}

Triangles earsOf(Polygon polygon)
{
    double size = 0.0;
    for (const glm::dvec2 &corner : polygon) {
        size = std::max({size, std::abs(corner.x), std::abs(corner.y)});
    }
    for (glm::dvec2 &corner : polygon) {
        corner *= std::ldexp(1.0, -std::ilogb(size));
    }
    Triangles triangles;
    cutEars(polygon, triangles);
    return triangles;
}

/// On a slanted plane, far from the origin, small or large.
std::vector<glm::dvec3> inSpace(const Polygon &polygon, PolygonRandom &random)
{
    const auto any = [&] { return 2 * uniform(random) - 1; };
    const glm::dvec3 u = glm::normalize(glm::dvec3(any(), any(), any()));
    const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(any(), any(), any())));
    const glm::dvec3 origin(any(), any(), any());
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 1'200) - 600);
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2 &corner : polygon) {
        corners.push_back(scale * (origin + corner.x * u + corner.y * v));
    }
    return corners;
}

Polygon turned(Polygon polygon, PolygonRandom &random)
{
    std::ranges::rotate(polygon, polygon.begin() + static_cast<std::ptrdiff_t>(random() % polygon.size()));
    return polygon;
}

}

class TestPolygonCutter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void starsAreCovered();
    void toursAreCovered();
    void cornersInLineMakeNoEmptyTriangles();
    void slantedPolygonsAreCoveredAtAnyScale();
    void bridgesToHolesAreCovered();
    void convexPolygonsAreFans();
    void largePolygons_data();
    void largePolygons();
    void whatIsNotSimpleEndsToo();
    void nothingButNumbersIsNeeded_data();
    void nothingButNumbersIsNeeded();
};

void TestPolygonCutter::starsAreCovered()
{
    QVERIFY(rc::check([](std::uint64_t seed) {
        PolygonRandom random(seed);
        const Polygon polygon = starPolygon(3 + random() % 500, random);
        const QString wrong = fault(polygon, earsOf(polygon));
        RC_ASSERT(wrong.toStdString() == "");
    }));
}

void TestPolygonCutter::toursAreCovered()
{
    QVERIFY(rc::check([](std::uint64_t seed) {
        PolygonRandom random(seed);
        const Polygon polygon = tourPolygon(3 + random() % 60, random);
        const QString wrong = fault(polygon, earsOf(polygon));
        RC_ASSERT(wrong.toStdString() == "");
    }));
}

void TestPolygonCutter::cornersInLineMakeNoEmptyTriangles()
{
    QVERIFY(rc::check([](std::uint64_t seed) {
        PolygonRandom random(seed);
        const Polygon polygon = turned(treePolygon(1 + random() % 200, random), random);
        const QString wrong = fault(polygon, earsOf(polygon), std::numeric_limits<double>::min());
        RC_ASSERT(wrong.toStdString() == "");
    }));
}

/// The plane is found, and the way the polygon turns in it.
void TestPolygonCutter::slantedPolygonsAreCoveredAtAnyScale()
{
    QVERIFY(rc::check([](std::uint64_t seed) {
        PolygonRandom random(seed);
        const std::size_t kind = random() % 3;
        const Polygon polygon = kind == 0 ? starPolygon(3 + random() % 200, random)
            : kind == 1                   ? tourPolygon(3 + random() % 40, random)
                                          : turned(treePolygon(1 + random() % 50, random), random);
        PolygonCutter cutter;
        const QString wrong = fault(polygon, cutter.cut(inSpace(polygon, random)));
        RC_ASSERT(wrong.toStdString() == "");
    }));
}

void TestPolygonCutter::bridgesToHolesAreCovered()
{
    PolygonRandom random(1);
    for (const std::size_t holes : {1, 2, 3, 10, 500}) {
        for (int i = 0; i < 20; ++i) {
            const Polygon polygon = turned(holedPolygon(holes), random);
            QCOMPARE(fault(polygon, earsOf(polygon)), QString());
        }
    }
}

void TestPolygonCutter::convexPolygonsAreFans()
{
    PolygonRandom random(1);
    PolygonCutter cutter;
    for (const std::size_t count : {3, 4, 5, 17, 400}) {
        Polygon polygon;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
            polygon.emplace_back(3 * std::cos(angle), std::sin(angle));
        }
        const auto triangles = cutter.cut(inSpace(polygon, random));
        QCOMPARE(triangles.size(), count - 2);
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            QVERIFY(triangles[i] == (CornerTriangle{0, i + 1, i + 2}));
        }
    }
}

void TestPolygonCutter::largePolygons_data()
{
    QTest::addColumn<int>("shape");
    QTest::newRow("comb") << 0;
    QTest::newRow("spiral") << 1;
    QTest::newRow("star") << 2;
    QTest::newRow("steps") << 3;
    QTest::newRow("holes") << 4;
}

/// Of 20,000 corners; the test's time limit is the only clock.
void TestPolygonCutter::largePolygons()
{
    QFETCH(int, shape);
    PolygonRandom random(1);
    const Polygon polygon = shape == 0 ? combPolygon(5'000)
        : shape == 1                   ? spiralPolygon(20'000)
        : shape == 2                   ? starPolygon(20'000, random)
        : shape == 3                   ? treePolygon(10'000, random)
                                       : holedPolygon(3'000);
    QVERIFY(polygon.size() >= 15'000);
    QCOMPARE(fault(polygon, earsOf(polygon), shape == 3 ? std::numeric_limits<double>::min() : -1e-13), QString());
}

/// Any points in any order: as many triangles, of its corners, the same each time.
void TestPolygonCutter::whatIsNotSimpleEndsToo()
{
    PolygonCutter cutter;
    QVERIFY(rc::check([&](std::uint64_t seed) {
        PolygonRandom random(seed);
        const std::size_t grid = 1 + random() % 50;
        std::vector<glm::dvec3> corners(3 + random() % 300);
        for (glm::dvec3 &corner : corners) {
            corner = {static_cast<double>(random() % grid), static_cast<double>(random() % grid),
                      random() % 4 == 0 ? static_cast<double>(random() % grid) : 0.0};
        }
        const auto cut = cutter.cut(corners);
        const Triangles first(cut.begin(), cut.end());
        RC_ASSERT(first.size() + 2 == corners.size());
        std::set<std::uint32_t> used;
        for (const CornerTriangle &triangle : first) {
            used.insert(triangle.begin(), triangle.end());
        }
        RC_ASSERT(used.size() == corners.size());
        RC_ASSERT(*used.rbegin() + 1 == corners.size());
        RC_ASSERT(std::ranges::equal(first, PolygonCutter().cut(corners)));
    }));
    PolygonRandom random(1);
    std::vector<glm::dvec3> corners(20'000);
    for (glm::dvec3 &corner : corners) {
        corner = {uniform(random), uniform(random), 0.0};
    }
    QCOMPARE(cutter.cut(corners).size(), corners.size() - 2);
}

void TestPolygonCutter::nothingButNumbersIsNeeded_data()
{
    QTest::addColumn<double>("size");
    QTest::newRow("zero") << 0.0;
    QTest::newRow("the least there is") << std::numeric_limits<double>::denorm_min();
    QTest::newRow("small") << 1e-310;
    QTest::newRow("large") << 1e300;
    QTest::newRow("the most there is") << std::numeric_limits<double>::max();
}

void TestPolygonCutter::nothingButNumbersIsNeeded()
{
    QFETCH(double, size);
    PolygonCutter cutter;
    PolygonRandom random(1);
    for (int i = 0; i < 100; ++i) {
        std::vector<glm::dvec3> corners(3 + random() % 20);
        for (glm::dvec3 &corner : corners) {
            for (int axis = 0; axis < 3; ++axis) {
                corner[axis] = size * (static_cast<double>(random() % 3) - 1);
            }
        }
        QCOMPARE(cutter.cut(corners).size(), corners.size() - 2);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestPolygonCutter)

#include "testpolygoncutter.moc"
