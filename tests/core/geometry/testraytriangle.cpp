// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/raytriangle.h"

#include <cmath>
#include <limits>
#include <random>

#include <QTest>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/rotation.h"
#include "tests/core/collide/raytruth.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_quad;
constexpr double u = 0.5 * std::numeric_limits<double>::epsilon();

double uniform(std::mt19937_64 &random, double least, double greatest)
{
    return std::uniform_real_distribution<double>(least, greatest)(random);
}

glm::dvec3 randomPoint(std::mt19937_64 &random, double size)
{
    return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

truth::Vector<Wide> wide(const glm::dvec3 &v)
{
    return {Wide(v.x), Wide(v.y), Wide(v.z)};
}

double greatestOf(const Triangle &triangle)
{
    double greatest = 0.0;
    for (const glm::dvec3 &corner : triangle) {
        greatest = std::max({greatest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    return greatest;
}

/// Any, a needle, a small one far away; sometimes behind.
Triangle randomTriangle(std::mt19937_64 &random)
{
    const glm::dvec3 middle = randomPoint(random, 1.0);
    const double size = std::pow(10.0, uniform(random, -6, 0.5));
    Triangle triangle{middle + randomPoint(random, size), middle + randomPoint(random, size), {}};
    triangle[2] =
        random() % 3 == 0 ? triangle[1] + randomPoint(random, 1e-3 * size) : middle + randomPoint(random, size);
    return triangle;
}

glm::dvec3 pointOf(std::mt19937_64 &random, const Triangle &triangle)
{
    const double s = uniform(random, 0, 1);
    const double t = uniform(random, 0, 1 - s);
    return (1 - s - t) * triangle[0] + s * triangle[1] + t * triangle[2];
}

/// Corners on a sphere round the origin, in rings of no special place, and faces that close it.
struct ClosedMesh {
    std::vector<glm::dvec3> corners;
    std::vector<std::array<std::size_t, 3>> faces;

    ClosedMesh(std::mt19937_64 &random, std::size_t rings, double size)
    {
        const glm::dmat3 turn = rotationFromDegrees(randomPoint(random, 180));
        corners = {turn * glm::dvec3(0, size, 0), turn * glm::dvec3(0, -size, 0)};
        const auto at = [&](std::size_t ring, std::size_t step) { return 2 + ring * rings + step % rings; };
        for (std::size_t ring = 0; ring < rings; ++ring) {
            for (std::size_t step = 0; step < rings; ++step) {
                const double up = 3.14159 * static_cast<double>(ring + 1) / static_cast<double>(rings + 1);
                const double round = 6.28318 * static_cast<double>(step) / static_cast<double>(rings);
                const double radius = size * uniform(random, 0.5, 1.5);
                corners.push_back(
                    turn
                    * (radius
                       * glm::dvec3(std::sin(up) * std::cos(round), std::cos(up), std::sin(up) * std::sin(round))));
                if (ring == 0) {
                    faces.push_back({0, at(0, step), at(0, step + 1)});
                    faces.push_back({1, at(rings - 1, step + 1), at(rings - 1, step)});
                } else {
                    faces.push_back({at(ring - 1, step), at(ring, step), at(ring, step + 1)});
                    faces.push_back({at(ring - 1, step), at(ring, step + 1), at(ring - 1, step + 1)});
                }
            }
        }
    }

    [[nodiscard]] Triangle triangle(std::size_t face) const
    {
        return {corners[faces[face][0]], corners[faces[face][1]], corners[faces[face][2]]};
    }
};

}

class TestRayTriangle : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsMetIsMetThere();
    void nothingSlipsThroughAClosedMesh();
    void cornersInEveryOrderGiveTheSameAnswer();
    void trianglesWithoutAFaceAreNotMet();
    void whatRunsAlongAFaceDoesNotMeetIt();
};

/// In numbers of 113 bits, also for the bounds that the header states.
void TestRayTriangle::whatIsMetIsMetThere()
{
    std::mt19937_64 random(seed(401));
    int metCount = 0;
    int grazedCount = 0;
    double worst = 0.0;
    for (int i = 0; i < 60'000; ++i) {
        const Triangle triangle = randomTriangle(random);
        const double share = uniform(random, 0, 1);
        const double past = uniform(random, -1, 1) * std::pow(10.0, uniform(random, -17, -13));
        const glm::dvec3 side = share * triangle[0] + (1 - share) * triangle[1];
        const auto aim = random() % 4;
        // anywhere, at a side, where rounding decides, or inside
        const glm::dvec3 direction = glm::normalize(aim == 0       ? randomPoint(random, 1.0)
                                                        : aim == 1 ? side + past * (triangle[2] - triangle[0])
                                                                   : pointOf(random, triangle));
        const auto met =
            truth::meeting<Wide>({wide(triangle[0]), wide(triangle[1]), wide(triangle[2])}, {0, 0, 0}, wide(direction));
        const std::optional<double> way = RayOnTriangles(direction).wayTo(triangle);
        const double across = 4 * u * greatestOf(triangle);
        const double inside = met ? static_cast<double>(met->inside) : 0.0;
        QVERIFY2(way || inside <= across, qPrintable(QStringLiteral("%1 missed").arg(i)));
        QVERIFY2(!way || inside >= -across || !met, qPrintable(QStringLiteral("%1 met").arg(i)));
        grazedCount += met && std::abs(inside) <= across ? 1 : 0;
        if (!way || inside <= across) {
            continue;
        }
        ++metCount;
        // least height as the ray sees it, and extent along it
        double height = std::numeric_limits<double>::infinity();
        double nearest = std::numeric_limits<double>::infinity();
        double farthest = -nearest;
        std::array<glm::dvec3, 3> seen;
        for (std::size_t k = 0; k < 3; ++k) {
            const double along = glm::dot(triangle[k], direction);
            seen[k] = triangle[k] - along * direction;
            nearest = std::min(nearest, along);
            farthest = std::max(farthest, along);
        }
        const double area = glm::length(glm::cross(seen[1] - seen[0], seen[2] - seen[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            height = std::min(height, area / glm::distance(seen[k], seen[(k + 1) % 3]));
        }
        if (height < 100 * across) {
            continue; // the height itself is rounding
        }
        const double bound = 16 * u * greatestOf(triangle) * (1 + (farthest - nearest) / height);
        // the direction's length is off by rounding too
        const double off = std::abs(static_cast<double>(met->t) - *way);
        worst = std::max(worst, off / bound);
        QVERIFY2(off <= bound, qPrintable(QStringLiteral("%1: %2 of the bound").arg(i).arg(off / bound)));
    }
    QVERIFY(metCount > 30'000 && grazedCount > 1'000);
    QVERIFY2(worst > 0.05, qPrintable(QString::number(worst))); // else the bound says nothing
}

/// From inside, at corners, at sides and anywhere: rays meet a face, or several.
void TestRayTriangle::nothingSlipsThroughAClosedMesh()
{
    std::mt19937_64 random(seed(402));
    for (int round = 0; round < 40; ++round) {
        const ClosedMesh mesh(random, random() % 8 + 3, std::pow(10.0, uniform(random, -60, 60)));
        for (int i = 0; i < 300; ++i) {
            const Triangle aim = mesh.triangle(random() % mesh.faces.size());
            const double share = uniform(random, 0, 1);
            const glm::dvec3 target = i % 3 == 0 ? aim[0]
                : i % 3 == 1                     ? share * aim[0] + (1 - share) * aim[1]
                                                 : pointOf(random, aim);
            const RayOnTriangles ray(glm::normalize(target / greatestOf(aim)));
            bool isMet = false;
            for (std::size_t face = 0; face < mesh.faces.size() && !isMet; ++face) {
                const std::optional<double> way = ray.wayTo(mesh.triangle(face));
                isMet = way && *way > 0.0;
            }
            QVERIFY2(isMet, qPrintable(QStringLiteral("round %1, %2").arg(round).arg(i)));
        }
    }
}

void TestRayTriangle::cornersInEveryOrderGiveTheSameAnswer()
{
    std::mt19937_64 random(seed(403));
    for (int i = 0; i < 5'000; ++i) {
        const Triangle t = randomTriangle(random);
        const RayOnTriangles ray(glm::normalize(i % 2 == 0 ? pointOf(random, t) : t[0] + 0.5 * (t[1] - t[0])));
        const std::optional<double> way = ray.wayTo(t);
        for (const Triangle &turned :
             {Triangle{t[1], t[2], t[0]}, Triangle{t[2], t[0], t[1]}, Triangle{t[0], t[2], t[1]},
              Triangle{t[2], t[1], t[0]}, Triangle{t[1], t[0], t[2]}}) {
            const std::optional<double> other = ray.wayTo(turned);
            if (way.has_value() != other.has_value()) { // three areas that cancel, summed in another order
                QVERIFY(glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) < 1e-12);
                continue;
            }
            QVERIFY(!way || std::abs(*way - *other) <= 1e-9 * std::abs(*way));
        }
    }
}

/// A corner thrice, or three on a line: never met, and never NaN.
void TestRayTriangle::trianglesWithoutAFaceAreNotMet()
{
    std::mt19937_64 random(seed(404));
    for (int i = 0; i < 5'000; ++i) {
        const glm::dvec3 a = randomPoint(random, 1.0);
        const glm::dvec3 b = randomPoint(random, 1.0);
        const glm::dvec3 direction = glm::normalize(i % 2 == 0 ? a : randomPoint(random, 1.0));
        const RayOnTriangles ray(direction);
        QVERIFY(!ray.wayTo({a, a, a}));
        QVERIFY(!ray.wayTo({a, b, a}) && !ray.wayTo({a, a, b}));
        QVERIFY(!ray.wayTo({glm::dvec3(0), glm::dvec3(0), glm::dvec3(0)}));
        QVERIFY(!ray.wayTo({direction, 2.0 * direction, 4.0 * direction}));
        const std::optional<double> way = ray.wayTo({a, 0.5 * a, 0.25 * a + 1e-17 * b});
        QVERIFY(!way || std::isfinite(*way));
    }
}

/// In numbers where nothing is rounded.
void TestRayTriangle::whatRunsAlongAFaceDoesNotMeetIt()
{
    const Triangle floor{{{-1, 0, 1}, {1, 0, 1}, {0, 0, 3}}};
    QVERIFY(!RayOnTriangles({0, 0, 1}).wayTo(floor));
    const Triangle wall{{{-1, 0, 2}, {1, 0, 2}, {0, 3, 2}}};
    QCOMPARE(RayOnTriangles({0, 0, 1}).wayTo(wall), std::optional(2.0)); // on its side
    QCOMPARE(RayOnTriangles({0, 0, -1}).wayTo(wall), std::optional(-2.0));
}

ROMANESCO_TEST(TestRayTriangle)

}

#include "testraytriangle.moc"
