// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <random>

#include <QTest>

#include "tests/core/export/exported.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Maps in doubles, by arithmetic of their own: the same sums in the same order give the same bits.
struct PlainMap {
    std::array<std::array<double, 3>, 3> a{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Corner b{0, 0, 0};
};

PlainMap plain(const AffineMap &map)
{
    PlainMap result;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result.a[row][column] = map.linear[static_cast<int>(column)][static_cast<int>(row)];
        }
        result.b[row] = map.translation[static_cast<int>(row)];
    }
    return result;
}

double sum(const std::array<double, 3> &row, double x, double y, double z)
{
    return row[0] * x + row[1] * y + row[2] * z;
}

Corner applied(const PlainMap &map, const Corner &v)
{
    Corner result;
    for (std::size_t row = 0; row < 3; ++row) {
        result[row] = sum(map.a[row], v[0], v[1], v[2]) + map.b[row];
    }
    return result;
}

PlainMap product(const PlainMap &outer, const PlainMap &inner)
{
    PlainMap result;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result.a[row][column] = sum(outer.a[row], inner.a[0][column], inner.a[1][column], inner.a[2][column]);
        }
    }
    result.b = applied(outer, inner.b);
    return result;
}

/// Of a map by itself, whose determinant is far from zero or, where it is flat, zero within rounding.
int orientation(const AffineMap &map)
{
    const auto &a = naive::fromCore(map).a;
    const long double determinant = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1])
        - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return determinant < -1e-12L ? -1 : determinant > 1e-12L ? 1 : 0;
}

/// Turned until its least corner comes first, so that equal triangles are equal, reversed ones are not.
Triangle canonical(Triangle triangle)
{
    std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    return triangle;
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles)
{
    std::ranges::transform(triangles, triangles.begin(), canonical);
    std::ranges::sort(triangles);
    return triangles;
}

/// A fractal, and the same as its text would list it.
struct Both {
    naive::Fractal fractal;
    Mesh mesh;

    [[nodiscard]] std::shared_ptr<const Model> model() const
    {
        const auto shared = std::make_shared<const Mesh>(mesh);
        FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(*shared)).value();
        return std::make_shared<const Model>(Model{shared, std::move(graph), {}, {}, {}});
    }

    /// Every sequence of picks once; the mirrored ones with their faces turned, flat ones as they are.
    void list(const AffineMap &world, std::vector<Triangle> &triangles) const
    {
        for (const naive::Picks &picks : naive::allPicks(fractal.levels())) {
            PlainMap map;
            int sign = orientation(world);
            for (const int pick : picks) {
                const AffineMap &next = fractal.maps[static_cast<std::size_t>(pick)];
                map = product(map, plain(next));
                sign *= orientation(next);
            }
            if (!(world == AffineMap{})) {
                map = product(plain(world), map);
            }
            for (const Mesh::Face &face : mesh.faces) {
                Triangle triangle;
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const glm::dvec3 &v = mesh.vertices[face[sign < 0 ? 2 - corner : corner]];
                    triangle[corner] = applied(map, {v.x, v.y, v.z});
                }
                triangles.push_back(triangle);
            }
        }
    }
};

}

class TestExportedCopies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyDistinctCopyIsWrittenOnceToTheLastBit();
    void itemsOfASceneStandAtTheirPlaces();
    void mirroredCopiesLookOutwards();
    void flatCopiesAreWritten();
    void branchesAreGroups();
    void stopsAreHeeded();
    void stopsAreHeededInsideACopy();
};

/// Maps of all kinds: similar, unequal, sheared, mirrored and flat; sets with and without `#`, which share maps.
void TestExportedCopies::everyDistinctCopyIsWrittenOnceToTheLastBit()
{
    std::mt19937_64 random(seed(7));
    for (int round = 0; round < 200; ++round) {
        const Both both{randomFractal(random, 0.9), randomMesh(random)};
        std::vector<Triangle> truth;
        both.list({}, truth);
        const std::string text = exported(sceneOf(both.model()));
        QCOMPARE(sorted(exactTriangles(text)), sorted(truth));
    }
}

void TestExportedCopies::itemsOfASceneStandAtTheirPlaces()
{
    std::mt19937_64 random(seed(8));
    for (int round = 0; round < 50; ++round) {
        const Both first{randomFractal(random, 0.9), randomMesh(random)};
        const Both second{randomFractal(random, 0.9), randomMesh(random)};
        Scene scene;
        std::vector<Triangle> truth;
        const std::shared_ptr<const Model> model = first.model();
        for (int i = 0; i < 2; ++i) {
            scene.items.push_back({.model = model, .worldFromModel = randomMap(random, 2.0)});
            first.list(scene.items.back().worldFromModel, truth);
        }
        scene.items.push_back({.model = second.model(), .worldFromModel = randomMap(random, 2.0)});
        second.list(scene.items.back().worldFromModel, truth);
        QCOMPARE(sorted(exactTriangles(exported(scene))), sorted(truth));
    }
}

