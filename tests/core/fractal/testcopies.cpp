// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/copies.h"

#include <cmath>
#include <stop_token>

#include <QTest>

#include "core/fractal/counts.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::Affine;
using naive::Fractal;
using Addresses = CopyWalk::Addresses;

FractalGraph graphOf(const Fractal &fractal)
{
    return FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1}).value();
}

/// Numbers of the maps, as the oracle has them; nothing where the address is no way to place them.
std::optional<naive::Picks> picksAt(std::span<const Pick> address, const naive::Levels &levels)
{
    naive::Picks picks;
    std::size_t at = 0;
    for (const Pick &pick : address) {
        for (; at < pick.position; ++at) {
            if (!levels.at(at).mayPass) {
                return std::nullopt;
            }
        }
        if (at != pick.position) {
            return std::nullopt;
        }
        picks.push_back(levels.at(at++).maps.at(pick.map));
    }
    const bool isWhole = std::all_of(levels.begin() + static_cast<std::ptrdiff_t>(at), levels.end(),
                                     [](const naive::Level &level) { return level.mayPass; });
    return isWhole ? std::optional(picks) : std::nullopt;
}

Affine productOf(const naive::Picks &picks, const std::vector<AffineMap> &maps)
{
    Affine product;
    for (const int pick : picks) {
        product = naive::product(product, naive::fromCore(maps[static_cast<std::size_t>(pick)]));
    }
    return product;
}

/// Within the rounding of some ten products of numbers up to some hundred.
bool isNear(const AffineMap &map, const Affine &truth)
{
    const Affine found = naive::fromCore(map);
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            if (!(std::abs(found.a[row][column] - truth.a[row][column]) < 1e-9L)) {
                return false;
            }
        }
        if (!(std::abs(found.b[row] - truth.b[row]) < 1e-9L)) {
            return false;
        }
    }
    return true;
}

/// Products are exact: a quarter turn and moves by whole numbers.
std::vector<AffineMap> wholeMaps()
{
    return {mapFromParts({1, 0, 0}, {0, 0, 90}, {1, 1, 1}),   mapFromParts({0, 2, 1}, {90, 0, 0}, {1, 1, -1}),
            mapFromParts({-1, 0, 3}, {0, 90, 0}, {1, 1, 1}),  mapFromParts({5, 0, 0}, {0, 0, 0}, {1, 1, 1}),
            mapFromParts({0, 0, -2}, {0, 180, 0}, {1, 1, 1}), mapFromParts({0, 3, 0}, {0, 0, -90}, {1, -1, 1})};
}

}

class TestCopies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theCopiesAreThoseOfAllWords_data();
    void theCopiesAreThoseOfAllWords();
    void keepingAddressesChangesNothing();
    void waysHaveTheirAddresses();
    void appendixB_data();
    void appendixB();
    void theFirstOfVeryManyCopiesComeAtOnce_data();
    void theFirstOfVeryManyCopiesComeAtOnce();
    void copiesFarUpAreFoundAgain();
    void aStopEndsTheWalk();
};

void TestCopies::theCopiesAreThoseOfAllWords_data()
{
    QTest::addColumn<double>("largest");
    QTest::newRow("contracting") << 0.5;
    QTest::newRow("hardly contracting") << 0.97;
    QTest::newRow("growing") << 1.3;
}

void TestCopies::theCopiesAreThoseOfAllWords()
{
    QFETCH(double, largest);
    std::mt19937_64 random(seed(41));
    int shared = 0;
    for (int round = 0; round < 400; ++round) {
        const Fractal fractal = randomFractal(random, largest);
        const naive::Levels levels = fractal.levels();
        const FractalGraph graph = graphOf(fractal);
        shared += graph.setsShareMaps() ? 1 : 0;
        CopyWalk copies(graph, Addresses::Keep);
        std::set<naive::Picks> found;
        while (copies.next()) {
            const std::optional<naive::Picks> picks = picksAt(copies.address(), levels);
            QVERIFY(picks);
            QVERIFY(found.insert(*picks).second);
            QVERIFY(isNear(copies.modelFromBase(), productOf(*picks, fractal.maps)));
            QVERIFY(mapOf(graph, copies.address()) == copies.modelFromBase());
        }
        QVERIFY(found == naive::allPicks(levels));
        QVERIFY(instancesDistinct(graph) == Count(found.size()));
        QVERIFY(!copies.next());
    }
    QVERIFY2(shared > 50, QByteArray::number(shared));
}

