// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/dimension.h"

#include <cmath>

#include <QTest>

#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Fractal;

std::optional<double> dimensionOf(const Fractal &fractal)
{
    return similarityDimension(FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1}).value());
}

/// Different maps of these scales, each turned and moved by itself, every second mirrored.
std::vector<AffineMap> similarities(const std::vector<double> &scales)
{
    std::vector<AffineMap> maps;
    for (const double scale : scales) {
        const auto i = static_cast<double>(maps.size());
        maps.push_back(
            mapFromParts({i, 0, 1}, {10 * i, 20 * i, 7}, {scale, maps.size() % 2 == 0 ? scale : -scale, scale}));
    }
    return maps;
}

/// The root of Σ r^D = 1 over all words' scales, by bisection in long doubles.
double moran(const std::vector<long double> &scales)
{
    long double least = 0;
    long double greatest = 100;
    for (int i = 0; i < 200; ++i) {
        const long double middle = (least + greatest) / 2;
        long double sum = 0;
        for (const long double scale : scales) {
            sum += std::pow(scale, middle);
        }
        (sum > 1 ? least : greatest) = middle;
    }
    return static_cast<double>(least);
}

bool isNear(std::optional<double> found, double truth)
{
    return found && std::abs(*found - truth) <= 1e-10 * truth;
}

}

class TestDimension : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void examplesHaveTheirDimension_data();
    void examplesHaveTheirDimension();
    void knownFractalsHaveTheirs_data();
    void knownFractalsHaveTheirs();
    void setsThatMayBePassedOverAreAsOne();
    void mixedSetsCountEachWordOfAPassOnce();
    void longPassesDoNotOverflow();
    void onePointHasNone();
    void mapsSharedByMixedSetsAreLeftOut();
    void whatHasNoDimension_data();
    void whatHasNoDimension();
};

void TestDimension::examplesHaveTheirDimension_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("dimension");
    QTest::newRow("menger") << QStringLiteral("menger") << std::log(20) / std::log(3);
    QTest::newRow("sierpinski") << QStringLiteral("sierpinski") << 2.0;

    // k steps of 0.97, k from 0 to 96, and a bud of a half.
    std::vector<long double> scales;
    for (int k = 0; k <= 96; ++k) {
        scales.push_back(0.5L * std::pow(0.97L, static_cast<long double>(k)));
    }
    QTest::newRow("romanesco") << QStringLiteral("romanesco") << moran(scales);
}

void TestDimension::examplesHaveTheirDimension()
{
    QFETCH(QString, name);
    QFETCH(double, dimension);
    for (const std::uint64_t depth : {1u, 2u, 1'000'000u}) {
        QVERIFY(isNear(similarityDimension(sample(name, depth).graph), dimension));
    }
}

void TestDimension::knownFractalsHaveTheirs_data()
{
    QTest::addColumn<QList<double>>("scales");
    QTest::addColumn<double>("dimension");
    QTest::newRow("Cantor dust") << QList<double>(8, 1.0 / 3) << std::log(8) / std::log(3);
    QTest::newRow("Cantor set") << QList<double>(2, 1.0 / 3) << std::log(2) / std::log(3);
    QTest::newRow("golden") << QList<double>{0.5, 0.25} << std::log((1 + std::sqrt(5)) / 2) / std::log(2);
    QTest::newRow("above space") << QList<double>(64, 0.5) << 6.0;
    QTest::newRow("hardly contracting") << QList<double>(2, 0.999) << std::log(2) / -std::log(0.999);
    QTest::newRow("tiny") << QList<double>(2, 1e-200) << std::log(2) / (200 * std::log(10));
    QTest::newRow("far apart") << QList<double>{0.9, 1e-6} << moran({0.9L, 1e-6L});
}

void TestDimension::knownFractalsHaveTheirs()
{
    QFETCH(QList<double>, scales);
    QFETCH(double, dimension);
    Fractal fractal;
    fractal.maps = similarities({scales.begin(), scales.end()});
    fractal.sets.emplace_back();
    for (int i = 0; i < static_cast<int>(scales.size()); ++i) {
        fractal.sets[0].maps.push_back(i);
    }
    fractal.items = {{5, 0, {{0, 0, {}}}}};
    QVERIFY(isNear(dimensionOf(fractal), dimension));
    fractal.sets[0].mayPass = true;
    QVERIFY(isNear(dimensionOf(fractal), dimension));
}

void TestDimension::setsThatMayBePassedOverAreAsOne()
{
    Fractal fractal;
    fractal.maps = similarities({0.1, 0.1, 0.5, 0.25});
    fractal.sets = {{{0, 1}, true}, {{2, 3}, true}, {{1, 2}, true}};
    fractal.items = {{3, 0, {{0, 0, {}}, {0, 1, {}}, {0, 2, {}}, {0, 0, {}}}}};
    QVERIFY(isNear(dimensionOf(fractal), moran({0.1L, 0.1L, 0.5L, 0.25L})));
}

