// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <memory>

#include <QTest>

#include "tests/core/export/glb.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// Normals, colours, materials and textures in a GLB.
class TestGlbLooks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cornersOfUnlikeAttributesAreVertices();
    void normalsHaveLengthOne();
    void materialsAndTexturesAreEmbedded();
    void whatHasATextureHasItsCoordinates();
    void namesAreUtf8();
    void texturesThatCannotBeReadAreCounted();
};

void TestGlbLooks::cornersOfUnlikeAttributesAreVertices()
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

void TestGlbLooks::normalsHaveLengthOne()
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
void TestGlbLooks::whatHasATextureHasItsCoordinates()
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

void TestGlbLooks::namesAreUtf8()
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

void TestGlbLooks::materialsAndTexturesAreEmbedded()
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

void TestGlbLooks::texturesThatCannotBeReadAreCounted()
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

}

ROMANESCO_TEST(romanesco::test::TestGlbLooks)
#include "testglblooks.moc"
