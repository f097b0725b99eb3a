// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/hullbounds.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/fractal/randomfractals.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Affine;
using naive::Fractal;
using naive::Point;

long double along(const Point &point, const glm::dvec3 &direction)
{
    return point[0] * direction.x + point[1] * direction.y + point[2] * direction.z;
}

/// How far a point is beyond the hull in a direction.
long double beyond(const std::vector<glm::dvec3> &corners, const glm::dvec3 &centre, const Point &point,
                   const glm::dvec3 &direction)
{
    long double reach = -INFINITY;
    for (const glm::dvec3 &corner : corners) {
        const glm::dvec3 place = corner + centre;
        reach = std::max(reach, along({place.x, place.y, place.z}, direction));
    }
    return along(point, direction) - reach;
}

std::vector<glm::dvec3> directions(std::mt19937_64 &random)
{
    std::vector<glm::dvec3> result;
    for (int i = 0; i < 20; ++i) {
        std::normal_distribution<double> normal;
        result.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
    }
    return result;
}

bool holds(const HullBounds::Hulls &hulls, const Point &point, const std::vector<glm::dvec3> &ways)
{
    const long double slack = 1e-15L * (1 + std::abs(point[0]) + std::abs(point[1]) + std::abs(point[2]));
    return std::ranges::all_of(ways, [&](const glm::dvec3 &way) {
        return beyond(hulls.fine.corners, glm::dvec3(0), point, way) <= hulls.fine.error + slack
            && beyond(hulls.coarse.corners, hulls.centre, point, way) <= hulls.coarse.error + slack;
    });
}

}

class TestHullBounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPositionsHullHoldsWhatFollows_data();
    void everyPositionsHullHoldsWhatFollows();
    void foldedPointsStayInsideAtGreatDepth_data();
    void foldedPointsStayInsideAtGreatDepth();
    void examplesHaveTightHulls_data();
    void examplesHaveTightHulls();
    void boxesThatAreHullsHaveNone();
    void whatIsTooMuchHasNone();
    void aStopLeavesNone();
    void errorsOfWhatFollowsCount();
    void sharedHullsHoldTheImagesOfOneAnother_data();
    void sharedHullsHoldTheImagesOfOneAnother();
    void coarseHullsHaveTheErrorsOfFineOnes();
};

void TestHullBounds::everyPositionsHullHoldsWhatFollows_data()
{
    QTest::addColumn<double>("largest");
    QTest::newRow("contracting") << 0.5;
    QTest::newRow("hardly contracting") << 0.97;
    QTest::newRow("growing") << 1.7;
}

