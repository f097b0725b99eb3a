// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/simplecollider.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "core/fractal/counts.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const Mesh triangle{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};

}

class TestSimpleCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsNearerThanWhatIsFound_data();
    void nothingIsNearerThanWhatIsFound();
    void theRadiusEndsTheSearch();
    void theDirectionIsTheContactNormal();
};

void TestSimpleCollider::nothingIsNearerThanWhatIsFound_data()
{
    QTest::addColumn<double>("largest");
    QTest::newRow("contracting") << 0.5;
    QTest::newRow("hardly contracting") << 0.97;
    QTest::newRow("growing") << 1.3;
}

void TestSimpleCollider::nothingIsNearerThanWhatIsFound()
{
    QFETCH(double, largest);
    std::mt19937_64 random(seed(1));
    for (int i = 0; i < 25; ++i) {
        const RandomFractal sample = randomFractalWithMesh(random, largest);
        const SimpleCollider collider(sample.graph, sample.mesh);
        const auto search = collider.search();
        Hit hit;
        for (int j = 0; j < 4; ++j) {
            const glm::dvec3 p = randomPoint(random, 6.0);
            search->closest({p}, hit);
            const Wide truth = distanceToAll(sample, p);
            const Wide tolerance = 1e-13 * (1 + truth + sample.graph.bound(0).radius);
            QVERIFY(hit.promise == Promise::Exact);
            QVERIFY(abs(hit.distance - truth) <= tolerance);
            QVERIFY(hit.lower <= truth + tolerance && hit.lower >= hit.distance - tolerance);
            QVERIFY(std::abs(glm::distance(hit.point, p) - hit.distance) <= tolerance);
            QVERIFY(abs(distanceToCopy(sample.fractal, sample.mesh, picksOf(hit.address, sample.fractal), p) - truth)
                    <= tolerance);
            QCOMPARE(Count(hit.cost.faceTests).toString(),
                     (*instancesDistinct(sample.graph) * Count(sample.mesh.faces.size())).toString());
        }
    }
}

void TestSimpleCollider::theRadiusEndsTheSearch()
{
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(triangle));
    const SimpleCollider collider(graph, triangle);
    Hit hit;
    collider.search()->closest({{1, 1, 2}, 1.9}, hit);
    QVERIFY(!hit.isFound());
    QVERIFY(hit.lower > 1.9 && hit.lower <= 2.0);
    collider.search()->closest({{1, 1, 2}, 2.0}, hit);
    QVERIFY(hit.isFound());
    QCOMPARE(hit.distance, 2.0);
    QCOMPARE(hit.point, glm::dvec3(1, 1, 0));
}

void TestSimpleCollider::theDirectionIsTheContactNormal()
{
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(triangle));
    const SimpleCollider collider(graph, triangle);
    Hit hit;
    const auto directionFrom = [&](const glm::dvec3 &p) {
        collider.search()->closest({p}, hit);
        return hit.direction;
    };
    QCOMPARE(directionFrom({1, 1, 3}), glm::dvec3(0, 0, 1));
    QCOMPARE(directionFrom({1, 1, -1e-200}), glm::dvec3(0, 0, -1));
    QCOMPARE(directionFrom({1, 1, 0}), glm::dvec3(0, 0, 1));
    QCOMPARE(directionFrom({-2, 0, 0}), glm::dvec3(-1, 0, 0));
    const Mesh point{{{1, 2, 3}}, {{0, 0, 0}}};
    const FractalGraph graphOfPoint = FractalGraph::ofMesh(boundingSphere(point));
    SimpleCollider(graphOfPoint, point).search()->closest({{1, 2, 3}}, hit);
    QCOMPARE(hit.direction, glm::dvec3(0, 1, 0));
    QCOMPARE(hit.distance, 0.0);
}

}

ROMANESCO_TEST(romanesco::test::TestSimpleCollider)

#include "testsimplecollider.moc"
