// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/mapfacts.h"

#include <cmath>

#include <QTest>

#include "core/fractal/fractalgraph.h"
#include "tests/core/naive.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestMapFacts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void factsAreTrueOfTheirMap_data();
    void factsAreTrueOfTheirMap();
    void factsStandBesideTheMaps();
};

void TestMapFacts::factsAreTrueOfTheirMap_data()
{
    QTest::addColumn<glm::dvec3>("scale");
    QTest::addColumn<double>("shear");
    QTest::addColumn<double>("norm");
    QTest::addColumn<bool>("isSimilarity");
    QTest::addColumn<int>("sign");
    QTest::newRow("scaled") << glm::dvec3(0.3) << 0.0 << 0.3 << true << 1;
    QTest::newRow("mirrored") << glm::dvec3(0.3, -0.3, 0.3) << 0.0 << 0.3 << true << -1;
    QTest::newRow("turned by a half") << glm::dvec3(-0.3, -0.3, 0.3) << 0.0 << 0.3 << true << 1;
    QTest::newRow("unequal") << glm::dvec3(0.3, 0.5, 2) << 0.0 << 2.0 << false << 1;
    QTest::newRow("unequal and mirrored") << glm::dvec3(0.3, 0.5, -2) << 0.0 << 2.0 << false << -1;
    QTest::newRow("flat") << glm::dvec3(0.3, 0.3, 0) << 0.0 << 0.3 << false << 0;
    QTest::newRow("sheared") << glm::dvec3(1) << 1.0 << (1 + std::sqrt(5)) / 2 << false << 1;
}

void TestMapFacts::factsAreTrueOfTheirMap()
{
    QFETCH(glm::dvec3, scale);
    QFETCH(double, shear);
    QFETCH(double, norm);
    AffineMap map = mapFromParts({1, 2, 3}, {10, 20, 30}, scale);
    map.linear[1] += shear * map.linear[0];
    const MapFacts facts = factsOf(map);
    QVERIFY(std::abs(facts.norm - norm) < 1e-12);
    QTEST(facts.isSimilarity, "isSimilarity");
    QTEST(facts.sign, "sign");
    QCOMPARE(facts.inverse.has_value(), facts.sign != 0);
    if (facts.inverse) {
        const naive::Point back =
            naive::applied(naive::fromCore(*facts.inverse), naive::applied(naive::fromCore(map), {4, -5, 6}));
        QVERIFY(std::abs(back[0] - 4) + std::abs(back[1] + 5) + std::abs(back[2] - 6) < 1e-13L);
    }
}

void TestMapFacts::factsStandBesideTheMaps()
{
    naive::Fractal fractal;
    for (int i = 1; i <= 4; ++i) {
        fractal.maps.push_back(mapFromParts({0, 0, 0}, {0, 0, 0}, glm::dvec3(0.1 * i)));
    }
    fractal.sets = {{{2, 0}, true}, {{1}, false}, {{3}, false}};
    fractal.items = {{0, 0, {}}, {0, 1, {}}};
    const FractalGraph graph = FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1}).value();
    QCOMPARE(graph.facts(0).size(), 2u);
    QCOMPARE(graph.facts(0)[0].norm, 0.1 * 3);
    QCOMPARE(graph.facts(0)[1].norm, 0.1);
    QCOMPARE(graph.facts(1).size(), 1u);
    QCOMPARE(graph.facts(1)[0].norm, 0.1 * 2);
    QVERIFY(graph.facts(2).empty()); // in no level
}

}

ROMANESCO_TEST(romanesco::test::TestMapFacts)

#include "testmapfacts.moc"
