// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <random>

#include <QTest>

#include "core/formats/glbwriter.h"
#include "tests/core/export/glb.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

bool isNear(const Triangle &a, const Triangle &b, double tolerance)
{
    for (std::size_t turn = 0; turn < 3; ++turn) {
        bool isAll = true;
        for (std::size_t i = 0; i < 9; ++i) {
            isAll = isAll && std::abs(a[i / 3][i % 3] - b[(i / 3 + turn) % 3][i % 3]) <= tolerance;
        }
        if (isAll) {
            return true;
        }
    }
    return false;
}

/// Each triangle has its own partner in the other list, in the same sense of rotation.
bool areSame(const std::vector<Triangle> &found, std::vector<Triangle> expected, double tolerance)
{
    for (const Triangle &triangle : found) {
        const auto partner =
            std::ranges::find_if(expected, [&](const Triangle &other) { return isNear(triangle, other, tolerance); });
        if (partner == expected.end()) {
            return false;
        }
        expected.erase(partner);
    }
    return expected.empty();
}

/// What an OBJ of the scene holds, right-handed: z negated and faces turned.
std::vector<Triangle> rightHanded(const Scene &scene)
{
    std::vector<Triangle> triangles = exactTriangles(exported(scene));
    for (Triangle &triangle : triangles) {
        for (Corner &corner : triangle) {
            corner[2] = -corner[2];
        }
        std::swap(triangle[1], triangle[2]);
    }
    return triangles;
}

qsizetype instancedNodes(const Glb &glb)
{
    qsizetype count = 0;
    for (const QJsonValue &node : glb.json["nodes"].toArray()) {
        count += node.toObject().contains("extensions") ? 1 : 0;
    }
    return count;
}

std::shared_ptr<const Scene> loadedText(const std::string &text)
{
    return loaded(TableFiles({{"cube.obj", unitCubeObj}, {"a.fdo", text}}), "a.fdo");
}

/// 4^depth cubes.
std::shared_ptr<const Scene> sheared(int depth)
{
    return loadedText("x. \"cube.obj\"\na 5 0 0\nb 0 5 0\nc 7 0 0\nd 0 0 7\nr 10 20 30\ns 1 1.1 1\nt.p. (p, r, s)\n"
                      "z<x>. [t.a, t.b, t.c, t.d] x\n<$>. z "
                      + std::to_string(depth) + "\n");
}

const std::string mirrors = "x. \"cube.obj\"\na 5 0 0\nb 0 5 0\nc -1 2 3\nd -2 -2 -2\nr 10 20 30\nt.p.s. (p, r, s)\n";

/// Two items that fit by themselves and not together. Nobody should look at more than a copy.
class ManySheared final : public CopySource
{
public:
    [[nodiscard]] std::span<const Item> items() const override { return m_items; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t, const Visitor &visitor) const override
    {
        visitor({{glm::dmat3(1, 0, 0, 1, 1, 0, 0, 0, 1), glm::dvec3(0.0)}});
        return {};
    }

private:
    Mesh m_mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}};
    std::array<Item, 2> m_items{Item{&m_mesh, 50'000'000}, Item{&m_mesh, 50'000'000}};
};

}

/// Where copies are in a GLB, and what it cannot hold.
class TestGlbExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void similarCopiesAreInstances();
    void mirroredCopiesHaveAMirroredNode();
    void shearedCopiesAreBaked();
    void flatCopiesAreInstancesToo();
    void anyFractalIsItsFlattening();
    void aMeshByItselfIsANode();
    void itemsShareTheirMesh();
    void otherProgramsReadBakedMeshes();
    void whatGlbCannotHoldIsRefused();
    void bytesAreForecast();
    void stopsAreHeeded();
};

void TestGlbExport::similarCopiesAreInstances()
{
    const auto scene = menger(2);
    const Glb glb(glbOf(*scene));
    QVERIFY(glb.isSound());
    QCOMPARE(instancedNodes(glb), 1);
    QCOMPARE(glb.json["extensionsRequired"].toArray(), QJsonArray{"EXT_mesh_gpu_instancing"});
    QCOMPARE(glb.at("accessors", 0)["count"].toInt(), 8);
    QCOMPARE(glb.json["asset"].toObject()["extras"].toObject()["comment"].toString(),
             QStringLiteral("Romanesco: a.fdo, depth 2, 4800 faces"));
    QVERIFY(areSame(glb.triangles(), rightHanded(*scene), 1e-6));
}

