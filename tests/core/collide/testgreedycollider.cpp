// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/greedycollider.h"

#include <QTest>

#include "core/collide/simplecollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// 4.4.3 by the letter, over the transformations of one iteration: the distance at which it ends.
Wide descended(const naive::Fractal &fractal, const Mesh &mesh, const std::vector<naive::Picks> &iteration, int depth,
               const glm::dvec3 &p)
{
    naive::Picks chosen;
    Wide distance = 0;
    for (int step = 0; step < depth; ++step) {
        naive::Picks nearest;
        for (const naive::Picks &way : iteration) {
            naive::Picks picks = chosen;
            picks.insert(picks.end(), way.begin(), way.end());
            const Wide candidate = distanceToCopy(fractal, mesh, picks, p);
            if (nearest.empty() || candidate < distance) {
                distance = candidate;
                nearest = picks;
            }
        }
        chosen = nearest;
    }
    return distance;
}

}

class TestGreedyCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachStepLooksAtOneIteration_data();
    void eachStepLooksAtOneIteration();
    void itDescendsAsTheDissertationSays();
    void whatItFindsIsOnTheSurface();
    void itIsRightOnSierpinskiAndWrongOnTwoSets();
    void depthsWithoutEndAreRefused();
};

void TestGreedyCollider::eachStepLooksAtOneIteration_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<int>("tests"); // b·t·d
    QTest::newRow("appendix B") << "appendix-b" << 6 << 14 * 25 * 6;
    QTest::newRow("Menger") << "menger" << 5 << 12 * 20 * 5;
    QTest::newRow("Sierpinski") << "sierpinski" << 8 << 4 * 4 * 8;
    QTest::newRow("two sets of 7") << "two-sets" << 3 << 10 * 49 * 3;
}

void TestGreedyCollider::eachStepLooksAtOneIteration()
{
    QFETCH(QString, name);
    QFETCH(int, depth);
    QFETCH(int, tests);
    const auto [description, mesh, graph] = sample(name, static_cast<std::uint64_t>(depth));
    const auto collider = GreedyCollider::create(graph, mesh);
    Hit hit;
    collider->search()->closest({{3, 2, 1}}, hit);
    QCOMPARE(hit.cost.faceTests, static_cast<std::uint64_t>(tests));
    QCOMPARE(hit.cost.nodeVisits, static_cast<std::uint64_t>(depth));
    QVERIFY(hit.promise == Promise::UpperBound && hit.lower == 0.0);
}

void TestGreedyCollider::itDescendsAsTheDissertationSays()
{
    std::mt19937_64 random(seed(2));
    for (int i = 0; i < 40; ++i) {
        naive::Fractal fractal;
        fractal.maps = {randomMap(random, 0.6), randomMap(random, 0.6), randomMap(random, 0.6)};
        fractal.sets = {{{0, 1, 2}, false}, {{2, 1}, false}};
        fractal.items = {{3, 0, {{0, 0, {}}, {0, 1, {}}}}};
        std::vector<naive::Picks> iteration;
        for (const int outer : fractal.sets[0].maps) {
            for (const int inner : fractal.sets[1].maps) {
                iteration.push_back({outer, inner});
            }
        }
        const Mesh mesh = randomMesh(random);
        const FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
        const auto collider = GreedyCollider::create(graph, mesh);
        const glm::dvec3 p = randomPoint(random, 4.0);
        Hit hit;
        collider->search()->closest({p}, hit);
        const Wide truth = descended(fractal, mesh, iteration, 3, p);
        QVERIFY(abs(hit.distance - truth) <= 1e-12 * (1 + truth));
    }
}

void TestGreedyCollider::whatItFindsIsOnTheSurface()
{
    std::mt19937_64 random(seed(3));
    for (int i = 0; i < 25; ++i) {
        const RandomFractal sample = randomFractalWithMesh(random, 0.7);
        const auto collider = GreedyCollider::create(sample.graph, sample.mesh);
        const glm::dvec3 p = randomPoint(random, 6.0);
        Hit hit;
        collider->search()->closest({p}, hit);
        const naive::Picks picks = picksOf(hit.address, sample.fractal);
        QVERIFY(naive::allPicks(sample.fractal.levels()).contains(picks));
        const Wide truth = distanceToCopy(sample.fractal, sample.mesh, picks, p);
        QVERIFY(abs(hit.distance - truth) <= 1e-12 * (1 + truth));
    }
}

void TestGreedyCollider::itIsRightOnSierpinskiAndWrongOnTwoSets()
{
    std::mt19937_64 random(seed(4));
    const auto wrong = [&](const char *name) {
        const auto [description, mesh, graph] = sample(QLatin1String(name), 2);
        const SimpleCollider oracle(graph, mesh);
        const auto collider = GreedyCollider::create(graph, mesh);
        const double size = graph.bound(0).radius;
        int count = 0;
        for (int i = 0; i < 30; ++i) {
            const glm::dvec3 p = graph.bound(0).centre + randomPoint(random, size);
            Hit found;
            Hit truth;
            collider->search()->closest({p}, found);
            oracle.search()->closest({p}, truth);
            count += found.distance > truth.distance * (1 + 1e-6) ? 1 : 0;
        }
        return count;
    };
    QCOMPARE(wrong("sierpinski"), 0);
    QVERIFY(wrong("two-sets") > 10);
}

void TestGreedyCollider::depthsWithoutEndAreRefused()
{
    const auto [description, mesh, graph] = sample(QStringLiteral("sierpinski"), 2'000'000);
    const auto collider = GreedyCollider::create(graph, mesh);
    QVERIFY(!collider);
    QVERIFY(collider.error().contains("2000000"));
}

}

ROMANESCO_TEST(romanesco::test::TestGreedyCollider)

#include "testgreedycollider.moc"
