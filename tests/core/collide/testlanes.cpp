// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/collide/exactcollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/instructionsets.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Two blocks.
constexpr std::size_t count = 2 * laneCount;

/// Any size, now and then 0.
double wildNumber(std::mt19937_64 &random)
{
    const double size = std::pow(10.0, uniform(random, -140, 140));
    return uniform(random, 0, 10) < 1.0 ? 0.0 : uniform(random, -size, size);
}

glm::dvec3 point(std::mt19937_64 &random, bool isWild)
{
    if (isWild) {
        return {wildNumber(random), wildNumber(random), wildNumber(random)};
    }
    return randomPoint(random, 1.0);
}

struct Sizes {
    std::array<TurnedBoxes, 2> turned;
    std::array<Parallelepipeds, 2> placed;
    std::vector<double> numbers;
    HullsOfFew hulls;
    AffineMap map;
    glm::dvec3 p{0.0};
};

Sizes sizes(std::mt19937_64 &random, bool isWild)
{
    Sizes result;
    const auto fill = [&](LanesOfPoint &lanes, std::size_t lane) { setLane(lanes, lane, point(random, isWild)); };
    for (std::size_t i = 0; i < count; ++i) {
        TurnedBoxes &turned = result.turned[i / laneCount];
        Parallelepipeds &placed = result.placed[i / laneCount];
        const std::size_t lane = i % laneCount;
        for (LanesOfPoint &row : turned.turned) {
            fill(row, lane);
        }
        fill(turned.offset, lane);
        setLane(turned.half, lane, glm::abs(point(random, isWild)));
        fill(placed.middle, lane);
        for (LanesOfPoint &edge : placed.edges) {
            fill(edge, lane);
        }
    }
    for (int i = 0; i < 3; ++i) {
        result.map.linear[i] = point(random, isWild);
    }
    result.map.translation = point(random, isWild);
    result.p = point(random, isWild);
    result.hulls.cornersUsed = HullsOfFew::cornerCount;
    for (std::size_t lane = 0; lane < laneCount; ++lane) {
        fill(result.hulls.centre, lane);
        for (LanesOfPoint &corner : result.hulls.corners) {
            fill(corner, lane);
        }
        result.hulls.error[lane] = std::abs(point(random, isWild).x);
    }
    result.numbers.resize(static_cast<std::size_t>(uniform(random, 1, 60)));
    std::ranges::generate(result.numbers, [&] { return std::round(3.0 * point(random, isWild).x); });
    return result;
}

std::vector<double> allOf(const Sizes &sizes)
{
    std::vector<double> results(2 * count);
    distancesTo(sizes.turned, sizes.p, results.data());
    distancesTo(sizes.placed, sizes.map, results.data() + count);
    results.push_back(static_cast<double>(leastOf(sizes.numbers)));
    raiseToHulls(sizes.hulls, sizes.p, results.data());
    raiseToHulls(sizes.hulls, sizes.map, 2.0, results.data() + count);
    return results;
}

using Long = std::array<long double, 3>;

Long wideLane(const LanesOfPoint &lanes, std::size_t lane)
{
    return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

long double product(const Long &a, const glm::dvec3 &b)
{
    return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}

void appendBits(const Hit &hit, std::vector<double> &bits)
{
    bits.insert(bits.end(),
                {hit.distance, hit.point.x, hit.point.y, hit.point.z, hit.direction.x, hit.direction.y, hit.direction.z,
                 hit.lower, static_cast<double>(hit.face), static_cast<double>(hit.cost.faceTests),
                 static_cast<double>(hit.cost.nodeVisits)});
    for (const Pick &pick : hit.address) {
        bits.push_back(pick.map);
    }
}

}

class TestLanes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyInstructionSetGivesTheSameBits();
    void collidersGiveTheSameBits();
    void turnedBoxesAreAsFarAsTheyAre();
    void noPointOfAParallelepipedIsNearer();
    void aBoxThatIsNotTurnedIsFoundExactly();
    void theFirstLeastIsFound();
    void hullsBeginWhereTheirNearestCornerIs();
};

void TestLanes::everyInstructionSetGivesTheSameBits()
{
    std::mt19937_64 random(seed(1));
    for (int i = 0; i < 2'000; ++i) {
        const Sizes numbers = sizes(random, i % 2 == 1);
        std::vector<std::vector<double>> results;
        const std::size_t sets = withEveryInstructionSet([&] { results.push_back(allOf(numbers)); });
#ifdef __x86_64__
        QVERIFY(sets >= 2 || hwy::SupportedTargets() == HWY_SSE2);
#endif
        QCOMPARE(results.size(), sets);
        for (const std::vector<double> &result : results) { // NaN, of products of 0 and too much, is no number
            QVERIFY(std::ranges::equal(result, results.front(),
                                       [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
        }
    }
}

/// All that an answer says, through both ways of going down.
void TestLanes::collidersGiveTheSameBits()
{
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 12);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
        const double size = fractal.graph.bound(0).radius;
        std::vector<std::vector<double>> results;
        withEveryInstructionSet([&] {
            std::mt19937_64 random(seed(2));
            std::vector<double> &bits = results.emplace_back();
            const auto inFrames = collider->search();
            const auto relative = collider->searchPlaced({});
            for (int i = 0; i < 100; ++i) {
                Hit hit;
                const glm::dvec3 p = randomPoint(random, size);
                inFrames->closest({p}, hit);
                appendBits(hit, bits);
                relative->closest({p}, hit);
                appendBits(hit, bits);
            }
        });
        for (const std::vector<double> &result : results) {
            QCOMPARE(result, results.front());
        }
    }
}

void TestLanes::turnedBoxesAreAsFarAsTheyAre()
{
    std::mt19937_64 random(seed(3));
    for (int i = 0; i < 2'000; ++i) {
        const Sizes numbers = sizes(random, false);
        std::array<double, count> found{};
        distancesTo(numbers.turned, numbers.p, found.data());
        for (std::size_t k = 0; k < count; ++k) {
            const TurnedBoxes &boxes = numbers.turned[k / laneCount];
            const Long offset = wideLane(boxes.offset, k % laneCount);
            const Long half = wideLane(boxes.half, k % laneCount);
            long double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const long double along =
                    std::abs(product(wideLane(boxes.turned[axis], k % laneCount), numbers.p) + offset[axis]);
                square += std::max(along - half[axis], 0.0L) * std::max(along - half[axis], 0.0L);
            }
            QVERIFY(std::abs(found[k] - std::sqrt(square)) <= 2e-15L);
        }
    }
}

