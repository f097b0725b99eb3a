// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/counts.h"

#include <string>

#include <QTest>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "tests/core/naive.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using naive::cpp_int;

/// Different maps, by number.
AffineMap numbered(int number)
{
    AffineMap map;
    map.linear *= 0.5;
    map.translation.x = number;
    return map;
}

/// Sets by the maps they hold ("ab#"), and items that name them by index.
naive::Fractal fractal(const std::vector<std::string> &sets, std::vector<naive::Fractal::Item> items)
{
    naive::Fractal result;
    for (int i = 0; i < 26; ++i) {
        result.maps.push_back(numbered(i));
    }
    for (const std::string &set : sets) {
        naive::Level &level = result.sets.emplace_back();
        for (const char c : set) {
            if (c == '#') {
                level.mayPass = true;
            } else {
                level.maps.push_back(c - 'a');
            }
        }
    }
    result.items = std::move(items);
    return result;
}

naive::Fractal::Item level(SetId set)
{
    return {0, set, {}};
}

naive::Fractal::Item repeat(std::uint64_t count, std::vector<naive::Fractal::Item> body)
{
    return {count, 0, std::move(body)};
}

QString distinct(const naive::Fractal &fractal)
{
    const auto graph = FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1});
    const std::optional<Count> count = instancesDistinct(*graph);
    return count ? QString::fromStdString(count->toString()) : QStringLiteral("too long");
}

QString text(const cpp_int &value)
{
    return QString::fromStdString(value.str());
}

constexpr std::uint64_t huge = 1'000'000'000'000'000'000;

}

class TestCounts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void appendixB_data();
    void appendixB();
    void aTreeOfSixBranches();
    void manyLevelsAgreeWithAnAutomaton_data();
    void manyLevelsAgreeWithAnAutomaton();
    void hugeRepeatsHaveTheirClosedForm_data();
    void hugeRepeatsHaveTheirClosedForm();
    void growthBeyondTenThousandDigits();
    void longAndShortRepeatsMeet();
    void nestedLongRepeatsAreNotUnrolled();
    void setsThatAreNotInTheFractalDoNotMatter();
    void sharedMapsBeyondTheLimitAreLeftOut();
    void veryManySetsAreLeftOut();
    void writtenCountsMultiply();
    void aThousandMapsAThousandLevelsDeepAreCounted();
};

void TestCounts::appendixB_data()
{
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<QString>("count");
    quint64 depth = 1;
    for (const char *count : {"25", "585", "13641", "318025", "7414345", "172855881"}) {
        QTest::addRow("depth %llu", depth) << depth << QString::fromLatin1(count);
        ++depth;
    }
}

void TestCounts::appendixB()
{
    QFETCH(quint64, depth);
    QTEST(distinct(fractal({"#abcd", "#efgh"}, {repeat(depth, {level(0), level(1)})})), "count");
}

void TestCounts::aTreeOfSixBranches()
{
    const naive::Fractal tree = fractal({"#abcdef"}, {repeat(5, {level(0)})});
    QCOMPARE(distinct(tree), "9331");
    const auto graph = FractalGraph::build(tree.description(), Sphere{{0, 0, 0}, 1});
    QCOMPARE(instancesAsWritten(*graph).toString(), "16807");
}

void TestCounts::manyLevelsAgreeWithAnAutomaton_data()
{
    QTest::addColumn<QStringList>("sets");
    QTest::addColumn<int>("repeats");
    const auto row = [](const QStringList &sets, int repeats) {
        QTest::newRow(qPrintable(sets.join(QLatin1Char(' ')) + " x " + QString::number(repeats))) << sets << repeats;
    };
    row({"#abc"}, 500);
    row({"#ab", "#cd"}, 300);
    row({"#ab", "#bc"}, 200);
    row({"#ab", "#bc", "#ca"}, 100);
    row({"#ab", "b", "#c"}, 300); // a map that is shared by a set that may be passed and one that may not
    row({"ab", "#abc"}, 200);
    row({"ab", "bc", "#d"}, 600);
    row({"#", "#a", "b"}, 600);
    row({"a", "b", "#c", "#d", "#c"}, 300);
    row({"#ab", "#ba", "#abc"}, 100);
}

