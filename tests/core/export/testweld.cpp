// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/export/weld.h"

#include <cmath>
#include <map>
#include <random>
#include <set>

#include <QTest>

#include "core/export/scenecopies.h"
#include "core/export/vertexgrid.h"
#include "tests/core/export/exported.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// What an OBJ of the welded scene holds, with what welding said of it.
struct WeldedFile {
    std::string text;
    WeldReport report;

    [[nodiscard]] Solid solid() const { return solidOf(exactTriangles(text)); }
    [[nodiscard]] std::size_t vertices() const { return linesOf(text, "v").size(); }

    /// Edges by the numbers of their vertices that do not have as many in the other direction.
    [[nodiscard]] std::size_t openEdges() const
    {
        std::map<std::pair<int, int>, int> edges;
        for (const std::vector<std::string> &face : linesOf(text, "f")) {
            for (std::size_t i = 0; i < 3; ++i) {
                const int a = std::atoi(face.at(i).c_str());
                const int b = std::atoi(face.at((i + 1) % 3).c_str());
                edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
            }
        }
        return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto &e) { return e.second != 0; }));
    }
};

WeldedFile welded(const Scene &scene, bool isGrouped = false)
{
    StringSink sink;
    const auto report = exportScene(scene, {.isGrouped = isGrouped, .isWelded = true}, sink);
    return report ? WeldedFile{sink.text, report->weld.value()} : WeldedFile{"error: " + report.error(), {}};
}

/// A mesh. Someone asks for a stop when all has been visited that there is to visit.
class StopsAtLast final : public CopySource
{
public:
    explicit StopsAtLast(const Mesh &mesh)
        : m_item{&mesh, 1}
    {
    }
    [[nodiscard]] std::span<const Item> items() const override { return {&m_item, 1}; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t, const Visitor &visitor) const override
    {
        visitor({});
        if (++m_visits == 3) {
            stop.request_stop();
        }
        return {};
    }
    mutable std::stop_source stop;

private:
    Item m_item;
    mutable int m_visits = 0;
};

std::shared_ptr<const Scene> cubes(const std::string &text)
{
    return loaded(TableFiles({{"cube.obj", unitCubeObj},
                              {"a.fdo", "x. \"cube.obj\"\nt.p. (p, #, #)\ns.p.q. (p, #, q)\n" + text}}),
                  "a.fdo");
}

}

class TestWeld : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aMengerSpongeIsTheUnionOfItsCubes_data();
    void aMengerSpongeIsTheUnionOfItsCubes();
    void tetrahedraShareTheirCorners();
    void cubesApartStayAsTheyAre();
    void holesAreCounted();
    void copiesInOnePlaceAreOne();
    void neighboursThatDoNotTouchStayApart();
    void neighboursFarFromTheOriginTouchWithinRounding();
    void mirroredNeighboursHaveAWallToo();
    void pointsAndFlatCopiesAreNoTrouble();
    void facesKeepTheirLooks();
    void branchesStayGroups();
    void coloursStayWithTheirVertices();
    void otherFormatsAreWeldedToo();
    void whatIsSmallerThanRoundingIsRefused();
    void moreFacesThanMemoryMayHoldAreRefused();
    void stopsAreHeeded();
    void gridsFindWhatASearchOfAllFinds();
};

void TestWeld::aMengerSpongeIsTheUnionOfItsCubes_data()
{
    QTest::addColumn<int>("depth");
    QTest::addColumn<bool>("isRough");
    for (int depth = 0; depth <= 3; ++depth) {
        QTest::addRow("depth %d", depth) << depth << false;
        QTest::addRow("depth %d, a third of ten digits", depth) << depth << true;
    }
}

