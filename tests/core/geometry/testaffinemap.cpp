// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/affinemap.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QTest>
#include <glm/matrix.hpp>

#include "core/geometry/rotation.h"
#include "tests/core/geometry/wild.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using RealMatrix = std::array<RealVector, 3>;

RealMatrix product(const RealMatrix &a, const RealMatrix &b)
{
    RealMatrix result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
    return result;
}

Real trace(const RealMatrix &a)
{
    return a[0][0] + a[1][1] + a[2][2];
}

/// The largest singular value by the power method in 100 digits: the Gram matrix squared 60 times leaves the
/// eigenspace of its largest eigenvalue, up to a factor.
Real exactNorm(const glm::dmat3 &matrix)
{
    RealMatrix gram;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            Real sum = 0;
            for (int k = 0; k < 3; ++k) {
                sum += Real(matrix[i][k]) * Real(matrix[j][k]);
            }
            gram[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = sum;
        }
    }
    if (trace(gram) == 0) {
        return 0;
    }
    RealMatrix power = gram;
    for (int i = 0; i < 60; ++i) {
        const Real size = trace(power);
        for (RealVector &row : power) {
            for (Real &entry : row) {
                entry /= size;
            }
        }
        power = product(power, power);
    }
    return sqrt(trace(product(power, gram)) / trace(power));
}

/// Never below, and at most 1e-12 of it above.
bool isTight(double norm, const Real &truth)
{
    // The power method itself comes from below, by less than 1e-18.
    return Real(norm) >= truth && Real(norm) <= truth * (1 + Real(1e-12));
}

}

class TestAffineMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aMapScalesThenRotatesThenMoves();
    void productsApplyTheInnerMapFirst();
    void operatorNormsOfKnownMatrices_data();
    void operatorNormsOfKnownMatrices();
    void operatorNormIsNeverBelowAndTight();
    void operatorNormIsTightForEntriesOfOneSize();
    void permutedDiagonalsHaveTheirExactNorm();
    void similaritiesAreTold_data();
    void similaritiesAreTold();
    void scaledRotationsAreSimilarities();
    void equalMapsHaveEqualHashes();
    void determinantsHaveTheirSign_data();
    void determinantsHaveTheirSign();
    void determinantSignsAreNeverWrong();
    void inversesTakeMapsBack();
    void inversesThatNoDoubleHoldsAreLeftOut();
};

void TestAffineMap::aMapScalesThenRotatesThenMoves()
{
    // (1, 2, 3) is scaled to (2, 6, 12); 90 degrees of yaw take x to z and z to -x; then comes the position.
    const AffineMap map = mapFromParts({100, 200, 300}, {0, 90, 0}, {2, 3, 4});
    QVERIFY(map({1, 2, 3}) == glm::dvec3(100 - 12, 200 + 6, 300 + 2));
}

void TestAffineMap::productsApplyTheInnerMapFirst()
{
    QVERIFY(rc::check([] {
        const AffineMap outer{*wildMatrix(-2, 2), *wildVector(-2, 2)};
        const AffineMap inner{*wildMatrix(-2, 2), *wildVector(-2, 2)};
        const glm::dvec3 point = *wildVector(-2, 2);
        const RealVector truth = applied(outer, applied(inner, exact(point)));
        RC_ASSERT(distance(exact((outer * inner)(point)), truth) < 1e-8);
    }));
    const AffineMap shift{glm::dmat3(1), {1, 0, 0}};
    const AffineMap twice{glm::dmat3(2), {0, 0, 0}};
    QVERIFY((shift * twice)({1, 1, 1}) == glm::dvec3(3, 2, 2));
    QVERIFY((twice * shift)({1, 1, 1}) == glm::dvec3(4, 2, 2));
}

void TestAffineMap::operatorNormsOfKnownMatrices_data()
{
    QTest::addColumn<glm::dmat3>("matrix");
    QTest::addColumn<double>("norm");
    QTest::newRow("zero") << glm::dmat3(0) << 0.0;
    QTest::newRow("identity") << glm::dmat3(1) << 1.0;
    QTest::newRow("mirror") << glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1) << 1.0;
    QTest::newRow("unequal scales") << glm::dmat3(0.25, 0, 0, 0, -3, 0, 0, 0, 2) << 3.0;
    QTest::newRow("shear by 1") << glm::dmat3(1, 0, 0, 1, 1, 0, 0, 0, 1) << std::numbers::phi;
    QTest::newRow("all ones") << glm::dmat3(1, 1, 1, 1, 1, 1, 1, 1, 1) << 3.0;
    QTest::newRow("one column") << glm::dmat3(2, 3, 6, 0, 0, 0, 0, 0, 0) << 7.0;
    QTest::newRow("one entry") << glm::dmat3(0, 0, 0, 0, 0, 0, 0, 1e-300, 0) << 1e-300;
    QTest::newRow("huge") << glm::dmat3(1e300) << 1e300;
    QTest::newRow("needle") << glm::dmat3(1, 0, 0, 0, 1e-200, 0, 0, 0, 1e200) << 1e200;
}

