// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <ranges>
#include <set>
#include <string>
#include <vector>

#include <QTest>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <glm/geometric.hpp>

#include "core/formats/objreader.h"
#include "core/text/linemap.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

namespace fs = std::filesystem;

/// What two readers have to agree on, whatever diagonals they cut polygons by.
struct Summary {
    std::size_t triangles = 0;
    /// Of all corners, what each has: position, texture coordinate and normal in single precision.
    std::set<std::array<float, 8>> corners;
    /// Twice the sum of the triangles' area vectors: no diagonal changes it.
    std::array<double, 3> area{};

    /// Of the box round it, squared.
    [[nodiscard]] double size() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3 && !corners.empty(); ++i) {
            const auto axis = [i](const auto &corner) { return corner[i]; };
            const auto [least, greatest] = std::ranges::minmax(corners | std::views::transform(axis));
            sum += static_cast<double>(greatest - least) * static_cast<double>(greatest - least);
        }
        return sum;
    }

    void add(const std::array<std::array<float, 8>, 3> &triangle)
    {
        ++triangles;
        corners.insert(triangle.begin(), triangle.end());
        const auto &[a, b, c] = triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            const auto u = [&](std::size_t axis) {
                return static_cast<double>(b[axis]) - static_cast<double>(a[axis]);
            };
            const auto v = [&](std::size_t axis) {
                return static_cast<double>(c[axis]) - static_cast<double>(a[axis]);
            };
            area[i] += u(j) * v(k) - u(k) * v(j);
        }
    }
};

Summary summaryOf(const Mesh &mesh)
{
    Summary summary;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        std::array<std::array<float, 8>, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = mesh.vertices.at(mesh.faces[i][k]);
            const std::uint32_t t =
                mesh.faceTextureCoordinates.empty() ? Mesh::none : mesh.faceTextureCoordinates.at(i)[k];
            const std::uint32_t n = mesh.faceNormals.empty() ? Mesh::none : mesh.faceNormals.at(i)[k];
            const glm::vec2 uv = t == Mesh::none ? glm::dvec2(0.0) : mesh.textureCoordinates.at(t);
            const glm::vec3 normal = n == Mesh::none ? glm::dvec3(0.0) : mesh.normals.at(n);
            triangle[k] = {p.x, p.y, p.z, uv.x, uv.y, normal.x, normal.y, normal.z};
        }
        summary.add(triangle);
    }
    return summary;
}

Summary summaryOf(const aiScene *scene)
{
    Summary summary;
    for (unsigned m = 0; scene && m < scene->mNumMeshes; ++m) {
        const aiMesh &mesh = *scene->mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) {
                continue; // points and lines
            }
            std::array<std::array<float, 8>, 3> triangle{};
            for (unsigned k = 0; k < 3; ++k) {
                const unsigned i = mesh.mFaces[f].mIndices[k];
                const aiVector3D p = mesh.mVertices[i];
                const aiVector3D t = mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][i] : aiVector3D();
                const aiVector3D n = mesh.HasNormals() ? mesh.mNormals[i] : aiVector3D();
                triangle[k] = {p.x, p.y, p.z, t.x, t.y, n.x, n.y, n.z};
            }
            summary.add(triangle);
        }
    }
    return summary;
}

/// Whether the corners that only one of two has differ in nothing but how their numbers were rounded.
bool areLike(const Summary &ours, const Summary &theirs)
{
    const auto isLike = [](const std::array<float, 8> &a, const std::array<float, 8> &b) {
        return std::ranges::equal(a, b, [](float x, float y) {
            return std::abs(x - y) <= 4 * std::numeric_limits<float>::epsilon() * std::max(std::abs(x), 1e-3F);
        });
    };
    const auto isIn = [&](const std::array<float, 8> &corner, const std::set<std::array<float, 8>> &set) {
        return set.contains(corner)
            || std::ranges::any_of(set, [&](const auto &other) { return isLike(corner, other); });
    };
    return std::ranges::all_of(ours.corners, [&](const auto &corner) { return isIn(corner, theirs.corners); })
        && std::ranges::all_of(theirs.corners, [&](const auto &corner) { return isIn(corner, ours.corners); });
}

std::string bytesOf(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> modelsIn(const fs::path &folder)
{
    std::vector<fs::path> models;
    std::error_code none;
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder, none)) {
        if (entry.path().extension() == ".obj") {
            models.push_back(entry.path());
        }
    }
    std::ranges::sort(models);
    return models;
}