/// Against all words of one pass, where it starts or ends with a level that none passes over.
void TestDimension::mixedSetsCountEachWordOfAPassOnce()
{
    std::mt19937_64 random(seed(51));
    int compared = 0;
    for (int round = 0; round < 500; ++round) {
        Fractal fractal;
        std::vector<double> scales;
        for (int i = 0; i < 6; ++i) {
            scales.push_back(std::uniform_real_distribution<double>(0.05, 0.95)(random));
        }
        fractal.maps = similarities(scales);
        fractal.sets = {{{0, 1}, random() % 2 == 0}, {{2, 3, 4}, random() % 2 == 0}, {{5}, false}};
        std::vector<Fractal::Item> pass = naive::randomItems(random, 3, 1, 4);
        pass.insert(random() % 2 == 0 ? pass.begin() : pass.end(), {0, 2, {}});
        Fractal once = fractal;
        once.items = pass;
        if (naive::wordsAsWritten(once.levels()) > 2'000) {
            continue;
        }
        std::vector<long double> ofWords;
        for (const naive::Picks &picks : naive::allPicks(once.levels())) {
            ofWords.push_back(1);
            for (const int pick : picks) {
                ofWords.back() *= scales[static_cast<std::size_t>(pick)];
            }
        }
        fractal.items = {{7, 0, pass}};
        QVERIFY(isNear(dimensionOf(fractal), moran(ofWords)));
        ++compared;
    }
    QVERIFY(compared > 200);
}

void TestDimension::longPassesDoNotOverflow()
{
    // 2 maps of a half 50,000 times in one pass: as one pass of 2.
    Fractal fractal;
    fractal.maps = similarities({0.5, 0.5, 0.25});
    fractal.sets = {{{0, 1}, false}, {{2}, true}, {{0, 1}, true}};
    fractal.items = {{2, 0, {{50'000, 0, {{0, 0, {}}}}}}};
    QVERIFY(isNear(dimensionOf(fractal), 1.0));
    // Nearly the same if the many may be passed over: c and any number of a and b, or of c.
    fractal.sets[0].maps = {2};
    fractal.items = {{2, 0, {{50'000, 0, {{0, 2, {}}}}, {0, 0, {}}}}};
    QVERIFY(isNear(dimensionOf(fractal), moran({0.5L, 0.5L, 0.25L})));
    fractal.items = {{2, 0, {{100'000, 0, {{0, 0, {}}}}, {0, 0, {}}}}};
    QVERIFY(!dimensionOf(fractal));
}

void TestDimension::onePointHasNone()
{
    Fractal fractal;
    fractal.maps = similarities({0.5});
    fractal.sets = {{{0}, false}};
    fractal.items = {{4, 0, {{0, 0, {}}}}};
    QVERIFY(dimensionOf(fractal) == 0.0);
}

void TestDimension::mapsSharedByMixedSetsAreLeftOut()
{
    Fractal fractal;
    fractal.maps = similarities({0.5, 0.5, 0.25});
    fractal.sets = {{{0, 1}, true}, {{1, 2}, false}};
    fractal.items = {{4, 0, {{0, 0, {}}, {0, 1, {}}}}};
    QVERIFY(!dimensionOf(fractal));
    fractal.sets[0].mayPass = false; // a product of sums, shared or not
    QVERIFY(isNear(dimensionOf(fractal), moran({0.25L, 0.125L, 0.25L, 0.125L})));
}

void TestDimension::whatHasNoDimension_data()
{
    QTest::addColumn<double>("y");
    QTest::addColumn<bool>("hasMap");
    QTest::addColumn<bool>("hasMore");
    QTest::newRow("flat") << 0.0 << true << false;
    QTest::newRow("unequal") << 0.6 << true << false;
    QTest::newRow("hashes alone") << 0.5 << false << false;
    QTest::newRow("levels outside") << 0.5 << true << true;
}

void TestDimension::whatHasNoDimension()
{
    QFETCH(double, y);
    QFETCH(bool, hasMap);
    QFETCH(bool, hasMore);
    Fractal fractal;
    fractal.maps = {mapFromParts({0, 0, 0}, {1, 2, 3}, {0.5, y, 0.5}), mapFromParts({1, 0, 0}, {0, 0, 0}, {1, 1, 1})};
    fractal.sets = {{hasMap ? std::vector{0} : std::vector<int>{}, true}, {{1}, false}};
    fractal.items = {{4, 0, {{0, 0, {}}}}};
    if (hasMore) {
        fractal.items.push_back({0, 1, {}});
    }
    QVERIFY(!dimensionOf(fractal));
    fractal.items = {{4, 0, {{0, 0, {}}, {0, 1, {}}}}}; // a map that does not contract
    QVERIFY(!dimensionOf(fractal));
}

}

ROMANESCO_TEST(romanesco::test::TestDimension)

#include "testdimension.moc"
