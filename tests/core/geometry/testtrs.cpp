// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/trs.h"

#include <cmath>
#include <random>

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// By v + 2w(q x v) + 2q x (q x v), without a matrix.
glm::dvec3 applied(const Trs &trs, const glm::dvec3 &point)
{
    const glm::dvec3 v = point * trs.scale;
    const glm::dvec3 q(trs.rotation.x, trs.rotation.y, trs.rotation.z);
    const glm::dvec3 once = glm::cross(q, v);
    return trs.translation + v + 2.0 * (trs.rotation.w * once + glm::cross(q, once));
}

double errorOf(const Trs &trs, const AffineMap &map)
{
    double error = 0.0;
    for (const glm::dvec3 &point : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0.0)}) {
        const double distance = glm::length(applied(trs, point) - map(point));
        error = distance <= error ? error : distance; // which a NaN is not
    }
    return error;
}

}

class TestTrs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mapsOfPartsComeApart();
    void onlyZTakesAMirror();
    void flatMapsHaveParts();
    void shearHasNoParts();
    void sizesDoNotMatter();
};

void TestTrs::mapsOfPartsComeApart()
{
    std::mt19937_64 random(seed(1));
    std::uniform_real_distribution<double> angle(-360, 360);
    std::uniform_real_distribution<double> size(-3, 3);
    for (int round = 0; round < 5'000; ++round) {
        const AffineMap map =
            mapFromParts({size(random), size(random), size(random)}, {angle(random), angle(random), angle(random)},
                         {size(random), size(random), size(random)});
        const std::optional<Trs> trs = trsOf(map);
        QVERIFY(trs);
        QVERIFY(errorOf(*trs, map) < 1e-13);
        QVERIFY(
            std::abs(glm::length(glm::dvec4(trs->rotation.x, trs->rotation.y, trs->rotation.z, trs->rotation.w)) - 1)
            < 1e-14);
        QVERIFY(trs->scale.x >= 0 && trs->scale.y >= 0);
    }
}

void TestTrs::onlyZTakesAMirror()
{
    const std::optional<Trs> proper = trsOf(mapFromParts({1, 2, 3}, {10, 20, 30}, {-2, -3, 4}));
    QVERIFY(proper && proper->scale.z > 0);
    const std::optional<Trs> mirrored = trsOf(mapFromParts({1, 2, 3}, {10, 20, 30}, {-2, 3, 4}));
    QVERIFY(mirrored && mirrored->scale.z < 0);
}

void TestTrs::flatMapsHaveParts()
{
    for (int which = 0; which < 8; ++which) {
        for (const double sign : {1.0, -1.0}) {
            const glm::dvec3 scale(which & 1 ? 2 * sign : 0, which & 2 ? 3 : 0, which & 4 ? 4 : 0);
            for (const glm::dvec3 &angles : {glm::dvec3(0.0), glm::dvec3(90, 0, 0), glm::dvec3(10, 200, 30)}) {
                const AffineMap map = mapFromParts({1, 2, 3}, angles, scale);
                const std::optional<Trs> trs = trsOf(map);
                QVERIFY(trs);
                QVERIFY(errorOf(*trs, map) < 1e-14);
                QVERIFY(which == 7 || trs->scale.z >= 0);
            }
        }
    }
}

void TestTrs::shearHasNoParts()
{
    AffineMap map = mapFromParts({1, 2, 3}, {10, 20, 30}, {1, 2, 3});
    map.linear[1] += 1e-8 * map.linear[0];
    QVERIFY(trsOf(map));
    for (const auto &[i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
        AffineMap sheared = map;
        sheared.linear[i] += 1e-4 * sheared.linear[j];
        QVERIFY(!trsOf(sheared));
    }
}

void TestTrs::sizesDoNotMatter()
{
    for (const double size : {1e-300, 1e-160, 1e160, 1e300}) {
        const AffineMap map = mapFromParts({0, 0, 0}, {10, 20, 30}, glm::dvec3(size, 2 * size, 3 * size));
        const std::optional<Trs> trs = trsOf(map);
        QVERIFY(trs);
        QVERIFY(std::abs(trs->scale.y / size - 2) < 1e-13);
        const std::optional<Trs> expected = trsOf(mapFromParts({0, 0, 0}, {10, 20, 30}, {1, 2, 3}));
        QVERIFY(expected);
        QVERIFY(std::abs(std::abs(glm::dot(trs->rotation, expected->rotation)) - 1) < 1e-14);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestTrs)
#include "testtrs.moc"
