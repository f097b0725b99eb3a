// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <set>
#include <string>

#include <QTest>

#include "core/fractal/counts.h"
#include "core/fractal/statetable.h"
#include "tests/core/naive.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr int mapCount = 4;

/// Maps of small whole numbers, whose products are exact.
std::vector<AffineMap> wholeMaps(std::mt19937_64 &random)
{
    std::vector<AffineMap> maps;
    while (maps.size() < mapCount) {
        AffineMap map;
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) {
                map.linear[column][row] = static_cast<double>(random() % 3) - 1.0;
            }
            map.translation[column] = static_cast<double>(random() % 5) - 2.0;
        }
        if (map != AffineMap{} && std::ranges::find(maps, map) == maps.end()) {
            maps.push_back(map);
        }
    }
    return maps;
}

naive::Fractal randomFractal(std::mt19937_64 &random, const naive::cpp_int &mostWords)
{
    while (true) {
        naive::Fractal fractal;
        fractal.maps = wholeMaps(random);
        fractal.sets = naive::randomSets(random, mapCount);
        fractal.items = naive::randomItems(random, fractal.sets.size(), 0, 4);
        const naive::Levels levels = fractal.levels();
        if (levels.size() <= 14 && naive::wordsAsWritten(levels) <= mostWords) {
            return fractal;
        }
    }
}

struct Instance {
    naive::Picks picks;
    AffineMap map;
};

/// All words of the state table, by its own expansions.
void enumerate(StateTable &table, const naive::Fractal &fractal, StateId state, const Instance &above,
               std::vector<Instance> &found)
{
    const Expansion &expansion = table.expansion(state);
    if (expansion.hasLeaf) {
        found.push_back(above);
    }
    for (const ChildRange &range : expansion.ranges) {
        for (std::uint32_t i = range.firstMap; i < range.endMap; ++i) {
            const AffineMap &map = table.graph().set(range.set).maps[i];
            Instance below = above;
            below.picks.push_back(static_cast<int>(std::ranges::find(fractal.maps, map) - fractal.maps.begin()));
            below.map = above.map * map;
            enumerate(table, fractal, range.next, below, found);
        }
    }
}

FractalGraph graphOf(const naive::Fractal &fractal)
{
    return FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1}).value();
}

/// For a failure: the levels, letters for maps.
QByteArray text(const naive::Levels &levels)
{
    QByteArray all;
    for (const naive::Level &level : levels) {
        all += level.mayPass ? "[#" : "[";
        for (const int map : level.maps) {
            all += static_cast<char>('a' + map);
        }
        all += "] ";
    }
    return all;
}

}

/// The canonical words against every word there is, on thousands of small fractals.
class TestCanonicalWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachSequenceOfPicksOccursOnce();
    void countsAreTheNumberOfSequences();
    void theInstancesAreThoseOfAllWords();
    void reachIsWhatMayBePassedOver();
    void twoTablesEnumerateInOneOrder();
    void hashesAloneAreOneInstance();
};

