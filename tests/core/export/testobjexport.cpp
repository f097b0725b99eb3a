// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/material.h>

#include "core/formats/objwriter.h"
#include "tests/core/export/exported.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Two triangles of unlike looks in two groups, with all that corners can have; the third has a corner without anything.
Mesh decoratedMesh()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
    mesh.textureCoordinates = {{0, 0}, {0.25, 0}, {0, 0.75}};
    mesh.normals = {{0, 0, -1}, {-1, 0, 0}};
    mesh.faceTextureCoordinates = {{0, 1, 2}, {2, 1, 0}, {Mesh::none, Mesh::none, Mesh::none}};
    mesh.faceNormals = {{0, 0, 0}, {1, 1, 1}, {Mesh::none, Mesh::none, Mesh::none}};
    Material red;
    red.name = "red";
    red.diffuse = {1, 0.25F, 0.125F};
    red.specular = {0.5F, 0.5F, 0.25F};
    red.emission = {0, 0.5F, 0};
    red.shininess = 30;
    red.opacity = 0.5F;
    red.diffuseTexture = "/pictures/bark.png";
    Material blue;
    blue.name = "blue";
    blue.diffuse = {0, 0, 1};
    mesh.materials = {red, blue};
    mesh.groups = {"bottom", "side"};
    mesh.parts = {{0, 0, 0, 0}, {1, 1, 1, 2}};
    return mesh;
}

/// Copies of a mesh by a list of maps.
class ListedCopies final : public CopySource
{
public:
    ListedCopies(const Mesh &mesh, std::vector<MeshCopy> copies)
        : m_item{&mesh, copies.size()}
        , m_copies(std::move(copies))
    {
    }
    [[nodiscard]] std::span<const Item> items() const override { return {&m_item, 1}; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t, const Visitor &visitor) const override
    {
        for (const MeshCopy &copy : m_copies) {
            if (!visitor(copy)) {
                break;
            }
        }
        return {};
    }

private:
    Item m_item;
    std::vector<MeshCopy> m_copies;
};

std::string objOf(const CopySource &copies, const ObjOptions &options = {})
{
    StringSink sink;
    const auto written = writeObj(copies, options, sink);
    return written ? sink.text : "error: " + written.error();
}

}

class TestObjExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meshesAreWrittenWithAllTheyHave();
    void copiesShareTextureCoordinatesAndHaveNormalsOfTheirOwn();
    void normalsGoAlongWithUnequalScales();
    void cornersMayHaveANormalAlone();
    void meshesNumberTheirOwnTextureCoordinates();
    void whatHoldsAlreadyIsNotSaidAgain();
    void mirroredCopiesKeepEachCornersAttributes();
    void coloursStandBesideVertices();
    void looksAreAsAssimpReadsThem();
    void aMeshComesBackAsItWas();
    void materialsOfSeveralMeshesAreBroughtTogether();
    void partsWithoutMaterialDoNotTakeThatOfOthers();
    void texturesAreNamedFromTheFolderOfTheFile();
    void digitsAndCommentAreAsWanted();
    void aSinkThatFailsEndsIt();
};

void TestObjExport::meshesAreWrittenWithAllTheyHave()
{
    const Mesh mesh = decoratedMesh();
    QCOMPARE(QString::fromStdString(objOf(PlainMesh(mesh), {.comment = "a mesh", .materialLibrary = "looks.mtl"})),
             QStringLiteral("# a mesh\nmtllib looks.mtl\nvt 0 0\nvt 0.25 0\nvt 0 0.75\n"
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 -1\nvn -1 0 0\n"
                            "usemtl red\ng bottom\nf 1/1/1 2/2/1 3/3/1\n"
                            "usemtl blue\ng side\ns 2\nf 1/3/2 3/2/2 4/1/2\nf 1 4 2\n"));
    QVERIFY(linesOf(objOf(PlainMesh(mesh)), "usemtl").empty());
}