void TestHullBounds::everyPositionsHullHoldsWhatFollows()
{
    QFETCH(const double, largest);
    std::mt19937_64 random(seed(91));
    int looked = 0;
    for (int round = 0; round < 80; ++round) {
        const Fractal fractal = randomFractal(random, largest);
        const Mesh mesh = randomMesh(random);
        const FractalGraph graph = graphOf(fractal, mesh);
        const BoxBounds boxes(graph, mesh);
        const HullBounds hulls(graph, boxes, mesh);
        const naive::Levels levels = fractal.levels();
        const std::vector<glm::dvec3> ways = directions(random);
        std::vector<Point> all = points(mesh);
        for (Position position = levels.size();; --position) {
            if (const HullBounds::Hulls *hull = hulls.at(graph, position)) {
                for (const Point &point : all) {
                    ++looked;
                    QVERIFY2(holds(*hull, point, ways),
                             qPrintable(QStringLiteral("round %1 position %2").arg(round).arg(position)));
                }
            }
            if (position == 0) {
                break;
            }
            const naive::Level &level = levels[position - 1];
            std::vector<Point> longer;
            if (level.mayPass) {
                longer = all;
            }
            for (const int map : level.maps) {
                for (const Point &point : all) {
                    longer.push_back(
                        naive::applied(naive::fromCore(fractal.maps[static_cast<std::size_t>(map)]), point));
                }
            }
            all = std::move(longer);
        }
    }
    QVERIFY(looked > 10'000);
}

void TestHullBounds::foldedPointsStayInsideAtGreatDepth_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"sierpinski", "tree", "appendix-b", "two-sets", "snowflake"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void TestHullBounds::foldedPointsStayInsideAtGreatDepth()
{
    QFETCH(const QString, name);
    const Sample fractal = sample(name, 3'000);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const HullBounds hulls(fractal.graph, boxes, fractal.mesh);
    const Folder folder(fractal.description);
    std::mt19937_64 random(seed(92));
    const std::vector<glm::dvec3> ways = directions(random);
    const std::vector<Point> vertices = points(fractal.mesh);
    for (int round = 0; round < 5; ++round) {
        Point point = vertices[random() % vertices.size()];
        for (Position position = fractal.graph.levels().levelCount(); position-- > 0;) {
            point = folder.fold(position, point, random);
            const HullBounds::Hulls *hull = hulls.at(fractal.graph, position);
            QVERIFY(hull && holds(*hull, point, ways));
        }
    }
}

void TestHullBounds::examplesHaveTightHulls_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("corners");
    QTest::newRow("sierpinski") << "sierpinski" << 4;
    QTest::newRow("tree") << "tree" << 96;
    QTest::newRow("appendix-b") << "appendix-b" << 96;
    QTest::newRow("two-sets") << "two-sets" << 96;
    QTest::newRow("snowflake") << "snowflake" << 96;
}

void TestHullBounds::examplesHaveTightHulls()
{
    QFETCH(const QString, name);
    QFETCH(const int, corners);
    for (const std::uint64_t depth : {5ull, 1'000'000ull}) {
        const Sample fractal = sample(name, depth);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const HullBounds hulls(fractal.graph, boxes, fractal.mesh);
        const double size = glm::length(boxes.at(fractal.graph, 0).size());
        const HullBounds::Hulls *whole = hulls.at(fractal.graph, 0);
        QVERIFY(whole);
        QVERIFY(whole->fine.corners.size() <= static_cast<std::size_t>(corners));
        QVERIFY(whole->coarse.corners.size() <= 16);
        QVERIFY2(whole->fine.error < 0.01 * size, qPrintable(QString::number(whole->fine.error / size)));
        QVERIFY2(whole->coarse.error < 0.06 * size, qPrintable(QString::number(whole->coarse.error / size)));
    }
}

void TestHullBounds::boxesThatAreHullsHaveNone()
{
    const Sample fractal = sample(QStringLiteral("menger"), 20);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const HullBounds hulls(fractal.graph, boxes, fractal.mesh);
    for (Position position = 0; position <= 20; ++position) {
        QVERIFY(!hulls.at(fractal.graph, position));
    }
}

/// A row of 10^9, and a mesh without faces.
void TestHullBounds::whatIsTooMuchHasNone()
{
    Fractal fractal;
    fractal.maps = {mapFromParts({1, 0, 0}, {0, 0, 0}, glm::dvec3(1))};
    fractal.sets = {{{0}, true}};
    fractal.items = {{1'000'000'000, 0, {{0, 0, {}}}}};
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces.push_back({0, 1, 2});
    const FractalGraph row = graphOf(fractal, mesh);
    const BoxBounds rowBoxes(row, mesh);
    QVERIFY(!HullBounds(row, rowBoxes, mesh).at(row, 0));

    const Sphere none = boundingSphere(Mesh{});
    const FractalGraph empty = FractalGraph::ofMesh(none);
    const BoxBounds emptyBoxes(empty, Mesh{});
    QVERIFY(!HullBounds(empty, emptyBoxes, Mesh{}).at(empty, 0));
}

void TestHullBounds::aStopLeavesNone()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.faces.push_back({0, 1, 2});
    mesh.faces.push_back({0, 1, 3});
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(mesh));
    const BoxBounds boxes(graph, mesh);
    QVERIFY(HullBounds(graph, boxes, mesh).at(graph, 0));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!HullBounds(graph, boxes, mesh, stop.get_token()).at(graph, 0));
}

