// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/waylanes.h"

#include <bit>

#include <QTest>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/instructionsets.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Eight boxes and hulls in a frame, and a sphere on its way to them, or past.
struct Shot {
    glm::dvec3 p{0.0};
    MovingSphere sphere;
    AffineMap map;
    std::array<Box, laneCount> boxes;
    TurnedBoxes turned;
    Parallelepipeds placed;
    std::array<std::vector<glm::dvec3>, laneCount> corners;
    std::array<glm::dvec3, laneCount> centres{};
    HullsOfFew hulls{};
};

Shot randomShot(std::mt19937_64 &random, int round)
{
    Shot shot;
    shot.hulls.cornersUsed = HullsOfFew::cornerCount;
    shot.p = randomPoint(random, 6);
    shot.sphere.direction = round % 10 == 0 ? glm::dvec3(0, 0, 1) : glm::normalize(randomPoint(random, 2) - shot.p);
    shot.sphere.radius = round % 7 == 0 ? 0.0 : std::pow(10.0, uniform(random, -3, 1));
    shot.map = randomMap(random, 2);
    for (std::size_t lane = 0; lane < laneCount; ++lane) {
        const glm::dvec3 middle = randomPoint(random, 2);
        const glm::dvec3 half = glm::abs(randomPoint(random, 1)) * (lane == 3 ? glm::dvec3(1, 0, 1) : glm::dvec3(1));
        shot.boxes[lane] = {middle - half, middle + half};
        setLane(shot.turned.offset, lane, -middle);
        setLane(shot.turned.half, lane, half);
        setLane(shot.placed.middle, lane, middle);
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis);
            const glm::dvec3 along = glm::column(glm::dmat3(1.0), axis);
            setLane(shot.turned.turned[row], lane, along);
            setLane(shot.placed.edges[row], lane, along * half);
        }
        shot.centres[lane] = middle;
        setLane(shot.hulls.centre, lane, middle);
        shot.hulls.error[lane] = lane == 5 ? infinity : uniform(random, 0, 0.1);
        for (LanesOfPoint &corner : shot.hulls.corners) {
            shot.corners[lane].push_back(half * randomPoint(random, 1));
            setLane(corner, lane, shot.corners[lane].back());
        }
    }
    return shot;
}

/// By the plane across the way to the centre of a hull.
double expectedWay(const Shot &shot, const AffineMap &map, std::size_t lane, double way)
{
    if (way == infinity || shot.hulls.error[lane] == infinity) {
        return way;
    }
    const glm::dvec3 normal = glm::normalize(map(shot.centres[lane]) - way * shot.sphere.direction);
    double offset = infinity;
    for (const glm::dvec3 &corner : shot.corners[lane]) {
        offset = std::min(offset, glm::dot(normal, map(shot.centres[lane] + corner)));
    }
    const double error = operatorNorm(map.linear) * shot.hulls.error[lane];
    return SupportPlane{normal, offset - error}.wayOf(shot.sphere, way);
}

struct Ways {
    Lanes turned{};
    Lanes placed{};
    Lanes turnedHulls{};
    Lanes placedHulls{};
};

Ways waysOf(const Shot &shot, const AffineMap &placed)
{
    Ways ways;
    waysTo({&shot.turned, 1}, shot.p, shot.sphere, ways.turned.data());
    waysTo({&shot.placed, 1}, placed, shot.sphere, ways.placed.data());
    ways.turnedHulls = ways.turned;
    raiseToHulls(shot.hulls, shot.p, shot.sphere, ways.turnedHulls.data());
    ways.placedHulls = ways.placed;
    raiseToHulls(shot.hulls, placed, operatorNorm(placed.linear), shot.sphere, ways.placedHulls.data());
    return ways;
}

}

class TestWayLanes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lanesAreAsOneByOne();
    void bitsAreTheSameOnEveryProcessor();
};

void TestWayLanes::lanesAreAsOneByOne()
{
    std::mt19937_64 random(seed(63));
    int touched = 0;
    int raised = 0;
    int loose = 0; // where they graze, lanes give up earlier
    const auto isAbout = [](double a, double b) { return a == b || std::abs(a - b) <= 1e-10 * (1 + std::abs(b)); };
    for (int round = 0; round < 1'000; ++round) {
        const Shot shot = randomShot(random, round);
        const AffineMap placed{shot.map.linear, shot.map.translation - shot.p};
        const AffineMap moved{glm::dmat3(1.0), -shot.p};
        const Ways ways = waysOf(shot, placed);
        for (std::size_t lane = 0; lane < laneCount; ++lane) {
            const Box &box = shot.boxes[lane];
            const BoxBody body{{box.least - shot.p, box.greatest - shot.p}};
            const double expected = wayTo(body, shot.sphere, wayToBox(body.box, shot.sphere), infinity);
            const double way = ways.turned[lane];
            QVERIFY(way <= expected + 1e-5 * shot.sphere.radius + 1e-12);
            loose += way == expected || expected - way <= 1e-5 * shot.sphere.radius + 1e-12 ? 0 : 1;
            touched += expected < infinity && expected > 0 ? 1 : 0;
            QVERIFY(isAbout(ways.placed[lane], wayToBox(parallelepiped(placed, box).box(), shot.sphere)));
            QVERIFY(isAbout(ways.turnedHulls[lane], expectedWay(shot, moved, lane, way)));
            QVERIFY(isAbout(ways.placedHulls[lane], expectedWay(shot, placed, lane, ways.placed[lane])));
            raised += ways.turnedHulls[lane] > way || ways.placedHulls[lane] > ways.placed[lane] ? 1 : 0;
        }
    }
    QVERIFY2(touched > 500 && raised > 500 && loose < 40,
             qPrintable(QStringLiteral("%1 %2 %3").arg(touched).arg(raised).arg(loose)));
}

void TestWayLanes::bitsAreTheSameOnEveryProcessor()
{
    std::vector<std::vector<std::uint64_t>> bits;
    const std::size_t sets = withEveryInstructionSet([&] {
        std::mt19937_64 random(seed(64));
        std::vector<std::uint64_t> &all = bits.emplace_back();
        for (int round = 0; round < 300; ++round) {
            const Shot shot = randomShot(random, round);
            const Ways ways = waysOf(shot, {shot.map.linear, shot.map.translation - shot.p});
            for (const Lanes &lanes : {ways.turned, ways.placed, ways.turnedHulls, ways.placedHulls}) {
                for (const double way : lanes) {
                    all.push_back(std::bit_cast<std::uint64_t>(way));
                }
            }
        }
    });
    QCOMPARE(bits.size(), sets);
    for (const auto &of : bits) {
        QVERIFY(of == bits.front());
    }
}

}

ROMANESCO_TEST(romanesco::test::TestWayLanes)

#include "testwaylanes.moc"
