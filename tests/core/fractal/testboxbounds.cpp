// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/boxbounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/fractal/copies.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Affine;
using naive::Fractal;
using naive::Point;

/// In long doubles.
struct ExactBox {
    std::array<long double, 3> least{INFINITY, INFINITY, INFINITY};
    std::array<long double, 3> greatest{-INFINITY, -INFINITY, -INFINITY};

    void add(const Point &point)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], point[axis]);
            greatest[axis] = std::max(greatest[axis], point[axis]);
        }
    }

    void add(const ExactBox &box)
    {
        add(box.least);
        add(box.greatest);
    }

    [[nodiscard]] long double size() const
    {
        return std::max({greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]});
    }
};

/// What the levels from each position on make of the mesh, written out from the end up; by position.
std::vector<ExactBox> exactBoxes(const Fractal &fractal, const Mesh &mesh)
{
    const naive::Levels levels = fractal.levels();
    std::vector<Affine> maps;
    for (const AffineMap &map : fractal.maps) {
        maps.push_back(naive::fromCore(map));
    }
    std::vector<Point> all = points(mesh);
    std::vector<ExactBox> boxes(levels.size() + 1);
    for (std::size_t position = levels.size() + 1; position-- > 0;) {
        if (position < levels.size()) {
            std::vector<Point> longer;
            if (levels[position].mayPass) {
                longer = all;
            }
            for (const int map : levels[position].maps) {
                for (const Point &point : all) {
                    longer.push_back(naive::applied(maps[static_cast<std::size_t>(map)], point));
                }
            }
            all = std::move(longer);
        }
        for (const Point &point : all) {
            boxes[position].add(point);
        }
    }
    return boxes;
}

bool holds(const Box &box, const Point &point, long double slack = 0)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        const long double more = slack * (1 + std::abs(point[axis]));
        if (point[axis] < box.least[i] - more || point[axis] > box.greatest[i] + more) {
            return false;
        }
    }
    return true;
}

/// How far the sides of a box are out, the farthest one in parts of the exact box's largest side, but for rounding;
/// negative where one is inside.
long double excess(const Box &box, const ExactBox &exact)
{
    long double farthest = -INFINITY;
    long double nearest = INFINITY;
    long double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        for (long double out : {exact.least[axis] - box.least[i], box.greatest[i] - exact.greatest[axis]}) {
            out = std::abs(out) < 1e-300L ? 0 : out; // what no double holds
            largest = std::max({largest, std::abs(exact.least[axis]), std::abs(exact.greatest[axis])});
            farthest = std::max(farthest, out);
            nearest = std::min(nearest, out);
        }
    }
    return (nearest < 0 ? nearest : farthest) / (exact.size() + 1e-9L * largest);
}

/// Boxes by position, those that share a node put together.
std::vector<ExactBox> shared(const FractalGraph &graph, std::vector<ExactBox> exact)
{
    std::map<BoundLayout::Node, ExactBox> byNode;
    const auto nodeAt = [&](Position position) { return graph.layout().nodeAt(graph.levels(), position).value(); };
    for (Position position = 0; position < exact.size(); ++position) {
        byNode[nodeAt(position)].add(exact[position]);
    }
    for (Position position = 0; position < exact.size(); ++position) {
        exact[position] = byNode[nodeAt(position)];
    }
    return exact;
}

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

/// The part of values that is at most so much.
double partUpTo(const std::vector<long double> &values, long double most)
{
    const auto count = std::ranges::count_if(values, [&](long double value) { return value <= most; });
    return static_cast<double>(count) / static_cast<double>(values.size());
}

/// A set of these maps, so often.
Fractal repeated(std::vector<AffineMap> maps, bool mayPass, std::uint64_t depth)
{
    Fractal fractal;
    fractal.sets = {{{}, mayPass}};
    for (std::size_t i = 0; i < maps.size(); ++i) {
        fractal.sets.front().maps.push_back(static_cast<int>(i));
    }
    fractal.maps = std::move(maps);
    fractal.items = {{depth, 0, {{0, 0, {}}}}};
    return fractal;
}

/// From -0.5, -1, 0 to 0.5, 1, 2.
Mesh wedge()
{
    Mesh mesh;
    mesh.vertices = {{-0.5, -1, 0}, {0.5, 0, 2}, {0, 1, 1}};
    mesh.faces = {{0, 1, 2}};
    return mesh;
}

AffineMap moved(double x, double y, double z)
{
    return {glm::dmat3(1.0), {x, y, z}};
}

