// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/base/count.h"

#include <cmath>
#include <limits>

#include <QTest>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <rapidcheck.h>

#include "tests/testmain.h"

namespace mp = boost::multiprecision;

namespace romanesco::test {

namespace {

QString text(const Count &count)
{
    return QString::fromStdString(count.toString());
}

Count fromInteger(const mp::cpp_int &value)
{
    Count sum(0);
    mp::cpp_int rest = value;
    Count place(1);
    while (rest != 0) {
        sum += place * Count(static_cast<std::uint64_t>(rest & 0xFFFFFFFFu));
        place *= Count(0x100000000u);
        rest >>= 32;
    }
    return sum;
}

/// "~8.81e646456992" of base^exponent through logarithms, in 150 decimal digits: shares nothing with Count.
QString shownPower(std::uint64_t base, std::uint64_t exponent)
{
    using Decimal = mp::number<mp::cpp_dec_float<150>>;
    const Decimal logarithm = mp::log10(Decimal(base)) * Decimal(exponent);
    const Decimal whole = mp::floor(logarithm);
    Decimal mantissa = mp::pow(Decimal(10), Decimal(logarithm - whole));
    mp::cpp_int hundredths(mp::floor(mantissa * 100 + Decimal(0.5)));
    mp::cpp_int shown(whole);
    if (hundredths == 1000) {
        hundredths = 100;
        ++shown;
    }
    const std::string digits = hundredths.str();
    return QString::fromStdString("~" + digits.substr(0, 1) + "." + digits.substr(1) + "e" + shown.str());
}

}

class TestCount : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void smallValuesAreTheirDigits_data();
    void smallValuesAreTheirDigits();
    void sumsAndProductsAreExact();
    void exactUpToTenThousandDigits();
    void hugePowersShowMantissaAndExponent_data();
    void hugePowersShowMantissaAndExponent();
    void roundingUpOfTheMantissaCarries();
    void mixedSumsAndProducts();
    void zeroIsNeutralAndAbsorbs();
    void logarithms();
};

void TestCount::smallValuesAreTheirDigits_data()
{
    QTest::addColumn<quint64>("value");
    QTest::addColumn<QString>("shown");
    QTest::newRow("zero") << quint64(0) << "0";
    QTest::newRow("one") << quint64(1) << "1";
    QTest::newRow("25^6") << quint64(244'140'625) << "244140625";
    QTest::newRow("2^64-1") << std::numeric_limits<quint64>::max() << "18446744073709551615";
}

void TestCount::smallValuesAreTheirDigits()
{
    QFETCH(quint64, value);
    QTEST(text(Count(value)), "shown");
    QVERIFY(Count(value).isExact());
    QCOMPARE(Count(value).isZero(), value == 0);
}

void TestCount::sumsAndProductsAreExact()
{
    QCOMPARE(text(power(Count(25), 6)), "244140625");
    QCOMPARE(text(power(Count(1000), 1000)), "1" + QString(3000, QLatin1Char('0')));
    QCOMPARE(text(power(Count(7), 0)), "1");
    QCOMPARE(text(power(Count(0), 0)), "1");
    QCOMPARE(text(power(Count(0), 5)), "0");
    QVERIFY(rc::check([](std::vector<std::uint32_t> a, std::vector<std::uint32_t> b) {
        mp::cpp_int x = 0;
        mp::cpp_int y = 0;
        for (const std::uint32_t digit : a) {
            x = (x << 32) + digit;
        }
        for (const std::uint32_t digit : b) {
            y = (y << 32) + digit;
        }
        RC_ASSERT((fromInteger(x) + fromInteger(y)).toString() == mp::cpp_int(x + y).str());
        RC_ASSERT((fromInteger(x) * fromInteger(y)).toString() == mp::cpp_int(x * y).str());
    }));
}