void TestWeld::aMengerSpongeIsTheUnionOfItsCubes()
{
    QFETCH(const int, depth);
    QFETCH(const bool, isRough);
    // neighbours are apart by some 1e-11 where a third has ten digits
    const WeldedFile file = welded(*(isRough ? roughMenger(depth) : menger(depth)));
    const Solid solid = file.solid();
    const double tolerance = isRough ? 1e-8 : 1e-12;
    QVERIFY(std::abs(solid.area - 2 * std::pow(20.0 / 9, depth) - 4 * std::pow(8.0 / 9, depth))
            < tolerance * solid.area);
    QVERIFY(std::abs(solid.volume - std::pow(20.0 / 27, depth)) < tolerance);
    QVERIFY(file.report.isClosed());
    QCOMPARE(file.openEdges(), std::size_t{0});
    // squares of the finest grid, two triangles each
    const double squares = solid.area * std::pow(9.0, depth);
    QCOMPARE(solid.faces, static_cast<std::size_t>(std::lround(2 * squares)));
    QCOMPARE(file.report.droppedWalls, static_cast<std::uint64_t>(12 * std::pow(20, depth)) - solid.faces);
    std::set<std::array<long, 3>> corners;
    for (const Triangle &triangle : exactTriangles(file.text)) {
        for (const Corner &corner : triangle) {
            std::array<long, 3> place;
            std::ranges::transform(corner, place.begin(),
                                   [&](double x) { return std::lround(2 * x * std::pow(3, depth)); });
            corners.insert(place);
        }
    }
    QCOMPARE(file.vertices(), corners.size());
}

void TestWeld::tetrahedraShareTheirCorners()
{
    for (int depth = 0; depth <= 4; ++depth) {
        const WeldedFile file = welded(*sierpinski(depth));
        const auto count = static_cast<std::size_t>(std::pow(4, depth));
        QCOMPARE(file.vertices(), 2 * count + 2);
        QCOMPARE(file.solid().faces, 4 * count);
        QVERIFY(file.report.isClosed());
        QCOMPARE(file.report.mergedVertices, 4 * count - (2 * count + 2));
    }
}

void TestWeld::cubesApartStayAsTheyAre()
{
    const WeldedFile file = welded(*cantorDust(2));
    QCOMPARE(file.vertices(), std::size_t{8 * 64});
    QCOMPARE(file.report.mergedVertices, 0u);
    QVERIFY(file.report.isClosed());
}

void TestWeld::holesAreCounted()
{
    const TableFiles files({{"one.obj", triangleObj}, {"a.sdo", "o \"one.obj\" #\no \"one.obj\" ((0, 0, 1), #, #)\n"}});
    const WeldedFile file = welded(*loaded(files, "a.sdo"));
    QVERIFY(!file.report.isClosed());
    QCOMPARE(file.report.openEdges, 6u);
    QCOMPARE(file.openEdges(), std::size_t{6});
}

void TestWeld::copiesInOnePlaceAreOne()
{
    const WeldedFile file = welded(*cubes("a 1e-12 0 0\nb 0 -1e-11 0\n<$>. [#, t.a, t.b] x\n"));
    QCOMPARE(file.solid().faces, std::size_t{12});
    QCOMPARE(file.report.droppedFaces, 24u);
    QCOMPARE(file.report.droppedWalls, 0u);
    QVERIFY(std::abs(file.solid().volume - 1) < 1e-9);
}

void TestWeld::neighboursThatDoNotTouchStayApart()
{
    const WeldedFile file = welded(*cubes("a 1.00001 0 0\n<$>. [#, t.a] x\n"));
    QCOMPARE(file.vertices(), std::size_t{16});
    QCOMPARE(file.report.droppedWalls, 0u);
}

/// Beside 123456.7 neighbouring doubles are 1.5e-11 apart, a millionth of an edge is 1e-12.
void TestWeld::neighboursFarFromTheOriginTouchWithinRounding()
{
    const WeldedFile file = welded(*cubes("a 123456.7 765432.1 -234567.8\nn 0 0 0\nb 1e-6 0 0\nc 0 1e-6 0\n"
                                          "tiny 1e-6 1e-6 1e-6\n<$>. [t.a] [s.n.tiny, s.b.tiny, s.c.tiny] x\n"));
    QCOMPARE(file.report.droppedWalls, 8u);
    QCOMPARE(file.vertices(), std::size_t{16});
    QVERIFY(file.report.isClosed());
}