/// All ways through the states, to where the mesh stands.
void TestCopies::waysHaveTheirAddresses()
{
    std::mt19937_64 random(seed(43));
    int shared = 0;
    for (int round = 0; round < 200; ++round) {
        const Fractal fractal = randomFractal(random, 0.9);
        const naive::Levels levels = fractal.levels();
        const FractalGraph graph = graphOf(fractal);
        shared += graph.setsShareMaps() ? 1 : 0;
        StateTable table(graph);
        std::set<naive::Picks> found;
        std::vector<std::pair<StateId, std::vector<Step>>> open{{table.root(), {}}};
        while (!open.empty()) {
            const auto [state, steps] = open.back();
            open.pop_back();
            if (table.expansion(state).hasLeaf) {
                const std::optional<Address> address = addressOf(table, steps);
                QVERIFY(address);
                const std::optional<naive::Picks> picks = picksAt(*address, levels);
                QVERIFY(picks);
                AffineMap map;
                for (const Step &step : steps) {
                    map = map * graph.set(step.set).maps[step.map];
                }
                QVERIFY(isNear(map, productOf(*picks, fractal.maps)));
                found.insert(*picks);
            }
            for (const ChildRange &range : table.expansion(state).ranges) {
                for (std::uint32_t number = range.firstMap; number < range.endMap; ++number) {
                    open.emplace_back(range.next, steps);
                    open.back().second.push_back({range.set, number});
                }
            }
        }
        QVERIFY(found == naive::allPicks(levels));
        // Maps that stand in other sets, or nowhere, are no way.
        for (SetId set = 0; set < graph.setCount(); ++set) {
            for (std::uint32_t number = 0; number <= graph.set(set).maps.size(); ++number) {
                const auto leads = [&](const ChildRange &range) {
                    return range.set == set && number >= range.firstMap && number < range.endMap;
                };
                const bool isWay = std::ranges::any_of(table.expansion(table.root()).ranges, leads);
                QCOMPARE(addressOf(table, std::vector<Step>(1, Step{set, number})).has_value(), isWay);
            }
        }
        QVERIFY(addressOf(table, {}).value().empty());
    }
    QVERIFY2(shared > 20, QByteArray::number(shared));
}

void TestCopies::keepingAddressesChangesNothing()
{
    std::mt19937_64 random(seed(42));
    for (int round = 0; round < 300; ++round) {
        const FractalGraph graph = graphOf(randomFractal(random, 0.9));
        CopyWalk with(graph, Addresses::Keep);
        CopyWalk without(graph);
        bool isThere = true;
        while (isThere) {
            isThere = with.next();
            QCOMPARE(without.next(), isThere);
            QVERIFY(with.modelFromBase() == without.modelFromBase());
        }
    }
}

void TestCopies::appendixB_data()
{
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<quint64>("count");
    quint64 depth = 1;
    for (const quint64 count : {25u, 585u, 13'641u, 318'025u, 7'414'345u}) {
        QTest::addRow("depth %llu", depth) << depth << count;
        ++depth;
    }
}

void TestCopies::appendixB()
{
    QFETCH(quint64, depth);
    const Sample appendix = sample(QStringLiteral("appendix-b"), depth);
    CopyWalk copies(appendix.graph);
    quint64 count = 0;
    while (copies.next()) {
        ++count;
    }
    QTEST(count, "count");
}

void TestCopies::theFirstOfVeryManyCopiesComeAtOnce_data()
{
    QTest::addColumn<int>("mapCount");
    QTest::addColumn<bool>("mayPass");
    QTest::addColumn<quint64>("depth");
    QTest::addRow("one map") << 1 << false << quint64(1'000'000);
    QTest::addRow("one map or none") << 1 << true << (quint64(1) << 50);
    QTest::addRow("two maps") << 2 << false << quint64(1'000'000);
    QTest::addRow("two maps or none") << 2 << true << (quint64(1) << 50);
}

