// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/share.h"

#include <cmath>

#include <QTest>

#include "core/measure/spread.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestShare : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void intervalsAreWilsons();
    void noneAndAllHaveTheirClosedForm();
    void intervalsHoldTheTruthAsOftenAsTheySay();
    void sixteenHundredAreEnough();
    void quantilesCount();
};

void TestShare::intervalsAreWilsons()
{
    // 15 of 148: Newcombe (1998), table I
    const auto [least, greatest] = Share{15, 148}.interval();
    QVERIFY(std::abs(least - 0.0624) < 5e-5);
    QVERIFY(std::abs(greatest - 0.1605) < 5e-5);
    const auto [leastOfMany, greatestOfMany] = Share{81, 263}.interval();
    QVERIFY(std::abs(leastOfMany - 0.2553) < 5e-5);
    QVERIFY(std::abs(greatestOfMany - 0.3662) < 5e-5);
}

void TestShare::noneAndAllHaveTheirClosedForm()
{
    const double square = 1.959963984540054 * 1.959963984540054;
    for (const std::size_t of : {1, 20, 29, 1600}) {
        const double bound = square / (static_cast<double>(of) + square);
        const auto none = Share{0, of}.interval();
        QCOMPARE(none.least, 0.0);
        QVERIFY(std::abs(none.greatest - bound) < 1e-12);
        const auto all = Share{of, of}.interval();
        QCOMPARE(all.greatest, 1.0);
        QVERIFY(std::abs(all.least - (1.0 - bound)) < 1e-12);
    }
}

/// By the probability of each count, not by chance.
void TestShare::intervalsHoldTheTruthAsOftenAsTheySay()
{
    constexpr std::size_t of = 200;
    double sum = 0.0;
    int truths = 0;
    for (double truth = 0.05; truth < 0.96; truth += 0.01) {
        double covered = 0.0;
        for (std::size_t count = 0; count <= of; ++count) {
            const auto n = static_cast<double>(of);
            const auto k = static_cast<double>(count);
            const double logarithm = std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)
                + k * std::log(truth) + (n - k) * std::log(1 - truth);
            const auto [least, greatest] = Share{count, of}.interval();
            covered += truth >= least && truth <= greatest ? std::exp(logarithm) : 0.0;
        }
        QVERIFY2(covered > 0.92 && covered < 0.98, qPrintable(QStringLiteral("%1 of %2").arg(covered).arg(truth)));
        sum += covered;
        ++truths;
    }
    QVERIFY(std::abs(sum / truths - 0.95) < 0.005);
}

void TestShare::sixteenHundredAreEnough()
{
    const auto half = Share{800, 1600}.interval();
    QVERIFY(half.greatest - half.least < 0.049);
    const auto none = Share{0, 1600}.interval();
    QVERIFY(none.greatest < 0.00241 && none.greatest > 0.00239);
}

void TestShare::quantilesCount()
{
    std::vector<double> values;
    for (int i = 1; i <= 200; ++i) {
        values.push_back((i * 37) % 201);
    }
    QCOMPARE(quantile(values, 0.99), 198.0);
    QCOMPARE(quantile(values, 1.0), 200.0);
    QCOMPARE(quantile({5.0}, 0.01), 5.0);
    const Spread spread = spreadOf({7, 1, 3, 2, 6, 5, 4});
    QCOMPARE(spread.median, 4.0);
    QCOMPARE(spread.lowerQuartile, 2.0);
    QCOMPARE(spread.upperQuartile, 6.0);
}

}

ROMANESCO_TEST(romanesco::test::TestShare)

#include "testshare.moc"
