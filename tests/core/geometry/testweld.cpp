// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/weld.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Of edge 1, its faces cut alike on opposite sides.
Mesh cubeAt(const glm::dvec3 &corner)
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back(corner + glm::dvec3(i & 1, i >> 1 & 1, i >> 2 & 1));
    }
    mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

void append(Mesh &mesh, const Mesh &more)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const Mesh::Face &face : more.faces) {
        mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    }
}

glm::dvec3 vertex(const Mesh &mesh, const Mesh::Face &face, std::size_t i)
{
    return mesh.vertices[face[i]];
}

double area(const Mesh &mesh)
{
    double sum = 0.0;
    for (const Mesh::Face &face : mesh.faces) {
        sum += 0.5
            * glm::length(glm::cross(vertex(mesh, face, 1) - vertex(mesh, face, 0),
                                     vertex(mesh, face, 2) - vertex(mesh, face, 0)));
    }
    return sum;
}

double volume(const Mesh &mesh)
{
    double sum = 0.0;
    for (const Mesh::Face &face : mesh.faces) {
        sum += glm::dot(vertex(mesh, face, 0), glm::cross(vertex(mesh, face, 1), vertex(mesh, face, 2))) / 6.0;
    }
    return sum;
}

Mesh menger(int depth)
{
    Mesh mesh = cubeAt({0, 0, 0});
    for (int level = 0; level < depth; ++level) {
        Mesh next;
        for (int i = 0; i < 27; ++i) {
            const glm::dvec3 place(i % 3, i / 3 % 3, i / 9);
            const int middles = (place.x == 1) + (place.y == 1) + (place.z == 1);
            if (middles < 2) {
                Mesh part = mesh;
                for (glm::dvec3 &v : part.vertices) {
                    v = (v + place) / 3.0;
                }
                append(next, part);
            }
        }
        mesh = std::move(next);
    }
    return mesh;
}

}

class TestWeld : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cubesSideBySideBecomeOneBody();
    void theMengerSpongeHasItsClosedForms_data();
    void theMengerSpongeHasItsClosedForms();
    void verticesWithinTheToleranceAreOne();
    void nothingNearRemainsApart();
    void anOpenMeshIsNotClosed();
    void facesThatLookTheSameWayStay();
    void attributesStayBesideTheirFaces();
    void aStopIsHeeded();
};

void TestWeld::cubesSideBySideBecomeOneBody()
{
    Mesh mesh = cubeAt({0, 0, 0});
    append(mesh, cubeAt({1, 0, 0}));
    Weld result;
    QVERIFY(weld(mesh, 1e-9, result));
    QCOMPARE(mesh.vertices.size(), 12U);
    QCOMPARE(mesh.faces.size(), 20U);
    QCOMPARE(result.droppedWalls, 4U);
    QCOMPARE(result.droppedSlivers, 0U);
    QCOMPARE(result.droppedVertices, 4U);
    QVERIFY(result.isClosed);
    QCOMPARE(area(mesh), 10.0);
    QCOMPARE(std::abs(volume(mesh)), 2.0);
}

void TestWeld::theMengerSpongeHasItsClosedForms_data()
{
    QTest::addColumn<int>("depth");
    QTest::newRow("1") << 1;
    QTest::newRow("2") << 2;
    QTest::newRow("3") << 3;
}

void TestWeld::theMengerSpongeHasItsClosedForms()
{
    QFETCH(int, depth);
    Mesh mesh = menger(depth);
    Weld result;
    QVERIFY(weld(mesh, 1e-6, result));
    const double surface = 2 * std::pow(20.0 / 9.0, depth) + 4 * std::pow(8.0 / 9.0, depth);
    QVERIFY(std::abs(area(mesh) / surface - 1.0) < 1e-9);
    QVERIFY(std::abs(std::abs(volume(mesh)) / std::pow(20.0 / 27.0, depth) - 1.0) < 1e-9);
    QVERIFY(result.isClosed);
}

void TestWeld::verticesWithinTheToleranceAreOne()
{
    for (const double offset : {0.0, 0.4999, 0.5, 1e6, -1e6, -0.75}) {
        for (const glm::dvec3 &way : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0.64, -0.48)}) {
            Mesh mesh = cubeAt(glm::dvec3(offset));
            append(mesh, cubeAt(glm::dvec3(offset) + 0.0099 * way));
            Weld result;
            QVERIFY(weld(mesh, 0.01, result));
            QCOMPARE(mesh.vertices.size(), 8U);
            mesh = cubeAt(glm::dvec3(offset));
            append(mesh, cubeAt(glm::dvec3(offset) + 0.0101 * way));
            QVERIFY(weld(mesh, 0.01, result));
            QCOMPARE(mesh.vertices.size(), 16U);
        }
    }
}