void TestCopies::theFirstOfVeryManyCopiesComeAtOnce()
{
    QFETCH(int, mapCount);
    QFETCH(bool, mayPass);
    QFETCH(quint64, depth);
    Fractal fractal;
    fractal.maps = wholeMaps();
    fractal.sets = {{{0}, mayPass}};
    if (mapCount == 2) {
        fractal.sets.front().maps.push_back(1);
    }
    fractal.items = {{depth, 0, {{0, 0, {}}}}};
    const FractalGraph graph = graphOf(fractal);
    CopyWalk copies(graph);

    // Without `#` the copies are the last picks in order; with it each is one map deeper than the one before.
    Affine expected;
    for (quint64 i = 0; !mayPass && i < depth - 4; ++i) {
        expected = naive::product(expected, naive::fromCore(fractal.maps[0]));
    }
    std::size_t most = 0;
    for (unsigned i = 0; i < (mayPass ? 100'000u : mapCount == 2 ? 16u : 1u); ++i) {
        QVERIFY(copies.next());
        Affine copy = expected;
        for (int bit = 3; !mayPass && bit >= 0; --bit) {
            copy = naive::product(copy, naive::fromCore(fractal.maps[i >> bit & 1u]));
        }
        QVERIFY(naive::fromCore(copies.modelFromBase()) == copy);
        if (mayPass) {
            expected = naive::product(expected, naive::fromCore(fractal.maps[0]));
        }
        most = std::max(most, copies.memoryUse());
    }
    QVERIFY(most < 10'000'000);
    QCOMPARE(copies.next(), mayPass || mapCount == 2);
}

/// Three of a and b, one c, up to thousands of d, one of e and f: far more places with children left than
/// are kept.
void TestCopies::copiesFarUpAreFoundAgain()
{
    constexpr std::uint64_t inner = 4'000;
    Fractal fractal;
    fractal.maps = wholeMaps();
    fractal.sets = {{{0, 1}, false}, {{2}, false}, {{3}, true}, {{4, 5}, false}};
    fractal.items = {{3, 0, {{0, 0, {}}}}, {0, 1, {}}, {inner, 0, {{0, 2, {}}}}, {0, 3, {}}};
    const FractalGraph graph = graphOf(fractal);
    CopyWalk copies(graph, Addresses::Keep);
    for (int outer = 0; outer < 8; ++outer) {
        const naive::Picks picks{outer >> 2 & 1, outer >> 1 & 1, outer & 1, 2};
        std::vector<Affine> prefixes{productOf(picks, fractal.maps)};
        for (std::uint64_t k = 0; k < inner; ++k) {
            prefixes.push_back(naive::product(prefixes.back(), naive::fromCore(fractal.maps[3])));
        }
        for (std::uint64_t i = inner + 1; i-- > 0;) {
            for (std::uint32_t last = 0; last < 2; ++last) {
                QVERIFY(copies.next());
                const Affine map = naive::product(prefixes[i], naive::fromCore(fractal.maps[4 + last]));
                QVERIFY(naive::fromCore(copies.modelFromBase()) == map);
                const std::span<const Pick> address = copies.address();
                QCOMPARE(address.size(), 4 + i + 1);
                QVERIFY(address[2] == (Pick{2, static_cast<std::uint32_t>(picks[2])}));
                QVERIFY(i == 0 || address[3 + i] == (Pick{3 + i, 0}));
                QVERIFY(address.back() == (Pick{4 + inner, last}));
            }
        }
    }
    QVERIFY(!copies.next());
    QVERIFY(copies.memoryUse() < 10'000'000);
}

void TestCopies::aStopEndsTheWalk()
{
    const Sample sponge = sample(QStringLiteral("menger"), 4);
    std::stop_source stop;
    CopyWalk copies(sponge.graph, Addresses::Drop, stop.get_token());
    for (int i = 0; i < 100; ++i) {
        QVERIFY(copies.next());
    }
    stop.request_stop();
    QVERIFY(!copies.next());
}

}

ROMANESCO_TEST(romanesco::test::TestCopies)

#include "testcopies.moc"
