// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/statetable.h"

#include <QTest>

#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestStateTable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void costDoesNotGrowWithTheDepth_data();
    void costDoesNotGrowWithTheDepth();
    void statesAreMadeOnce();
    void forgettingLeavesTheRoot();
    void someStatesCanBeKept();
    void boundsStandBesideTheChildren();
};

namespace {

struct Cost {
    std::size_t states;
    std::size_t bytes;
    std::size_t copies;
};

/// Goes down to copies of a thousandth of the whole, as drawing does.
Cost explore(const FractalGraph &graph)
{
    struct Copy {
        StateId state;
        double norm;
    };
    StateTable table(graph);
    const double whole = table.state(table.root()).bound.radius;
    std::vector<Copy> open{{table.root(), 1.0}};
    std::size_t copies = 0;
    while (!open.empty() && copies < 2'000'000) {
        const Copy copy = open.back();
        open.pop_back();
        ++copies;
        if (copy.norm * table.state(copy.state).bound.radius <= whole / 1'000) {
            continue;
        }
        for (const ChildRange &range : table.expansion(copy.state).ranges) {
            for (std::uint32_t i = range.firstMap; i < range.endMap; ++i) {
                open.push_back({range.next, copy.norm * graph.facts(range.set)[i].norm});
            }
        }
    }
    return {table.stateCount(), table.memoryUse(), copies};
}

}

void TestStateTable::costDoesNotGrowWithTheDepth_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("shallow");
    QTest::addColumn<int>("deep");
    QTest::newRow("Sierpinski") << "sierpinski" << 20 << 40;
    QTest::newRow("Sierpinski, very deep") << "sierpinski" << 20 << 1'000'000'000;
    QTest::newRow("Menger") << "menger" << 14 << 40;
    QTest::newRow("appendix B") << "appendix-b" << 12 << 1'000'000;
}

void TestStateTable::costDoesNotGrowWithTheDepth()
{
    QFETCH(QString, name);
    QFETCH(int, shallow);
    QFETCH(int, deep);
    const Cost a = explore(sample(name, static_cast<std::uint64_t>(shallow)).graph);
    const Cost b = explore(sample(name, static_cast<std::uint64_t>(deep)).graph);
    QCOMPARE(a.states, b.states);
    QCOMPARE(a.bytes, b.bytes);
    QCOMPARE(a.copies, b.copies);
}

void TestStateTable::statesAreMadeOnce()
{
    // 4 maps and 6 levels: a state for each place, though 4^6 copies stand at the end.
    const Sample sierpinski = sample(QStringLiteral("sierpinski"), 6);
    StateTable table(sierpinski.graph);
    StateId state = table.root();
    for (int i = 0; i < 6; ++i) {
        const Expansion &expansion = table.expansion(state);
        QCOMPARE(expansion.ranges.size(), 1u);
        QCOMPARE(&expansion, &table.expansion(state));
        QVERIFY(!expansion.hasLeaf);
        state = expansion.ranges.front().next;
    }
    QVERIFY(table.expansion(state).hasLeaf);
    QCOMPARE(table.stateCount(), 7u);
}

void TestStateTable::forgettingLeavesTheRoot()
{
    const Sample sierpinski = sample(QStringLiteral("sierpinski"), 6);
    StateTable table(sierpinski.graph);
    const std::size_t bytes = table.memoryUse();
    (void)table.expansion(table.root());
    QVERIFY(table.memoryUse() > bytes);
    table.forget();
    QCOMPARE(table.memoryUse(), bytes);
    QCOMPARE(table.stateCount(), 1u);
    QCOMPARE(table.expansion(table.root()).ranges.size(), 1u);
}

void TestStateTable::someStatesCanBeKept()
{
    const Sample sierpinski = sample(QStringLiteral("sierpinski"), 6);
    StateTable table(sierpinski.graph);
    std::vector<StateId> path{table.root()};
    for (int i = 0; i < 6; ++i) {
        path.push_back(table.expansion(path.back()).ranges.front().next);
    }
    std::vector<StateId> kept{path[4], path[2], path[4], path[0]};
    table.forgetAllBut(kept);
    QCOMPARE(table.stateCount(), 3u);
    QCOMPARE(kept[0], kept[2]);
    QCOMPARE(kept[3], table.root());
    QCOMPARE(table.state(kept[0]).positions, Positions{4});
    QCOMPARE(table.state(kept[1]).positions, Positions{2});
    QCOMPARE(table.state(table.expansion(kept[1]).ranges.front().next).positions, Positions{3});
}

void TestStateTable::boundsStandBesideTheChildren()
{
    const Sample tree = sample(QStringLiteral("tree"), 7);
    StateTable table(tree.graph);
    const Expansion &expansion = table.expansion(table.root());
    const std::vector<Sphere> &bounds = table.childBounds(table.root());
    std::size_t child = 0;
    for (const ChildRange &range : expansion.ranges) {
        const Sphere &below = table.state(range.next).bound;
        for (std::uint32_t i = range.firstMap; i < range.endMap; ++i, ++child) {
            const naive::Point centre = naive::applied(naive::fromCore(tree.graph.set(range.set).maps[i]),
                                                       {below.centre.x, below.centre.y, below.centre.z});
            for (std::size_t axis = 0; axis < 3; ++axis) {
                QVERIFY(std::abs(static_cast<double>(centre[axis]) - bounds[child].centre[static_cast<int>(axis)])
                        < 1e-12);
            }
            QVERIFY(bounds[child].radius >= below.radius * tree.graph.facts(range.set)[i].norm * (1 - 1e-12));
        }
    }
    QCOMPARE(child, bounds.size());
}

}

ROMANESCO_TEST(romanesco::test::TestStateTable)

#include "teststatetable.moc"
