// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <limits>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/geometry/affinemap.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Affine;
using naive::Point;

long double distance(const Point &p, const glm::dvec3 &q)
{
    const Point d{p[0] - q.x, p[1] - q.y, p[2] - q.z};
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

bool holds(const Sphere &sphere, const Point &point, long double slack = 0)
{
    return distance(point, sphere.centre) <= sphere.radius * (1 + slack);
}

}

class TestSphereBounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPositionsBoundHoldsWhatFollows_data();
    void everyPositionsBoundHoldsWhatFollows();
    void contractingSetsShareATightBoundAtAnyDepth();
    void sharedBoundsHoldTheImagesOfOneAnother();
    void boundsHoldTheNextOnesWhereRepeatsMeet();
    void whatGrowsLeavesTheRestTight();
    void foldedPointsStayInsideAtGreatDepth_data();
    void foldedPointsStayInsideAtGreatDepth();
    void attractorsStayInsideAtTheGreatestDepths_data();
    void attractorsStayInsideAtTheGreatestDepths();
    void boundsDoNotGrowWithTheDepth_data();
    void boundsDoNotGrowWithTheDepth();
    void movesAloneAreBoundedByTheirSum_data();
    void movesAloneAreBoundedByTheirSum();
    void growthIsFollowedAsFarAsNumbersGo();
    void slowGrowthIsFollowedThroughNestedRepeats();
    void buildingTakesKilobytesAtAnyDepth();
    void theEndIsTheMesh();
};

void TestSphereBounds::everyPositionsBoundHoldsWhatFollows_data()
{
    QTest::addColumn<double>("largest");
    QTest::newRow("strongly contracting") << 0.1;
    QTest::newRow("contracting") << 0.5;
    QTest::newRow("hardly contracting") << 0.97;
    QTest::newRow("growing") << 1.7;
}

void TestSphereBounds::everyPositionsBoundHoldsWhatFollows()
{
    QFETCH(double, largest);
    std::mt19937_64 random(seed(21));
    for (int round = 0; round < 250; ++round) {
        const naive::Fractal fractal = randomFractal(random, largest);
        const Mesh mesh = randomMesh(random);
        const FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
        const naive::Levels levels = fractal.levels();
        std::vector<Affine> maps;
        for (const AffineMap &map : fractal.maps) {
            maps.push_back(naive::fromCore(map));
        }
        // From the end up: what the levels from a position on make, written out.
        std::vector<Point> all = points(mesh);
        for (std::size_t position = levels.size(); position-- > 0;) {
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
            const Sphere bound = graph.bound(position);
            for (const Point &point : all) {
                if (!holds(bound, point)) {
                    QFAIL(qPrintable(QStringLiteral("round %1 position %2").arg(round).arg(position)));
                }
            }
        }
    }
}

/// Where maps contract, a repeat of any depth has a bound near that of a shallow one, `#` or not.
void TestSphereBounds::contractingSetsShareATightBoundAtAnyDepth()
{
    std::mt19937_64 random(seed(22));
    for (int round = 0; round < 1'000; ++round) {
        naive::Fractal fractal;
        for (int i = 0; i < 3; ++i) {
            fractal.maps.push_back(randomMap(random, round % 2 == 0 ? 0.5 : 0.8));
        }
        fractal.sets = naive::randomSets(random, 3);
        const std::vector<naive::Fractal::Item> pass = naive::randomItems(random, fractal.sets.size(), 1, 4);
        fractal.items = pass;
        if (std::ranges::all_of(fractal.levels(), [](const naive::Level &level) { return level.maps.empty(); })) {
            continue; // nothing contracts where nothing happens
        }
        const Mesh mesh = randomMesh(random);
        double shallow = 0;
        for (const std::uint64_t depth : {300ull, 1'000'000ull, 1'000'000'000'000ull}) {
            fractal.items = {{depth, 0, pass}};
            const FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
            const double radius = graph.bound(0).radius;
            if (depth == 300) {
                shallow = radius;
            } else {
                constexpr double nothing = 1e-5; // a single map goes on shrinking
                QVERIFY2(
                    radius <= 1.05 * shallow + nothing && radius >= 0.95 * shallow - nothing,
                    qPrintable(
                        QStringLiteral("round %1 depth %2: %3 %4").arg(round).arg(depth).arg(radius).arg(shallow)));
            }
        }
    }
}