void TestObjExport::copiesShareTextureCoordinatesAndHaveNormalsOfTheirOwn()
{
    const Mesh mesh = decoratedMesh();
    const AffineMap map = mapFromParts({0, 0, 0}, {0, 0, 0}, {2, 4, 8});
    const std::string text = objOf(ListedCopies(mesh, {{map}, {map}}));
    QCOMPARE(linesOf(text, "vt").size(), std::size_t{3});
    QCOMPARE(linesOf(text, "vn").size(), std::size_t{4});
    QCOMPARE(linesOf(text, "f").at(3), (std::vector<std::string>{"5/1/3", "6/2/3", "7/3/3"}));
}

/// The plane x + y = 1 becomes x/2 + y/4 = 1.
void TestObjExport::normalsGoAlongWithUnequalScales()
{
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 1, 1}};
    mesh.faces = {{0, 1, 2}};
    mesh.normals = {{1, 1, 0}};
    mesh.faceNormals = {{0, 0, 0}};
    const AffineMap map = mapFromParts({7, 8, 9}, {0, 0, 0}, {2, 4, 8});
    const std::vector<std::string> normal = linesOf(objOf(ListedCopies(mesh, {{map}})), "vn").at(0);
    QVERIFY(std::abs(std::strtod(normal.at(0).c_str(), nullptr) - 2 / std::sqrt(5.0)) < 1e-15);
    QVERIFY(std::abs(std::strtod(normal.at(1).c_str(), nullptr) - 1 / std::sqrt(5.0)) < 1e-15);
    // as it is where nothing is turned
    QCOMPARE(linesOf(objOf(PlainMesh(mesh)), "vn").at(0), (std::vector<std::string>{"1", "1", "0"}));
}

void TestObjExport::cornersMayHaveANormalAlone()
{
    Mesh mesh = decoratedMesh();
    mesh.faceTextureCoordinates.clear();
    QCOMPARE(linesOf(objOf(PlainMesh(mesh)), "f").at(1), (std::vector<std::string>{"1//2", "3//2", "4//2"}));
    mesh.faceNormals.clear();
    QCOMPARE(linesOf(objOf(PlainMesh(mesh)), "f").at(1), (std::vector<std::string>{"1", "3", "4"}));
    mesh = decoratedMesh();
    mesh.faceNormals.clear();
    QCOMPARE(linesOf(objOf(PlainMesh(mesh)), "f").at(1), (std::vector<std::string>{"1/3", "3/2", "4/1"}));
}

void TestObjExport::meshesNumberTheirOwnTextureCoordinates()
{
    const auto model = modelOfMesh(std::make_shared<const Mesh>(decoratedMesh()));
    const auto other = modelOfMesh(std::make_shared<const Mesh>(decoratedMesh()));
    Scene scene;
    for (const auto &each : {model, other, model}) {
        scene.items.push_back({.model = each});
    }
    const std::string text = exported(scene);
    QCOMPARE(linesOf(text, "vt").size(), std::size_t{6});
    QCOMPARE(linesOf(text, "f").at(3), (std::vector<std::string>{"5/4/3", "6/5/3", "7/6/3"}));
    QCOMPARE(linesOf(text, "f").at(6), (std::vector<std::string>{"9/1/5", "10/2/5", "11/3/5"}));
}

void TestObjExport::whatHoldsAlreadyIsNotSaidAgain()
{
    Mesh mesh = decoratedMesh();
    mesh.parts = {{0, 1, 1, 3}};
    const std::string text = objOf(ListedCopies(mesh, {{}, {}, {}}), {.materialLibrary = "m"});
    for (const char *keyword : {"usemtl", "g", "s"}) {
        QCOMPARE(linesOf(text, keyword).size(), std::size_t{1});
    }
}

void TestObjExport::mirroredCopiesKeepEachCornersAttributes()
{
    const Mesh mesh = decoratedMesh();
    const AffineMap mirror = mapFromParts({0, 0, 0}, {0, 0, 0}, {-1, 1, 1});
    const std::string text = objOf(ListedCopies(mesh, {{mirror, true}}));
    QCOMPARE(linesOf(text, "f").at(1), (std::vector<std::string>{"1/3/2", "4/1/2", "3/2/2"}));
    QCOMPARE(linesOf(text, "vn").at(1), (std::vector<std::string>{"1", "0", "0"}));
    QCOMPARE(linesOf(text, "vn").at(0), (std::vector<std::string>{"0", "0", "-1"}));
}

