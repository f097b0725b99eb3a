// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstring>
#include <random>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/formats/glbwriter.h"
#include "tests/core/export/exported.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A GLB taken apart by the specification, which knows nothing of how it was made.
class Glb
{
public:
    explicit Glb(const std::string &bytes)
    {
        m_isSound = bytes.size() >= 20 && bytes.starts_with("glTF") && word(bytes, 4) == 2
            && word(bytes, 8) == bytes.size() && bytes.size() % 4 == 0 && bytes.substr(16, 4) == "JSON"
            && word(bytes, 12) % 4 == 0;
        if (!m_isSound) {
            return;
        }
        const std::size_t size = word(bytes, 12);
        json = QJsonDocument::fromJson(QByteArray(bytes.data() + 20, static_cast<qsizetype>(size))).object();
        m_isSound = !json.isEmpty();
        if (m_isSound && 20 + size < bytes.size()) {
            m_isSound = bytes.substr(24 + size, 4) == std::string("BIN\0", 4)
                && word(bytes, 20 + size) == bytes.size() - 28 - size
                && at("buffers", 0)["byteLength"].toInteger() == static_cast<qint64>(bytes.size() - 28 - size);
            m_binary = bytes.substr(28 + size);
        }
        m_isSound = m_isSound && viewsAreSound() && accessorsAreSound();
    }

    [[nodiscard]] bool isSound() const { return m_isSound; }

    QJsonObject json;

    [[nodiscard]] QJsonObject at(const char *list, qint64 index) const
    {
        return json[QLatin1String(list)].toArray()[static_cast<qsizetype>(index)].toObject();
    }

    /// The numbers of an accessor, some for each element.
    [[nodiscard]] std::vector<std::vector<double>> elements(qint64 accessor) const
    {
        const QJsonObject object = at("accessors", accessor);
        const QJsonObject view = at("bufferViews", object["bufferView"].toInteger());
        const std::size_t width = widthOf(object);
        const auto stride = static_cast<std::size_t>(view["byteStride"].toInteger(static_cast<qint64>(4 * width)));
        const auto begin = static_cast<std::size_t>(view["byteOffset"].toInteger() + object["byteOffset"].toInteger());
        std::vector<std::vector<double>> result;
        for (std::size_t i = 0; i < static_cast<std::size_t>(object["count"].toInteger()); ++i) {
            std::vector<double> &element = result.emplace_back();
            for (std::size_t j = 0; j < width; ++j) {
                const std::size_t place = begin + i * stride + 4 * j;
                float number = 0;
                std::memcpy(&number, m_binary.data() + place, 4);
                const bool isFloat = object["componentType"].toInt() == 5126;
                element.push_back(isFloat ? static_cast<double>(number) : static_cast<double>(word(m_binary, place)));
            }
        }
        return result;
    }

    [[nodiscard]] std::string bytesOfView(qint64 index) const
    {
        const QJsonObject view = at("bufferViews", index);
        return m_binary.substr(static_cast<std::size_t>(view["byteOffset"].toInteger()),
                               static_cast<std::size_t>(view["byteLength"].toInteger()));
    }

    /// Of all nodes with all their instances.
    [[nodiscard]] std::vector<Triangle> triangles() const
    {
        std::vector<Triangle> result;
        const QJsonArray nodes = json["scenes"].toArray()[0].toObject()["nodes"].toArray();
        for (const QJsonValue &number : nodes) {
            const QJsonObject node = at("nodes", number.toInteger());
            const QJsonArray primitives = at("meshes", node["mesh"].toInteger())["primitives"].toArray();
            for (const Placing &instance : instancesOf(node)) {
                for (const QJsonValue &primitive : primitives) {
                    append(primitive.toObject(), placingOf(node), instance, result);
                }
            }
        }
        return result;
    }

private:
    struct Placing {
        std::vector<double> translation{0, 0, 0};
        std::vector<double> rotation{0, 0, 0, 1};
        std::vector<double> scale{1, 1, 1};