/// A round mesh has more corners than are kept, at each level.
void TestHullBounds::errorsOfWhatFollowsCount()
{
    std::mt19937_64 random(seed(93));
    Mesh mesh;
    std::normal_distribution<double> normal;
    for (std::uint32_t i = 0; i < 600; i += 3) {
        for (int corner = 0; corner < 3; ++corner) {
            mesh.vertices.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
        }
        mesh.faces.push_back({i, i + 1, i + 2});
    }
    Fractal fractal;
    fractal.maps = {mapFromParts({0.02, 0, 0}, {10, 20, 30}, glm::dvec3(0.99)),
                    mapFromParts({0, 0.02, 0}, {-40, 0, 70}, glm::dvec3(0.99))};
    fractal.sets = {{{0}, false}, {{1}, false}};
    fractal.items = {{0, 0, {}}, {0, 1, {}}, {0, 0, {}}, {0, 1, {}}};
    const FractalGraph graph = graphOf(fractal, mesh);
    const BoxBounds boxes(graph, mesh);
    const HullBounds hulls(graph, boxes, mesh);
    std::vector<Point> all = points(mesh);
    for (const int map : {1, 0, 1, 0}) {
        for (Point &point : all) {
            point = naive::applied(naive::fromCore(fractal.maps[static_cast<std::size_t>(map)]), point);
        }
    }
    std::vector<glm::dvec3> ways;
    const glm::dvec3 middle = boxes.at(graph, 0).centre();
    for (const Point &point : all) {
        ways.push_back(glm::normalize(glm::dvec3(point[0], point[1], point[2]) - middle));
    }
    const HullBounds::Hulls &hull = *hulls.at(graph, 0);
    long double fine = 0;
    long double coarse = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        fine = std::max(fine, beyond(hull.fine.corners, glm::dvec3(0), all[i], ways[i]));
        coarse = std::max(coarse, beyond(hull.coarse.corners, hull.centre, all[i], ways[i]));
    }
    QVERIFY2(fine <= hull.fine.error && fine > 0.5L * hull.fine.error,
             qPrintable(QString::number(double(fine / hull.fine.error))));
    QVERIFY2(coarse <= hull.coarse.error, qPrintable(QString::number(double(coarse / hull.coarse.error))));
}

void TestHullBounds::sharedHullsHoldTheImagesOfOneAnother_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"sierpinski", "tree", "appendix-b", "two-sets", "snowflake"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

/// With their errors: what holds then holds at any depth.
void TestHullBounds::sharedHullsHoldTheImagesOfOneAnother()
{
    QFETCH(const QString, name);
    const Sample fractal = sample(name, 1'000);
    const FractalGraph &graph = fractal.graph;
    const BoxBounds boxes(graph, fractal.mesh);
    const HullBounds hulls(graph, boxes, fractal.mesh);
    for (Position position = 300; position < 304; ++position) {
        const Hull &outer = hulls.at(graph, position)->fine;
        const Hull &inner = hulls.at(graph, position + 1)->fine;
        const SetId set = graph.levels().set(graph.levels().locate(position).slot);
        for (std::size_t i = 0; i < graph.set(set).maps.size(); ++i) {
            for (const glm::dvec3 &corner : inner.corners) {
                const double outside = distanceToHull(outer.corners, graph.set(set).maps[i](corner)).least;
                QVERIFY(outside + graph.facts(set)[i].norm * inner.error <= outer.error * (1 + 1e-9));
            }
        }
    }
}

/// A corner that is too flat to be kept.
void TestHullBounds::coarseHullsHaveTheErrorsOfFineOnes()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, 0.3, -1e-12}};
    mesh.faces.push_back({0, 1, 2});
    mesh.faces.push_back({0, 1, 3});
    mesh.faces.push_back({0, 1, 4});
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(mesh));
    const BoxBounds boxes(graph, mesh);
    const HullBounds hulls(graph, boxes, mesh);
    const HullBounds::Hulls &hull = *hulls.at(graph, 0);
    QCOMPARE(hull.fine.corners.size(), std::size_t{4});
    QVERIFY(holds(hull, {0.3L, 0.3L, -1e-12L}, {glm::dvec3(0, 0, -1)}));
}
}

ROMANESCO_TEST(romanesco::test::TestHullBounds)

#include "testhullbounds.moc"