/// Nor is it far off: from where the nearest lies along a corner, an edge or a face.
void TestLanes::noPointOfAParallelepipedIsNearer()
{
    std::mt19937_64 random(seed(4));
    double shares = 0.0;
    int tried = 0;
    for (int i = 0; i < 300; ++i) {
        Sizes numbers = sizes(random, false);
        numbers.map.translation *= 8.0;
        std::array<double, count> found{};
        distancesTo(numbers.placed, numbers.map, found.data());
        for (std::size_t k = 0; k < count; ++k) {
            const Parallelepipeds &boxes = numbers.placed[k / laneCount];
            const auto at = [&](const LanesOfPoint &lanes) {
                return glm::dvec3(lanes[0][k % laneCount], lanes[1][k % laneCount], lanes[2][k % laneCount]);
            };
            double nearest = infinity;
            for (int corner = 0; corner < 125; ++corner) {
                glm::dvec3 place = at(boxes.middle);
                for (int axis = 0, rest = corner; axis < 3; ++axis, rest /= 5) {
                    place += (rest % 5 - 2) / 2.0 * at(boxes.edges[static_cast<std::size_t>(axis)]);
                }
                nearest = std::min(nearest, glm::length(numbers.map(place)));
            }
            QVERIFY(found[k] <= nearest * (1.0 + 1e-14));
            shares += nearest > 0.0 ? found[k] / nearest : 1.0;
            ++tried;
        }
    }
    QVERIFY2(shares / tried > 0.7, qPrintable(QString::number(shares / tried)));
}

void TestLanes::aBoxThatIsNotTurnedIsFoundExactly()
{
    std::array<Parallelepipeds, 1> boxes{};
    setLane(boxes[0].middle, 0, {5, 6, 0.5});
    setLane(boxes[0].edges[0], 0, {2, 0, 0});
    setLane(boxes[0].edges[1], 0, {0, 2, 0});
    setLane(boxes[0].edges[2], 0, {0, 0, 1});
    setLane(boxes[0].middle, 1, {1, 0, 0}); // holds the origin
    setLane(boxes[0].edges[0], 1, {2, 0, 0});
    setLane(boxes[0].middle, 2, {3, 0, 4}); // a point
    std::array<double, laneCount> found{};
    distancesTo(boxes, AffineMap{}, found.data());
    QCOMPARE(found[0], 5.0);
    QCOMPARE(found[1], 0.0);
    QCOMPARE(found[2], 5.0);
}

void TestLanes::theFirstLeastIsFound()
{
    std::mt19937_64 random(seed(5));
    for (int i = 0; i < 5'000; ++i) {
        std::vector<double> numbers(1 + random() % 60);
        std::ranges::generate(numbers, [&] {
            const double number = std::floor(uniform(random, 0, 20));
            return number == 19.0 ? infinity : number;
        });
        QCOMPARE(leastOf(numbers), static_cast<std::size_t>(std::ranges::min_element(numbers) - numbers.begin()));
    }
    QCOMPARE(leastOf(std::vector(17, infinity)), std::size_t{0});
}

/// As seen along the way to the centre; also as a map places them.
void TestLanes::hullsBeginWhereTheirNearestCornerIs()
{
    std::mt19937_64 random(seed(6));
    int raised = 0;
    for (int i = 0; i < 1'000; ++i) {
        Sizes numbers = sizes(random, false);
        numbers.p *= 5.0;
        numbers.map.translation *= 5.0;
        std::array<double, count> found{};
        found.fill(0.5);
        raiseToHulls(numbers.hulls, numbers.p, found.data());
        raiseToHulls(numbers.hulls, numbers.map, 3.0, found.data() + laneCount);
        for (std::size_t lane = 0; lane < laneCount; ++lane) {
            for (const bool isPlaced : {false, true}) {
                const auto at = [&](const LanesOfPoint &lanes) {
                    return glm::dvec3(lanes[0][lane], lanes[1][lane], lanes[2][lane]);
                };
                const glm::dvec3 centre = at(numbers.hulls.centre);
                const glm::dvec3 way = isPlaced ? numbers.map(centre) : centre - numbers.p;
                double least = infinity;
                for (const LanesOfPoint &corner : numbers.hulls.corners) {
                    const glm::dvec3 seen =
                        isPlaced ? numbers.map(centre + at(corner)) : centre + at(corner) - numbers.p;
                    least = std::min(least, glm::dot(seen, way) / glm::length(way));
                }
                const double expected = least - (isPlaced ? 3.0 : 1.0) * numbers.hulls.error[lane];
                const double result = found[lane + (isPlaced ? laneCount : 0)];
                QVERIFY(std::abs(result - std::max(expected, 0.5)) <= 1e-13);
                raised += result > 0.5 ? 1 : 0;
            }
        }
    }
    QVERIFY2(raised > 4'000 && raised < 15'000, qPrintable(QString::number(raised)));
}

ROMANESCO_TEST(TestLanes)

}

#include "testlanes.moc"
