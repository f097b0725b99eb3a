// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "app/window/countwords.h"

using namespace romanesco;

class TestCountWords : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void countsAreWrittenForPeople_data();
    void countsAreWrittenForPeople();
    void theLocaleSeparates();
    void aSummaryShowsThePower();
    void whatIsEqualIsSaidOnce();
};

void TestCountWords::countsAreWrittenForPeople_data()
{
    QTest::addColumn<int>("base");
    QTest::addColumn<qulonglong>("exponent");
    QTest::addColumn<QString>("text");
    QTest::newRow("nothing") << 0 << 1ull << QStringLiteral("0");
    QTest::newRow("small") << 7 << 1ull << QStringLiteral("7");
    QTest::newRow("appendix b") << 25 << 6ull << QStringLiteral("244,140,625");
    QTest::newRow("15 digits") << 10 << 14ull << QStringLiteral("100,000,000,000,000");
    QTest::newRow("16 digits") << 10 << 15ull << QStringLiteral("1.00 × 10¹⁵");
    QTest::newRow("long") << 20 << 30ull << QStringLiteral("1.07 × 10³⁹");
    QTest::newRow("no longer exact") << 10 << 1'000'000ull << QStringLiteral("≈ 1.00 × 10¹⁰⁰⁰⁰⁰⁰");
}

void TestCountWords::countsAreWrittenForPeople()
{
    QFETCH(const int, base);
    QFETCH(const qulonglong, exponent);
    const Count count = power(Count(static_cast<std::uint64_t>(base)), exponent);
    QTEST(countText(count, QLocale(QLocale::English)), "text");
}

void TestCountWords::theLocaleSeparates()
{
    QCOMPARE(countText(Count(1'234'567), QLocale(QLocale::German)), QStringLiteral("1.234.567"));
}

void TestCountWords::aSummaryShowsThePower()
{
    Summary summary;
    summary.iteration = Summary::Iteration{25, 6};
    summary.instancesAsWritten = Count(244'140'625);
    summary.instancesDistinct = Count(172'855'881);
    summary.facesAsWritten = Count(2'929'687'500);
    QCOMPARE(summaryText(summary, QLocale(QLocale::English)),
             QStringLiteral("25⁶ = 244,140,625 copies as written · 172,855,881 distinct · 2,929,687,500 faces"));
}

void TestCountWords::whatIsEqualIsSaidOnce()
{
    Summary summary;
    summary.instancesAsWritten = Count(8);
    summary.instancesDistinct = Count(8);
    summary.facesAsWritten = Count(96);
    QCOMPARE(summaryText(summary, QLocale(QLocale::English)), QStringLiteral("8 copies as written · 96 faces"));
}

QTEST_MAIN(TestCountWords)
#include "testcountwords.moc"
