// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/numbertext.h"

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::string textOf(NumberText &numbers, double value)
{
    std::array<char, NumberText::mostBytes> buffer;
    return {buffer.data(), numbers.write(buffer.data(), value)};
}

/// Of any bits that are a number, and now and then the same again.
double wildDouble(std::mt19937_64 &random)
{
    static double last = 0.0;
    if (random() % 4 == 0) {
        return last;
    }
    do {
        last = std::bit_cast<double>(random());
    } while (!std::isfinite(last));
    return last;
}

}

class TestNumberText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersReadBackToTheLastBit();
    void noShorterTextReadsBack();
    void digitsAreAsManyAsWanted();
    void theLongestNumbersFit();
    void localesDoNotMatter();
};

void TestNumberText::numbersReadBackToTheLastBit()
{
    std::mt19937_64 random(seed(1));
    NumberText numbers;
    for (int i = 0; i < 200'000; ++i) {
        const double value = wildDouble(random);
        const double back = std::strtod(textOf(numbers, value).c_str(), nullptr);
        QCOMPARE(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value));
    }
    for (const double value : {0.0, -0.0, std::numeric_limits<double>::denorm_min(), 1.0 / 3.0}) {
        const double back = std::strtod(textOf(numbers, value).c_str(), nullptr);
        QCOMPARE(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value));
    }
}

void TestNumberText::noShorterTextReadsBack()
{
    std::mt19937_64 random(seed(2));
    NumberText numbers;
    for (int i = 0; i < 20'000; ++i) {
        const double value = wildDouble(random);
        const std::string text = textOf(numbers, value);
        const auto digits =
            std::ranges::count_if(text.substr(0, text.find('e')), [](char c) { return c >= '0' && c <= '9'; });
        if (text.find('e') != std::string::npos && digits > 1) {
            char shorter[64];
            std::snprintf(shorter, sizeof(shorter), "%.*e", static_cast<int>(digits) - 2, value);
            QVERIFY2(std::strtod(shorter, nullptr) != value, shorter);
        }
    }
}

void TestNumberText::digitsAreAsManyAsWanted()
{
    std::mt19937_64 random(seed(3));
    for (const int digits : {1, 3, 6, 15, 17}) {
        NumberText numbers(digits);
        for (int i = 0; i < 20'000; ++i) {
            const double value = wildDouble(random);
            char printed[64];
            std::snprintf(printed, sizeof(printed), "%.*g", digits, value);
            QCOMPARE(textOf(numbers, value), std::string(printed));
        }
    }
}

void TestNumberText::theLongestNumbersFit()
{
    NumberText numbers;
    QCOMPARE(textOf(numbers, -2.2250738585072014e-308), std::string("-2.2250738585072014e-308"));
    NumberText digits(17);
    QCOMPARE(textOf(digits, -1.2345678901234567e-4).size(), std::size_t{23});
}

void TestNumberText::localesDoNotMatter()
{
    const std::string before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // where there is none, nothing changes
    NumberText numbers;
    NumberText digits(4);
    const std::string texts = textOf(numbers, 1234.5) + " " + textOf(digits, 0.5);
    std::setlocale(LC_ALL, before.c_str());
    QCOMPARE(texts, std::string("1234.5 0.5"));
}

}

ROMANESCO_TEST(romanesco::test::TestNumberText)
#include "testnumbertext.moc"
