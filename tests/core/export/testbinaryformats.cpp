// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <cstring>

#include <QTest>

#include "core/formats/plywriter.h"
#include "core/formats/stlwriter.h"
#include "tests/core/export/exported.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// So many copies of a mesh, which nobody should ask for.
class TooMany final : public CopySource
{
public:
    TooMany(const Mesh &mesh, std::uint64_t count)
        : m_item{&mesh, count}
    {
    }
    [[nodiscard]] std::span<const Item> items() const override { return {&m_item, 1}; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t, const Visitor &) const override
    {
        return std::unexpected("visited");
    }

private:
    Item m_item;
};

Mesh slantedTriangle(double size = 1.0)
{
    Mesh mesh;
    mesh.vertices = {{size, 0, 0}, {0, size, 0}, {0, 0, size}};
    mesh.faces = {{0, 1, 2}};
    return mesh;
}

float floatAt(const std::string &bytes, std::size_t at)
{
    float value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
}

}

class TestBinaryFormats : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stlFacesHaveTheirNormals();
    void stlFacesWithoutAreaHaveNone();
    void stlHeadersAreNotTakenForText();
    void stlCoordinatesBeyondFloatsAreRefused();
    void plyCoordinatesAreExact();
    void plyVerticesHaveColoursWhereAMeshHas();
    void moreThanAFileHoldsIsRefusedBeforeItIsBegun();
};

void TestBinaryFormats::stlFacesHaveTheirNormals()
{
    for (const double size : {1.0, 1e-200, 1e30}) {
        StringSink sink;
        const Mesh mesh = slantedTriangle(size);
        QVERIFY(writeStl(PlainMesh(mesh), "one", sink));
        QCOMPARE(sink.text.size(), std::size_t{134});
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(std::abs(floatAt(sink.text, 84 + 4 * i) - 1 / std::sqrt(3.0)) < 1e-6);
        }
    }
}

void TestBinaryFormats::stlFacesWithoutAreaHaveNone()
{
    Mesh mesh = slantedTriangle();
    mesh.faces = {{0, 0, 1}};
    StringSink sink;
    QVERIFY(writeStl(PlainMesh(mesh), "one", sink));
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(floatAt(sink.text, 84 + 4 * i), 0.0F);
    }
}

void TestBinaryFormats::stlHeadersAreNotTakenForText()
{
    const Mesh mesh = slantedTriangle();
    StringSink sink;
    QVERIFY(
        writeStl(PlainMesh(mesh), "solid as a rock, and of a name that is much longer than the eighty bytes", sink));
    QVERIFY(!sink.text.starts_with("solid"));
    QCOMPARE(sink.text.size(), std::size_t{134});
    QCOMPARE(importedTriangles(sink.text, "stl").size(), std::size_t{1});
}

void TestBinaryFormats::stlCoordinatesBeyondFloatsAreRefused()
{
    const Mesh mesh = slantedTriangle(1e39);
    StringSink sink;
    const auto written = writeStl(PlainMesh(mesh), "one", sink);
    QVERIFY(!written);
    QVERIFY(written.error().contains("3.4e38"));
}

void TestBinaryFormats::plyCoordinatesAreExact()
{
    const Mesh mesh = slantedTriangle(1.0 / 3.0);
    StringSink sink;
    QVERIFY(writePly(PlainMesh(mesh), "one", sink));
    QVERIFY(sink.text.starts_with("ply\nformat binary_little_endian 1.0\ncomment one\nelement vertex 3\n"));
    double x = 0;
    std::memcpy(&x, sink.text.data() + sink.text.find("end_header\n") + 11, sizeof(x));
    QCOMPARE(x, 1.0 / 3.0);
    QCOMPARE(sink.text.size(), sink.text.find("end_header\n") + 11 + 3 * plyBytesOfVertex(false) + plyBytesOfFace);
}

void TestBinaryFormats::plyVerticesHaveColoursWhereAMeshHas()
{
    Mesh coloured = slantedTriangle();
    coloured.colours = {{1, 0, 0}, {0, 0.5F, 0}, {0, 0, 7}};
    Scene scene;
    for (const Mesh &mesh : {slantedTriangle(), coloured}) {
        scene.items.push_back({.model = modelOfMesh(std::make_shared<const Mesh>(mesh))});
    }
    const std::string bytes = exported(scene, {.format = ExportFormat::Ply});
    Assimp::Importer importer;
    const aiScene *read = imported(importer, bytes, "ply");
    QVERIFY(read);
    const aiMesh &mesh = *read->mMeshes[0];
    QCOMPARE(mesh.mNumFaces, 2u);
    QVERIFY(mesh.HasVertexColors(0));
    const auto colourOf = [&](unsigned face, unsigned corner) {
        const aiColor4D &colour = mesh.mColors[0][mesh.mFaces[face].mIndices[corner]];
        return std::vector<long>{std::lround(255 * colour.r), std::lround(255 * colour.g), std::lround(255 * colour.b)};
    };
    QCOMPARE(colourOf(0, 1), (std::vector<long>{255, 255, 255}));
    QCOMPARE(colourOf(1, 1), (std::vector<long>{0, 128, 0}));
    QCOMPARE(colourOf(1, 2), (std::vector<long>{0, 0, 255}));
}

void TestBinaryFormats::moreThanAFileHoldsIsRefusedBeforeItIsBegun()
{
    const Mesh mesh = slantedTriangle();
    for (const std::uint64_t count : {std::uint64_t{1} << 32, ~std::uint64_t{0}}) {
        const TooMany copies(mesh, count);
        StringSink sink;
        QCOMPARE(writeStl(copies, "x", sink).error(), std::string("an STL file holds at most 4294967295 faces"));
        QCOMPARE(writePly(copies, "x", sink).error(), std::string("a PLY file holds at most 4294967296 vertices"));
        QVERIFY(sink.text.empty());
    }
    StringSink sink;
    QCOMPARE(writeStl(TooMany(mesh, 0xFFFF'FFFF), "x", sink).error(), std::string("visited"));
    QCOMPARE(writePly(TooMany(mesh, 0x5555'5555), "x", sink).error(), std::string("visited"));
}

}

ROMANESCO_TEST(romanesco::test::TestBinaryFormats)
#include "testbinaryformats.moc"
