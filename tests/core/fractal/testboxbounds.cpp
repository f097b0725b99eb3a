// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/boxbounds.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/fractal/copies.h"
#include "tests/core/fractal/boxes.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Affine;
using naive::Fractal;
using naive::Point;

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

/// The part of values that is at most so much.
double partUpTo(const std::vector<long double> &values, long double most)
{
    const auto count = std::ranges::count_if(values, [&](long double value) { return value <= most; });
    return static_cast<double>(count) / static_cast<double>(values.size());
}

}

/// Boxes hold what they are to hold, and little more.
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
