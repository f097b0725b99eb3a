// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/frameerror.h"

#include <cmath>
#include <random>
#include <vector>

#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

class TestFrameError : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void equalPicturesAreNotOff();
    void itIsTheRootOfTheMeanSquare();
    void oneColourIsEnoughForAPixel();
    void itIsTheSameBothWays();
};

void TestFrameError::equalPicturesAreNotOff()
{
    const std::vector<std::uint8_t> picture{0, 128, 255, 3, 2, 1};
    QCOMPARE(errorOf(picture, picture).rms, 0.0);
    QCOMPARE(errorOf(picture, picture).share, 0.0);
}

void TestFrameError::itIsTheRootOfTheMeanSquare()
{
    const std::vector<std::uint8_t> black(12, 0);
    QCOMPARE(errorOf(std::vector<std::uint8_t>(12, 255), black).rms, 255.0);
    // one of four pixels by 3, 4 and 12: the root of 169 / 12
    std::vector<std::uint8_t> picture = black;
    picture[3] = 3;
    picture[4] = 4;
    picture[5] = 12;
    QCOMPARE(errorOf(picture, black).rms, std::sqrt(169.0 / 12.0));
    QCOMPARE(errorOf(picture, black).share, 0.25);
}

/// By more than 8: not by 8.
void TestFrameError::oneColourIsEnoughForAPixel()
{
    const std::vector<std::uint8_t> grey(15, 100);
    std::vector<std::uint8_t> picture = grey;
    picture[0] = 108;
    QCOMPARE(errorOf(picture, grey).share, 0.0);
    picture[4] = 91;
    picture[8] = 109;
    QCOMPARE(errorOf(picture, grey).share, 0.4);
}

void TestFrameError::itIsTheSameBothWays()
{
    std::mt19937 random(seed(1));
    std::vector<std::uint8_t> a(3 * 500);
    std::vector<std::uint8_t> b(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = static_cast<std::uint8_t>(random());
        b[i] = static_cast<std::uint8_t>(random());
    }
    QCOMPARE(errorOf(a, b).rms, errorOf(b, a).rms);
    QCOMPARE(errorOf(a, b).share, errorOf(b, a).share);
    QVERIFY(std::abs(errorOf(a, b).rms - 104.0) < 5.0); // of two evenly spread: 255 / sqrt(6)
}

}

ROMANESCO_TEST(romanesco::test::TestFrameError)

#include "testframeerror.moc"
