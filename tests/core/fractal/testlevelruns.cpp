// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/levelruns.h"

#include <QTest>

#include "tests/core/naive.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Item = naive::Fractal::Item;

/// The sets of the runs' levels, written out by the nesting that the sequence was made from.
void writeOut(const std::vector<LevelRun> &runs, const LevelSequence &levels, std::vector<SetId> &all)
{
    for (const LevelRun &run : runs) {
        if (run.repeat == 0) {
            all.push_back(levels.set(run.slot));
            continue;
        }
        const LevelSequence::Repeat &repeat = levels.repeats()[run.repeat];
        std::vector<LevelRun> pass;
        LevelSequence::Slot slot = repeat.firstSlot;
        for (const std::uint32_t inner : repeat.inner) {
            for (; slot < levels.repeats()[inner].firstSlot; ++slot) {
                pass.push_back({slot, 0, 1});
            }
            pass.push_back({0, inner, levels.repeats()[inner].count});
            slot = levels.repeats()[inner].endSlot;
        }
        for (; slot < repeat.endSlot; ++slot) {
            pass.push_back({slot, 0, 1});
        }
        for (std::uint64_t i = 0; i < run.passes; ++i) {
            writeOut(pass, levels, all);
        }
    }
}

}

class TestLevelRuns : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runsAreTheLevelsWrittenOut();
    void runsAreFewAtAnyDepth();
};

void TestLevelRuns::runsAreTheLevelsWrittenOut()
{
    std::mt19937_64 random(seed(61));
    int nested = 0;
    for (int round = 0; round < 1'000; ++round) {
        naive::Fractal fractal;
        fractal.sets.assign(5, {});
        do {
            fractal.items = naive::randomItems(random, 5, 0, 90);
        } while (fractal.setsOfLevels().size() > 20'000);
        const std::vector<SetId> sets = fractal.setsOfLevels();
        const LevelSequence levels = fractal.description().levels;
        nested += levels.repeats().size() > 2 ? 1 : 0;
        for (int i = 0; i < 10 && !sets.empty(); ++i) {
            const Position begin = random() % sets.size();
            std::vector<Position> ends{sets.size()};
            Position end = 0;
            for (const Item &item : fractal.items) { // where no repeat goes over
                naive::Fractal alone;
                alone.items = {item};
                end += alone.setsOfLevels().size();
                if (end >= begin) {
                    ends.push_back(end);
                }
            }
            end = ends[random() % ends.size()];
            std::vector<SetId> found;
            writeOut(runsBetween(levels, begin, end), levels, found);
            QVERIFY(found
                    == std::vector<SetId>(sets.begin() + static_cast<std::ptrdiff_t>(begin),
                                          sets.begin() + static_cast<std::ptrdiff_t>(end)));
        }
    }
    QVERIFY2(nested > 50, QByteArray::number(nested));
}

void TestLevelRuns::runsAreFewAtAnyDepth()
{
    constexpr std::uint64_t many = 1'000'000;
    naive::Fractal fractal;
    fractal.sets.assign(3, {});
    fractal.items = {{many, 0, {{many, 0, {{0, 0, {}}, {0, 1, {}}}}, {many, 0, {{0, 2, {}}}}}}};
    const LevelSequence levels = fractal.description().levels;
    for (const Position begin : {Position(0), Position(1), 2 * many + 5, 3 * many, 4 * many + 1, 3 * many * many - 1}) {
        const std::vector<LevelRun> runs = runsBetween(levels, begin, levels.levelCount());
        QVERIFY(runs.size() <= 5);
        Position length = 0;
        for (const LevelRun &run : runs) {
            length += run.repeat == 0 ? 1 : run.passes * levels.repeats()[run.repeat].passLength;
        }
        QCOMPARE(length, levels.levelCount() - begin);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestLevelRuns)

#include "testlevelruns.moc"
