// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/rotation.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

#include <QTest>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <rapidcheck.h>

#include "tests/core/geometry/wild.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestRotation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void quadrantAnglesAreExact_data();
    void quadrantAnglesAreExact();
    void anglesOfAnySizeAreReducedExactly_data();
    void anglesOfAnySizeAreReducedExactly();
    void anyAngleIsWithinTwoUnitsOfTheLastPlace();
    void bitsAreTheSameEverywhere();
    void eachAxisTurnsAsTheBookSays();
    void theOriginIsSeenWhereAppendixASeesIt();
    void anglesApplyInTheOrderPitchYawRoll();
    void rotationsKeepLengthAndHandedness();
    void anglesAreFoundAgain();
};

void TestRotation::quadrantAnglesAreExact_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("cosine");
    QTest::addColumn<double>("sine");
    const double cosines[] = {1, 0, -1, 0};
    const double sines[] = {0, 1, 0, -1};
    for (const double turns : {-1e12, -3.0, -1.0, 0.0, 1.0, 2.0, 1e9}) {
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double degrees = turns * 360 + quarter * 90;
            QTest::addRow("%.17g", degrees) << degrees << cosines[quarter] << sines[quarter];
        }
    }
}

void TestRotation::quadrantAnglesAreExact()
{
    QFETCH(double, degrees);
    QFETCH(double, cosine);
    QFETCH(double, sine);
    const CosSin both = cosSinOfDegrees(degrees);
    QVERIFY(both.cosine == cosine); // QCOMPARE would allow for rounding
    QVERIFY(both.sine == sine);
}

namespace {

/// In 100 digits, reduced there.
std::pair<Real, Real> exactCosSin(double degrees)
{
    // Whole degrees are reduced as an integer, of which a double may have 1,024 bits.
    const boost::multiprecision::cpp_int whole(std::trunc(degrees));
    const Real rest = Real(whole % 360) + Real(degrees - std::trunc(degrees));
    const Real quarters = rest / 90;
    if (quarters == trunc(quarters)) { // of which 100 digits leave something
        const int quarter = (static_cast<int>(quarters) + 4) % 4;
        return {quarter % 2 == 1 ? 0 : 1 - quarter, quarter % 2 == 0 ? 0 : 2 - quarter};
    }
    const Real radians = rest * boost::math::constants::pi<Real>() / 180;
    return {cos(radians), sin(radians)};
}

bool isNear(double value, const Real &truth)
{
    return abs(Real(value) - truth) <= 2 * std::numeric_limits<double>::epsilon() * abs(truth);
}

}

void TestRotation::anglesOfAnySizeAreReducedExactly_data()
{
    QTest::addColumn<double>("degrees");
    for (const double degrees : {1e9, -1e9, 1e9 + 0.125, 123456789.987654321, 1e15 + 0.5, 1e22, 1e300, 1.7e308, 30.0,
                                 45.0, 60.0, 137.508, 1e-9, 1e-300, 89.99999999999999, 90.00000000000001,
                                 179.99999999999997, 359.99999999999994, 720.0000000000001}) {
        QTest::addRow("%.17g", degrees) << degrees;
    }
}

void TestRotation::anglesOfAnySizeAreReducedExactly()
{
    QFETCH(double, degrees);
    const auto [cosine, sine] = exactCosSin(degrees);
    const CosSin both = cosSinOfDegrees(degrees);
    QVERIFY(isNear(both.cosine, cosine));
    QVERIFY(isNear(both.sine, sine));
}

void TestRotation::anyAngleIsWithinTwoUnitsOfTheLastPlace()
{
    QVERIFY(rc::check([] {
        const double degrees = *wildNumber(-20, 20);
        const auto [cosine, sine] = exactCosSin(degrees);
        const CosSin both = cosSinOfDegrees(degrees);
        RC_ASSERT(isNear(both.cosine, cosine));
        RC_ASSERT(isNear(both.sine, sine));
    }));
}

/// With every processor and C library: FNV-1a of the bits.
void TestRotation::bitsAreTheSameEverywhere()
{
    std::mt19937_64 random(5);
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < 100'000; ++i) {
        const CosSin both = cosSinOfDegrees(std::ldexp(static_cast<double>(random() >> 11), -53) * 720 - 360);
        for (const double number : {both.cosine, both.sine}) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3u;
        }
    }
    QCOMPARE(QString::number(hash, 16), QStringLiteral("292b3264f08b0b38"));
}