void TestObjExport::coloursStandBesideVertices()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    mesh.colours = {{1, 0.1F, 0}, {0, 1, 0}, {0, 0, 1}};
    QCOMPARE(linesOf(objOf(PlainMesh(mesh)), "v").at(0), (std::vector<std::string>{"0", "0", "0", "1", "0.1", "0"}));
}

void TestObjExport::looksAreAsAssimpReadsThem()
{
    QTemporaryDir folder;
    QVERIFY(folder.isValid());
    const std::filesystem::path path = folder.filePath("out.obj").toStdString();
    Scene scene = sceneOf(modelOfMesh(std::make_shared<const Mesh>(decoratedMesh())));
    QVERIFY(exportToFile(scene, {}, path));
    Assimp::Importer importer;
    const aiScene *read = importer.ReadFile(path.string(), 0);
    QVERIFY(read);
    int seen = 0;
    for (unsigned i = 0; i < read->mNumMeshes; ++i) {
        const aiMesh &mesh = *read->mMeshes[i];
        const aiMaterial &material = *read->mMaterials[mesh.mMaterialIndex];
        if (material.GetName() == aiString("red")) {
            ++seen;
            aiColor3D colour;
            float number = 0;
            aiString texture;
            QCOMPARE(mesh.mNumFaces, 1u);
            QCOMPARE(material.Get(AI_MATKEY_COLOR_DIFFUSE, colour), aiReturn_SUCCESS);
            QCOMPARE(colour, aiColor3D(1, 0.25F, 0.125F));
            QCOMPARE(material.Get(AI_MATKEY_COLOR_SPECULAR, colour), aiReturn_SUCCESS);
            QCOMPARE(colour, aiColor3D(0.5F, 0.5F, 0.25F));
            QCOMPARE(material.Get(AI_MATKEY_COLOR_EMISSIVE, colour), aiReturn_SUCCESS);
            QCOMPARE(colour, aiColor3D(0, 0.5F, 0));
            QCOMPARE(material.Get(AI_MATKEY_OPACITY, number), aiReturn_SUCCESS);
            QCOMPARE(number, 0.5F);
            QCOMPARE(material.Get(AI_MATKEY_SHININESS, number), aiReturn_SUCCESS);
            QCOMPARE(number, 30.0F);
            QCOMPARE(material.GetTexture(aiTextureType_DIFFUSE, 0, &texture), aiReturn_SUCCESS);
            QVERIFY(QString::fromUtf8(texture.C_Str()).endsWith("/pictures/bark.png"));
            QCOMPARE(mesh.mTextureCoords[0][1], aiVector3D(0.25F, 0, 0));
            QCOMPARE(mesh.mTextureCoords[0][2], aiVector3D(0, 0.75F, 0));
            QCOMPARE(mesh.mNormals[0], aiVector3D(0, 0, -1));
        } else if (material.GetName() == aiString("blue")) {
            ++seen;
            QCOMPARE(mesh.mNumFaces, 2u);
        }
    }
    QCOMPARE(seen, 2);
}

void TestObjExport::aMeshComesBackAsItWas()
{
    QTemporaryDir folder;
    QVERIFY(folder.isValid());
    const std::filesystem::path path = folder.filePath("out.obj").toStdString();
    QFile texture(folder.filePath("bark.png"));
    QVERIFY(texture.open(QIODevice::WriteOnly));
    Mesh mesh = decoratedMesh();
    mesh.materials[0].name = "a name with blanks";
    mesh.materials[0].diffuseTexture = folder.filePath("bark.png").toStdString();
    QVERIFY(exportToFile(sceneOf(modelOfMesh(std::make_shared<const Mesh>(mesh))), {}, path));
    const DiskFiles disk;
    const SceneResult result = SceneLoader(disk).load(path, disk.read(path).value());
    QVERIFY(result.diagnostics.empty());
    const Mesh &back = *result.scene->items.front().model->mesh;
    QCOMPARE(back.vertices, mesh.vertices);
    QCOMPARE(back.faces, mesh.faces);
    QCOMPARE(back.textureCoordinates, mesh.textureCoordinates);
    QCOMPARE(back.faceTextureCoordinates, mesh.faceTextureCoordinates);
    QCOMPARE(back.normals, mesh.normals);
    QCOMPARE(back.faceNormals, mesh.faceNormals);
    QCOMPARE(back.materials, mesh.materials);
    QCOMPARE(back.groups, mesh.groups);
    QCOMPARE(back.parts.size(), mesh.parts.size());
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        QCOMPARE(back.parts[i].firstFace, mesh.parts[i].firstFace);
        QCOMPARE(back.parts[i].material, mesh.parts[i].material);
        QCOMPARE(back.parts[i].group, mesh.parts[i].group);
        QCOMPARE(back.parts[i].smoothing, mesh.parts[i].smoothing);
    }
}

