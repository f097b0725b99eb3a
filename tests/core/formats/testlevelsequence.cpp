// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/levelsequence.h"

#include <set>

#include <QTest>

#include "tests/core/naive.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestLevelSequence : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPositionIsWhereTheListHasIt();
    void successorsAreThoseOfTheList();
    void runsEndWhereTheirRepeatEnds();
    void structureDoesNotGrowWithCounts();
    void positionsOfHugeRepeats();
    void repeatsOfNothingLeaveNothing();
    void deepNestingStaysShallow();
};

namespace {

naive::Fractal randomFractal(std::mt19937_64 &random, std::uint64_t mostRepeats)
{
    naive::Fractal fractal;
    fractal.sets.resize(5);
    fractal.items = naive::randomItems(random, fractal.sets.size(), 0, mostRepeats);
    return fractal;
}

}

void TestLevelSequence::everyPositionIsWhereTheListHasIt()
{
    std::mt19937_64 random(seed(1));
    for (int round = 0; round < 2'000; ++round) {
        const naive::Fractal fractal = randomFractal(random, round % 4 == 0 ? 40 : 5);
        const std::vector<SetId> list = fractal.setsOfLevels();
        const LevelSequence levels = fractal.description().levels;
        QCOMPARE(levels.levelCount(), list.size());
        for (Position position = 0; position < list.size() && position < 20'000; ++position) {
            const LevelSequence::Location at = levels.locate(position);
            QCOMPARE(levels.set(at.slot), list[position]);
            QVERIFY(at.end > position && at.end <= levels.levelCount());
        }
    }
}

void TestLevelSequence::successorsAreThoseOfTheList()
{
    std::mt19937_64 random(seed(2));
    for (int round = 0; round < 500; ++round) {
        const LevelSequence levels = randomFractal(random, 6).description().levels;
        std::vector<std::set<LevelSequence::Slot>> seen(levels.slotCount());
        for (Position position = 0; position < levels.levelCount(); ++position) {
            const bool isLast = position + 1 == levels.levelCount();
            seen[levels.locate(position).slot].insert(isLast ? levels.slotCount() : levels.locate(position + 1).slot);
        }
        for (LevelSequence::Slot slot = 0; slot < levels.slotCount(); ++slot) {
            const auto &found = levels.successors(slot);
            const std::set<LevelSequence::Slot> all(found.begin(), found.end());
            QVERIFY(all == seen[slot]);
        }
    }
}

void TestLevelSequence::runsEndWhereTheirRepeatEnds()
{
    // A (B C)^100 A, and inside a repeat: ((B C)^100 D)^3.
    LevelSequence::Builder flat;
    flat.addLevel(0);
    flat.beginRepeat(100);
    flat.addLevel(1);
    flat.addLevel(2);
    flat.endRepeat();
    flat.addLevel(0);
    const LevelSequence sequence = std::move(flat).build();
    QCOMPARE(sequence.slotCount(), 4u);
    QCOMPARE(sequence.locate(0).end, Position(202));
    for (Position position = 1; position <= 200; ++position) {
        QCOMPARE(sequence.locate(position).end, Position(201));
    }
    QCOMPARE(sequence.locate(201).end, Position(202));

    LevelSequence::Builder nested;
    nested.beginRepeat(3);
    nested.beginRepeat(100);
    nested.addLevel(1);
    nested.addLevel(2);
    nested.endRepeat();
    nested.addLevel(3);
    nested.endRepeat();
    const LevelSequence inner = std::move(nested).build();
    QCOMPARE(inner.slotCount(), 3u);
    for (Position pass = 0; pass < 3; ++pass) {
        QCOMPARE(inner.locate(pass * 201 + 7).end, pass * 201 + 200);
        QCOMPARE(inner.locate(pass * 201 + 200).end, Position(603));
    }
}

void TestLevelSequence::structureDoesNotGrowWithCounts()
{
    for (const std::uint64_t count : {1ull, 100ull, 1'000'000'000'000ull, 1ull << 62}) {
        LevelSequence::Builder builder;
        builder.beginRepeat(count);
        builder.addLevel(0);
        builder.addLevel(1);
        builder.endRepeat();
        const LevelSequence levels = std::move(builder).build();
        QCOMPARE(levels.slotCount(), 2u);
        QCOMPARE(levels.levelCount(), 2 * count);
    }
}

void TestLevelSequence::positionsOfHugeRepeats()
{
    // ((A B)^n C)^m with n·m near the greatest: position k is C where k mod (2n + 1) is 2n.
    constexpr std::uint64_t n = 3'000'000'000;
    constexpr std::uint64_t m = 1'500'000'000;
    LevelSequence::Builder builder;
    builder.beginRepeat(m);
    builder.beginRepeat(n);
    builder.addLevel(0);
    builder.addLevel(1);
    builder.endRepeat();
    builder.addLevel(2);
    builder.endRepeat();
    const LevelSequence levels = std::move(builder).build();
    QCOMPARE(levels.levelCount(), m * (2 * n + 1));
    std::mt19937_64 random(seed(3));
    for (int i = 0; i < 10'000; ++i) {
        const Position position =
            i % 2 == 0 ? random() % levels.levelCount() : (random() % m) * (2 * n + 1) + 2 * n - 2 + random() % 3;
        const Position inPass = position % (2 * n + 1);
        const SetId expected = inPass == 2 * n ? 2 : inPass % 2 == 0 ? 0 : 1;
        QCOMPARE(levels.set(levels.locate(position).slot), expected);
    }
}

void TestLevelSequence::repeatsOfNothingLeaveNothing()
{
    LevelSequence::Builder builder;
    builder.beginRepeat(7);
    builder.beginRepeat(1'000);
    builder.endRepeat();
    builder.endRepeat();
    builder.beginRepeat(0);
    builder.addLevel(3);
    builder.beginRepeat(100);
    builder.addLevel(2);
    builder.endRepeat();
    builder.endRepeat();
    builder.addLevel(4);
    const LevelSequence levels = std::move(builder).build();
    QCOMPARE(levels.levelCount(), Position(1));
    QCOMPARE(levels.slotCount(), 1u);
    QCOMPARE(levels.set(levels.locate(0).slot), SetId(4));
    QCOMPARE(LevelSequence::Builder().build().levelCount(), Position(0));
}

void TestLevelSequence::deepNestingStaysShallow()
{
    // 10,000 repeats, each a level and the next, once: as many levels, and every place found at once.
    LevelSequence::Builder builder;
    for (SetId i = 0; i < 10'000; ++i) {
        builder.beginRepeat(1);
        builder.addLevel(i);
    }
    for (int i = 0; i < 10'000; ++i) {
        builder.endRepeat();
    }
    const LevelSequence levels = std::move(builder).build();
    QCOMPARE(levels.levelCount(), Position(10'000));
    QVERIFY(levels.repeats().size() <= 64);
    for (Position position = 0; position < 10'000; ++position) {
        QCOMPARE(levels.set(levels.locate(position).slot), SetId(position));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestLevelSequence)

#include "testlevelsequence.moc"