void TestCounts::manyLevelsAgreeWithAnAutomaton()
{
    QFETCH(QStringList, sets);
    QFETCH(int, repeats);
    std::vector<std::string> letters;
    std::vector<naive::Fractal::Item> body;
    for (const QString &set : sets) {
        body.push_back(level(static_cast<SetId>(letters.size())));
        letters.push_back(set.toStdString());
    }
    const naive::Fractal whole = fractal(letters, {repeat(static_cast<std::uint64_t>(repeats), body)});
    const naive::Levels levels = whole.levels();
    QCOMPARE(distinct(whole), text(naive::PickCounter(levels).count()));
}

void TestCounts::hugeRepeatsHaveTheirClosedForm_data()
{
    QTest::addColumn<quint64>("n");
    QTest::addColumn<quint64>("m");
    QTest::addColumn<quint64>("k");
    for (const quint64 n : {quint64(1), quint64(1'000), quint64(99'999), quint64(100'001), quint64(huge)}) {
        for (const quint64 m : {quint64(1), quint64(100'000), quint64(200'000), quint64(huge)}) {
            const quint64 k = n / 3 + 7;
            QTest::addRow("%llu %llu %llu", n, m, k) << n << m << k;
        }
    }
}

void TestCounts::hugeRepeatsHaveTheirClosedForm()
{
    QFETCH(quint64, n);
    QFETCH(quint64, m);
    QFETCH(quint64, k);
    // Up to n of a, up to m of b, up to k of a: without a b the two runs of a are one.
    const naive::Fractal runs =
        fractal({"#a", "#b"}, {repeat(n, {level(0)}), repeat(m, {level(1)}), repeat(k, {level(0)})});
    QCOMPARE(distinct(runs), text((cpp_int(n) + 1) * m * (cpp_int(k) + 1) + n + k + 1));

    // Up to n of a, then a c that must be, then up to m of a or b: no more than 2^(m+1) - 1 kinds of the last.
    if (m == 1) {
        const naive::Fractal fixed = fractal({"#a", "c", "#ab"}, {repeat(n, {level(0)}), level(1), level(2)});
        QCOMPARE(distinct(fixed), text((cpp_int(n) + 1) * 3));
    }

    // Passes of up to n of a and one c each: (n + 1)^5.
    const naive::Fractal passes = fractal({"#a", "c"}, {repeat(5, {repeat(n, {level(0)}), level(1)})});
    QCOMPARE(distinct(passes), text(boost::multiprecision::pow(cpp_int(n) + 1, 5)));
}

void TestCounts::growthBeyondTenThousandDigits()
{
    // [#ab] [#c] over and over, against the recurrence of its last places in 120 digits.
    using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<120>>;
    constexpr std::uint64_t passes = 150'000;
    // Words from a level on: all, and those after the first of each set.
    Decimal all = 1;
    Decimal afterAb = 0;
    Decimal afterC = 0;
    for (std::uint64_t i = 0; i < passes; ++i) {
        afterC = all;
        all = 1 + 2 * afterAb + afterC;
        afterAb = all;
        all = 1 + 2 * afterAb + afterC;
    }
    const QString shown = distinct(fractal({"#ab", "#c"}, {repeat(passes, {level(0), level(1)})}));
    const Decimal exponent = floor(log10(all));
    const Decimal mantissa = all / pow(Decimal(10), exponent);
    QCOMPARE(shown, QString::fromStdString("~" + mantissa.str(3) + "e" + cpp_int(exponent).str()));
}

void TestCounts::longAndShortRepeatsMeet()
{
    // The same number with one level more or less where powers of matrices take over.
    for (const std::uint64_t n : {99'998u, 99'999u, 100'000u, 100'001u, 100'002u}) {
        QCOMPARE(distinct(fractal({"#a"}, {repeat(n, {level(0)})})), text(cpp_int(n) + 1));
        QCOMPARE(distinct(fractal({"#a", "#b"}, {level(1), repeat(n, {level(0)}), level(1)})),
                 text(4 * cpp_int(n) + 3));
    }
}

void TestCounts::nestedLongRepeatsAreNotUnrolled()
{
    // 40 repeats in one another, the innermost long: [c] once for each of 2^40 passes, [#a] 200,000 times in each.
    std::vector<naive::Fractal::Item> items{repeat(200'000, {level(0)})};
    for (int i = 0; i < 40; ++i) {
        items = {repeat(2, {items.front(), level(1)})};
    }
    // Of each pass the words multiply with the next, for c parts them.
    const QString shown = distinct(fractal({"#a", "c"}, items));
    QVERIFY(shown.startsWith(QLatin1Char('~')));

    // All passable: picks of one letter, as many as there are levels. Innermost n, then n -> 2·n + 2.
    items = {repeat(200'000, {level(0)})};
    cpp_int levels = 200'000;
    for (int i = 0; i < 40; ++i) {
        items = {repeat(2, {items.front(), level(0)})};
        levels = 2 * levels + 2;
    }
    QCOMPARE(distinct(fractal({"#a"}, items)), text(levels + 1));

    // The level that is not in the inner repeat comes last, so that passes begin inside another repeat.
    items = {repeat(1'000'000'000'000, {repeat(100, {level(0)}), level(0)})};
    QCOMPARE(distinct(fractal({"#a"}, items)), text(cpp_int(101) * 1'000'000'000'000 + 1));
}

void TestCounts::setsThatAreNotInTheFractalDoNotMatter()
{
    // Set 1 would share a map between a set with # and one without.
    QCOMPARE(distinct(fractal({"#a", "a"}, {repeat(huge, {level(0)})})), text(cpp_int(huge) + 1));
}

void TestCounts::sharedMapsBeyondTheLimitAreLeftOut()
{
    QCOMPARE(distinct(fractal({"#ab", "b"}, {repeat(huge, {level(0), level(1)})})), "too long");
}

void TestCounts::veryManySetsAreLeftOut()
{
    // n levels [#, m], of different maps: 2^n. The cost is n², so that it ends at some n.
    const auto count = [](int n) {
        naive::Fractal many;
        for (int i = 0; i < n; ++i) {
            many.maps.push_back(numbered(i));
            many.sets.push_back({{i}, true});
            many.items.push_back(level(static_cast<SetId>(i)));
        }
        return distinct(many);
    };
    QCOMPARE(count(1'000), text(boost::multiprecision::pow(cpp_int(2), 1'000)));
    QCOMPARE(count(20'000), "too long");
}

void TestCounts::writtenCountsMultiply()
{
    const auto written = [](const naive::Fractal &fractal) {
        const auto graph = FractalGraph::build(fractal.description(), Sphere{{0, 0, 0}, 1});
        return QString::fromStdString(instancesAsWritten(*graph).toString());
    };
    QCOMPARE(written(fractal({"#abcd", "#efgh"}, {repeat(6, {level(0), level(1)})})), "244140625");
    QCOMPARE(written(fractal({"ab"}, {repeat(2'147'483'647, {level(0)})})), "~8.81e646456992");
    QCOMPARE(written(fractal({"ab", "abc"}, {level(1), repeat(3, {repeat(100, {level(0)}), level(1)}), level(0)})),
             text(3 * boost::multiprecision::pow(boost::multiprecision::pow(cpp_int(2), 100) * 3, 3) * 2));
    QCOMPARE(written(fractal({"#a"}, {})), "1");
}

/// 10^3000 copies; where each level may be passed over, all shorter words as well.
void TestCounts::aThousandMapsAThousandLevelsDeepAreCounted()
{
    naive::Fractal many;
    many.sets.push_back({{}, false});
    for (int i = 0; i < 1'000; ++i) {
        many.maps.push_back(numbered(i));
        many.sets[0].maps.push_back(i);
    }
    many.items = {repeat(1'000, {level(0)})};
    const QString all = QLatin1Char('1') + QString(3'000, QLatin1Char('0'));
    QCOMPARE(distinct(many), all);
    const auto graph = FractalGraph::build(many.description(), Sphere{{0, 0, 0}, 1});
    QCOMPARE(QString::fromStdString(instancesAsWritten(*graph).toString()), all);
    QVERIFY2(graph->memoryUse() < 1'000'000, qPrintable(QString::number(graph->memoryUse())));
    many.sets[0].mayPass = true;
    const cpp_int thousand = 1'000;
    QCOMPARE(distinct(many), text((boost::multiprecision::pow(thousand, 1'001) - 1) / 999));
}

}

ROMANESCO_TEST(romanesco::test::TestCounts)

#include "testcounts.moc"
