// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/scene/scene.h"

#include <cmath>
#include <limits>

#include <QTest>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/fractal/extent.h"
#include "core/scene/summary.h"
#include "tests/core/fractal/samples.h"
#include "tests/core/naive.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::shared_ptr<const Model> model(const QString &name, std::uint64_t depth)
{
    Sample made = sample(name, depth);
    const auto mesh = std::make_shared<const Mesh>(std::move(made.mesh));
    BoxBounds boxes(made.graph, *mesh);
    const Box box = extent(made.graph, boxes, *mesh);
    return std::make_shared<const Model>(Model{mesh, std::move(made.graph), std::move(boxes), box, {}});
}

std::shared_ptr<const Model> triangle()
{
    const auto mesh = std::make_shared<const Mesh>(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    FractalGraph graph = FractalGraph::ofMesh(boundingSphere(*mesh));
    return std::make_shared<const Model>(Model{mesh, std::move(graph), {}, {{0, 0, 0}, {1, 1, 0}}, {}});
}

/// The vertices of the Sierpinski example, written out by four plain loops in one.
std::vector<glm::dvec3> sierpinskiVertices(const Mesh &mesh, int depth)
{
    std::vector<glm::dvec3> points = mesh.vertices;
    for (int level = 0; level < depth; ++level) {
        std::vector<glm::dvec3> next;
        for (const glm::dvec3 &place : {glm::dvec3(-0.5, 0, 0.28868), glm::dvec3(0.5, 0, 0.28868),
                                        glm::dvec3(0, 0, -0.57735), glm::dvec3(0, 0.8165, 0)}) {
            for (const glm::dvec3 &point : points) {
                next.push_back(place + 0.5 * point);
            }
        }
        points = std::move(next);
    }
    return points;
}

Box boxOf(const std::vector<glm::dvec3> &points)
{
    Box box{glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (const glm::dvec3 &point : points) {
        box.least = glm::min(box.least, point);
        box.greatest = glm::max(box.greatest, point);
    }
    return box;
}

const AffineMap leaning = mapFromParts({5, -2, 30}, {20, 40, 60}, {2, 0.5, 1});

}

class TestScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theBoxOfOneItemIsThatOfItsTransformedPoints_data();
    void theBoxOfOneItemIsThatOfItsTransformedPoints();
    void theBoxHoldsAllItems();
    void aSceneOfNothingHasNoSize();
    void anItemInPlaceIsAsTheModelIs();
    void theSphereHoldsAllItems();
    void sumsCountEveryItem();
    void aSceneOfOneItemIsSummedUpAsItsModel();
};

void TestScene::theBoxOfOneItemIsThatOfItsTransformedPoints_data()
{
    QTest::addColumn<AffineMap>("map");
    QTest::newRow("moved") << AffineMap{glm::dmat3(1.0), {5, -2, 30}};
    QTest::newRow("turned and sheared") << leaning;
    QTest::newRow("mirrored") << mapFromParts({1, 2, 3}, {10, 20, 30}, {-1, 1, 1});
    QTest::newRow("flat") << mapFromParts({1, 2, 3}, {10, 20, 30}, {1, 0, 1});
    QTest::newRow("a line") << mapFromParts({1, 2, 3}, {10, 20, 30}, {0, 0, 3});
    QTest::newRow("a point") << mapFromParts({1, 2, 3}, {10, 20, 30}, {0, 0, 0});
    QTest::newRow("tiny") << mapFromParts({0, 0, 0}, {10, 20, 30}, glm::dvec3(1e-100));
    QTest::newRow("huge") << mapFromParts({0, 0, 0}, {10, 20, 30}, glm::dvec3(1e100));
}

void TestScene::theBoxOfOneItemIsThatOfItsTransformedPoints()
{
    QFETCH(const AffineMap, map);
    const auto sierpinski = model(QStringLiteral("sierpinski"), 4);
    std::vector<glm::dvec3> points = sierpinskiVertices(*sierpinski->mesh, 4);
    for (glm::dvec3 &point : points) {
        point = map(point);
    }
    const Box expected = boxOf(points);
    const Box box = extentOf({{.model = sierpinski, .worldFromModel = map}});
    const double size = std::max(glm::length(expected.size()), glm::length(map.translation));
    QVERIFY(glm::distance(box.least / size, expected.least / size) < 1e-12);
    QVERIFY(glm::distance(box.greatest / size, expected.greatest / size) < 1e-12);
}