/// What the two readers disagree on in a file; empty where they agree.
QString disagreement(const fs::path &path)
{
    const std::string text = bytesOf(path);
    const ObjResult result = readObj(text);
    if (hasErrors(result.diagnostics)) {
        return QString::fromStdString(result.diagnostics.back().message());
    }
    const Summary ours = summaryOf(result.mesh);
    Assimp::Importer importer;
    const Summary theirs = summaryOf(importer.ReadFile(path.string(), aiProcess_Triangulate));
    if (ours.triangles != theirs.triangles) {
        return QStringLiteral("%1 triangles, %2 of assimp's").arg(ours.triangles).arg(theirs.triangles);
    }
    if (!areLike(ours, theirs)) {
        return QStringLiteral("other corners");
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(ours.area[i] - theirs.area[i]) > 1e-6 * ours.size()) {
            return QStringLiteral("another area");
        }
    }
    return {};
}

}

/// Models that people made, as assimp reads them.
class TestObjModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void modelsAreThoseOfAssimp_data();
    void modelsAreThoseOfAssimp();
    void concaveModelsAreCovered();
    void brokenModelsAreRefused_data();
    void brokenModelsAreRefused();
};

void TestObjModels::modelsAreThoseOfAssimp_data()
{
    QTest::addColumn<QString>("folder");
    QTest::addColumn<int>("count");
    QTest::addColumn<QStringList>("differing");
    QTest::newRow("assimp-testmodels")
        << QStringLiteral("/usr/share/assimp/models/OBJ") << 23
        << QStringList{
               // not read here
               QStringLiteral("box_UTF16BE: the file is not UTF-8 text (it looks like UTF-16)"),
               // one face of 312 corners, 1 2 3 4 1 2 3 4 …, of which assimp leaves out some
               QStringLiteral("box_longline: 944 triangles, 634 of assimp's"),
               // one face of 66 corners, of which assimp leaves out 5 % of the area
               QStringLiteral("concave_polygon: 64 triangles, 58 of assimp's"),
               // assimp stops in the middle of the word
               QStringLiteral("number_formats: \"3.1+e2\" is not a number"),
               // the face of concave_polygon
               QStringLiteral("space_in_material_name: 64 triangles, 58 of assimp's"),
           };
    QTest::newRow("bunny") << QStringLiteral("/usr/share/glmark2/models") << 1 << QStringList();
    QTest::newRow("homedecor") << QStringLiteral("/usr/share/games/minetest/mods/homedecor") << 146 << QStringList();
}

/// The packages are parts of the development root; a system without them fails here.
void TestObjModels::modelsAreThoseOfAssimp()
{
    QFETCH(QString, folder);
    const std::vector<fs::path> models = modelsIn(folder.toStdString());
    QTEST(static_cast<int>(models.size()), "count");
    QStringList differing;
    for (const fs::path &model : models) {
        if (const QString difference = disagreement(model); !difference.isEmpty()) {
            differing.push_back(QString::fromStdString(model.stem().string()) + QStringLiteral(": ") + difference);
        }
    }
    QTEST(differing, "differing");
}

/// Where assimp leaves something out: the triangles of one flat face together are as large as the face.
void TestObjModels::concaveModelsAreCovered()
{
    const Mesh mesh = readObj(bytesOf("/usr/share/assimp/models/OBJ/concave_polygon.obj")).mesh;
    QCOMPARE(mesh.faces.size(), 64u);
    glm::dvec3 whole(0.0);
    double sum = 0.0;
    for (const auto &[a, b, c] : mesh.faces) {
        const glm::dvec3 area = glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        whole += area;
        sum += glm::length(area);
    }
    QVERIFY(sum <= glm::length(whole) * (1 + 1e-9));
}

void TestObjModels::brokenModelsAreRefused_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("expected");
    QTest::newRow("empty") << "empty" << "";
    QTest::newRow("indices of nothing") << "malformed" << "23:5 no vertex 12: 8 vertices so far";
    QTest::newRow("a face without corners") << "malformed2" << "23:1 a face has at least three corners, found 0";
}

void TestObjModels::brokenModelsAreRefused()
{
    QFETCH(QString, name);
    const fs::path path = "/usr/share/assimp/models/invalid/" + name.toStdString() + ".obj";
    QVERIFY(fs::exists(path));
    const std::string text = bytesOf(path);
    const ObjResult result = readObj(text);
    QString remark;
    for (const Diagnostic &diagnostic : result.diagnostics) {
        const TextPosition at = LineMap(text).position(diagnostic.range.begin);
        remark +=
            QStringLiteral("%1:%2 %3").arg(at.line).arg(at.column).arg(QString::fromStdString(diagnostic.message()));
    }
    QTEST(remark, "expected");
    QVERIFY(result.mesh.faces.empty());
}

}

ROMANESCO_TEST(romanesco::test::TestObjModels)

#include "testobjmodels.moc"