void TestWeld::mirroredNeighboursHaveAWallToo()
{
    // the mirror of the cube beside it, whose touching side is cut along the same diagonal
    const WeldedFile file = welded(*cubes("a 1 0 0\nm -1 1 1\n<$>. [#, s.a.m] x\n"));
    QCOMPARE(file.report.droppedWalls, 4u);
    QVERIFY(file.report.isClosed());
    QVERIFY(std::abs(file.solid().volume - 2) < 1e-12);
    QVERIFY(std::abs(file.solid().area - 10) < 1e-12);
}

void TestWeld::pointsAndFlatCopiesAreNoTrouble()
{
    const WeldedFile point = welded(*cubes("a 5 0 0\nz 0 0 0\n<$>. [#, s.a.z] x\n"));
    QCOMPARE(point.solid().faces, std::size_t{12});
    QCOMPARE(point.report.droppedFaces, 12u);
    // a sheet of nothing: its sides look to both sides of it
    const WeldedFile flat = welded(*cubes("a 5 0 0\nf 1 0 1\n<$>. [#, s.a.f] x\n"));
    QCOMPARE(flat.solid().faces, std::size_t{12});
    QVERIFY(flat.report.isClosed());
}

void TestWeld::facesKeepTheirLooks()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.faces = {{0, 1, 2}, {2, 1, 3}};
    mesh.textureCoordinates = {{0, 0}, {1, 0}, {0, 1}};
    mesh.faceTextureCoordinates = {{0, 1, 2}, {2, 1, Mesh::none}};
    mesh.materials.resize(2);
    mesh.materials[0].name = "red";
    mesh.materials[1].name = "blue";
    mesh.groups = {"left", "right"};
    mesh.parts = {{0, 0, 0, 0}, {1, 1, 1, 4}};
    Scene scene;
    for (const double x : {0.0, 1.0}) {
        scene.items.push_back(
            {.model = modelOfMesh(std::make_shared<const Mesh>(mesh)), .worldFromModel = {glm::dmat3(1.0), {x, 0, 0}}});
    }
    const SceneCopies copies(scene, {1, 1}, SceneCopies::Branches::Unnamed, "a", {});
    const auto result = weld(copies, {});
    QVERIFY(result);
    const Mesh &together = result->mesh;
    QCOMPARE(together.vertices.size(), std::size_t{6});
    QCOMPARE(together.textureCoordinates.size(), std::size_t{6});
    QCOMPARE(together.textureCoordinates[4], glm::dvec2(1, 0));
    QCOMPARE(together.faceTextureCoordinates[1], (Mesh::Face{2, 1, Mesh::none}));
    QCOMPARE(together.faceTextureCoordinates[3], (Mesh::Face{5, 4, Mesh::none}));
    QCOMPARE(together.parts.size(), std::size_t{4});
    QCOMPARE(together.parts[3].firstFace, 3u);
    QCOMPARE(together.materials.at(together.parts[3].material).name, std::string("blue"));
    QCOMPARE(together.groups.at(together.parts[3].group), std::string("right"));
    QCOMPARE(together.parts[3].smoothing, 4u);
    QCOMPARE(together.materials.size(), std::size_t{2});
    const auto plain = menger(1);
    const SceneCopies alike(*plain, {20}, SceneCopies::Branches::Unnamed, "a", {});
    QCOMPARE(weld(alike, {})->mesh.parts.size(), std::size_t{1});
}

/// Parts lose faces in their middle, and begin later then.
void TestWeld::branchesStayGroups()
{
    const WeldedFile file = welded(*cubes("a 1 0 0\nb 2 0 0\n<$>. [#, t.a, t.b] x\n"), true);
    std::map<std::string, int> faces;
    std::string group;
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
        group = line.starts_with("g ") ? line.substr(2) : group;
        faces[group] += line.starts_with("f ") ? 1 : 0;
    }
    QCOMPARE(faces, (std::map<std::string, int>{{"", 0}, {"item", 10}, {"item.1.1", 8}, {"item.1.2", 10}}));
}