void TestGlbExport::mirroredCopiesHaveAMirroredNode()
{
    const auto scene = loadedText(mirrors + "m -2 2 2\n<$>. [#, t.a.m] [#, t.b.m] x\n");
    QVERIFY(scene);
    const Glb glb(glbOf(*scene));
    QVERIFY(glb.isSound());
    QCOMPARE(instancedNodes(glb), 2);
    QCOMPARE(glb.at("nodes", 1)["scale"].toArray(), (QJsonArray{1, 1, -1}));
    const std::vector<Triangle> triangles = glb.triangles();
    QVERIFY(areSame(triangles, rightHanded(*scene), 1e-5));
    QVERIFY(solidOf(triangles).volume > 0);
}

void TestGlbExport::shearedCopiesAreBaked()
{
    const auto scene = loadedText(mirrors + "<$>. [#, t.a.c] [#, t.b.d] [t.a.c] x\n");
    QVERIFY(scene);
    StringSink sink;
    const auto report = exportScene(*scene, {.format = ExportFormat::Glb}, sink);
    QVERIFY(report);
    QCOMPARE(report->bakedCopies, 4u);
    const Glb glb(sink.text);
    QVERIFY(glb.isSound());
    QVERIFY(!glb.json.contains("extensionsRequired"));
    const std::vector<Triangle> triangles = glb.triangles();
    QCOMPARE(triangles.size(), std::size_t{48});
    QVERIFY(areSame(triangles, rightHanded(*scene), 1e-5));
    QVERIFY(solidOf(triangles).volume > 0);
}

void TestGlbExport::flatCopiesAreInstancesToo()
{
    for (const char *scale : {"2 3 0", "0 3 0", "0 2 3", "0 0 0", "0 0 1", "-1 0 2"}) {
        const auto scene = loadedText(mirrors + "f " + scale + "\n<$>. [#, t.a.f] x\n");
        QVERIFY(scene);
        const Glb glb(glbOf(*scene));
        QVERIFY(glb.isSound());
        QVERIFY(instancedNodes(glb) > 0);
        // a flat cube has each face twice, looking to both sides
        QVERIFY2(areSame(glb.triangles(), rightHanded(*scene), 1e-5), scale);
    }
}

void TestGlbExport::anyFractalIsItsFlattening()
{
    std::mt19937_64 random(seed(21));
    int instanced = 0;
    for (int round = 0; round < 60; ++round) {
        const naive::Fractal fractal = randomFractal(random, 0.9);
        const auto mesh = std::make_shared<const Mesh>(randomMesh(random));
        FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(*mesh)).value();
        Scene scene;
        scene.items.push_back({.model = std::make_shared<const Model>(Model{mesh, std::move(graph), {}, {}, {}}),
                               .worldFromModel = randomMap(random, 2.0)});
        const Glb glb(glbOf(scene));
        QVERIFY(glb.isSound());
        instanced += instancedNodes(glb) > 0 ? 1 : 0;
        QVERIFY2(areSame(glb.triangles(), rightHanded(scene), 1e-4), qPrintable(QString::number(round)));
    }
    QVERIFY(instanced > 5 && instanced < 55);
}

void TestGlbExport::aMeshByItselfIsANode()
{
    const TableFiles files({{"cube.obj", unitCubeObj},
                            {"a.sdo",
                             "o \"cube.obj\" ((1, 2, 3), (10, 20, 30), (-2, 3, 4))\n"
                             "p \"cube.obj\" ((9, 9, 9), #, #) 0.5\n"}});
    const auto scene = loaded(files, "a.sdo");
    const Glb glb(glbOf(*scene));
    QVERIFY(glb.isSound());
    QVERIFY(!glb.json.contains("extensionsUsed"));
    QCOMPARE(glb.json["nodes"].toArray().size(), 2);
    const QJsonObject primitive = glb.at("meshes", 0)["primitives"].toArray()[0].toObject();
    QCOMPARE(primitive["attributes"].toObject().keys(), QStringList("POSITION"));
    const QJsonObject material = glb.at("materials", primitive["material"].toInteger(-1));
    QCOMPARE(material["pbrMetallicRoughness"].toObject()["metallicFactor"].toDouble(1), 0.0);
    QVERIFY(areSame(glb.triangles(), rightHanded(*scene), 1e-5));
}