        /// Rotation by v + 2w(q x v) + 2q x (q x v).
        [[nodiscard]] Corner operator()(const Corner &point) const
        {
            Corner v;
            for (std::size_t i = 0; i < 3; ++i) {
                v[i] = point[i] * scale[i];
            }
            const Corner q{rotation[0], rotation[1], rotation[2]};
            const Corner once = cross(q, v);
            const Corner twice = cross(q, once);
            for (std::size_t i = 0; i < 3; ++i) {
                v[i] += 2 * (rotation[3] * once[i] + twice[i]) + translation[i];
            }
            return v;
        }
        static Corner cross(const Corner &a, const Corner &b)
        {
            return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        }
        /// Faces are turned by readers where this is negative.
        [[nodiscard]] double sign() const { return scale[0] * scale[1] * scale[2]; }
    };

    static std::uint32_t word(const std::string &bytes, std::size_t place)
    {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + place, 4);
        return value;
    }

    static std::size_t widthOf(const QJsonObject &accessor)
    {
        const QString type = accessor["type"].toString();
        return type == "SCALAR" ? 1 : static_cast<std::size_t>(type.last(1).toInt());
    }

    static std::vector<double> numbers(const QJsonValue &value, std::vector<double> otherwise)
    {
        if (value.isArray()) {
            otherwise.clear();
            for (const QJsonValue &number : value.toArray()) {
                otherwise.push_back(number.toDouble());
            }
        }
        return otherwise;
    }

    static Placing placingOf(const QJsonObject &node)
    {
        return {numbers(node["translation"], {0, 0, 0}), numbers(node["rotation"], {0, 0, 0, 1}),
                numbers(node["scale"], {1, 1, 1})};
    }

    [[nodiscard]] std::vector<Placing> instancesOf(const QJsonObject &node) const
    {
        const QJsonObject attributes =
            node["extensions"].toObject()["EXT_mesh_gpu_instancing"].toObject()["attributes"].toObject();
        if (attributes.isEmpty()) {
            return {Placing()};
        }
        const auto translations = elements(attributes["TRANSLATION"].toInteger());
        const auto rotations = elements(attributes["ROTATION"].toInteger());
        const auto scales = elements(attributes["SCALE"].toInteger());
        std::vector<Placing> result;
        for (std::size_t i = 0; i < translations.size(); ++i) {
            result.push_back({translations[i], rotations.at(i), scales.at(i)});
        }
        return result;
    }

    /// Instances are taken for never mirrored by themselves, as viewers do, which turn faces by the node alone.
    void append(const QJsonObject &primitive, const Placing &node, const Placing &instance,
                std::vector<Triangle> &result) const
    {
        const auto positions = elements(primitive["attributes"].toObject()["POSITION"].toInteger());
        const auto indices = elements(primitive["indices"].toInteger());
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            Triangle triangle;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::vector<double> &p = positions.at(static_cast<std::size_t>(indices[i + corner][0]));
                triangle[node.sign() < 0 ? 2 - corner : corner] = node(instance({p[0], p[1], p[2]}));
            }
            result.push_back(triangle);
        }
    }

    [[nodiscard]] bool viewsAreSound() const
    {
        std::size_t end = 0;
        for (const QJsonValue &value : json["bufferViews"].toArray()) {
            const QJsonObject view = value.toObject();
            const auto offset = static_cast<std::size_t>(view["byteOffset"].toInteger());
            if (offset < end || offset % 4 != 0) {
                return false;
            }
            end = offset + static_cast<std::size_t>(view["byteLength"].toInteger());
        }
        return end <= m_binary.size() && m_binary.size() < end + 4;
    }

    [[nodiscard]] bool accessorsAreSound() const
    {
        for (qint64 i = 0; i < json["accessors"].toArray().size(); ++i) {
            const QJsonObject accessor = at("accessors", i);
            const QJsonObject view = at("bufferViews", accessor["bufferView"].toInteger());
            const qint64 width = 4 * static_cast<qint64>(widthOf(accessor));
            const qint64 end = accessor["byteOffset"].toInteger()
                + (accessor["count"].toInteger() - 1) * view["byteStride"].toInteger(width) + width;
            if (accessor["count"].toInteger() < 1 || end > view["byteLength"].toInteger()
                || (accessor.contains("min") && !boundsHold(i, accessor))) {
                return false;
            }
        }
        return true;
    }

    /// The bounds are those of the numbers, to the last bit.
    [[nodiscard]] bool boundsHold(qint64 index, const QJsonObject &accessor) const
    {
        std::vector<std::vector<double>> all = elements(index);
        for (qsizetype i = 0; i < accessor["min"].toArray().size(); ++i) {
            const auto at = [&](const std::vector<double> &element) { return element[static_cast<std::size_t>(i)]; };
            const auto [least, greatest] = std::ranges::minmax(all, {}, at);
            if (at(least) != accessor["min"].toArray()[i].toDouble()
                || at(greatest) != accessor["max"].toArray()[i].toDouble()) {
                return false;
            }
        }
        return true;
    }

    std::string m_binary;
    bool m_isSound = false;
};

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