void TestRotation::eachAxisTurnsAsTheBookSays()
{
    // Left-handed, x right, y up, z forward: a positive pitch looks down, a positive yaw looks left, and a positive
    // roll brings up over to the right.
    const glm::dvec3 right(1, 0, 0);
    const glm::dvec3 up(0, 1, 0);
    const glm::dvec3 forward(0, 0, 1);
    QVERIFY(rotationFromDegrees({90, 0, 0}) * forward == up);
    QVERIFY(rotationFromDegrees({90, 0, 0}) * up == -forward);
    QVERIFY(rotationFromDegrees({90, 0, 0}) * right == right);
    QVERIFY(rotationFromDegrees({0, 90, 0}) * forward == -right);
    QVERIFY(rotationFromDegrees({0, 90, 0}) * right == forward);
    QVERIFY(rotationFromDegrees({0, 90, 0}) * up == up);
    QVERIFY(rotationFromDegrees({0, 0, 90}) * right == -up);
    QVERIFY(rotationFromDegrees({0, 0, 90}) * up == right);
    QVERIFY(rotationFromDegrees({0, 0, 90}) * forward == forward);
}

void TestRotation::theOriginIsSeenWhereAppendixASeesIt()
{
    // c (-48.761894, 25.567242, 64.429054) (-0.071402885, -2.4999454, 0) 60, the rotation in radians.
    constexpr double degrees = 180.0 / std::numbers::pi;
    const glm::dmat3 worldFromCamera = rotationFromDegrees(glm::dvec3(-0.071402885, -2.4999454, 0) * degrees);
    const glm::dvec3 origin =
        glm::transpose(worldFromCamera) * (glm::dvec3(0) - glm::dvec3(-48.761894, 25.567242, 64.429054));
    QVERIFY(origin.z > 0);
    QVERIFY(std::abs(std::acos(origin.z / glm::length(origin)) * degrees - 20.8) < 0.05);
    QVERIFY(std::abs(origin.x / origin.z - -0.02) < 0.005);
    QVERIFY(std::abs(origin.y / origin.z - -0.38) < 0.005);
}

void TestRotation::anglesApplyInTheOrderPitchYawRoll()
{
    // Roll acts on a point first: up goes right by it, then forward by the yaw, then up by the pitch.
    QVERIFY(rotationFromDegrees({90, 90, 90}) * glm::dvec3(0, 1, 0) == glm::dvec3(0, 1, 0));
    // In the other order up would go to the back and then right.
    QVERIFY(rotationFromDegrees({90, 0, 90}) * glm::dvec3(0, 1, 0) == glm::dvec3(1, 0, 0));
    QVERIFY(rotationFromDegrees({0, 90, 90}) * glm::dvec3(0, 1, 0) == glm::dvec3(0, 0, 1));
}

void TestRotation::rotationsKeepLengthAndHandedness()
{
    QVERIFY(rc::check([] {
        const glm::dmat3 rotation = rotationFromDegrees(*wildVector(-9, 12));
        const glm::dmat3 gram = glm::transpose(rotation) * rotation;
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) {
                RC_ASSERT(std::abs(gram[column][row] - (row == column ? 1.0 : 0.0)) < 1e-15);
            }
        }
        RC_ASSERT(std::abs(glm::determinant(rotation) - 1.0) < 1e-15);
    }));
}

/// The same rotation, from angles in their ranges; straight up and nearly so too.
void TestRotation::anglesAreFoundAgain()
{
    const double quarter = 0.5 * std::numbers::pi;
    const auto check = [&](const glm::dvec3 &radians) {
        const glm::dmat3 rotation = rotationFromRadians(radians);
        const glm::dvec3 found = radiansOf(rotation);
        const glm::dmat3 again = rotationFromRadians(found);
        for (int column = 0; column < 3; ++column) {
            QVERIFY(glm::distance(rotation[column], again[column]) < 1e-11);
        }
        QVERIFY(std::abs(found.y) <= quarter && std::abs(found.x) <= 2 * quarter && std::abs(found.z) <= 2 * quarter);
        if (std::abs(std::abs(radians.y) - quarter) < 1e-15) {
            QVERIFY(found.z == 0.0);
        }
    };
    std::mt19937 random(seed(1));
    std::uniform_real_distribution<double> angle(-4.0, 4.0);
    for (int i = 0; i < 2'000; ++i) {
        check({angle(random), angle(random), angle(random)});
        const double away = std::pow(10.0, -16.0 * std::abs(angle(random)) / 4.0);
        check({angle(random), (i % 2 ? 1.0 : -1.0) * (quarter - away), angle(random)});
        check({angle(random), i % 2 ? quarter : -quarter, angle(random)});
    }
    for (const glm::dvec3 &radians : {glm::dvec3(0.0), glm::dvec3(-0.07, -2.49, 0.0), glm::dvec3(quarter, 0.0, 0.0)}) {
        check(radians);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestRotation)

#include "testrotation.moc"