void TestScene::theBoxHoldsAllItems()
{
    const auto flat = triangle();
    const auto sierpinski = model(QStringLiteral("sierpinski"), 4);
    const Box alone = extentOf({{.model = sierpinski, .worldFromModel = leaning}});
    std::vector<SceneItem> items{{.model = sierpinski, .worldFromModel = leaning}};
    for (const glm::dvec3 &place : {glm::dvec3(-100, 0, 0), glm::dvec3(0, 200, 0), glm::dvec3(0, 0, 0)}) {
        items.push_back({.model = flat, .worldFromModel = {glm::dmat3(1.0), place}});
    }
    const Box box = extentOf(items);
    QCOMPARE(box.least.x, -100.0);
    QCOMPARE(box.greatest.y, 201.0);
    QVERIFY(std::abs(box.greatest.z - alone.greatest.z) < 1e-12);
    QCOMPARE(box.least.z, 0.0);
}

void TestScene::aSceneOfNothingHasNoSize()
{
    const Box box = extentOf({});
    QVERIFY(box.least == glm::dvec3(0) && box.greatest == glm::dvec3(0));
    QCOMPARE(reachAlong(std::vector<SceneItem>(), {1, 0, 0}), -std::numeric_limits<double>::infinity());
    QVERIFY(boundingSphere(Scene{}).isEmpty());
    const Summary summary = summarise(Scene{});
    QVERIFY(summary.instancesAsWritten.isZero() && !summary.facesPerBase && !summary.levelCount);
}

/// To the last bit, so that pictures and numbers are too.
void TestScene::anItemInPlaceIsAsTheModelIs()
{
    const auto appendixB = model(QStringLiteral("appendix-b"), 6);
    const Box box = extentOf({{.model = appendixB}});
    QVERIFY(box.least == appendixB->extent.least && box.greatest == appendixB->extent.greatest);
    const Scene scene = sceneOf(appendixB);
    QVERIFY(scene.extent.least == box.least && scene.extent.greatest == box.greatest);
    const Sphere bound = boundingSphere(scene);
    QVERIFY(bound.centre == appendixB->graph.bound(0).centre && bound.radius == appendixB->graph.bound(0).radius);
}

void TestScene::theSphereHoldsAllItems()
{
    const auto sierpinski = model(QStringLiteral("sierpinski"), 4);
    Scene scene;
    scene.items = {{.model = sierpinski, .worldFromModel = leaning},
                   {.model = sierpinski, .worldFromModel = {glm::dmat3(-1.0), {0, -9, 0}}}};
    const Sphere bound = boundingSphere(scene);
    for (const SceneItem &item : scene.items) {
        for (const glm::dvec3 &point : sierpinskiVertices(*sierpinski->mesh, 4)) {
            QVERIFY(glm::distance(item.worldFromModel(point), bound.centre) <= bound.radius);
        }
    }
    QVERIFY(bound.radius < 40.0);
}

void TestScene::sumsCountEveryItem()
{
    const auto sierpinski = model(QStringLiteral("sierpinski"), 4); // 256 copies of 4 faces, scale 0.5
    const auto tree = model(QStringLiteral("tree"), 3);             // 125 copies as written, 85 distinct, of 20 faces
    Scene scene;
    scene.items = {{.model = sierpinski}, {.model = tree}, {.model = sierpinski}, {.model = triangle()}};
    const Summary summary = summarise(scene);
    QCOMPARE(summary.instancesAsWritten.toString(), std::string("638"));
    QCOMPARE(summary.instancesDistinct->toString(), std::string("598"));
    QCOMPARE(summary.facesAsWritten.toString(), std::string("4549"));
    QVERIFY(!summary.facesPerBase && !summary.levelCount && !summary.iteration && summary.levelSizes.empty());
    QVERIFY(summary.isContracting);
    QVERIFY(std::abs(summary.contraction->least - 0.5) < 1e-12);
    QVERIFY(std::abs(summary.contraction->greatest - 0.74) < 1e-12);
    QVERIFY(!summary.similarityDimension);
}

void TestScene::aSceneOfOneItemIsSummedUpAsItsModel()
{
    Scene scene;
    scene.items = {{.model = model(QStringLiteral("sierpinski"), 4), .worldFromModel = leaning}};
    const Summary summary = summarise(scene);
    QCOMPARE(*summary.facesPerBase, 4u);
    QCOMPARE(summary.iteration->depth, 4u);
    QVERIFY(std::abs(*summary.similarityDimension - 2.0) < 1e-12); // four copies of a half
    QCOMPARE(summary.instancesAsWritten.toString(), std::string("256"));
}

}

ROMANESCO_TEST(romanesco::test::TestScene)

#include "testscene.moc"
