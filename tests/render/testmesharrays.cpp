// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <QTest>
#include <glm/geometric.hpp>

#include "render/mesharrays.h"
#include "tests/testmain.h"

using namespace romanesco;

namespace {

const std::vector<glm::dvec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
constexpr std::uint32_t none = Mesh::none;

MeshArrays arrays(const Mesh &mesh)
{
    return arraysOf(mesh, boundingSphere(mesh));
}

/// All that a corner of a face shows, found through the arrays.
using Shown = std::array<float, 11>;

Shown shown(const MeshArrays &made, std::uint32_t row)
{
    Shown all{};
    const auto put = [&](std::size_t at, const auto &rows) {
        if (!rows.empty()) {
            std::ranges::copy(rows[row], all.begin() + static_cast<std::ptrdiff_t>(at));
        }
    };
    put(0, made.positions);
    put(3, made.normals);
    put(6, made.textureCoordinates);
    put(8, made.colours);
    return all;
}

}

class TestMeshArrays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plainMeshesStayAsTheyAre();
    void cornersThatDifferHaveRowsOfTheirOwn();
    void eachCornerShowsWhatTheMeshSays();
    void smoothingGroupsShareNormals();
    void facesAreSortedByMaterial();
};

void TestMeshArrays::plainMeshesStayAsTheyAre()
{
    const Mesh mesh{.vertices = {{10, 0, 0}, {14, 0, 0}, {10, 3, 0}}, .faces = {{0, 1, 2}}};
    const MeshArrays made = arrays(mesh);
    QCOMPARE(made.positions.size(), 3u);
    QCOMPARE(made.faces, mesh.faces);
    QVERIFY(made.normals.empty() && made.textureCoordinates.empty() && made.colours.empty());
    for (const auto &[x, y, z] : made.positions) {
        QVERIFY(std::hypot(x, y, z) <= 1.0f + 1e-6f);
    }
}

void TestMeshArrays::cornersThatDifferHaveRowsOfTheirOwn()
{
    Mesh mesh{.vertices = square, .faces = {{0, 1, 2}, {0, 2, 3}}};
    mesh.textureCoordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.faceTextureCoordinates = {{0, 1, 2}, {0, 2, 3}};
    QCOMPARE(arrays(mesh).positions.size(), 4u);
    mesh.faceTextureCoordinates = {{0, 1, 2}, {1, 2, none}};
    const MeshArrays made = arrays(mesh);
    QCOMPARE(made.positions.size(), 5u);                                               // vertex 0 twice
    QCOMPARE(made.textureCoordinates[made.faces[0][2]], (std::array<float, 2>{1, 0})); // the image's top is 0
}

/// Against the mesh itself, corner by corner.
void TestMeshArrays::eachCornerShowsWhatTheMeshSays()
{
    std::mt19937_64 random(5);
    const auto number = [&](std::size_t size) { return static_cast<std::uint32_t>(random() % size); };
    const auto real = [&] { return std::uniform_real_distribution(-1.0, 1.0)(random); };
    Mesh mesh;
    for (int i = 0; i < 40; ++i) {
        mesh.vertices.emplace_back(real(), real(), real());
        mesh.normals.emplace_back(real(), real(), real());
        mesh.textureCoordinates.emplace_back(real(), real());
        mesh.colours.emplace_back(0.5 + 0.5 * real(), 0.25, 0.75);
    }
    for (std::uint32_t i = 0; i < 300; ++i) {
        mesh.faces.push_back({number(40), number(40), number(40)});
        mesh.faceNormals.push_back({number(40), number(4), none});
        mesh.faceTextureCoordinates.push_back({number(3), none, number(40)});
        if (i % 50 == 0) {
            mesh.parts.push_back({.firstFace = i, .material = number(3)});
        }
    }
    const Sphere base = boundingSphere(mesh);
    const MeshArrays made = arraysOf(mesh, base);
    std::multiset<std::array<Shown, 3>> expected;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        std::array<Shown, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = mesh.faces[face][i];
            const std::uint32_t normal = mesh.faceNormals[face][i];
            const std::uint32_t texture = mesh.faceTextureCoordinates[face][i];
            const glm::vec3 p((mesh.vertices[vertex] - base.centre) * (1.0 / base.radius));
            const glm::vec3 n(normal == none ? glm::dvec3(0) : glm::normalize(mesh.normals[normal]));
            const glm::vec2 t(texture == none ? glm::dvec2(0, 0) : mesh.textureCoordinates[texture]);
            const glm::vec3 &c = mesh.colours[vertex];
            corners[i] = {p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y, c.x, c.y, c.z};
        }
        expected.insert(corners);
    }
    QCOMPARE(made.faces.size(), mesh.faces.size());
    for (const Mesh::Face &face : made.faces) {
        std::array<Shown, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = shown(made, face[i]);
            corners[i][7] = 1.0f - corners[i][7];
        }
        const auto isSame = [&](const std::array<Shown, 3> &other) {
            for (std::size_t i = 0; i < 33; ++i) {
                if (std::abs(corners[i / 11][i % 11] - other[i / 11][i % 11]) > 1e-6f) {
                    return false;
                }
            }
            return true;
        };
        const auto found = std::ranges::find_if(expected, isSame);
        QVERIFY(found != expected.end());
        expected.erase(found);
    }
}