/// What makes one sphere good for every depth: each lies in that of the level before, through every map.
void TestSphereBounds::sharedBoundsHoldTheImagesOfOneAnother()
{
    std::mt19937_64 random(seed(25));
    for (int round = 0; round < 400; ++round) {
        naive::Fractal fractal;
        for (int i = 0; i < 3; ++i) {
            fractal.maps.push_back(randomMap(random, std::array{0.3, 0.8, 0.97}[random() % 3]));
        }
        fractal.sets = naive::randomSets(random, 3);
        fractal.items = {{1'000'000, 0, naive::randomItems(random, fractal.sets.size(), 0, 4)}};
        const FractalDescription description = fractal.description();
        const Mesh mesh = randomMesh(random);
        const auto built = FractalGraph::build(description, boundingSphere(mesh));
        if (!built) {
            continue; // a shear makes some grow
        }
        const FractalGraph &graph = *built;
        const Folder folder(description);
        const Position looked = std::min<Position>(200, description.levels.levelCount() / 2);
        for (Position position = 0; position < looked; ++position) {
            const Sphere inner = graph.bound(position + 1);
            const Sphere outer = graph.bound(position);
            for (int i = 0; i < 10; ++i) { // points of the inner sphere's surface
                Point point{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
                const long double length = distance(point, glm::dvec3(0));
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    point[axis] = inner.centre[static_cast<int>(axis)] + point[axis] / length * inner.radius;
                }
                QVERIFY(holds(outer, folder.fold(position, point, random), 1e-14L));
            }
        }
    }
}

void TestSphereBounds::boundsHoldTheNextOnesWhereRepeatsMeet()
{
    std::mt19937_64 random(seed(26));
    int looked = 0;
    for (int round = 0; round < 1'000; ++round) {
        const naive::Fractal fractal = randomLongFractal(random);
        const FractalDescription description = fractal.description();
        const LevelSequence &levels = description.levels;
        const auto graph = FractalGraph::build(description, boundingSphere(randomMesh(random)));
        if (levels.levelCount() == 0 || !graph) {
            continue; // a shear makes some grow
        }
        ++looked;
        const Folder folder(description);
        const Position border = levels.locate(random() % levels.levelCount()).end;
        const Position first =
            random() % 2 == 0 ? border - std::min<Position>(border, random() % 200) : random() % levels.levelCount();
        for (Position position = first; position < std::min(first + 100, levels.levelCount()); ++position) {
            const Sphere inner = graph->bound(position + 1);
            for (int i = 0; i < 4; ++i) {
                Point point{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
                const long double length = distance(point, glm::dvec3(0));
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    point[axis] = inner.centre[static_cast<int>(axis)] + point[axis] / length * inner.radius;
                }
                // A sphere of 1e-12 far from the origin is as exact as its centre's last digit.
                const Sphere outer = graph->bound(position);
                const long double most = outer.radius * (1 + 1e-8L) + 1e-16L * glm::length(outer.centre);
                QVERIFY(distance(folder.fold(position, point, random), outer.centre) <= most);
            }
        }
    }
    QVERIFY(looked > 500);
}