void TestExportedCopies::mirroredCopiesLookOutwards()
{
    const std::string text = "x. \"cube.obj\"\na 5 0 0\nb 0 5 0\nc -1 2 3\nd -2 -2 -2\nr 10 20 30\n"
                             "t.p.s. (p, r, s)\n<$>. [#, t.a.c, t.b.d] x\n";
    const TableFiles files({{"cube.obj", unitCubeObj},
                            {"a.fdo", text},
                            {"a.sdo", "f \"a.fdo\" ((20, 0, 0), (30, 0, 0), (1, -1, 1))\no \"cube.obj\" #\n"}});
    for (const char *path : {"a.fdo", "a.sdo"}) {
        const auto scene = loaded(files, path);
        QVERIFY(scene);
        const Solid solid = solidOf(exactTriangles(exported(*scene)));
        const double cubes = path == std::string("a.sdo") ? 1 + (1 + 6 + 8) : 1 + 6 + 8;
        QVERIFY2(std::abs(solid.volume - cubes) < 1e-9, qPrintable(QString::number(solid.volume)));
        for (const char *format : {"ply", "stl"}) {
            const std::string bytes = exported(*scene, {.format = exportFormat(std::string("a.") + format).value()});
            const Solid other = solidOf(importedTriangles(bytes, format));
            QVERIFY2(std::abs(other.volume - cubes) < 1e-3, qPrintable(QString::number(other.volume)));
        }
    }
}

void TestExportedCopies::flatCopiesAreWritten()
{
    const TableFiles files(
        {{"cube.obj", unitCubeObj}, {"a.fdo", "x. \"cube.obj\"\nf 2 3 0\nr 10 20 30\nt. (#, r, f)\n<$>. [t] x\n"}});
    const auto scene = loaded(files, "a.fdo");
    QVERIFY(scene);
    const Solid solid = solidOf(exactTriangles(exported(*scene)));
    QCOMPARE(solid.faces, 12);
    QVERIFY(std::abs(solid.area - 2 * 6.0) < 1e-12);
}

void TestExportedCopies::branchesAreGroups()
{
    const TableFiles files({{"one.obj", triangleObj},
                            {"a.fdo",
                             "x. \"one.obj\"\na 1 0 0\nb 0 1 0\nt.p. (p, #, #)\n"
                             "z<x>. [#, t.a, t.b] x\n<$>. z 2\n"},
                            {"a.sdo", "f \"a.fdo\" #\no \"one.obj\" #\nf \"a.fdo\" #\n"}});
    const auto scene = loaded(files, "a.sdo");
    const std::string text = exported(*scene, {.isGrouped = true});
    std::string groups;
    for (const std::vector<std::string> &words : linesOf(text, "g")) {
        groups += words.at(0) + " ";
    }
    QCOMPARE(groups, std::string("a a.1.1 a.1.2 one a-2 a-2.1.1 a-2.1.2 "));
    QVERIFY(linesOf(exported(*scene), "g").empty());
    const std::string alone = exported(*loaded(files, "a.fdo"), {.isGrouped = true, .source = "my tree.fdo"});
    QCOMPARE(linesOf(alone, "g").at(1).at(0), std::string("my_tree.1.1"));
}

void TestExportedCopies::stopsAreHeeded()
{
    std::stop_source stop;
    CountingSink sink;
    ExportContext context{stop.get_token(), [&](std::uint64_t bytes) {
                              if (bytes > 1'000'000) {
                                  stop.request_stop();
                              }
                          }};
    const auto report = exportScene(*menger(5), {}, sink, context);
    QVERIFY(!report);
    QCOMPARE(report.error(), std::string("cancelled"));
    QVERIFY(sink.count() < 2'000'000);
}

void TestExportedCopies::stopsAreHeededInsideACopy()
{
    Mesh mesh;
    mesh.vertices.assign(1'000'000, {0.1, 0.2, 0.3});
    mesh.faces = {{0, 1, 2}};
    std::stop_source stop;
    CountingSink sink;
    const auto report = exportScene(sceneOf(modelOfMesh(std::make_shared<const Mesh>(std::move(mesh)))), {}, sink,
                                    {stop.get_token(), [&](std::uint64_t) { stop.request_stop(); }});
    QVERIFY(!report);
    QCOMPARE(report.error(), std::string("cancelled"));
    QVERIFY(sink.count() < 1'000'000);
}

}

ROMANESCO_TEST(romanesco::test::TestExportedCopies)
#include "testexportedcopies.moc"