void TestCount::exactUpToTenThousandDigits()
{
    const Count ten(10);
    const Count nines = fromInteger(mp::pow(mp::cpp_int(10), 10'000) - 1);
    QVERIFY(nines.isExact());
    QCOMPARE(text(nines), QString(10'000, QLatin1Char('9')));
    QVERIFY(!(nines + Count(1)).isExact());
    QCOMPARE(text(nines + Count(1)), "~1.00e10000");
    QVERIFY(power(ten, 9'999).isExact());
    QVERIFY(!power(ten, 10'000).isExact());
    QCOMPARE(text(power(ten, 10'000)), "~1.00e10000");
    QVERIFY(power(Count(2), 33'219).isExact());
    QVERIFY(!power(Count(2), 33'220).isExact());
}

void TestCount::hugePowersShowMantissaAndExponent_data()
{
    QTest::addColumn<quint64>("base");
    QTest::addColumn<quint64>("exponent");
    constexpr quint64 largestDepth = std::numeric_limits<qint64>::max();
    for (const quint64 base : {2u, 3u, 7u, 25u, 999u, 1000u, 4'294'967'295u}) {
        for (const quint64 exponent : {quint64(40'000), quint64(1'000'003), quint64(2'147'483'647), largestDepth}) {
            QTest::addRow("%llu^%llu", base, exponent) << base << exponent;
        }
    }
    QTest::newRow("2^2^63") << quint64(2) << (quint64(1) << 63);
}

void TestCount::hugePowersShowMantissaAndExponent()
{
    QFETCH(quint64, base);
    QFETCH(quint64, exponent);
    const Count count = power(Count(base), exponent);
    QVERIFY(!count.isExact());
    QCOMPARE(text(count), shownPower(base, exponent));
    if (base == 2 && exponent == 2'147'483'647) {
        QCOMPARE(text(count), "~8.81e646456992");
    }
}

void TestCount::roundingUpOfTheMantissaCarries()
{
    // 9.996 · 10^12000 is nearest to 1.00e12001, and 9.994 · 10^12000 to 9.99e12000.
    const Count place = power(Count(10), 11'997);
    QCOMPARE(text(place * Count(9996)), "~1.00e12001");
    QCOMPARE(text(place * Count(9994)), "~9.99e12000");
    QCOMPARE(text(place * Count(1004)), "~1.00e12000");
    QCOMPARE(text(place * Count(1006)), "~1.01e12000");
}

void TestCount::mixedSumsAndProducts()
{
    const Count large = power(Count(10), 20'000);
    QCOMPARE(text(large + Count(1)), "~1.00e20000");
    QCOMPARE(text(Count(1) + large), "~1.00e20000");
    QCOMPARE(text(large + large), "~2.00e20000");
    QCOMPARE(text(large + power(Count(10), 19'998) * Count(250)), "~3.50e20000");
    QCOMPARE(text(power(Count(10), 19'998) * Count(250) + large), "~3.50e20000");
    QCOMPARE(text(large * Count(12'345)), "~1.23e20004"); // 1.2345
    QCOMPARE(text(Count(12'345) * large), "~1.23e20004");
    QCOMPARE(text(large * large), "~1.00e40000");
    QVERIFY(!(large + Count(1)).isExact());

    // A sum of many small parts is not lost in a large one: 10^4 times 10^-4 of it.
    Count sum = large;
    const Count part = power(Count(10), 19'996);
    for (int i = 0; i < 10'000; ++i) {
        sum += part;
    }
    QCOMPARE(text(sum), "~2.00e20000");
}

void TestCount::zeroIsNeutralAndAbsorbs()
{
    const Count large = power(Count(10), 20'000);
    QCOMPARE(text(large + Count(0)), text(large));
    QCOMPARE(text(Count(0) + large), text(large));
    QVERIFY((large * Count(0)).isZero());
    QVERIFY((Count(0) * large).isZero());
    QVERIFY((Count(0) * large).isExact());
    QVERIFY(Count(3) == Count(1) + Count(2));
    QVERIFY(!(large == Count(3)));
}

void TestCount::logarithms()
{
    QCOMPARE(Count(0).log10(), -std::numeric_limits<double>::infinity());
    QCOMPARE(Count(1).log10(), 0.0);
    QCOMPARE(Count(1000).log10(), 3.0);
    QCOMPARE(power(Count(2), 2'147'483'647).log10(), 2'147'483'647 * std::log10(2.0));
    QVERIFY(std::abs(power(Count(25), 1'000).log10() - 1'000 * std::log10(25.0)) < 1e-9);
}

}

ROMANESCO_TEST(romanesco::test::TestCount)

#include "testcount.moc"