/// A million steps of a copy of a cluster, and clusters of all that.
void TestSphereBounds::whatGrowsLeavesTheRestTight()
{
    constexpr std::uint64_t many = 1'000'000;
    naive::Fractal fractal;
    fractal.maps = {mapFromParts({1, 0, 0}, {0, 0, 0}, glm::dvec3(1)),
                    mapFromParts({3, 0, 0}, {0, 40, 0}, glm::dvec3(0.5)),
                    mapFromParts({-3, 0, 0}, {0, 0, 20}, glm::dvec3(0.5))};
    fractal.sets = {{{0}, true}, {{1, 2}, false}};
    const auto boundAt = [&](Position position) {
        return FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1}).value().bound(position);
    };
    fractal.items = {{many, 0, {{0, 1, {}}}}};
    const double cluster = boundAt(0).radius;
    QVERIFY(cluster < 20);
    fractal.items = {{many, 0, {{0, 1, {}}}}, {many, 0, {{0, 0, {}}}}, {many, 0, {{0, 1, {}}}}};
    QVERIFY(std::abs(boundAt(2 * many).radius - cluster) < 0.01 * cluster);
    const double row = boundAt(many).radius;
    QVERIFY(row > 0.5e6 && row < 1.01e6);
    const double clusters = boundAt(0).radius;
    QVERIFY(clusters < 1.1 * cluster); // the row shrinks to nothing in a million levels
    QVERIFY(boundAt(many - 1).radius < 0.6 * row);
    fractal.maps[1].translation = {1'000, 0, 0};
    fractal.sets[1].maps = {1};
    fractal.items = {{many, 0, {{0, 0, {}}}}, {0, 1, {}}};
    QVERIFY(holds(boundAt(0), {many + 1'000.5L, 0, 0}));
}

void TestSphereBounds::foldedPointsStayInsideAtGreatDepth_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake"}) {
        QTest::newRow(name) << QString::fromLatin1(name) << 100'000;
    }
    QTest::newRow("romanesco") << "romanesco" << 2'000;
}

void TestSphereBounds::foldedPointsStayInsideAtGreatDepth()
{
    QFETCH(QString, name);
    QFETCH(int, depth);
    const Sample fractal = sample(name, static_cast<std::uint64_t>(depth));
    const Folder folder(fractal.description);
    std::mt19937_64 random(seed(23));
    const std::vector<Point> vertices = points(fractal.mesh);
    for (int round = 0; round < 3; ++round) {
        Point point = vertices[random() % vertices.size()];
        const Position count = fractal.graph.levels().levelCount();
        for (Position position = count; position-- > 0;) {
            point = folder.fold(position, point, random);
            const bool isLooked = position < 50 || count - position < 200 || position % 997 == 0;
            if (isLooked) {
                QVERIFY(holds(fractal.graph.bound(position), point));
            }
        }
    }
}

void TestSphereBounds::attractorsStayInsideAtTheGreatestDepths_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void TestSphereBounds::attractorsStayInsideAtTheGreatestDepths()
{
    // After 3,000 contractions any start is within 1e-13 of a point of the fractal.
    QFETCH(QString, name);
    const std::uint64_t depth = name == QLatin1String("romanesco") ? 1ull << 55 : 1ull << 62;
    const Sample fractal = sample(name, name == QLatin1String("appendix-b") ? depth - 1 : depth);
    const Folder folder(fractal.description);
    const std::vector<Point> vertices = points(fractal.mesh);
    std::mt19937_64 random(seed(24));
    for (int round = 0; round < 20; ++round) {
        const Position end = round % 2 == 0 ? 3'000 : 3'000 + random() % (fractal.graph.levels().levelCount() - 4'000);
        Point point = vertices[random() % vertices.size()];
        for (Position position = end; position-- > end - 3'000;) {
            point = folder.fold(position, point, random);
        }
        QVERIFY(holds(fractal.graph.bound(end - 3'000), point, 1e-9L));
    }
}

void TestSphereBounds::boundsDoNotGrowWithTheDepth_data()
{
    attractorsStayInsideAtTheGreatestDepths_data();
}

void TestSphereBounds::boundsDoNotGrowWithTheDepth()
{
    QFETCH(QString, name);
    const double shallow = sample(name, 40).graph.bound(0).radius;
    for (const std::uint64_t depth : {1'000ull, 1'000'000ull, 1ull << 54}) {
        const double deep = sample(name, depth).graph.bound(0).radius;
        QVERIFY2(std::abs(deep - shallow) <= 0.06 * shallow,
                 qPrintable(QString::number(deep) + " " + QString::number(shallow)));
    }
}

void TestSphereBounds::movesAloneAreBoundedByTheirSum_data()
{
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<bool>("mayPass");
    for (const quint64 depth :
         {quint64(1), quint64(1'000), quint64(70'000), quint64(1'000'000'000), quint64(1) << 62}) {
        QTest::addRow("%llu", depth) << depth << false;
        QTest::addRow("%llu with #", depth) << depth << true;
    }
}

void TestSphereBounds::movesAloneAreBoundedByTheirSum()
{
    QFETCH(quint64, depth);
    QFETCH(bool, mayPass);
    naive::Fractal fractal;
    fractal.maps = {{glm::dmat3(1), {1, 0, 0}}};
    fractal.sets = {{{0}, mayPass}};
    fractal.items = {{depth, 0, {{0, 0, {}}}}};
    const Sphere base{{0, 0.5, 0}, 1};
    const auto graph = FractalGraph::build(fractal.description(), base);
    QVERIFY(graph.has_value());
    const auto count = static_cast<long double>(depth);
    for (const long double part : {0.0L, 0.25L, 1.0L}) {
        const Position position = static_cast<Position>(count * part);
        const long double left = static_cast<long double>(depth - position);
        const Sphere bound = graph->bound(position);
        QVERIFY(holds(bound, {left + 1, 0.5L, 0}));
        QVERIFY(!mayPass || holds(bound, {-1, 0.5L, 0}));
        QVERIFY(bound.radius <= 1.01L * left + 4);
    }
}

void TestSphereBounds::growthIsFollowedAsFarAsNumbersGo()
{
    naive::Fractal fractal;
    fractal.maps = {{glm::dmat3(2), {1, 0, 0}}, {glm::dmat3(0.5), {0, 1, 0}}, {glm::dmat3(1e200), {0, 0, 0}}};
    fractal.sets = {{{0, 1}, true}, {{2}, false}};
    const Sphere base{{0, 0, 0}, 1};
    fractal.items = {{400, 0, {{0, 0, {}}}}};
    const auto large = FractalGraph::build(fractal.description(), base);
    QVERIFY(large.has_value());
    const long double farthest = std::ldexp(2.0L, 400) - 1; // x ↦ 2x + 1, from 1
    QVERIFY(holds(large->bound(0), {farthest, 0, 0}));
    QVERIFY(large->bound(0).radius < 2.1L * farthest);

    // Beyond that the map that enlarges is to blame, not one that no level has.
    for (const std::uint64_t depth : {2'000ull, 1'000'000ull, 1ull << 62}) {
        fractal.items = {{depth, 0, {{0, 0, {}}}}};
        const auto beyond = FractalGraph::build(fractal.description(), base);
        QVERIFY(!beyond.has_value());
        QCOMPARE(beyond.error(), (SourceRange{0, 1}));
    }

    // Where nothing enlarges, the farthest move is; and else the mesh.
    fractal.maps = {{glm::dmat3(0.5), {1e200, 0, 0}}, {glm::dmat3(0.5), {1e300, 0, 0}}};
    fractal.sets = {{{0, 1}, true}};
    fractal.items = {{0, 0, {}}};
    FractalDescription description = fractal.description();
    description.meshRange = {77, 78};
    const auto moved = FractalGraph::build(description, base);
    QVERIFY(!moved.has_value());
    QCOMPARE(moved.error(), (SourceRange{1, 2}));
    fractal.maps = {{glm::dmat3(0.5), {1, 0, 0}}, {glm::dmat3(0.5), {2, 0, 0}}};
    description = fractal.description();
    description.meshRange = {77, 78};
    const auto mesh = FractalGraph::build(description, Sphere{{0, 0, 0}, 1e200});
    QVERIFY(!mesh.has_value());
    QCOMPARE(mesh.error(), (SourceRange{77, 78}));
}

void TestSphereBounds::slowGrowthIsFollowedThroughNestedRepeats()
{
    // ((A)^200 B)^400 with A: x ↦ 1.001 x + 1 and B: x ↦ 0.9 x + 2 along one axis, where bounds about the origin are exact.
    naive::Fractal fractal;
    fractal.maps = {{glm::dmat3(1.001), {1, 0, 0}}, {glm::dmat3(0.9), {2, 0, 0}}};
    fractal.sets = {{{0}, false}, {{1}, false}};
    fractal.items = {{400, 0, {{200, 0, {{0, 0, {}}}}, {0, 1, {}}}}};
    const FractalGraph graph = FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1}).value();
    long double farthest = 1;
    for (Position position = 400 * 201; position-- > 0;) {
        const bool isB = position % 201 == 200;
        farthest = isB ? 0.9L * farthest + 2 : 1.001L * farthest + 1;
        const bool isBeyondTheTail = 400 * 201 - position > 65'536;
        if (isBeyondTheTail && position % 37 == 0) {
            const Sphere bound = graph.bound(position);
            QVERIFY(holds(bound, {farthest, 0, 0}));
            QVERIFY(bound.radius <= 1.001L * farthest);
        }
    }
}

void TestSphereBounds::buildingTakesKilobytesAtAnyDepth()
{
    for (const char *name : {"sierpinski", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        const std::size_t shallow = sample(QString::fromLatin1(name), 100).graph.memoryUse();
        const std::size_t deep = sample(QString::fromLatin1(name), 1ull << 55).graph.memoryUse();
        QVERIFY2(deep <= shallow + 4'096, name);
        QVERIFY2(deep < 300'000, name);
    }
}

void TestSphereBounds::theEndIsTheMesh()
{
    const Sample fractal = sample(QStringLiteral("tree"), 9);
    const Sphere end = fractal.graph.bound(fractal.graph.levels().levelCount());
    QVERIFY(end.centre == fractal.graph.base().centre);
    QCOMPARE(end.radius, fractal.graph.base().radius);
    const FractalGraph single = FractalGraph::ofMesh(Sphere{{1, 2, 3}, 4});
    QVERIFY(single.bound(0).centre == glm::dvec3(1, 2, 3));
    QCOMPARE(single.levels().levelCount(), Position(0));
    QVERIFY(single.reach(0).reachesEnd);
}

}

ROMANESCO_TEST(romanesco::test::TestSphereBounds)

#include "testspherebounds.moc"