void TestCanonicalWords::eachSequenceOfPicksOccursOnce()
{
    std::mt19937_64 random(seed(11));
    for (int round = 0; round < 4'000; ++round) {
        const naive::Fractal fractal = randomFractal(random, 3'000);
        const FractalGraph graph = graphOf(fractal);
        StateTable table(graph);
        std::vector<Instance> found;
        enumerate(table, fractal, table.root(), {}, found);
        std::set<naive::Picks> sequences;
        for (const Instance &instance : found) {
            QVERIFY2(sequences.insert(instance.picks).second, text(fractal.levels()));
        }
        QVERIFY2(sequences == naive::allPicks(fractal.levels()), text(fractal.levels()));
    }
}

void TestCanonicalWords::countsAreTheNumberOfSequences()
{
    std::mt19937_64 random(seed(12));
    for (int round = 0; round < 4'000; ++round) {
        const naive::Fractal fractal = randomFractal(random, 20'000);
        const FractalGraph graph = graphOf(fractal);
        const naive::Levels levels = fractal.levels();
        const std::size_t sequences = naive::allPicks(levels).size();
        QVERIFY2(naive::PickCounter(levels).count() == sequences, text(levels)); // the two oracles agree
        QVERIFY2(instancesDistinct(graph) == Count(sequences), text(levels));
        QCOMPARE(instancesAsWritten(graph).toString(), naive::wordsAsWritten(levels).str());
    }
}

void TestCanonicalWords::theInstancesAreThoseOfAllWords()
{
    std::mt19937_64 random(seed(13));
    for (int round = 0; round < 500; ++round) {
        const naive::Fractal fractal = randomFractal(random, 2'000);
        const FractalGraph graph = graphOf(fractal);
        StateTable table(graph);
        std::vector<Instance> found;
        enumerate(table, fractal, table.root(), {}, found);
        std::vector<naive::Affine> maps;
        for (const Instance &instance : found) {
            maps.push_back(naive::fromCore(instance.map));
        }
        std::vector<naive::Affine> expected;
        for (const naive::Picks &picks : naive::allPicks(fractal.levels())) {
            naive::Affine map;
            for (const int pick : picks) {
                map = naive::product(map, naive::fromCore(fractal.maps[static_cast<std::size_t>(pick)]));
            }
            expected.push_back(map);
        }
        std::ranges::sort(maps);
        std::ranges::sort(expected);
        QVERIFY2(maps == expected, text(fractal.levels()));
    }
}

void TestCanonicalWords::reachIsWhatMayBePassedOver()
{
    std::mt19937_64 random(seed(14));
    for (int round = 0; round < 500; ++round) {
        naive::Fractal fractal;
        fractal.maps = wholeMaps(random);
        for (AffineMap &map : fractal.maps) {
            map.linear *= 0.2; // else thousands of levels grow beyond all numbers
        }
        fractal.sets = naive::randomSets(random, mapCount);
        fractal.items = naive::randomItems(random, fractal.sets.size(), 0, round % 3 == 0 ? 30 : 4);
        const naive::Levels levels = fractal.levels();
        const FractalGraph graph = graphOf(fractal);
        for (std::size_t from = 0; from <= levels.size() && from < 200; ++from) {
            std::vector<Position> expected;
            std::set<std::pair<std::vector<int>, bool>> seen;
            std::size_t at = from;
            bool mayPass = true;
            for (; at < levels.size() && mayPass; ++at) {
                std::vector<int> sorted = levels[at].maps;
                std::ranges::sort(sorted);
                if (seen.insert({sorted, levels[at].mayPass}).second) {
                    expected.push_back(at);
                }
                mayPass = levels[at].mayPass;
            }
            const FractalGraph::Reach reach = graph.reach(from);
            std::vector<Position> found;
            for (const auto &[position, slot] : reach.levels) {
                QCOMPARE(graph.levels().locate(position).slot, slot);
                found.push_back(position);
            }
            QVERIFY2(found == expected, text(levels));
            QCOMPARE(reach.reachesEnd, mayPass);
            QCOMPARE(reach.last, mayPass ? levels.size() : at - 1);
        }
    }
}

void TestCanonicalWords::twoTablesEnumerateInOneOrder()
{
    std::mt19937_64 random(seed(15));
    for (int round = 0; round < 200; ++round) {
        const naive::Fractal fractal = randomFractal(random, 2'000);
        const FractalGraph graph = graphOf(fractal);
        StateTable first(graph);
        StateTable second(graph);
        std::vector<Instance> warmUp;
        enumerate(second, fractal, second.root(), {}, warmUp);
        second.forget();
        QCOMPARE(second.stateCount(), 1u);
        std::vector<Instance> a;
        std::vector<Instance> b;
        enumerate(first, fractal, first.root(), {}, a);
        enumerate(second, fractal, second.root(), {}, b);
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            QVERIFY(a[i].picks == b[i].picks);
        }
    }
}

void TestCanonicalWords::hashesAloneAreOneInstance()
{
    naive::Fractal fractal;
    fractal.sets = {{{}, true}};
    for (const std::uint64_t count : {1ull, 7ull, 1'000'000ull, 1ull << 62}) {
        fractal.items = {{count, 0, {{0, 0, {}}}}};
        const FractalGraph graph = graphOf(fractal);
        QVERIFY(instancesDistinct(graph) == Count(1));
        QVERIFY(instancesAsWritten(graph) == Count(1));
        StateTable table(graph);
        QVERIFY(table.expansion(table.root()).hasLeaf);
        QVERIFY(table.expansion(table.root()).ranges.empty());
    }
}

}

ROMANESCO_TEST(romanesco::test::TestCanonicalWords)

#include "testcanonicalwords.moc"