void TestObjExport::materialsOfSeveralMeshesAreBroughtTogether()
{
    const Mesh first = decoratedMesh();
    const Mesh same = decoratedMesh();
    Mesh other = decoratedMesh();
    other.materials[0].diffuse = {0, 1, 0};
    const std::vector<CopySource::Item> items{{&first, 1}, {&same, 1}, {&other, 1}, {&first, 1}};
    const MaterialTable materials(items);
    std::vector<std::string> names;
    for (const MaterialTable::Entry &entry : materials.entries()) {
        names.push_back(entry.name);
    }
    QCOMPARE(names, (std::vector<std::string>{"red", "blue", "red_2"}));
    QCOMPARE(materials.entryOf(same, 1), 1u);
    QCOMPARE(materials.entryOf(other, 0), 2u);
    QCOMPARE(materials.entryOf(other, 1), 1u);
}

void TestObjExport::partsWithoutMaterialDoNotTakeThatOfOthers()
{
    Mesh mesh = decoratedMesh();
    mesh.parts[1].material = Mesh::none;
    const std::string text = objOf(PlainMesh(mesh), {.materialLibrary = "m.mtl"});
    QCOMPARE(linesOf(text, "usemtl").size(), std::size_t{2});
    const std::string plain = linesOf(text, "usemtl").at(1).at(0);
    const MaterialTable materials(PlainMesh(mesh).items());
    QVERIFY(mtlText(materials, ".").contains("newmtl " + plain + "\n"));
}

void TestObjExport::texturesAreNamedFromTheFolderOfTheFile()
{
    const Mesh mesh = decoratedMesh();
    const MaterialTable materials(PlainMesh(mesh).items());
    QVERIFY(mtlText(materials, "/pictures/out").contains("map_Kd ../bark.png\n"));
    QVERIFY(mtlText(materials, "/pictures").contains("map_Kd bark.png\n"));
}

void TestObjExport::digitsAndCommentAreAsWanted()
{
    Mesh mesh;
    mesh.vertices = {{1.0 / 3.0, 0, 0}, {1, -2.0 / 3.0, 0}, {0, 1e-9 / 7.0, 123456}};
    mesh.faces = {{0, 1, 2}};
    QCOMPARE(QString::fromStdString(objOf(PlainMesh(mesh), {.comment = "x", .digits = 3})),
             QStringLiteral("# x\nv 0.333 0 0\nv 1 -0.667 0\nv 0 1.43e-10 1.23e+05\nf 1 2 3\n"));
}

void TestObjExport::aSinkThatFailsEndsIt()
{
    class Failing final : public ByteSink
    {
    public:
        [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
        {
            m_bytes += bytes.size();
            ++calls;
            return m_bytes > 1'000'000 ? std::expected<void, std::string>(std::unexpect, "disk full")
                                       : std::expected<void, std::string>();
        }
        int calls = 0;

    private:
        std::size_t m_bytes = 0;
    };
    for (const char *ending : {".obj", ".ply", ".stl"}) {
        Failing sink;
        const auto report = exportScene(*menger(4), {.format = exportFormat(std::string("a") + ending).value()}, sink);
        QVERIFY(!report);
        QCOMPARE(report.error(), std::string("disk full"));
        QVERIFY(sink.calls < 10);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestObjExport)
#include "testobjexport.moc"