Box boxAt(const Fractal &fractal, const Mesh &mesh, Position position)
{
    const FractalGraph graph = graphOf(fractal, mesh);
    return BoxBounds(graph, mesh).at(graph, position);
}

/// Holds the truth, and no side is farther out than that part of the largest.
bool isTight(const Box &box, const ExactBox &truth, long double part)
{
    const long double out = excess(box, truth);
    return out >= 0 && out <= part;
}

}

class TestBoxBounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPositionsBoxHoldsWhatFollows_data();
    void everyPositionsBoxHoldsWhatFollows();
    void examplesHaveTightBoxes_data();
    void examplesHaveTightBoxes();
    void foldedPointsStayInsideAtGreatDepth_data();
    void foldedPointsStayInsideAtGreatDepth();
    void pointsOfDeepFractalsStayInside();
    void boxesDoNotGrowWithTheDepth_data();
    void boxesDoNotGrowWithTheDepth();
    void longRowsAreFollowedExactly_data();
    void longRowsAreFollowedExactly();
    void whatKeepsToTheAxesIsFollowedAxisByAxis_data();
    void whatKeepsToTheAxesIsFollowedAxisByAxis();
    void sidesThatOthersMoveLaterAreMoved();
    void whatGrowsLeavesTheRestTight();
    void growthIsFollowedAsFarAsNumbersGo();
    void nestsThatTurnHaveBoxes();
    void whatAnEmptyLevelEndsHasNoBox();
    void flatFractalsHaveFlatBoxes();
    void theEndIsTheMesh();
    void manyLevelsTakeTimeAsTheyAreMany_data();
    void manyLevelsTakeTimeAsTheyAreMany();
};

void TestBoxBounds::everyPositionsBoxHoldsWhatFollows_data()
{
    QTest::addColumn<double>("largest");
    QTest::newRow("strongly contracting") << 0.1;
    QTest::newRow("contracting") << 0.5;
    QTest::newRow("hardly contracting") << 0.97;
    QTest::newRow("growing") << 1.7;
}

void TestBoxBounds::everyPositionsBoxHoldsWhatFollows()
{
    QFETCH(double, largest);
    std::mt19937_64 random(seed(71));
    std::vector<long double> all;
    for (int round = 0; round < 400; ++round) {
        const Fractal fractal = randomFractal(random, largest);
        const Mesh mesh = randomMesh(random);
        const FractalGraph graph = graphOf(fractal, mesh);
        const BoxBounds boxes(graph, mesh);
        const std::vector<ExactBox> exact = shared(graph, exactBoxes(fractal, mesh));
        for (Position position = 0; position < exact.size(); ++position) {
            all.push_back(excess(boxes.at(graph, position), exact[position]));
            QVERIFY2(all.back() >= 0, qPrintable(QStringLiteral("round %1 position %2").arg(round).arg(position)));
        }
    }
    QVERIFY(partUpTo(all, 0.005L) > 0.95);
    QVERIFY(partUpTo(all, 0.02L) > 0.99);
}

void TestBoxBounds::examplesHaveTightBoxes_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<double>("part");
    const auto row = [](const char *name, quint64 depth, double part) {
        QTest::addRow("%s %llu", name, depth) << QString::fromLatin1(name) << depth << part;
    };
    row("appendix-b", 3, 0.005);
    row("menger", 3, 1e-12);
    row("romanesco", 1, 0.005);
    row("romanesco", 2, 0.03); // a spiral of 96 steps shares its box with longer ones
    row("sierpinski", 6, 1e-12);
    row("snowflake", 4, 0.005);
    row("tree", 5, 0.005);
    row("two-sets", 3, 1e-12);
}

void TestBoxBounds::examplesHaveTightBoxes()
{
    QFETCH(QString, name);
    QFETCH(quint64, depth);
    QFETCH(double, part);
    const Sample fractal = sample(name, depth);
    CopyWalk copies(fractal.graph);
    ExactBox truth;
    const std::vector<Point> vertices = points(fractal.mesh);
    while (copies.next()) {
        for (const Point &vertex : vertices) {
            truth.add(naive::applied(naive::fromCore(copies.modelFromBase()), vertex));
        }
    }
    const Box box = BoxBounds(fractal.graph, fractal.mesh).at(fractal.graph, 0);
    QVERIFY2(isTight(box, truth, part), qPrintable(QString::number(static_cast<double>(excess(box, truth)))));
}

