// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/base/threadteam.h"

#include <numeric>

#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

class TestThreadTeam : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRoundIsWorkedOnOnce_data();
    void everyRoundIsWorkedOnOnce();
    void oneLoopFollowsAnother();
};

void TestThreadTeam::everyRoundIsWorkedOnOnce_data()
{
    QTest::addColumn<unsigned>("threads");
    QTest::addColumn<std::size_t>("count");
    for (const unsigned threads : {1u, 2u, 5u}) {
        for (const std::size_t count : {0u, 1u, 7u, 8u, 1000u}) {
            QTest::addRow("%u threads, %zu rounds", threads, count) << threads << count;
        }
    }
}

void TestThreadTeam::everyRoundIsWorkedOnOnce()
{
    QFETCH(const unsigned, threads);
    QFETCH(const std::size_t, count);
    ThreadTeam team(threads);
    QCOMPARE(team.size(), threads);
    std::vector<int> rounds(count);
    std::vector<int> byThread(threads);
    team.run(count, 7, [&](std::size_t first, std::size_t last, unsigned thread) {
        byThread.at(thread) += static_cast<int>(last - first); // no other has that number now
        for (std::size_t i = first; i < last; ++i) {
            ++rounds[i];
        }
    });
    QCOMPARE(rounds, std::vector<int>(count, 1));
    QCOMPARE(std::accumulate(byThread.begin(), byThread.end(), 0), static_cast<int>(count));
}

/// What one has written the next reads, on whatever thread.
void TestThreadTeam::oneLoopFollowsAnother()
{
    ThreadTeam team(3);
    std::vector<int> numbers(100, 1);
    for (int loop = 0; loop < 2000; ++loop) {
        std::vector<int> sums(100);
        team.run(100, 9, [&](std::size_t first, std::size_t last, unsigned) {
            for (std::size_t i = first; i < last; ++i) {
                sums[i] = (numbers[i] + numbers[(i * 37 + 1) % 100]) % 1000;
            }
        });
        std::vector<int> expected(100);
        for (std::size_t i = 0; i < 100; ++i) {
            expected[i] = (numbers[i] + numbers[(i * 37 + 1) % 100]) % 1000;
        }
        QCOMPARE(sums, expected);
        numbers = sums;
    }
}

}

ROMANESCO_TEST(romanesco::test::TestThreadTeam)

#include "testthreadteam.moc"
