// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/numbers.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <QTest>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <rapidcheck.h>

#include "tests/testmain.h"

namespace romanesco::test {

class TestNumbers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void spellings_data();
    void spellings();
    void overflowAndUnderflowByAnySpelling_data();
    void overflowAndUnderflowByAnySpelling();
    void seventeenDigitsComeBack();
    void readingIsCorrectlyRounded();
    void wholeNumbers_data();
    void wholeNumbers();
};

void TestNumbers::spellings_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value"); // NaN: malformed
    const auto good = [](const char *text, double value) { QTest::newRow(text) << QString::fromLatin1(text) << value; };
    const auto bad = [&](const char *text) { good(text, std::numeric_limits<double>::quiet_NaN()); };
    good("0", 0);
    good("-0", -0.0);
    good("1", 1);
    good("+1", 1);
    good("-1", -1);
    good("007", 7);
    good(".5", 0.5);
    good("-.5", -0.5);
    good("+.5", 0.5);
    good("5.", 5);
    good("5.e1", 50);
    good(".5e1", 5);
    good("1e5", 1e5);
    good("1E5", 1e5);
    good("1e+5", 1e5);
    good("1e-5", 1e-5);
    good("1e005", 1e5);
    good("0e999999999999", 0);
    good("0.0e-999999999999", 0);
    good("1.7976931348623157e308", std::numeric_limits<double>::max());
    good("4.9406564584124654e-324", std::numeric_limits<double>::denorm_min());
    good("0.1", 0.1);
    good("9007199254740993", 9007199254740992.0); // a tie goes to the even one
    for (const char *text :
         {"",      "+",   "-",      ".",   "-.",   "e5",  ".e5",   "1e",    "1e+", "1e-", "1e5.", "1e5.5",
          "1.2.3", "1,5", "--1",    "+-1", "-+1",  "++1", "0x10",  "0x1p3", "1p3", "inf", "-inf", "infinity",
          "nan",   "NaN", "nan(1)", "1f",  "1.0f", "1d",  "1_000", "1'000", " 1",  "1 ",  "1\n",  "\u0661"}) {
        bad(text);
    }
}

void TestNumbers::spellings()
{
    QFETCH(QString, text);
    QFETCH(double, value);
    const ParsedNumber number = numberFromText(text.toStdString());
    QCOMPARE(number.status, std::isnan(value) ? NumberStatus::Malformed : NumberStatus::Good);
    if (!std::isnan(value)) {
        QVERIFY(number.value == value);
        QCOMPARE(std::signbit(number.value), std::signbit(value));
    }
}

void TestNumbers::overflowAndUnderflowByAnySpelling_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isLarge");
    const auto row = [](const QString &text, bool isLarge) {
        const QString shown = text.left(20) + QStringLiteral("…") + text.right(20);
        QTest::newRow(qPrintable(shown)) << text << isLarge;
        QTest::newRow(qPrintable("minus " + shown)) << QString("-" + text) << isLarge;
    };
    const QString zeros(400, QLatin1Char('0'));
    row("1e400", true);
    row("1.7976931348623159e308", true);
    row("179769313486231590" + zeros, true);
    row("0.00001e314", true);
    row("1" + zeros + "e-91", true);
    row("0." + zeros + "1e710", true);
    row("1e99999999999999999999999", true);
    row("1e-400", false);
    row("2e-324", false);
    row("0." + zeros + "1", false);
    row("100000e-330", false);
    row("1" + zeros + "e-725", false);
    row("0." + zeros + "1e76", false);
    row("1e-99999999999999999999999", false);
    row("00000000000000000000000000000000000001e-340", false);
}

void TestNumbers::overflowAndUnderflowByAnySpelling()
{
    QFETCH(QString, text);
    QFETCH(bool, isLarge);
    const ParsedNumber number = numberFromText(text.toStdString());
    QCOMPARE(number.status, isLarge ? NumberStatus::Overflow : NumberStatus::Underflow);
    QVERIFY(isLarge || number.value == 0.0);
}

void TestNumbers::seventeenDigitsComeBack()
{
    QVERIFY(rc::check([](std::uint64_t bits) {
        const double value = std::bit_cast<double>(bits);
        RC_PRE(std::isfinite(value));
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", value);
        const ParsedNumber number = numberFromText(text);
        RC_ASSERT(number.status == NumberStatus::Good);
        RC_ASSERT(std::bit_cast<std::uint64_t>(number.value) == bits);
    }));
}

void TestNumbers::readingIsCorrectlyRounded()
{
    using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>>;
    QVERIFY(rc::check([](std::uint64_t whole, std::uint64_t fraction) {
        const int exponent = *rc::gen::inRange(-60, 60);
        const std::string text =
            std::to_string(whole) + '.' + std::to_string(fraction) + 'e' + std::to_string(exponent);
        const ParsedNumber number = numberFromText(text);
        RC_ASSERT(number.status == NumberStatus::Good);
        // No double is nearer to the value.
        const Real truth(text);
        const Real error = abs(Real(number.value) - truth);
        RC_ASSERT(error <= abs(Real(std::nextafter(number.value, 0.0)) - truth));
        RC_ASSERT(error <= abs(Real(std::nextafter(number.value, 1e300)) - truth));
    }));
}

void TestNumbers::wholeNumbers_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isWhole");
    QTest::addColumn<quint64>("value");
    constexpr quint64 greatest = std::numeric_limits<quint64>::max();
    QTest::newRow("0") << "0" << true << quint64(0);
    QTest::newRow("05") << "05" << true << quint64(5);
    QTest::newRow("greatest") << "18446744073709551615" << true << greatest;
    QTest::newRow("one more") << "18446744073709551616" << true << greatest;
    QTest::newRow("far more") << QString(1000, QLatin1Char('9')) << true << greatest;
    QTest::newRow("zeros before") << QString(QString(1000, QLatin1Char('0')) + "7") << true << quint64(7);
    for (const char *text : {"", "-1", "+1", "1.", "1.0", "1e0", "a", "1a", " 1", "1 "}) {
        QTest::addRow("\"%s\"", text) << text << false << quint64(0);
    }
}

void TestNumbers::wholeNumbers()
{
    QFETCH(QString, text);
    QFETCH(bool, isWhole);
    QFETCH(quint64, value);
    const std::optional<std::uint64_t> whole = wholeFromText(text.toStdString());
    QCOMPARE(whole.has_value(), isWhole);
    QCOMPARE(whole.value_or(0), value);
}

}

ROMANESCO_TEST(romanesco::test::TestNumbers)

#include "testnumbers.moc"
