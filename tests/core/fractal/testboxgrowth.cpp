// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/boxbounds.h"

#include <array>
#include <cmath>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/fractal/boxes.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Affine;
using naive::Fractal;
using naive::Point;

/// Levels of maps that keep to the axes, by intervals, which are exact then; by position.
std::vector<ExactBox> exactIntervals(const Fractal &fractal, const Mesh &mesh)
{
    const naive::Levels levels = fractal.levels();
    std::vector<ExactBox> boxes(levels.size() + 1);
    for (const Point &point : points(mesh)) {
        boxes.back().add(point);
    }
    for (std::size_t position = levels.size(); position-- > 0;) {
        const ExactBox &next = boxes[position + 1];
        for (const int map : levels[position].maps) {
            const Affine affine = naive::fromCore(fractal.maps[static_cast<std::size_t>(map)]);
            boxes[position].add(naive::applied(affine, next.least));
            boxes[position].add(naive::applied(affine, next.greatest));
        }
        if (levels[position].mayPass) {
            boxes[position].add(next);
        }
    }
    return boxes;
}

/// Moves, sizes, mirrors and quarter turns; most do not contract.
AffineMap randomAxisMap(std::mt19937_64 &random)
{
    const auto size = [&] { return std::array{1.0, -1.0, 1.0, 0.5, 0.9, 0.0}[random() % 6]; };
    const auto turn = [&] { return random() % 3 == 0 ? 90.0 * static_cast<double>(random() % 4) : 0.0; };
    return mapFromParts({uniform(random, -2, 2), random() % 2 == 0 ? 0.0 : 1.0, uniform(random, -1, 0)},
                        {turn(), turn(), turn()}, {size(), size(), size()});
}

}

/// Boxes of levels that do not contract: what grows is followed, and the rest stays tight.
class TestBoxGrowth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longRowsAreFollowedExactly_data();
    void longRowsAreFollowedExactly();
    void whatKeepsToTheAxesIsFollowedAxisByAxis_data();
    void whatKeepsToTheAxesIsFollowedAxisByAxis();
    void sidesThatOthersMoveLaterAreMoved();
    void whatGrowsLeavesTheRestTight();
    void growthIsFollowedAsFarAsNumbersGo();
    void nestsThatTurnHaveBoxes();
};

void TestBoxGrowth::longRowsAreFollowedExactly_data()
{
    QTest::addColumn<quint64>("depth");
    for (const quint64 depth : {quint64(100), quint64(70'000), quint64(1'000'000'000), quint64(1) << 62}) {
        QTest::addRow("%llu", depth) << depth;
    }
}

void TestBoxGrowth::longRowsAreFollowedExactly()
{
    QFETCH(quint64, depth);
    const Mesh mesh = wedge();
    const auto count = static_cast<long double>(depth);

    // A row along x, of moves of 1: y and z are those of the mesh to the last bit.
    const FractalGraph row = graphOf(repeated({moved(1, 0, 0)}, true, depth), mesh);
    const BoxBounds boxes(row, mesh);
    for (const long double part : {0.0L, 0.25L, 0.999L}) {
        const auto position = static_cast<Position>(count * part);
        const Box box = boxes.at(row, position);
        const auto left = static_cast<long double>(depth - position);
        QVERIFY(isTight(box, {{-0.5L, -1, 0}, {left + 0.5L, 1, 2}}, 1e-9L));
        if (depth > 4'096 && part < 0.5L) {
            QVERIFY(box.least.y == -1 && box.greatest.y == 1 && box.least.z == 0 && box.greatest.z == 2);
        }
    }

    // A grid, mirrored at each step, beside copies of half the size.
    AffineMap mirrored = moved(0, 0, 0);
    mirrored.linear[0][0] = -1;
    const AffineMap half = mapFromParts({0, -4, 0}, {0, 0, 0}, glm::dvec3(0.5));
    const Box box = boxAt(repeated({moved(1, 0, 0), moved(0, 0, 2), mirrored, half}, true, depth), mesh, 0);
    QVERIFY(isTight(box, {{-count + 0.5L, -8, 0}, {count + 0.5L, 1, 2 * count + 2}}, 0.02L));
}

void TestBoxGrowth::whatKeepsToTheAxesIsFollowedAxisByAxis_data()
{
    QTest::addColumn<quint64>("own");
    QTest::newRow("most") << quint64{75};
    QTest::newRow("a chain of turns in a nest") << quint64{2'000'081};
}

/// Far from the end of repeats of thousands of levels.
void TestBoxGrowth::whatKeepsToTheAxesIsFollowedAxisByAxis()
{
    QFETCH(const quint64, own);
    std::mt19937_64 random(seed(own));
    std::vector<long double> all;
    int grown = 0;
    for (int round = 0; round < 60; ++round) {
        Fractal fractal;
        for (int i = 0; i < 4; ++i) {
            fractal.maps.push_back(randomAxisMap(random));
        }
        fractal.sets = naive::randomSets(random, 4);
        do {
            fractal.items = naive::randomItems(random, fractal.sets.size(), 1, 100);
        } while (fractal.setsOfLevels().size() < 5'000 || fractal.setsOfLevels().size() > 40'000);
        const Mesh mesh = randomMesh(random);
        const FractalGraph graph = graphOf(fractal, mesh);
        const BoxBounds boxes(graph, mesh);
        const std::vector<ExactBox> exact = exactIntervals(fractal, mesh);
        for (Position position = 0; position < exact.size(); position += random() % 500 + 1) {
            if (graph.layout().nodeAt(graph.levels(), position)) {
                continue;
            }
            ++grown;
            all.push_back(excess(boxes.at(graph, position), exact[position]));
            QVERIFY2(all.back() >= 0, qPrintable(QStringLiteral("round %1 position %2").arg(round).arg(position)));
        }
    }
    QVERIFY2(grown > 200, QByteArray::number(grown));
}

