// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/hull.h"

#include <random>

#include <QTest>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/geometric.hpp>

#include "tests/core/geometry/triangletruth.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_quad;

truth::Vector<Wide> wide(const glm::dvec3 &v)
{
    return {Wide(v.x), Wide(v.y), Wide(v.z)};
}

double volume(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c, const glm::dvec3 &d)
{
    return glm::dot(b - a, glm::cross(c - a, d - a));
}

bool isInside(const std::array<glm::dvec3, 4> &corners, const glm::dvec3 &p)
{
    const auto &[a, b, c, d] = corners;
    const double whole = volume(a, b, c, d);
    return std::abs(whole) > 1e-12 && volume(p, b, c, d) / whole > 0 && volume(a, p, c, d) / whole > 0
        && volume(a, b, p, d) / whole > 0 && volume(a, b, c, p) / whole > 0;
}

/// Inside a tetrahedron of four of the points, or on a triangle of three of them.
double trueDistance(const std::vector<glm::dvec3> &points, const glm::dvec3 &p)
{
    Wide least = std::numeric_limits<double>::infinity();
    for (const glm::dvec3 &a : points) {
        for (const glm::dvec3 &b : points) {
            for (const glm::dvec3 &c : points) {
                least = std::min(least, truth::distance<Wide>({wide(a), wide(b), wide(c)}, wide(p)));
                for (const glm::dvec3 &d : points) {
                    if (isInside({a, b, c, d}, p)) {
                        return 0;
                    }
                }
            }
        }
    }
    return static_cast<double>(least);
}

class Random
{
public:
    double number(double least, double greatest) { return std::uniform_real_distribution(least, greatest)(m_random); }
    glm::dvec3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
    std::size_t index(std::size_t count) { return m_random() % count; }

private:
    std::mt19937_64 m_random{seed(81)};
};

}

class TestHull : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void distancesAreThoseOfAllTriangles_data();
    void distancesAreThoseOfAllTriangles();
    void pointsOfTheHullAreAtNoDistance();
    void thinnedHullsLeaveOutWhatIsNear();
    void aFewPointsAreAllKept();
};

void TestHull::distancesAreThoseOfAllTriangles_data()
{
    QTest::addColumn<QString>("shape");
    for (const char *shape : {"body", "flat", "line", "point", "twice"}) {
        QTest::newRow(shape) << QString::fromLatin1(shape);
    }
}

void TestHull::distancesAreThoseOfAllTriangles()
{
    QFETCH(const QString, shape);
    Random random;
    int inside = 0;
    for (int round = 0; round < 150; ++round) {
        std::vector<glm::dvec3> points;
        const glm::dvec3 u = random.point(1);
        const glm::dvec3 v = random.point(1);
        const std::size_t count = 1 + random.index(8);
        for (std::size_t i = 0; i < count; ++i) {
            points.push_back(shape == QLatin1String("flat")        ? random.number(-1, 1) * u + random.number(-1, 1) * v
                                 : shape == QLatin1String("line")  ? random.number(-1, 1) * u
                                 : shape == QLatin1String("point") ? u
                                                                   : random.point(1));
            if (shape == QLatin1String("twice")) {
                points.push_back(points.back());
            }
        }
        for (const double size : {0.5, 2.0, 1e5}) {
            const glm::dvec3 p = random.point(size);
            const double expected = trueDistance(points, p);
            inside += expected == 0 ? 1 : 0;
            const HullDistance found = distanceToHull(points, p);
            const double rounding = 1e-14 * (1 + size);
            QVERIFY(found.least <= expected + rounding);
            QVERIFY(found.greatest >= expected - rounding);
            QVERIFY2(found.greatest - found.least <= 1e-12 * (1 + size),
                     qPrintable(QStringLiteral("%1 %2 %3").arg(found.least).arg(found.greatest).arg(expected)));
        }
    }
    QVERIFY(shape != QLatin1String("body") || inside > 5);
}

void TestHull::pointsOfTheHullAreAtNoDistance()
{
    Random random;
    for (int round = 0; round < 300; ++round) {
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 20; ++i) {
            points.push_back(random.point(1));
        }
        const double along = random.number(0, 1);
        const glm::dvec3 between = along * points[0] + (1 - along) * points[1];
        QVERIFY(distanceToHull(points, points[5]).greatest < 1e-12);
        QVERIFY(distanceToHull(points, between).greatest < 1e-9);
        QVERIFY(distanceToHull(points, points[5]).least < 1e-15);
    }
}

void TestHull::thinnedHullsLeaveOutWhatIsNear()
{
    Random random;
    for (const std::size_t most : {std::size_t{1}, std::size_t{4}, std::size_t{16}, std::size_t{400}}) {
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 300; ++i) {
            points.push_back(glm::normalize(random.point(1)));
        }
        const Hull hull = thinned(points, most, 0.02);
        QVERIFY(hull.corners.size() <= most);
        double farthest = 0;
        for (const glm::dvec3 &point : points) {
            const double outside = distanceToHull(hull.corners, point).least;
            farthest = std::max(farthest, outside);
            QVERIFY(outside <= hull.error + 1e-12);
        }
        QVERIFY(hull.error <= farthest + 1e-9); // no more than it must be
        QVERIFY(most < 400 || (hull.error <= 0.02 && hull.corners.size() < 200));
    }
}

void TestHull::aFewPointsAreAllKept()
{
    Random random;
    for (const std::size_t count : {0u, 1u, 2u, 3u, 4u}) {
        std::vector<glm::dvec3> points;
        for (std::size_t i = 0; i < count; ++i) {
            points.push_back(random.point(1));
        }
        const Hull hull = thinned(points, 16, 0);
        QCOMPARE(hull.corners.size(), count);
        QCOMPARE(hull.error, 0.0);
    }
}
}

ROMANESCO_TEST(romanesco::test::TestHull)

#include "testhull.moc"