std::string glbOf(const Scene &scene)
{
    return exported(scene, {.format = ExportFormat::Glb, .source = "a.fdo"});
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

}

namespace {

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
    void cornersOfUnlikeAttributesAreVertices();
    void normalsHaveLengthOne();
    void materialsAndTexturesAreEmbedded();
    void whatHasATextureHasItsCoordinates();
    void namesAreUtf8();
    void texturesThatCannotBeReadAreCounted();
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

void TestGlbExport::cornersOfUnlikeAttributesAreVertices()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.faces = {{0, 1, 2}, {2, 1, 3}};
    mesh.colours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}};
    mesh.textureCoordinates = {{0, 0}, {1, 0.25}, {0, 1}};
    mesh.faceTextureCoordinates = {{0, 1, 2}, {2, 0, Mesh::none}};
    mesh.normals = {{0, 0, 3}, {0, 3, 4}};
    mesh.faceNormals = {{0, 0, 0}, {0, 0, 1}};
    const Glb glb(glbOf(sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh)))));
    QVERIFY(glb.isSound());
    const QJsonObject attributes = glb.at("meshes", 0)["primitives"].toArray()[0].toObject()["attributes"].toObject();
    // the corner (1, 0, 0) has two texture coordinates
    const auto positions = glb.elements(attributes["POSITION"].toInteger());
    QCOMPARE(positions.size(), std::size_t{5});
    const auto textures = glb.elements(attributes["TEXCOORD_0"].toInteger());
    QCOMPARE(textures[1], (std::vector<double>{1, 0.75}));
    QCOMPARE(glb.elements(attributes["NORMAL"].toInteger()).back(),
             (std::vector<double>{0, double(0.6F), double(-0.8F)}));
    QCOMPARE(glb.elements(attributes["COLOR_0"].toInteger()).back(), (std::vector<double>{1, 0, 0}));
}

void TestGlbExport::normalsHaveLengthOne()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}, {0, 1, 0}};
    mesh.normals = {{0, 0, 5}, {1e200, 1e200, 0}, {0, 1e-200, 0}, {0, 0, 0}};
    mesh.faceNormals = {{0, 1, 2}, {3, 3, 3}};
    Scene scene = sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh)));
    for (const glm::dmat3 &linear :
         {glm::dmat3(1, 0, 0, 1, 1, 0, 0, 0, 1), glm::dmat3(1, 0, 0, 1, 0, 0, 0, 0, 1), glm::dmat3(0.0)}) {
        scene.items[0].worldFromModel.linear = linear;
        const Glb glb(glbOf(scene));
        QVERIFY(glb.isSound());
        const QJsonObject primitive = glb.at("meshes", 0)["primitives"].toArray()[0].toObject();
        const auto normals = glb.elements(primitive["attributes"].toObject()["NORMAL"].toInteger());
        QCOMPARE(normals.size(), std::size_t{5});
        for (const std::vector<double> &n : normals) {
            QVERIFY(std::abs(std::hypot(n[0], n[1], n[2]) - 1) < 1e-6);
        }
    }
}

/// A material whose texture has none to go by is an error in glTF.
void TestGlbExport::whatHasATextureHasItsCoordinates()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}, {0, 2, 1}};
    mesh.materials.resize(2);
    mesh.materials[0].name = "plain";
    mesh.materials[1].name = "bark";
    mesh.materials[1].diffuseTexture = "bark.png";
    mesh.parts = {{0, 0, Mesh::none, 0}, {1, 1, Mesh::none, 0}};
    const Glb glb(glbOf(sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh)))));
    QVERIFY(glb.isSound());
    const QJsonArray primitives = glb.at("meshes", 0)["primitives"].toArray();
    QCOMPARE(primitives.size(), 2);
    for (const QJsonValue &value : primitives) {
        const QJsonObject primitive = value.toObject();
        const bool isBark = glb.at("materials", primitive["material"].toInteger())["name"].toString() == u"bark";
        QCOMPARE(primitive["attributes"].toObject().contains("TEXCOORD_0"), isBark);
    }
}