void TestAffineMap::operatorNormsOfKnownMatrices()
{
    QFETCH(glm::dmat3, matrix);
    QFETCH(double, norm);
    const double found = operatorNorm(matrix);
    QVERIFY(found >= norm * (1 - 2e-16)); // the closed form is rounded too
    QVERIFY(found <= norm * (1 + 1e-12));
}

void TestAffineMap::operatorNormIsNeverBelowAndTight()
{
    QVERIFY(rc::check([] {
        const glm::dmat3 matrix = *wildMatrix();
        RC_ASSERT(isTight(operatorNorm(matrix), exactNorm(matrix)));
    }));
}

void TestAffineMap::operatorNormIsTightForEntriesOfOneSize()
{
    QVERIFY(rc::check([] {
        const double size = std::abs(*wildNumber(-290, 290)) + 1e-300;
        const glm::dmat3 matrix = *wildMatrix(-2, 1) * size;
        RC_ASSERT(isTight(operatorNorm(matrix), exactNorm(matrix)));
    }));
    QVERIFY(rc::check([] { // near a rotation all singular values are near one another
        const glm::dmat3 matrix = rotationFromDegrees(*wildVector(-2, 4)) * (1.0 + *wildNumber(-16, -1));
        RC_ASSERT(isTight(operatorNorm(matrix), exactNorm(matrix)));
    }));
}

void TestAffineMap::permutedDiagonalsHaveTheirExactNorm()
{
    // So that a depth of 10^18 of moves alone does not grow by the norm's own margin.
    QVERIFY(operatorNorm(glm::dmat3(1)) == 1.0);
    QVERIFY(operatorNorm(glm::dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0)) == 1.0);
    QVERIFY(operatorNorm(glm::dmat3(0.1, 0, 0, 0, 0, 0.3, 0, -0.2, 0)) == 0.3);
}

void TestAffineMap::similaritiesAreTold_data()
{
    QTest::addColumn<glm::dmat3>("matrix");
    QTest::addColumn<bool>("isSimilar");
    const glm::dmat3 turn = rotationFromDegrees({12, 34, 56});
    QTest::newRow("identity") << glm::dmat3(1) << true;
    QTest::newRow("rotation") << turn << true;
    QTest::newRow("scaled") << turn * 0.37 << true;
    QTest::newRow("tiny") << turn * 1e-200 << true;
    QTest::newRow("huge") << turn * 1e200 << true;
    QTest::newRow("mirrored") << turn * glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1) << true;
    QTest::newRow("point reflection") << glm::dmat3(-0.5) << true;
    QTest::newRow("flat") << glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0) << false;
    QTest::newRow("zero") << glm::dmat3(0) << false;
    QTest::newRow("unequal") << turn * glm::dmat3(1, 0, 0, 0, 1.000001, 0, 0, 0, 1) << false;
    QTest::newRow("unequal by 1e-9") << turn * glm::dmat3(1 + 1e-9, 0, 0, 0, 1, 0, 0, 0, 1) << false;
    QTest::newRow("sheared") << glm::dmat3(1, 0, 0, 1e-6, 1, 0, 0, 0, 1) << false;
}

void TestAffineMap::similaritiesAreTold()
{
    QFETCH(glm::dmat3, matrix);
    QTEST(isSimilarity(matrix), "isSimilar");
}

void TestAffineMap::scaledRotationsAreSimilarities()
{
    QVERIFY(rc::check([] {
        const double scale = *wildNumber();
        RC_PRE(scale != 0.0);
        const glm::dmat3 mirror(*rc::gen::arbitrary<bool>() ? -1 : 1, 0, 0, 0, 1, 0, 0, 0, 1);
        RC_ASSERT(isSimilarity(rotationFromDegrees(*wildVector(-3, 5)) * mirror * scale));
    }));
}

void TestAffineMap::equalMapsHaveEqualHashes()
{
    const AffineMap zero{glm::dmat3(1), {0.0, 1, 2}};
    const AffineMap minusZero{glm::dmat3(1, -0.0, 0, 0, 1, 0, 0, 0, 1), {-0.0, 1, 2}};
    QVERIFY(zero == minusZero);
    QCOMPARE(AffineMapHash{}(zero), AffineMapHash{}(minusZero));
    AffineMap other = zero;
    other.linear[1][2] = std::numeric_limits<double>::denorm_min();
    QVERIFY(!(zero == other));
    QVERIFY(AffineMapHash{}(zero) != AffineMapHash{}(other));
}