/// What grows upwards is turned to the left, that backwards, and that down, which shows only where it is longer than the mesh.
void TestBoxGrowth::sidesThatOthersMoveLaterAreMoved()
{
    Mesh mesh;
    mesh.vertices = {{-1'000, -1'000, -1'000}, {0, 0, 0}, {0, 0.5, 0}};
    mesh.faces = {{0, 1, 2}};
    const auto flattened = [](glm::length_t from, glm::length_t to, double factor) {
        AffineMap map;
        map.linear = glm::dmat3(0.0);
        map.linear[from][to] = factor;
        return map;
    };
    const Fractal once =
        repeated({moved(0, 1, 0), flattened(1, 0, -1), flattened(0, 2, 1), flattened(2, 1, 1)}, true, 10'000);
    Fractal nested = once;
    nested.items = {{2'500, 0, {{2, 0, {{0, 0, {}}}}, {2, 0, {{0, 0, {}}}}}}};
    for (const Fractal &fractal : {once, nested}) {
        const FractalGraph graph = graphOf(fractal, mesh);
        const BoxBounds boxes(graph, mesh);
        const std::vector<ExactBox> exact = exactIntervals(fractal, mesh);
        QVERIFY(exact.front().least[0] < -9'000 && exact.front().least[1] < -9'000);
        for (Position position = 0; position < exact.size(); position += 10) {
            QVERIFY2(excess(boxes.at(graph, position), exact[position]) >= 0, qPrintable(QString::number(position)));
        }
    }
}

/// A million steps of a copy of a cluster, and clusters of all that.
void TestBoxGrowth::whatGrowsLeavesTheRestTight()
{
    constexpr std::uint64_t many = 1'000'000;
    Fractal fractal;
    fractal.maps = {moved(1, 0, 0), mapFromParts({3, 0, 0}, {0, 40, 0}, glm::dvec3(0.5)),
                    mapFromParts({-3, 0, 0}, {0, 0, 20}, glm::dvec3(0.5))};
    fractal.sets = {{{0}, true}, {{1, 2}, false}};
    fractal.items = {{many, 0, {{0, 1, {}}}}};
    const glm::dvec3 cluster = boxAt(fractal, wedge(), 0).size();
    fractal.items = {{3, 0, {{0, 1, {}}}}, {many, 0, {{0, 0, {}}}}, {many, 0, {{0, 1, {}}}}};
    const FractalGraph graph = graphOf(fractal, wedge());
    const BoxBounds boxes(graph, wedge());
    QVERIFY(glm::length(boxes.at(graph, many + 3).size() - cluster) < 0.01 * glm::length(cluster));
    const glm::dvec3 row = boxes.at(graph, 3).size();
    QVERIFY(std::abs(row.x - many - cluster.x) < 1e-3 * many);
    QVERIFY(std::abs(row.y - cluster.y) < 0.02 * cluster.y && std::abs(row.z - cluster.z) < 0.02 * cluster.z);
    // The longest way through the three levels outside turns by 40 degrees once and stays in the plane of x and z.
    const glm::dvec3 whole = boxes.at(graph, 0).size();
    QVERIFY(whole.x < 2.0 * many / 8 && whole.x > 0.5 * many / 8);
}

void TestBoxGrowth::growthIsFollowedAsFarAsNumbersGo()
{
    AffineMap turned = mapFromParts({1, 0, 0}, {0, 0, 30}, glm::dvec3(2));
    const Fractal fractal = repeated({mapFromParts({1, 0, 0}, {0, 0, 0}, glm::dvec3(2)), turned}, true, 400);
    const Box box = boxAt(fractal, wedge(), 0);
    const long double farthest = std::ldexp(1.5L, 400) - 1; // x to 2x + 1, from 0.5
    QVERIFY(holds(box, {farthest, 0, 0}));
    // Which of the outer levels turn hardly matters to the reach, so that there are too many ways to look at: no tighter
    // than the sphere then.
    QVERIFY(box.size().x < 12 * farthest && box.size().y < 12 * farthest && box.size().z < 2 * farthest);
}

/// Intervals that turn grow beyond all numbers; spheres do not.
void TestBoxGrowth::nestsThatTurnHaveBoxes()
{
    std::mt19937_64 random(seed(76));
    Fractal fractal;
    fractal.maps = {mapFromParts({0.1, 0, 0}, {0, 30, 45}, glm::dvec3(1)), moved(1, 0, 0)};
    fractal.sets = {{{0}, false}, {{0}, true}, {{1}, false}};
    for (const SetId turning : {0u, 1u}) {
        fractal.items = {{5'000, 0, {{0, turning, {}}}}, {0, 2, {}}};
        for (int nesting = 0; nesting < 4; ++nesting) {
            fractal.items = {{3, 0, fractal.items}, {0, 2, {}}};
            const FractalGraph graph = graphOf(fractal, wedge());
            const BoxBounds boxes(graph, wedge());
            const FractalDescription description = fractal.description();
            const Folder folder(description);
            Point point = points(wedge()).front();
            for (Position position = graph.levels().levelCount(); position-- > 0;) {
                point = folder.fold(position, point, random);
                QVERIFY(position % 997 != 0 || holds(boxes.at(graph, position), point, 1e-9L));
            }
            const Box box = boxes.at(graph, 0);
            QVERIFY(glm::length(box.size()) <= 4.0 * graph.bound(0).radius);
        }
    }
}

}

ROMANESCO_TEST(romanesco::test::TestBoxGrowth)

#include "testboxgrowth.moc"