void TestBoxBounds::foldedPointsStayInsideAtGreatDepth_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake"}) {
        QTest::newRow(name) << QString::fromLatin1(name) << 100'000;
    }
    QTest::newRow("romanesco") << "romanesco" << 2'000;
}

void TestBoxBounds::foldedPointsStayInsideAtGreatDepth()
{
    QFETCH(QString, name);
    QFETCH(int, depth);
    const Sample fractal = sample(name, static_cast<std::uint64_t>(depth));
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const Folder folder(fractal.description);
    std::mt19937_64 random(seed(73));
    const std::vector<Point> vertices = points(fractal.mesh);
    for (int round = 0; round < 3; ++round) {
        Point point = vertices[random() % vertices.size()];
        const Position count = fractal.graph.levels().levelCount();
        for (Position position = count; position-- > 0;) {
            point = folder.fold(position, point, random);
            const bool isLooked = position < 50 || count - position < 200 || position % 997 == 0;
            if (isLooked) {
                QVERIFY(holds(boxes.at(fractal.graph, position), point));
            }
        }
    }
}

/// Of random fractals of any depth: after thousands of levels that contract any start is as good as a vertex, and
/// farther in each point may be one.
void TestBoxBounds::pointsOfDeepFractalsStayInside()
{
    std::mt19937_64 random(seed(74));
    int looked = 0;
    for (int round = 0; round < 600; ++round) {
        Fractal fractal;
        for (int i = 0; i < 3; ++i) {
            fractal.maps.push_back(randomMap(random, std::array{0.3, 0.8, 0.95}[random() % 3]));
        }
        fractal.sets = naive::randomSets(random, 3);
        const std::uint64_t depth = std::array{100ull, 1'000'000ull, 1ull << 50}[random() % 3];
        fractal.items = {{depth, 0, naive::randomItems(random, fractal.sets.size(), 0, 4)}};
        const FractalDescription description = fractal.description();
        const Mesh mesh = randomMesh(random);
        const auto graph = FractalGraph::build(description, boundingSphere(mesh));
        const Position count = description.levels.levelCount();
        if (!graph || count == 0) {
            continue; // a shear makes some grow
        }
        const Folder folder(description);
        const BoxBounds boxes(*graph, mesh);
        const std::vector<Point> vertices = points(mesh);
        const Position end = random() % 2 == 0 ? count : random() % count;
        const Position begin = end - std::min<Position>(end, 4'000);
        const bool isExact = end == count;
        Point point = vertices[random() % vertices.size()];
        for (Position position = end; position-- > begin;) {
            point = folder.fold(position, point, random);
            if (isExact || end - position > 3'500) {
                ++looked;
                QVERIFY2(holds(boxes.at(*graph, position), point, 1e-9L), qPrintable(QString::number(round)));
            }
        }
    }
    QVERIFY(looked > 10'000);
}

void TestBoxBounds::boxesDoNotGrowWithTheDepth_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void TestBoxBounds::boxesDoNotGrowWithTheDepth()
{
    QFETCH(QString, name);
    const auto sizeAt = [&](std::uint64_t depth) {
        const Sample fractal = sample(name, depth);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        return boxes.at(fractal.graph, 0).size();
    };
    const glm::dvec3 shallow = sizeAt(60);
    for (const std::uint64_t depth : {1'000ull, 1'000'000ull, 1ull << 54}) {
        const glm::dvec3 deep = sizeAt(depth);
        QVERIFY(glm::length(deep - shallow) <= 0.01 * glm::length(shallow));
    }
}

void TestBoxBounds::longRowsAreFollowedExactly_data()
{
    QTest::addColumn<quint64>("depth");
    for (const quint64 depth : {quint64(100), quint64(70'000), quint64(1'000'000'000), quint64(1) << 62}) {
        QTest::addRow("%llu", depth) << depth;
    }
}

void TestBoxBounds::longRowsAreFollowedExactly()
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

void TestBoxBounds::whatKeepsToTheAxesIsFollowedAxisByAxis_data()
{
    QTest::addColumn<quint64>("own");
    QTest::newRow("most") << quint64{75};
    QTest::newRow("a chain of turns in a nest") << quint64{2'000'081};
}

/// Far from the end of repeats of thousands of levels.
void TestBoxBounds::whatKeepsToTheAxesIsFollowedAxisByAxis()
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
void TestBoxBounds::sidesThatOthersMoveLaterAreMoved()
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
void TestBoxBounds::whatGrowsLeavesTheRestTight()
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

void TestBoxBounds::growthIsFollowedAsFarAsNumbersGo()
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
void TestBoxBounds::nestsThatTurnHaveBoxes()
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

void TestBoxBounds::whatAnEmptyLevelEndsHasNoBox()
{
    Fractal fractal;
    fractal.maps = {moved(1, 0, 0), mapFromParts({0, 0, 0}, {0, 30, 45}, glm::dvec3(1))};
    fractal.sets = {{{0}, false}, {{0, 1}, true}, {{}, false}};
    for (const SetId set : {0u, 1u}) {
        for (const bool isFirst : {true, false}) {
            fractal.items = {{0, set, {}}};
            fractal.items.insert(isFirst ? fractal.items.begin() : fractal.items.end(), {0, 2, {}});
            fractal.items = {{100'000, 0, fractal.items}, {100'000, 0, {{0, set, {}}}}};
            QVERIFY(boxAt(fractal, wedge(), 0).isEmpty());
        }
    }
}

void TestBoxBounds::flatFractalsHaveFlatBoxes()
{
    const AffineMap flat = mapFromParts({1, 0, 5}, {0, 0, 0}, {0.5, 0.5, 0});
    const AffineMap other = mapFromParts({-1, 1, 5}, {0, 0, 45}, {0.5, -0.5, 0});
    for (const std::uint64_t depth : {1u, 5u, 1'000'000u}) {
        const Box box = boxAt(repeated({flat, other}, false, depth), wedge(), 0);
        QVERIFY(box.least.z <= 5 && box.greatest.z >= 5 && box.size().z < 1e-12);
        QVERIFY(box.size().x > 1 && box.size().x < 6);
    }
    const Box point = boxAt(repeated({mapFromParts({1, 2, 3}, {0, 0, 0}, glm::dvec3(0))}, false, 7), wedge(), 0);
    QVERIFY(holds(point, {1, 2, 3}) && glm::length(point.size()) < 1e-12);
}

void TestBoxBounds::theEndIsTheMesh()
{
    Mesh mesh;
    mesh.vertices = {{9, 9, 9}, {1, 2, 3}, {-1, 5, 3}, {0, 0, 4}};
    mesh.faces = {{1, 2, 3}};
    const FractalGraph alone = FractalGraph::ofMesh(boundingSphere(mesh));
    const Box box = BoxBounds(alone, mesh).at(alone, 0);
    QVERIFY(box.least == glm::dvec3(-1, 0, 3));
    QVERIFY(box.greatest == glm::dvec3(1, 5, 4));
    for (const std::uint64_t depth : {5u, 1'000'000u}) {
        for (const double size : {0.5, 1.0}) {
            const AffineMap map = mapFromParts({1, 0, 0}, {0, 30, 0}, glm::dvec3(size));
            QVERIFY(boxAt(repeated({map}, true, depth), Mesh{}, 0).isEmpty());
        }
    }
}

void TestBoxBounds::manyLevelsTakeTimeAsTheyAreMany_data()
{
    QTest::addColumn<double>("size");
    QTest::addColumn<bool>("mayPass");
    QTest::newRow("contracting") << 0.5 << false;
    QTest::newRow("contracting, #") << 0.5 << true;
    QTest::newRow("moves") << 1.0 << false;
    QTest::newRow("moves, #") << 1.0 << true;
}

/// 10,000 levels, each another set; what is not linear here takes minutes.
void TestBoxBounds::manyLevelsTakeTimeAsTheyAreMany()
{
    QFETCH(double, size);
    QFETCH(bool, mayPass);
    constexpr int count = 10'000;
    Fractal fractal;
    for (int i = 0; i < count; ++i) {
        fractal.maps.push_back(mapFromParts({0.5 * i / count, 0.1, 0}, {0.01 * i, 0, 1}, glm::dvec3(size)));
        fractal.sets.push_back({{i}, mayPass});
        fractal.items.push_back({0, static_cast<SetId>(i), {}});
    }
    const Mesh mesh = wedge();
    const FractalGraph once = graphOf(fractal, mesh);
    QVERIFY(!BoxBounds(once, mesh).at(once, 0).isEmpty());
    fractal.items = {{1'000, 0, fractal.items}};
    const FractalGraph often = graphOf(fractal, mesh);
    QVERIFY(!BoxBounds(often, mesh).at(often, 0).isEmpty());
}
}

ROMANESCO_TEST(romanesco::test::TestBoxBounds)

#include "testboxbounds.moc"