namespace {

Real exactDeterminant(const glm::dmat3 &m)
{
    const auto entry = [&](int column, int row) { return Real(m[column][row]); };
    const auto minorAt = [&](int a, int b) { return entry(1, a) * entry(2, b) - entry(1, b) * entry(2, a); };
    return entry(0, 0) * minorAt(1, 2) + entry(0, 1) * minorAt(2, 0) + entry(0, 2) * minorAt(0, 1);
}

}

void TestAffineMap::determinantsHaveTheirSign_data()
{
    QTest::addColumn<glm::dmat3>("matrix");
    QTest::addColumn<int>("sign");
    const glm::dmat3 turn = rotationFromDegrees({12, 34, 56});
    const auto scales = [](double x, double y, double z) { return glm::dmat3(x, 0, 0, 0, y, 0, 0, 0, z); };
    QTest::newRow("identity") << glm::dmat3(1) << 1;
    QTest::newRow("turned") << turn << 1;
    QTest::newRow("mirrored") << turn * scales(1, -1, 1) << -1;
    QTest::newRow("point reflection") << turn * -0.5 << -1;
    QTest::newRow("flat") << turn * scales(1, 1, 0) << 0;
    QTest::newRow("zero") << glm::dmat3(0) << 0;
    QTest::newRow("equal columns") << glm::dmat3(turn[0], turn[1], turn[0]) << 0;
    QTest::newRow("in a plane but for rounding") << glm::dmat3(turn[0], turn[1], 0.1 * turn[0] + 0.7 * turn[1]) << 0;
    QTest::newRow("tiny") << turn * 1e-250 << 1;
    QTest::newRow("needle") << turn * scales(1e-200, -1e-200, 1e200) << -1;
    QTest::newRow("huge") << scales(-1e300, 1e300, 1e300) << -1;
    QTest::newRow("not a number") << glm::dmat3(std::numeric_limits<double>::quiet_NaN()) << 0;
}

void TestAffineMap::determinantsHaveTheirSign()
{
    QFETCH(glm::dmat3, matrix);
    QTEST(determinantSign(matrix), "sign");
}

void TestAffineMap::determinantSignsAreNeverWrong()
{
    int signs = 0;
    QVERIFY(rc::check([&] {
        glm::dmat3 matrix = *wildMatrix(-3, 3);
        matrix[2] = *wildNumber(-3, 3) * matrix[0] + *wildNumber(-3, 3) * matrix[1]
            + *wildNumber(-20, 1) * glm::dvec3(1, 1, 1); // hardly out of a plane
        const Real truth = exactDeterminant(matrix);
        const int sign = determinantSign(matrix);
        RC_ASSERT(sign * truth >= 0);
        signs += sign != 0 ? 1 : 0;
    }));
    QVERIFY(signs > 20);
}

void TestAffineMap::inversesTakeMapsBack()
{
    int inverses = 0;
    QVERIFY(rc::check([&] {
        const AffineMap map{*wildMatrix(-2, 2) * *wildNumber(-100, 100), *wildVector(-2, 2)};
        const std::optional<AffineMap> back = inverse(map);
        RC_ASSERT(back.has_value() == (determinantSign(map.linear) != 0));
        if (back) {
            ++inverses;
            // Sizes of the columns apart, the condition of such a matrix is mostly below 10^6.
            const Real condition = Real(operatorNorm(map.linear)) * Real(operatorNorm(back->linear));
            const RealVector point = exact(*wildVector(-2, 2));
            const RealVector there = applied(map, point);
            const Real size = distance(there, RealVector{}) * Real(operatorNorm(back->linear))
                + distance(point, RealVector{}) + distance(exact(back->translation), RealVector{});
            RC_ASSERT(distance(applied(*back, there), point) <= Real(1e-14) * condition * size);
        }
    }));
    QVERIFY(inverses > 50);
    const glm::dmat3 half(0.5);
    const std::optional<AffineMap> twice = inverse({half, {1, 2, 3}});
    QVERIFY(twice && *twice == (AffineMap{glm::dmat3(2), {-2, -4, -6}}));
}

void TestAffineMap::inversesThatNoDoubleHoldsAreLeftOut()
{
    QVERIFY(!inverse({glm::dmat3(1e-310), {0, 0, 0}}));
    QVERIFY(!inverse({glm::dmat3(1e-200), {1e200, 0, 0}}));
    QVERIFY(inverse({glm::dmat3(1e-200), {1, 0, 0}}));
    QVERIFY(!inverse({glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0), {0, 0, 0}}));
}

}

ROMANESCO_TEST(romanesco::test::TestAffineMap)

#include "testaffinemap.moc"
