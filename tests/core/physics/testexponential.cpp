// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/physics/exponential.h"

#include <cmath>
#include <limits>
#include <random>

#include <QTest>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/testmain.h"

namespace romanesco::test {

class TestExponential : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itIsWithinTwoUnits();
    void theEndsAreSafe();
};

void TestExponential::itIsWithinTwoUnits()
{
    using Wide = boost::multiprecision::cpp_bin_float_quad;
    std::mt19937_64 random(seed(1));
    std::uniform_real_distribution<double> size(-12, 2.85);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double x = std::min(708.9, std::pow(10.0, size(random))) * (i % 2 == 0 ? -1 : 1);
        if (x < -708) {
            continue;
        }
        const double found = exponential(x);
        const Wide truth = exp(Wide(x));
        const double unit = std::nextafter(found, 1e308) - found;
        worst = std::max(worst, std::abs(static_cast<double>((Wide(found) - truth) / unit)));
    }
    QVERIFY2(worst < 2, qPrintable(QString::number(worst)));
}

void TestExponential::theEndsAreSafe()
{
    QCOMPARE(exponential(0), 1.0);
    QCOMPARE(exponential(-1e300), 0.0);
    QCOMPARE(exponential(-std::numeric_limits<double>::infinity()), 0.0);
    QCOMPARE(exponential(1000), std::numeric_limits<double>::infinity());
    QVERIFY(exponential(-708) >= std::numeric_limits<double>::min());
    QVERIFY(std::isnan(exponential(std::nan(""))));
}

}

ROMANESCO_TEST(romanesco::test::TestExponential)

#include "testexponential.moc"