void TestMeshArrays::smoothingGroupsShareNormals()
{
    // A roof: two squares that meet at a right angle.
    Mesh mesh{.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}, {2, 0, 0}, {2, 0, 1}},
              .faces = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}}};
    const auto normalAt = [&](std::size_t face, std::size_t corner) {
        const MeshArrays made = arrays(mesh);
        const auto &[x, y, z] = made.normals.at(made.faces[face][corner]);
        return glm::dvec3(x, y, z);
    };
    mesh.parts = {{.firstFace = 0, .smoothing = 3}};
    QVERIFY(glm::distance(glm::abs(normalAt(2, 1)), glm::dvec3(0, 1, 0)) < 1e-6); // on the ridge
    QVERIFY(std::abs(std::abs(normalAt(0, 0).y) - std::sqrt(0.5)) < 1e-6);
    QCOMPARE(arrays(mesh).positions.size(), 6u);

    mesh.parts = {{.firstFace = 0, .smoothing = 1}, {.firstFace = 2, .smoothing = 2}};
    QVERIFY2(std::abs(std::abs(normalAt(2, 1).y) - std::sqrt(0.5)) < 1e-6, "groups do not mix");
    QCOMPARE(arrays(mesh).positions.size(), 8u);

    mesh.parts = {{.firstFace = 0, .smoothing = 1}, {.firstFace = 2, .smoothing = 0}};
    QVERIFY2(glm::length(normalAt(2, 1)) == 0.0, "flat");

    // The mesh's own normals come first.
    mesh.normals = {{0, 0, 5}};
    mesh.faceNormals = {{0, 0, 0}, {none, none, none}, {none, none, none}, {none, none, none}};
    QVERIFY(glm::distance(normalAt(0, 1), glm::dvec3(0, 0, 1)) < 1e-6);
}

void TestMeshArrays::facesAreSortedByMaterial()
{
    Mesh mesh{.vertices = square, .faces = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {0, 1, 3}, {3, 2, 1}}};
    mesh.parts = {{.firstFace = 0, .material = 1},
                  {.firstFace = 2, .material = none},
                  {.firstFace = 3, .material = 0},
                  {.firstFace = 4, .material = 1}};
    mesh.materials.resize(2);
    const MeshArrays made = arrays(mesh);
    QCOMPARE(made.parts.size(), 3u);
    const std::vector<Mesh::Face> expected{{0, 1, 3}, {0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {1, 2, 3}};
    QCOMPARE(made.faces, expected);
    std::size_t next = 0;
    for (const auto &[first, count, material] : made.parts) {
        QCOMPARE(first, next);
        next += count;
    }
    QCOMPARE(next, mesh.faces.size());
    QCOMPARE(made.parts[0].material, 0u);
    QCOMPARE(made.parts[1].material, 1u);
    QCOMPARE(made.parts[2].material, none);
}

ROMANESCO_TEST(TestMeshArrays)
#include "testmesharrays.moc"
