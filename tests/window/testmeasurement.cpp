// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "app/window/measurement.h"

using namespace romanesco;

/// Numbers of what was measured, with as many digits as are true.
class TestMeasurement : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noDigitIsShownThatIsNotTrue_data();
    void noDigitIsShownThatIsNotTrue();
    void placesAreThoseOfTheWorld();
    void directionsHaveFourDecimals();
};

void TestMeasurement::noDigitIsShownThatIsNotTrue_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("exponent");
    QTest::addColumn<QString>("words");
    QTest::newRow("exact") << 0.25 << 1e-18 << 0.0 << QStringLiteral("0.25");
    QTest::newRow("known to a millionth") << 1.0 / 3.0 << 1e-6 << 0.0 << QStringLiteral("0.33333");
    QTest::newRow("below zero") << -1.0 / 3.0 << 1e-3 << 0.0 << QStringLiteral("-0.33");
    QTest::newRow("less than its error") << 1e-9 << 1e-6 << 0.0 << QStringLiteral("0");
    QTest::newRow("in another unit") << 3.0 << 1e-12 << 4.0 << QStringLiteral("48");
    // 2^-10000, whose logarithm is known to 16 digits, 5 of them before the point
    QTest::newRow("beyond a double") << 1.0 << 1e-16 << -10000.0 << QStringLiteral("5.0123727492e-3011");
    QTest::newRow("beyond a double, below zero") << -1.0 << 1e-3 << -10000.0 << QStringLiteral("-5e-3011");
}

void TestMeasurement::noDigitIsShownThatIsNotTrue()
{
    QFETCH(const double, value);
    QFETCH(const double, error);
    QFETCH(const double, exponent);
    QTEST(trueDigits(value, error, exponent), "words");
}

void TestMeasurement::placesAreThoseOfTheWorld()
{
    Surroundings place;
    QCOMPARE(worldPlace(place, {1.0, -2.5, 0.0}, 1e-17), QStringLiteral("(1, -2.5, 0)"));
    place.origin = {100.0, 0.0, 0.0};
    place.unitExponent = -3.0;
    QCOMPARE(worldPlace(place, {8.0, 4.0, -1.0}, 1e-16), QStringLiteral("(101, 0.5, -0.125)"));
    // What is deep inside the world cannot tell from its middle.
    place.unitExponent = -100.0;
    QCOMPARE(worldPlace(place, {8.0, 0.0, 0.0}, 1e-16), QStringLiteral("(100, 0, 0)"));
}

void TestMeasurement::directionsHaveFourDecimals()
{
    QCOMPARE(directionWords({0.0, -1.0, 0.0}), QStringLiteral("(0, -1, 0)"));
    QCOMPARE(directionWords({0.57735, -1e-9, 0.70711}), QStringLiteral("(0.5774, 0, 0.7071)"));
}

QTEST_GUILESS_MAIN(TestMeasurement)
#include "testmeasurement.moc"
