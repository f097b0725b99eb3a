// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <array>
#include <cmath>
#include <random>

#include <QTest>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/geometry/longmap.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// The oracle: 600 digits, rounded where they end.
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<600>, boost::multiprecision::et_off>;

struct Written {
    std::array<std::array<Digits, 3>, 4> columns{};

    /// The last column is the translation.
    [[nodiscard]] Written then(const AffineMap &inner) const
    {
        Written product;
        for (int column = 0; column < 4; ++column) {
            const glm::dvec3 v = column < 3 ? inner.linear[column] : inner.translation;
            for (std::size_t row = 0; row < 3; ++row) {
                product.columns[static_cast<std::size_t>(column)][row] = columns[0][row] * v.x + columns[1][row] * v.y
                    + columns[2][row] * v.z + (column < 3 ? Digits(0) : columns[3][row]);
            }
        }
        return product;
    }
};

AffineMap randomMap(std::mt19937_64 &random, double scale)
{
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    AffineMap map = mapFromParts({number(random), number(random), number(random)},
                                 {180 * number(random), 180 * number(random), 180 * number(random)}, glm::dvec3(scale));
    map.linear[0][1] *= 1.0 + 1e-3 * number(random);
    return map;
}

}

class TestLongMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void productsKeepTheirDigits();
    void whatDoublesHoldIsExact();
};

/// Two ways that part and come together: their difference is as small as their ends, to the last of its digits.
void TestLongMap::productsKeepTheirDigits()
{
    std::mt19937_64 random(seed(17));
    for (const int levels : {1, 40, 600}) {
        const AffineMap start = randomMap(random, 1.0);
        LongMap one(start.linear, 1600);
        LongMap other = one;
        Written oneWritten;
        for (std::size_t i = 0; i < 9; ++i) {
            oneWritten.columns[i / 3][i % 3] = start.linear[static_cast<int>(i / 3)][static_cast<int>(i % 3)];
        }
        Written otherWritten = oneWritten;
        for (int level = 0; level < levels; ++level) {
            const AffineMap map = randomMap(random, 0.3);
            AffineMap near = map;
            near.translation.x += std::ldexp(1.0, -level % 50);
            one = one * map;
            other = other * near;
            oneWritten = oneWritten.then(map);
            otherWritten = otherWritten.then(near);
        }
        const double exponent = -1.7 * levels + 0.3;
        const Digits unit = pow(Digits(2), Digits(exponent));
        LongMap between = other;
        between.moveTo(one);
        const AffineMap found = between.dividedBy(0.0);
        const AffineMap small = between.dividedBy(exponent);
        for (std::size_t row = 0; row < 3; ++row) {
            const int i = static_cast<int>(row);
            const Digits exact = otherWritten.columns[3][row] - oneWritten.columns[3][row];
            QVERIFY(abs(found.translation[i] - exact) <= 1e-15 * abs(exact));
            for (std::size_t column = 0; column < 3; ++column) {
                const Digits number = otherWritten.columns[column][row];
                const double scaled = small.linear[static_cast<int>(column)][i];
                QVERIFY(abs(scaled - number / unit) <= 2e-15 * abs(number / unit));
            }
        }
        between.moveToOrigin();
        QVERIFY(between.dividedBy(0.0).translation == glm::dvec3(0.0));
    }
}

/// Of either sign, however many bits they have.
void TestLongMap::whatDoublesHoldIsExact()
{
    const glm::dmat3 numbers(1.0, -1.0, 0.0, 0x1.fffffffffffffp200, -0x1.fffffffffffffp3, 0x1p-300, -0x1.8p-299, 0.3,
                             -0x1.000000001p90);
    for (const unsigned bits : {400u, 463u, 464u, 465u, 1000u}) {
        const LongMap map(numbers, bits);
        QVERIFY(map.dividedBy(0.0).linear == numbers);
        QVERIFY(map.dividedBy(3.0).linear == numbers / 8.0);
        QVERIFY(map.dividedBy(-100.0).linear == numbers * 0x1p100);
        QVERIFY((map * AffineMap{glm::dmat3(2.0), {0, 0, 1}}).dividedBy(1.0) == (AffineMap{numbers, 0.5 * numbers[2]}));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestLongMap)
#include "testlongmap.moc"