void TestGlbExport::namesAreUtf8()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    mesh.materials.resize(1);
    mesh.materials[0].name = "\xE4pfel \\ \"Äpfel\" \xF0\x9F\x8D\x8E\xC3";
    mesh.parts = {{0, 0, Mesh::none, 0}};
    const Glb glb(glbOf(sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh)))));
    QVERIFY(glb.isSound());
    QCOMPARE(glb.at("materials", 0)["name"].toString(), QStringLiteral(u"\uFFFDpfel \\ \"Äpfel\" \U0001F34E\uFFFD"));
}

void TestGlbExport::materialsAndTexturesAreEmbedded()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}};
    mesh.materials.resize(3);
    mesh.materials[2].name = "of no face";
    mesh.materials[0].name = "bark \"old\"";
    mesh.materials[0].diffuse = {0.5F, 0.25F, 2.0F};
    mesh.materials[0].opacity = 0.5F;
    mesh.materials[0].shininess = 6;
    mesh.materials[0].diffuseTexture = "bark.png";
    mesh.materials[1].name = "leaf";
    mesh.materials[1].diffuseTexture = "leaf.jpg";
    mesh.parts = {{0, 0, Mesh::none, 0}, {1, 1, Mesh::none, 0}, {2, 2, Mesh::none, 0}, {2, 0, Mesh::none, 0}};
    const std::string png = "\x89PNG\r\n\x1A\n and so on";
    const TableFiles files({{"bark.png", png}, {"leaf.jpg", "\xFF\xD8\xFF!"}});
    StringSink sink;
    const Scene scene = sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh)));
    QVERIFY(exportScene(scene, {.format = ExportFormat::Glb}, sink, {.files = &files}));
    const Glb glb(sink.text);
    QVERIFY(glb.isSound());
    const QJsonObject bark = glb.at("materials", 0);
    QCOMPARE(bark["name"].toString(), QStringLiteral("bark \"old\""));
    const QJsonObject look = bark["pbrMetallicRoughness"].toObject();
    QCOMPARE(look["baseColorFactor"].toArray(), (QJsonArray{0.5, 0.25, 1, 0.5}));
    QCOMPARE(look["metallicFactor"].toDouble(), 0.0);
    QCOMPARE(look["roughnessFactor"].toDouble(), 0.5);
    QCOMPARE(bark["alphaMode"].toString(), QStringLiteral("BLEND"));
    const QJsonObject texture = glb.at("textures", look["baseColorTexture"].toObject()["index"].toInteger());
    const QJsonObject image = glb.at("images", texture["source"].toInteger());
    QCOMPARE(image["mimeType"].toString(), QStringLiteral("image/png"));
    QCOMPARE(glb.bytesOfView(image["bufferView"].toInteger()), png);
    QCOMPARE(glb.at("images", 1)["mimeType"].toString(), QStringLiteral("image/jpeg"));
    // the parts of a material are one primitive
    const QJsonArray primitives = glb.at("meshes", 0)["primitives"].toArray();
    QCOMPARE(primitives.size(), 2);
    QCOMPARE(glb.elements(primitives[0].toObject()["indices"].toInteger()).size(), std::size_t{6});
    QCOMPARE(primitives[0].toObject()["material"].toInt(), 0);
    QCOMPARE(primitives[1].toObject()["material"].toInt(), 1);
}

void TestGlbExport::texturesThatCannotBeReadAreCounted()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    mesh.materials.resize(2);
    mesh.materials[0].name = "a";
    mesh.materials[0].diffuseTexture = "gone.png";
    mesh.materials[1].name = "b";
    mesh.materials[1].diffuseTexture = "picture.tga";
    mesh.parts = {{0, 0, Mesh::none, 0}};
    const TableFiles files({{"picture.tga", "no picture that glTF knows"}});
    StringSink sink;
    const Scene scene = sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh)));
    const auto report = exportScene(scene, {.format = ExportFormat::Glb}, sink, {.files = &files});
    QVERIFY(report);
    QCOMPARE(report->missingImages, 2u);
    QVERIFY(Glb(sink.text).isSound());
    QVERIFY(!Glb(sink.text).json.contains("images"));
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
