// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <glm/geometric.hpp>

#include "core/collide/bvhcollider.h"
#include "core/collide/writtenout.h"
#include "tests/core/collide/allocations.h"
#include "tests/core/collide/deepsweeps.h"
#include "tests/core/collide/sweeptruth.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestDeepSweep : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void deepFractalsAreTouchedAtTheRadius_data();
    void deepFractalsAreTouchedAtTheRadius();
    void bothWaysAgree();
    void anOverlapIsTouchedAtOnce();
    void nearMissesAreProved_data();
    void nearMissesAreProved();
    void whatRestsTouchesNothingElse();
    void laterTouchesDoNotCount();
    void aSpentBudgetIsAdmitted();
    void deepFractalsCostLittle();
    void sweepsDoNotAllocateOnceTheyHaveGrown();
};

void TestDeepSweep::deepFractalsAreTouchedAtTheRadius_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    for (const char *name : {"menger", "sierpinski", "tree", "two-sets", "appendix-b", "snowflake"}) {
        for (const quint64 depth : {quint64(4), quint64(40), quint64(1'000'000)}) {
            QTest::addRow("%s %llu", name, depth) << QString::fromLatin1(name) << depth;
        }
    }
}

/// The search for what is nearest tells how far the sphere is from the surface, and so how far it may go on.
void TestDeepSweep::deepFractalsAreTouchedAtTheRadius()
{
    QFETCH(const QString, name);
    QFETCH(const quint64, depth);
    std::mt19937_64 random(seed(61));
    const Deep deep(name, depth);
    const auto search = deep.collider.search();
    const double rounding = 1e-12 * deep.size();
    int touched = 0;
    int missed = 0;
    for (int i = 0; i < 60; ++i) {
        const Sweep sweep = deep.sweep(random, *search);
        Touch touch;
        search->sweep(sweep, touch);
        QVERIFY(touch.promise == Promise::Exact);
        Hit hit;
        if (touch.isFound()) {
            ++touched;
            search->closest({.p = sweep.p + touch.time * sweep.v, .nodeBudget = 10'000}, hit);
            QVERIFY2(hit.lower <= sweep.radius + rounding, qPrintable(words(sweep, touch)));
            QVERIFY(touch.lower >= touch.time - 1.001e-5 * sweep.radius / glm::length(sweep.v) - 1e-6);
            QVERIFY(glm::distance(touch.point, sweep.p + touch.time * sweep.v) <= sweep.radius + rounding);
            search->closest({.p = touch.point, .nodeBudget = 10'000}, hit);
            QVERIFY(hit.lower <= rounding);
        } else {
            ++missed;
            QVERIFY(touch.lower >= 1 - 1e-5);
        }
        double time = 0.0;
        for (int step = 0; step < 100 && time < touch.lower; ++step) {
            search->closest({.p = sweep.p + time * sweep.v, .nodeBudget = 10'000}, hit);
            QVERIFY2(hit.distance >= sweep.radius - rounding, qPrintable(words(sweep, touch)));
            time += std::max(hit.lower - sweep.radius, 1e-3 * sweep.radius) / glm::length(sweep.v);
        }
    }
    QVERIFY2(touched > 0 && missed > 0, qPrintable(QStringLiteral("%1 %2").arg(touched).arg(missed)));
}

/// Similarities too can be swept the other way.
void TestDeepSweep::bothWaysAgree()
{
    std::mt19937_64 random(seed(62));
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        const Deep deep(QLatin1String(name), 6);
        const auto inFrames = deep.collider.search();
        const auto relative = deep.collider.searchPlaced({});
        for (int i = 0; i < 100; ++i) {
            const Sweep sweep = deep.sweep(random, *inFrames);
            Touch one;
            Touch other;
            inFrames->sweep(sweep, one);
            relative->sweep(sweep, other);
            QCOMPARE(one.isFound(), other.isFound());
            QVERIFY(std::max(one.lower, other.lower) <= std::min(one.time, other.time) + 1e-12);
            const double late = 1e-5 * sweep.radius / glm::length(sweep.v);
            QVERIFY(!one.isFound() || std::abs(one.time - other.time) <= late + 1e-9);
        }
    }
}

void TestDeepSweep::anOverlapIsTouchedAtOnce()
{
    std::mt19937_64 random(seed(65));
    for (const char *name : {"menger", "sierpinski", "two-sets"}) {
        const Deep deep(QLatin1String(name), 20);
        const auto search = deep.collider.search();
        std::uint64_t visits = 0;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 p = deep.boxes.at(deep.fractal.graph, 0).centre() + randomPoint(random, 0.4 * deep.size());
            Hit hit;
            search->closest({p}, hit);
            const double radius = hit.distance * (1 + std::pow(10.0, uniform(random, -6, 1)));
            Touch touch;
            const glm::dvec3 v = i % 2 == 0 ? randomPoint(random, 1) : glm::dvec3(0);
            search->sweep({.p = p, .v = v, .radius = radius}, touch);
            QVERIFY(touch.time * glm::length(v) <= 1e-5 * radius && touch.promise == Promise::Exact);
            QVERIFY(touch.lower == 0.0);
            QVERIFY(glm::distance(touch.point, p + touch.time * v) <= radius + 1e-12 * deep.size());
            QVERIFY(glm::dot(touch.direction, p - touch.point) > 0);
            visits += touch.cost.nodeVisits;
        }
        QVERIFY2(visits < 100 * 100, qPrintable(QString::number(visits)));
    }
}

void TestDeepSweep::nearMissesAreProved_data()
{
    QTest::addColumn<double>("amiss");
    for (const double amiss : {1e-3, 1e-5, 1e-7, 1e-9}) {
        QTest::addRow("%g", amiss) << amiss;
    }
}

/// Past a corner, near which there are branches of every size.
void TestDeepSweep::nearMissesAreProved()
{
    QFETCH(const double, amiss);
    const Deep deep(QStringLiteral("menger"), 1000);
    const glm::dvec3 corner = deep.boxes.at(deep.fractal.graph, 0).greatest;
    const glm::dvec3 outwards = glm::normalize(glm::dvec3(1, 1, 1));
    const glm::dvec3 across = glm::normalize(glm::dvec3(1, -1, 0));
    const auto search = deep.collider.search();
    const auto relative = deep.collider.searchPlaced({});
    for (const double radius : {0.3, 0.01}) {
        const glm::dvec3 middle = corner + radius * (1 + amiss) * outwards;
        const Sweep sweep{.p = middle - across, .v = 2.0 * across, .radius = radius};
        for (const auto *asked : {&search, &relative}) {
            Touch touch;
            (*asked)->sweep(sweep, touch);
            QVERIFY2(!touch.isFound() && touch.lower == 1.0, qPrintable(words(sweep, touch)));
            QVERIFY(touch.cost.nodeVisits < 100);
        }
    }
}

void TestDeepSweep::whatRestsTouchesNothingElse()
{
    std::mt19937_64 random(seed(66));
    const Deep deep(QStringLiteral("tree"), 5);
    const auto search = deep.collider.search();
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = randomPoint(random, 3);
        Hit hit;
        search->closest({p}, hit);
        const double radius = std::max(0.0, hit.distance * (1 - 1e-9) - 1e-13 * deep.size());
        Touch touch;
        search->sweep({.p = p, .radius = radius}, touch);
        QVERIFY(!touch.isFound() && touch.lower == 1.0 && touch.promise == Promise::Exact);
        search->sweep({.p = p, .v = {1, 2, 3}, .time = 0.0, .radius = radius}, touch);
        QVERIFY(!touch.isFound() && touch.lower == 0.0);
    }
}

void TestDeepSweep::laterTouchesDoNotCount()
{
    std::mt19937_64 random(seed(67));
    for (const char *name : {"menger", "two-sets"}) {
        const Deep deep(QLatin1String(name), 3);
        const Mesh all = writtenOut(deep.fractal.graph, deep.fractal.mesh, {}, 2'000'000).value();
        const BvhCollider bvh = BvhCollider::create(all).value();
        const auto searches = {deep.collider.search(), bvh.search()};
        int touched = 0;
        for (int i = 0; i < 200; ++i) {
            Sweep sweep = deep.sweep(random, **searches.begin());
            for (const auto &search : searches) {
                sweep.time = 1;
                Touch whole;
                search->sweep(sweep, whole);
                if (!whole.isFound()) {
                    continue;
                }
                ++touched;
                Touch touch;
                sweep.time = whole.time * (1 - 1e-4) - 1e-4 * sweep.radius / glm::length(sweep.v);
                if (sweep.time < 0) {
                    continue;
                }
                search->sweep(sweep, touch);
                QVERIFY(!touch.isFound() && touch.lower == sweep.time && touch.promise == Promise::Exact);
                sweep.time = whole.time * (1 + 1e-9) + 1e-9;
                search->sweep(sweep, touch);
                QVERIFY(touch.isFound() && std::abs(touch.time - whole.time) < 1e-5);
            }
        }
        QVERIFY(touched > 20);
    }
}

void TestDeepSweep::aSpentBudgetIsAdmitted()
{
    std::mt19937_64 random(seed(68));
    const Deep deep(QStringLiteral("appendix-b"), 6);
    const auto search = deep.collider.search();
    int spent = 0;
    for (int i = 0; i < 200; ++i) {
        const Sweep sweep = deep.sweep(random, *search);
        Touch truth;
        search->sweep(sweep, truth);
        for (const std::uint64_t budget : {0u, 1u, 2u, 4u, 8u, 20u, 100'000u}) {
            Sweep less = sweep;
            less.nodeBudget = budget;
            Touch touch;
            search->sweep(less, touch);
            QVERIFY(touch.cost.nodeVisits <= std::max<std::uint64_t>(budget, 1));
            QVERIFY(touch.lower <= truth.time && touch.time >= truth.lower);
            if (budget > truth.cost.nodeVisits) {
                QVERIFY(touch.promise == Promise::Exact && touch.time == truth.time && touch.lower == truth.lower);
            } else if (budget + 2 < truth.cost.nodeVisits) {
                QVERIFY(touch.promise == Promise::UpperBound);
                ++spent;
            }
        }
    }
    QVERIFY2(spent > 50, qPrintable(QString::number(spent)));
}

void TestDeepSweep::deepFractalsCostLittle()
{
    std::mt19937_64 random(seed(69));
    // mean nodes of a sweep, which grow as the depth does
    for (const auto &[name, most] : {std::pair("menger", 30), {"sierpinski", 50}, {"two-sets", 40}, {"tree", 40}}) {
        const Deep deep(QLatin1String(name), 40);
        const auto search = deep.collider.search();
        std::uint64_t visits = 0;
        for (int i = 0; i < 200; ++i) {
            Touch touch;
            search->sweep(deep.sweep(random, *search), touch);
            visits += touch.cost.nodeVisits;
        }
        QVERIFY2(visits < 200u * static_cast<unsigned>(most),
                 qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(name)).arg(visits / 200)));
    }
}

void TestDeepSweep::sweepsDoNotAllocateOnceTheyHaveGrown()
{
    std::mt19937_64 random(seed(71));
    const Deep deep(QStringLiteral("appendix-b"), 6);
    const Mesh all = writtenOut(sample(QStringLiteral("menger"), 2).graph, deep.fractal.mesh, {}, 100'000).value();
    const BvhCollider bvh = BvhCollider::create(all).value();
    for (const Collider *collider : std::initializer_list<const Collider *>{&deep.collider, &bvh}) {
        const auto search = collider->search();
        std::vector<Sweep> sweeps;
        for (int i = 0; i < 100; ++i) {
            sweeps.push_back(deep.sweep(random, *search));
        }
        Touch touch;
        for (const Sweep &sweep : sweeps) {
            search->sweep(sweep, touch);
        }
        const std::size_t before = allocationCount();
        for (const Sweep &sweep : sweeps) {
            search->sweep(sweep, touch);
        }
        QCOMPARE(allocationCount(), before);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestDeepSweep)

#include "testdeepsweep.moc"
