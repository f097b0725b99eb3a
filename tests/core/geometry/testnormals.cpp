// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/normals.h"

#include <cmath>
#include <random>

#include <QTest>
#include <rapidcheck.h>

#include <glm/geometric.hpp>

#include "tests/core/geometry/wild.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

RealVector cross(const RealVector &a, const RealVector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real dot(const RealVector &a, const RealVector &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The determinant over the lengths of the columns, from -1 to 1; 0 where a column is 0.
Real relativeDeterminant(const glm::dmat3 &m)
{
    const RealVector a = exact(m[0]);
    const RealVector b = exact(m[1]);
    const RealVector c = exact(m[2]);
    const Real lengths = sqrt(dot(a, a)) * sqrt(dot(b, b)) * sqrt(dot(c, c));
    return lengths == 0 ? Real(0) : Real(dot(a, cross(b, c)) / lengths);
}

}

class TestNormals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mirrorsAreToldAtAnyScale();
    void flatMapsAreNotMirrors();
    void normalsStandOnTheImagesOfTheirFaces();
    void normalsPointToTheSameSideAfterAMirror();
    void normalsOfAnyLengthHaveADirection();
    void whatHasNoDirectionStaysAsItIs();
};

void TestNormals::mirrorsAreToldAtAnyScale()
{
    QVERIFY(rc::check([] {
        const glm::dmat3 matrix = *wildMatrix();
        const Real determinant = relativeDeterminant(matrix);
        RC_PRE(abs(determinant) > 1e-12);
        RC_ASSERT(isMirrored(matrix) == (determinant < 0));
    }));
}

void TestNormals::flatMapsAreNotMirrors()
{
    QVERIFY(rc::check([] {
        glm::dmat3 matrix = *wildMatrix(-5, 5);
        // each entry is rounded, so that the determinant is some 1e-17 to either side
        matrix[2] = matrix[0] * 0.7 + matrix[1] * 0.3;
        RC_ASSERT(!isMirrored(matrix));
    }));
}

void TestNormals::normalsStandOnTheImagesOfTheirFaces()
{
    std::mt19937_64 random(seed(5));
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
    int compared = 0;
    for (int round = 0; round < 5'000; ++round) {
        const double size = std::pow(10.0, 140 * unit(random));
        const glm::dmat3 matrix = size * glm::dmat3(vector(), vector(), vector());
        const glm::dvec3 u = vector();
        const glm::dvec3 v = vector();
        if (abs(relativeDeterminant(matrix)) < 0.01 || glm::length(glm::cross(u, v)) < 0.01) {
            continue;
        }
        ++compared;
        const glm::dvec3 normal = transformedNormal(normalMatrix(matrix), glm::cross(u, v));
        // the image's own normal, in 100 digits
        const AffineMap map{matrix, glm::dvec3(0.0)};
        const RealVector image = cross(applied(map, exact(u)), applied(map, exact(v)));
        const Real cosine = dot(image, exact(normal)) / sqrt(dot(image, image));
        const Real expected = relativeDeterminant(matrix) > 0 ? 1 : -1;
        QVERIFY2(abs(cosine - expected) < 1e-13, qPrintable(QString::number(round)));
    }
    QVERIFY(compared > 3'000);
}

void TestNormals::normalsPointToTheSameSideAfterAMirror()
{
    const glm::dmat3 mirror(-2.0, 0, 0, 0, 1, 0, 0, 0, 1);
    QCOMPARE(transformedNormal(normalMatrix(mirror), {0, 3, 0}), glm::dvec3(0, 1, 0));
    QCOMPARE(transformedNormal(normalMatrix(mirror), {1, 0, 0}), glm::dvec3(-1, 0, 0));
    QCOMPARE(transformedNormal(normalMatrix(mirror * 1e-200), {1, 0, 0}), glm::dvec3(-1, 0, 0));
}

void TestNormals::normalsOfAnyLengthHaveADirection()
{
    const glm::dmat3 turned(0, 1, 0, -1, 0, 0, 0, 0, 1);
    for (const double length : {1e-320, 1e-200, 1e200, 1.7e308}) {
        const glm::dvec3 normal = transformedNormal(turned, glm::dvec3(3, 4, 0) * (length / 4));
        QVERIFY2(glm::distance(normal, glm::dvec3(-0.8, 0.6, 0)) < (length < 1e-300 ? 1e-3 : 1e-15),
                 qPrintable(QString::number(length)));
    }
}

void TestNormals::whatHasNoDirectionStaysAsItIs()
{
    const glm::dmat3 flat(1.0, 0, 0, 0, 1, 0, 0, 0, 0);
    QCOMPARE(transformedNormal(normalMatrix(flat), {0, 0, 4}), glm::dvec3(0, 0, 1));
    QCOMPARE(transformedNormal(normalMatrix(flat), {1, 0, 0}), glm::dvec3(1, 0, 0));
    QCOMPARE(transformedNormal(normalMatrix(glm::dmat3(0.0)), {0, 5, 0}), glm::dvec3(0, 5, 0));
    QCOMPARE(transformedNormal(glm::dmat3(1.0), {0, 0, 0}), glm::dvec3(0, 0, 0));
}

}

ROMANESCO_TEST(romanesco::test::TestNormals)
#include "testnormals.moc"