void TestGlbExport::itemsShareTheirMesh()
{
    const auto model = menger(1)->items.front().model;
    Scene scene;
    for (const double place : {0.0, 5.0, 10.0}) {
        scene.items.push_back({.model = model, .worldFromModel = {glm::dmat3(1.0), {place, 0, 0}}});
    }
    const Glb glb(glbOf(scene));
    QCOMPARE(glb.json["meshes"].toArray().size(), 1);
    QCOMPARE(glb.json["nodes"].toArray().size(), 3);
    QVERIFY(areSame(glb.triangles(), rightHanded(scene), 1e-5));
}

void TestGlbExport::otherProgramsReadBakedMeshes()
{
    const auto scene = loadedText(mirrors + "<$>. [#, t.a.c] [#, t.b.d] [t.a.c] x\n");
    const Solid solid = solidOf(importedTriangles(glbOf(*scene), "glb"));
    const Solid truth = solidOf(exactTriangles(exported(*scene)));
    QCOMPARE(solid.faces, truth.faces);
    QVERIFY(std::abs(solid.area - truth.area) < 1e-5 * truth.area);
    QVERIFY(std::abs(solid.volume - truth.volume) < 1e-5 * truth.volume);
}

void TestGlbExport::whatGlbCannotHoldIsRefused()
{
    // 20^7 instances of 40 bytes; 4^13 cubes of 240 bytes
    const std::string tooLarge = "a GLB file holds at most 4294967295 bytes";
    const auto baked = sheared(13);
    QVERIFY(baked);
    StringSink sink;
    for (const auto &scene : {menger(7), baked}) {
        const auto report = exportScene(*scene, {.format = ExportFormat::Glb}, sink);
        QVERIFY(!report);
        QCOMPARE(report.error(), tooLarge);
        const ExportOptions options{.format = ExportFormat::Glb};
        QCOMPARE(obstacle(forecast(*scene, options).value(), options, "/tmp/a.glb"), tooLarge);
    }
    QCOMPARE(writeGlb(ManySheared(), {}, sink).error(), tooLarge);
    Mesh far;
    far.vertices = {{1e39, 0, 0}, {1e39, 1, 0}, {1e39, 0, 1}};
    far.faces = {{0, 1, 2}};
    QVERIFY(exportScene(sceneOf(modelOfMesh(std::make_shared<const Mesh>(far))), {.format = ExportFormat::Glb}, sink)
                .error()
                .contains("3.4e38"));
    QVERIFY(sink.text.empty());
}

void TestGlbExport::bytesAreForecast()
{
    const auto baked =
        loadedText(mirrors + "e 7 0 0\nf 0 0 7\ng 1 1.1 1\nz<x>. [t.a.g, t.b.g, t.e.g, t.f.g] x\n<$>. z 8\n");
    for (const auto &scene : {menger(1), menger(4), baked}) {
        const ExportOptions options{.format = ExportFormat::Glb};
        CountingSink sink;
        QVERIFY(exportScene(*scene, options, sink));
        const double told = static_cast<double>(forecast(*scene, options).value().bytes.toInteger().value());
        QVERIFY(std::abs(told / static_cast<double>(sink.count()) - 1.0) < 0.02);
    }
}

void TestGlbExport::stopsAreHeeded()
{
    std::stop_source stop;
    stop.request_stop();
    CountingSink sink;
    const auto report = exportScene(*menger(5), {.format = ExportFormat::Glb}, sink, {.stop = stop.get_token()});
    QVERIFY(!report);
    QCOMPARE(report.error(), std::string("cancelled"));
    QCOMPARE(sink.count(), 0u);
}

}

ROMANESCO_TEST(romanesco::test::TestGlbExport)
#include "testglbexport.moc"
