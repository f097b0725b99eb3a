// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/physics/supports.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/collide/bruteforce.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

glm::dvec3 randomDirection(std::mt19937_64 &random)
{
    return glm::normalize(randomPoint(random, 1.0));
}

}

class TestSupports : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsAllowedIsTheNearest();
    void nothingIsLeftBetweenOpposites();
    void alongIsAcrossAll();
    void sameDirectionsCountOnce();
    void thereIsAnEndToThem();
};

/// By the inequality that only the nearest point of a convex set fulfils: no point of it is ahead of what is missing.
void TestSupports::whatIsAllowedIsTheNearest()
{
    std::mt19937_64 random(seed(1));
    int changed = 0;
    for (int round = 0; round < 3000; ++round) {
        Supports supports;
        const glm::dvec3 open = randomDirection(random);
        const std::size_t count = random() % 6 + 1;
        while (supports.count() < count) {
            const glm::dvec3 n = randomDirection(random);
            if (round % 3 == 0 || glm::dot(n, open) > 0) {
                supports.add(n);
            }
        }
        const glm::dvec3 v = randomPoint(random, 1.0);
        const glm::dvec3 allowed = supports.allowed(v);
        QVERIFY(glm::length(allowed) <= glm::length(v) * (1 + 1e-15));
        for (const glm::dvec3 &n : supports.directions()) {
            QVERIFY(glm::dot(allowed, n) >= -1e-11);
        }
        QVERIFY(std::abs(glm::dot(v - allowed, allowed)) < 1e-11);
        changed += allowed != v ? 1 : 0;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 other = randomPoint(random, 2.0);
            const bool isAllowed = std::ranges::all_of(supports.directions(),
                                                       [&](const glm::dvec3 &n) { return glm::dot(other, n) >= 0; });
            QVERIFY(!isAllowed || glm::dot(v - allowed, other) <= 1e-11);
        }
    }
    QVERIFY(changed > 1500);
}

void TestSupports::nothingIsLeftBetweenOpposites()
{
    Supports supports;
    for (const glm::dvec3 &n : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)}) {
        supports.add(n);
    }
    QCOMPARE(supports.allowed({3, 4, 5}), glm::dvec3(0, 0, 5));
    supports.add({0, 0, -1});
    QCOMPARE(supports.allowed({3, 4, 5}), glm::dvec3(0));
}

void TestSupports::alongIsAcrossAll()
{
    std::mt19937_64 random(seed(2));
    for (int round = 0; round < 1000; ++round) {
        Supports supports;
        for (std::uint64_t i = random() % 4; i > 0; --i) {
            supports.add(randomDirection(random));
        }
        const glm::dvec3 v = randomPoint(random, 1.0);
        const glm::dvec3 along = supports.along(v);
        for (const glm::dvec3 &n : supports.directions()) {
            QVERIFY(std::abs(glm::dot(along, n)) < 1e-9);
        }
        if (supports.count() == 1) {
            const glm::dvec3 n = supports.directions()[0];
            QVERIFY(glm::distance(along, v - glm::dot(v, n) * n) < 1e-14);
        }
        QVERIFY(supports.count() < 3 || along == glm::dvec3(0));
        QVERIFY(!supports.isEmpty() || along == v);
    }
}

void TestSupports::sameDirectionsCountOnce()
{
    Supports supports;
    QVERIFY(supports.add({0, 1, 0}));
    QVERIFY(supports.add(glm::normalize(glm::dvec3(1e-10, 1, 0))));
    QCOMPARE(supports.count(), std::size_t{1});
    QVERIFY(supports.holds({0, 1, 0}) && !supports.holds({0, 0, 1}));
    QVERIFY(supports.add(glm::normalize(glm::dvec3(1e-3, 1, 0))));
    QCOMPARE(supports.count(), std::size_t{2});
    supports.keepIf([](const glm::dvec3 &n) { return n.x < 1e-6; });
    QCOMPARE(supports.count(), std::size_t{1});
}

void TestSupports::thereIsAnEndToThem()
{
    std::mt19937_64 random(seed(3));
    Supports supports;
    while (supports.count() < Supports::most) {
        QVERIFY(supports.add(randomDirection(random)));
    }
    QVERIFY(!supports.add(randomDirection(random)));
    QCOMPARE(supports.count(), Supports::most);
}

}

ROMANESCO_TEST(romanesco::test::TestSupports)

#include "testsupports.moc"