void TestWeld::nothingNearRemainsApart()
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    Mesh mesh;
    for (std::uint32_t i = 0; i < 3'000; ++i) {
        mesh.vertices.emplace_back(place(random), place(random), place(random));
        if (i % 3 == 2) {
            mesh.faces.push_back({i - 2, i - 1, i});
        }
    }
    const Mesh before = mesh;
    Weld result;
    QVERIFY(weld(mesh, 0.05, result));
    QVERIFY(mesh.vertices.size() < before.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            QVERIFY(glm::distance(mesh.vertices[i], mesh.vertices[j]) > 0.05);
        }
    }
    // faces are those of before, in order, with corners moved by no more than the tolerance
    std::size_t at = 0;
    for (const Mesh::Face &face : before.faces) {
        const auto isMoved = [&](std::size_t i) {
            return at < mesh.faces.size()
                && glm::distance(vertex(mesh, mesh.faces[at], i), vertex(before, face, i)) <= 0.05;
        };
        at += isMoved(0) && isMoved(1) && isMoved(2) ? 1 : 0;
    }
    QCOMPARE(at, mesh.faces.size());
    QCOMPARE(mesh.faces.size() + result.droppedSlivers + result.droppedWalls, before.faces.size());
}

void TestWeld::anOpenMeshIsNotClosed()
{
    Mesh mesh = cubeAt({0, 0, 0});
    Weld result;
    QVERIFY(weld(mesh, 1e-9, result) && result.isClosed);
    mesh.faces.pop_back();
    QVERIFY(weld(mesh, 1e-9, result) && !result.isClosed);
    mesh = cubeAt({0, 0, 0});
    std::swap(mesh.faces[5][0], mesh.faces[5][1]); // one looks inwards
    QVERIFY(weld(mesh, 1e-9, result) && !result.isClosed);
    mesh = {};
    QVERIFY(weld(mesh, 1e-9, result) && !result.isClosed);
}

void TestWeld::facesThatLookTheSameWayStay()
{
    Mesh mesh = cubeAt({0, 0, 0});
    append(mesh, cubeAt({0, 0, 0}));
    mesh.faces.push_back({2, 0, 3}); // back to back with two
    Weld result;
    QVERIFY(weld(mesh, 1e-9, result));
    QCOMPARE(result.droppedWalls, 2U);
    QCOMPARE(mesh.faces.size(), 23U);
}

void TestWeld::attributesStayBesideTheirFaces()
{
    Mesh mesh = cubeAt({0, 0, 0});
    append(mesh, cubeAt({1, 0, 0}));
    for (std::uint32_t i = 0; i < 24; ++i) {
        mesh.normals.emplace_back(i, 0, 1);
        mesh.textureCoordinates.emplace_back(i, 1);
        mesh.faceNormals.push_back({i, i, i});
        mesh.faceTextureCoordinates.push_back({i, Mesh::none, i});
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.colours.emplace_back(static_cast<float>(i) / 16.0F);
    }
    // the second part is the wall of the first cube alone
    mesh.parts = {{0, 0, 0, 0}, {10, 1, 1, 1}, {12, 2, 2, 2}};
    const Mesh before = mesh;
    Weld result;
    QVERIFY(weld(mesh, 1e-9, result));
    QCOMPARE(mesh.faceNormals.size(), 20U);
    QCOMPARE(mesh.faceTextureCoordinates.size(), 20U);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const std::size_t old = mesh.faceNormals[i][0];
        QCOMPARE(mesh.faceTextureCoordinates[i][0], mesh.faceNormals[i][0]);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            QCOMPARE(vertex(mesh, mesh.faces[i], corner), vertex(before, before.faces[old], corner));
        }
    }
    QCOMPARE(mesh.parts.size(), 2U);
    QCOMPARE(mesh.parts[1].firstFace, 10U);
    QCOMPARE(mesh.parts[1].material, 2U);
    QCOMPARE(mesh.colours.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto same = std::ranges::find(before.vertices, mesh.vertices[i]) - before.vertices.begin();
        QCOMPARE(mesh.colours[i], before.colours[static_cast<std::size_t>(same)]);
    }
}

void TestWeld::aStopIsHeeded()
{
    Mesh mesh = cubeAt({0, 0, 0});
    std::stop_source stop;
    stop.request_stop();
    Weld result;
    QVERIFY(!weld(mesh, 1e-9, result, stop.get_token()));
}

}

ROMANESCO_TEST(romanesco::test::TestWeld)

#include "testweld.moc"