void TestWeld::coloursStayWithTheirVertices()
{
    Mesh mesh;
    // the second vertex belongs to no face and goes
    mesh.vertices = {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 2, 3}};
    mesh.colours = {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const WeldedFile file = welded(sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh))));
    QCOMPARE(file.vertices(), std::size_t{3});
    QCOMPARE(linesOf(file.text, "v").at(1), (std::vector<std::string>{"1", "0", "0", "0", "1", "0"}));
}

void TestWeld::otherFormatsAreWeldedToo()
{
    for (const char *format : {"ply", "stl", "glb"}) {
        const std::string bytes =
            exported(*menger(1), {.format = exportFormat(std::string("a.") + format).value(), .isWelded = true});
        const Solid solid = solidOf(importedTriangles(bytes, format));
        QVERIFY2(std::abs(solid.area - 2 * 20.0 / 9 - 4 * 8.0 / 9) < 1e-4, format);
    }
}

void TestWeld::whatIsSmallerThanRoundingIsRefused()
{
    for (const int depth : {12, 14, 40}) {
        const auto scene =
            cubes("a 1 0 0\nb 0 1 0\ntenth .1 .1 .1\nz<x>. [#, s.a.tenth] x\n<$>. z " + std::to_string(depth) + "\n");
        QVERIFY(scene);
        const WeldedFile file = welded(*scene);
        QCOMPARE(file.text.starts_with("error: the smallest copies are hardly larger than"), depth > 12);
    }
}

void TestWeld::moreFacesThanMemoryMayHoldAreRefused()
{
    const auto scene = menger(5);
    const std::string words = "welding holds all faces in memory, at most 10000000";
    QCOMPARE(exported(*scene, {.isWelded = true}), "error: " + words);
    const ExportOptions options{.isWelded = true};
    QCOMPARE(obstacle(forecast(*scene, options).value(), options, "/tmp/a.obj"), words);
}

void TestWeld::stopsAreHeeded()
{
    std::stop_source stop;
    stop.request_stop();
    CountingSink sink;
    const auto report = exportScene(*menger(4), {.isWelded = true}, sink, {.stop = stop.get_token()});
    QVERIFY(!report);
    QCOMPARE(report.error(), std::string("cancelled"));
    const Mesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}};
    const StopsAtLast late(mesh);
    const auto result = weld(late, late.stop.get_token());
    QVERIFY(!result);
    QCOMPARE(result.error(), std::string("cancelled"));
}

/// Points on and beside the sides of cells most of all.
void TestWeld::gridsFindWhatASearchOfAllFinds()
{
    std::mt19937_64 random(seed(3));
    constexpr double tolerance = 0.01;
    VertexGrid grid(tolerance, 0.5);
    std::vector<glm::dvec3> kept;
    const auto coordinate = [&] {
        const double side = 0.125 * static_cast<double>(random() % 9) - 0.5;
        return side + tolerance * 2.5 * (static_cast<double>(random() % 1'001) / 500 - 1);
    };
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 point(coordinate(), coordinate(), coordinate());
        std::size_t expected = 0;
        const auto isNear = [&](const glm::dvec3 &other) {
            return std::abs(other.x - point.x) <= tolerance && std::abs(other.y - point.y) <= tolerance
                && std::abs(other.z - point.z) <= tolerance;
        };
        while (expected < kept.size() && !isNear(kept[expected])) {
            ++expected;
        }
        if (expected == kept.size()) {
            kept.push_back(point);
        }
        QCOMPARE(grid.add(point), static_cast<std::uint32_t>(expected));
    }
    QVERIFY(kept.size() > 3'000 && kept.size() < 19'000);
    QCOMPARE(grid.points(), kept);
}

}

ROMANESCO_TEST(romanesco::test::TestWeld)
#include "testweld.moc"
