// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/objreader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <QTest>

#include "core/text/linemap.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

QString faces(const Mesh &mesh)
{
    QStringList all;
    for (const auto &[a, b, c] : mesh.faces) {
        all.push_back(QStringLiteral("%1 %2 %3").arg(a).arg(b).arg(c));
    }
    return all.join(QStringLiteral(", "));
}

/// "0-2 material group 1; …", "-" for none.
QString parts(const Mesh &mesh)
{
    QStringList all;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const auto &[first, material, group, smoothing] = mesh.parts[i];
        const std::size_t end = i + 1 < mesh.parts.size() ? mesh.parts[i + 1].firstFace : mesh.faces.size();
        const std::string words = std::to_string(first) + '-' + std::to_string(end) + ' '
            + (material == Mesh::none ? "-" : mesh.materials.at(material).name) + ' '
            + (group == Mesh::none ? "-" : mesh.groups.at(group)) + ' ' + std::to_string(smoothing);
        all.push_back(QString::fromStdString(words));
    }
    return all.join(QStringLiteral("; "));
}

/// "5:1 …" a line each.
QString remarks(const Diagnostics &diagnostics, std::string_view text)
{
    QStringList all;
    for (const Diagnostic &diagnostic : diagnostics) {
        const TextPosition at = LineMap(text).position(diagnostic.range.begin);
        all.push_back(QString::fromStdString(std::to_string(at.line) + ':' + std::to_string(at.column) + ' '
                                             + diagnostic.message()));
    }
    return all.join(QLatin1Char('\n'));
}

constexpr std::uint32_t none = Mesh::none;

const QByteArray square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}

class TestObjReader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void facesInEveryForm_data();
    void facesInEveryForm();
    void concavePolygonsAreCutIntoEars_data();
    void concavePolygonsAreCutIntoEars();
    void verticesPassUnchanged();
    void cornersHaveWhatTheyName();
    void whatNoCornerNamesIsDropped();
    void coloursStandBesideVertices_data();
    void coloursStandBesideVertices();
    void statementsPartTheFaces_data();
    void statementsPartTheFaces();
    void placesLeadToTheMaterials();
    void librariesAreNamed_data();
    void librariesAreNamed();
    void whatIsPassedOverIsCounted_data();
    void whatIsPassedOverIsCounted();
    void errorsNameTheirPlace_data();
    void errorsNameTheirPlace();
    void whatCameBeforeAnErrorIsKept();
    void warningsStandBeforeTheError();
    void largeFansAreRead();
    void readingCanBeStopped();
};

void TestObjReader::facesInEveryForm_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const QByteArray &rest, const char *expected) {
        QTest::newRow(name) << square + rest << QString::fromLatin1(expected);
    };
    row("v", "f 1 2 3", "0 1 2");
    row("v/vt", "vt 0\nf 1/1 2/1 3/1", "0 1 2");
    row("v//vn", "vn 0 0 1\nf 1//1 2//1 3//1", "0 1 2");
    row("v/vt/vn", "vt 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1", "0 1 2");
    row("mixed forms", "vt 0\nvn 0 0 1\nf 1 2/1 3//1", "0 1 2");
    row("indices left out", "f 1/ 2// 3/", "0 1 2");
    row("from the end", "f -4 -3 -1", "0 1 3");
    row("from the end of what is there so far", "f -1 -2 -3\nv 9 9 9\nf -1 -2 -3", "3 2 1, 4 3 2");
    row("fan of four", "f 1 2 3 4", "0 1 2, 0 2 3");
    row("fan of five", "f 1 2 3 4 1", "0 1 2, 0 2 3, 0 3 0");
    row("leading zeros", "f 01 002 0000000000000000000000000000000000000000003", "0 1 2");
    row("blanks", "  f\t 1 \t2  3 \t ", "0 1 2");
    row("comment behind", "f 1 2 3 # 4", "0 1 2");
    row("continued", "f 1 2 \\\n3", "0 1 2");
    row("continued tightly", "f 1 2\\\n 3\\\n4", "0 1 2, 0 2 3");
    row("continued with CR LF", "f 1 2 \\\r\n3\r\n", "0 1 2");
    row("continued vertex", "v 5 \\\n6 \\\n7\nf 1 2 5", "0 1 4");
    row("CR alone", "f 1 2 3\rf 1 3 4\r", "0 1 2, 0 2 3");
    row("no final end", "f 1 2 3\nf 2 3 4", "0 1 2, 1 2 3");
    row("no faces", "", "");
    QTest::newRow("BOM") << "\xEF\xBB\xBF" + square + "f 1 2 4" << "0 1 3";
    QTest::newRow("empty") << QByteArray() << "";
}

void TestObjReader::facesInEveryForm()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const ObjResult result = readObj(bytes);
    QVERIFY(result.diagnostics.empty());
    QTEST(faces(result.mesh), "expected");
}

void TestObjReader::concavePolygonsAreCutIntoEars_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    // An arrow: 2 is where it is notched. The diagonal must end there.
    const QByteArray arrow = "v 0 2 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\n";
    QTest::newRow("from its tip") << arrow + "f 1 2 3 4" << "0 1 2, 0 2 3";
    QTest::newRow("from a barb") << arrow + "f 2 3 4 1" << "2 3 0, 2 0 1";
    QTest::newRow("from the notch") << arrow + "f 3 4 1 2" << "2 3 0, 2 0 1";
    QTest::newRow("the other way round") << arrow + "f 2 1 4 3" << "2 1 0, 2 0 3";
    QTest::newRow("too small for products")
        << QByteArray("v 0 2e-200 0\nv 1e-200 0 0\nv 0 1e-200 0\nv -1e-200 0 0\nf 2 3 4 1") << "2 3 0, 2 0 1";
    QTest::newRow("too large for products")
        << QByteArray("v 0 2e200 0\nv 1e200 0 0\nv 0 1e200 0\nv -1e200 0 0\nf 2 3 4 1") << "2 3 0, 2 0 1";
}

void TestObjReader::concavePolygonsAreCutIntoEars()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const ObjResult result = readObj(bytes);
    QVERIFY(result.diagnostics.empty());
    // whatever the order of the triangles and where each starts
    const auto sorted = [](const QString &triangles) {
        QStringList all;
        for (const QString &triangle : triangles.split(QStringLiteral(", "))) {
            QStringList corners = triangle.split(QLatin1Char(' '));
            std::ranges::rotate(corners, std::ranges::min_element(corners));
            all.push_back(corners.join(QLatin1Char(' ')));
        }
        all.sort();
        return all;
    };
    QFETCH(QString, expected);
    QCOMPARE(sorted(faces(result.mesh)), sorted(expected));
}

void TestObjReader::verticesPassUnchanged()
{
    const ObjResult result = readObj("v 1 2 3\nv -1.5e-3 +.25 5.\nv\t1e300\t-1e-300 -0\nv 4 5 6 0\nv 4 5 6 7 8\n");
    QVERIFY(result.diagnostics.empty());
    const std::vector<glm::dvec3> expected{{1, 2, 3}, {-1.5e-3, 0.25, 5}, {1e300, -1e-300, 0}, {4, 5, 6}, {4, 5, 6}};
    QVERIFY(result.mesh.vertices == expected); // a weight divides nothing
    QVERIFY(std::signbit(result.mesh.vertices[2].z));
    QVERIFY(result.mesh.colours.empty());
}

void TestObjReader::cornersHaveWhatTheyName()
{
    const std::string text = square.toStdString()
        + "f 1 2 3\nvt .5\nvt .25 .75\nvt 1 2 3\nf 1/1 2/2 3\nvn 0 0 2\nvn 1 0 0\nf 1/-1/-2 2//2 3/3/1 4\nf 1 3 4\n";
    const ObjResult result = readObj(text);
    QVERIFY(result.diagnostics.empty());
    const Mesh &mesh = result.mesh;
    QVERIFY(mesh.textureCoordinates == (std::vector<glm::dvec2>{{0.5, 0}, {0.25, 0.75}, {1, 2}}));
    QVERIFY(mesh.normals == (std::vector<glm::dvec3>{{0, 0, 2}, {1, 0, 0}}));
    QCOMPARE(faces(mesh), QStringLiteral("0 1 2, 0 1 2, 0 1 2, 0 2 3, 0 2 3"));
    using Faces = std::vector<Mesh::Face>;
    QVERIFY(mesh.faceTextureCoordinates
            == (Faces{{none, none, none}, {0, 1, none}, {2, none, 2}, {2, 2, none}, {none, none, none}}));
    QVERIFY(mesh.faceNormals
            == (Faces{{none, none, none}, {none, none, none}, {0, 1, 0}, {0, 0, none}, {none, none, none}}));
}

void TestObjReader::whatNoCornerNamesIsDropped()
{
    const ObjResult result =
        readObj(square.toStdString() + "vt 1 1\nvn 0 0 1\nusemtl m\ng a\nf 1 2 3\nusemtl n\ng b\n");
    QVERIFY(result.diagnostics.empty());
    QVERIFY(result.mesh.textureCoordinates.empty() && result.mesh.faceTextureCoordinates.empty());
    QVERIFY(result.mesh.normals.empty() && result.mesh.faceNormals.empty());
    QCOMPARE(result.mesh.materials.size(), 1u);
    QCOMPARE(result.mesh.groups.size(), 1u);
    QCOMPARE(result.mesh.vertices.size(), 4u);
}

void TestObjReader::coloursStandBesideVertices_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QList<float>>("expected");
    const auto row = [](const char *name, const char *text, const QList<float> &expected) {
        QTest::newRow(name) << QByteArray(text) << expected;
    };
    row("none", "v 1 2 3\nv 4 5 6 1", {});
    row("all", "v 1 2 3 .25 .5 1\nv 1 2 3 0 1 0", {0.25F, 0.5F, 1, 0, 1, 0});
    row("opacity behind it", "v 1 2 3 .25 .5 1 0.5", {0.25F, 0.5F, 1});
    row("some: the others are white", "v 1 2 3\nv 1 2 3 0 0 0.5\nv 1 2 3", {1, 1, 1, 0, 0, 0.5F, 1, 1, 1});
    row("two numbers are none", "v 1 2 3 .5 .5", {});
    row("held to 0 and 1", "v 1 2 3 255 -1 1.5", {1, 0, 1});
}

void TestObjReader::coloursStandBesideVertices()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    QList<float> colours;
    for (const glm::vec3 &colour : readObj(bytes).mesh.colours) {
        colours << colour.x << colour.y << colour.z;
    }
    QTEST(colours, "expected");
}

void TestObjReader::statementsPartTheFaces_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *rest, const char *expected) {
        QByteArray text = rest;
        text.replace("F", "f 1 2 3"); // short for a face
        QTest::newRow(name) << square + text << QString::fromUtf8(expected);
    };
    row("nothing said", "F", "");
    row("one material", "usemtl m\nF\nF", "0-2 m - 0");
    row("faces before the first", "F\nF\nusemtl m\nF", "0-2 - - 0; 2-3 m - 0");
    row("all kinds", "usemtl m\ng a\ns 3\nF", "0-1 m a 3");
    row("a polygon", "f 1 2 3 4\nusemtl m\nf 1 2 3 4", "0-2 - - 0; 2-4 m - 0");
    row("back to the first", "usemtl m\nF\nusemtl n\nF\nusemtl m\nF", "0-1 m - 0; 1-2 n - 0; 2-3 m - 0");
    row("the same again", "usemtl m\nF\nusemtl m\nF\ng a\ng\nF", "0-3 m - 0");
    row("said twice before a face", "usemtl m\nusemtl n\nF", "0-1 n - 0");
    row("no name is none", "usemtl m\nF\nusemtl\nF", "0-1 m - 0; 1-2 - - 0");
    row("an object", "o thing\nF", "0-1 - thing 0");
    row("the later of object and group", "o thing\ng a\nF\no other\nF", "0-1 - a 0; 1-2 - other 0");
    row("groups of several words", "g left wing\nF", "0-1 - left wing 0");
    row("smoothing", "s 1\nF\ns off\nF\ns 4294967295\nF\ns 0\nF\ns on\nF",
        "0-1 - - 1; 1-2 - - 0; 2-3 - - 4294967295; 3-4 - - 0; 4-5 - - 1");
    row("blanks and comments in names", "usemtl  Material #25 of 30 \t\nF", "0-1 Material #25 of 30 - 0");
    row("a name that goes on", "g left \\\n  wing\\\r\n\nF", "0-1 - left    wing 0");
    row("CR LF", "g a\r\nF\r\n", "0-1 - a 0");
    row("CR", "g a\rF\r", "0-1 - a 0");
}

void TestObjReader::statementsPartTheFaces()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const ObjResult result = readObj(bytes);
    QVERIFY(result.diagnostics.empty());
    QTEST(parts(result.mesh), "expected");
    for (const Material &material : result.mesh.materials) {
        QVERIFY(material == Material{.name = material.name}); // the default's look
    }
}

void TestObjReader::placesLeadToTheMaterials()
{
    const std::string text =
        square.toStdString() + "usemtl n\nusemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\nusemtl m\nf 1 2 3\n";
    const ObjResult result = readObj(text);
    QCOMPARE(result.sources.materialPlaces.size(), result.mesh.materials.size());
    QStringList places;
    for (std::size_t i = 0; i < result.sources.materialPlaces.size(); ++i) {
        const SourceRange place = result.sources.materialPlaces[i];
        places.push_back(QString::number(LineMap(text).position(place.begin).line) + QLatin1Char(' ')
                         + QString::fromStdString(text.substr(place.begin, place.length())));
    }
    QCOMPARE(places, (QStringList{QStringLiteral("6 usemtl m"), QStringLiteral("8 usemtl n")}));
}

void TestObjReader::librariesAreNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QStringList>("expected");
    const auto row = [](const char *name, const char *text, const QStringList &expected) {
        QTest::newRow(name) << QByteArray(text) << expected;
    };
    row("one", "mtllib a.mtl", {QStringLiteral("a.mtl")});
    row("two", "mtllib a.mtl  b.MTL", {QStringLiteral("a.mtl"), QStringLiteral("b.MTL")});
    row("two lines", "mtllib a.mtl\nmtllib b.mtl", {QStringLiteral("a.mtl"), QStringLiteral("b.mtl")});
    row("blanks", "mtllib my own.mtl .mtl other one.mtl\r\n",
        {QStringLiteral("my own.mtl"), QStringLiteral(".mtl"), QStringLiteral("other one.mtl")});
    row("another ending", "mtllib a.txt", {QStringLiteral("a.txt")});
    row("another ending behind", "mtllib a.mtl b c", {QStringLiteral("a.mtl"), QStringLiteral("b c")});
    row("folders", "mtllib ..\\x\\a.mtl ../..", {QStringLiteral("..\\x\\a.mtl"), QStringLiteral("../..")});
    row("comment", "mtllib a.mtl # b.mtl", {QStringLiteral("a.mtl")});
    row("goes on", "mtllib a.mtl \\\nb.mtl", {QStringLiteral("a.mtl"), QStringLiteral("b.mtl")});
    row("none", "mtllib", {});
}

void TestObjReader::librariesAreNamed()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const ObjResult result = readObj(bytes);
    QStringList names;
    for (const ObjResult::Sources::Library &library : result.sources.libraries) {
        names.push_back(QString::fromStdString(library.name));
        QVERIFY(bytes.substr(library.place.begin).starts_with("mtllib"));
    }
    QTEST(names, "expected");
}

void TestObjReader::whatIsPassedOverIsCounted_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const QByteArray &rest, const char *expected) {
        QTest::newRow(name) << square + rest << QString::fromUtf8(expected);
    };
    row("comments, names, blank lines", "# p 1\n\n#\n   \no a\ng\ns off\nmtllib a.mtl", "");
    row("a comment that looks as if it went on", "# a\\\nf 1 2 3", "");
    row("points", "\np 1\n p 2 3", "6:1 points are passed over (in 2 places)");
    row("lines", "l 1 2", "5:1 lines that bound no face are passed over (in 1 place)");
    row("curves", "vp 1\ncstype bezier\ndeg 3\ncurv 0 1 1 2 \\\n 3 4\nparm u 0 1\nend",
        "5:1 curves and surfaces are passed over (in 6 places)");
    row("settings", "lod 3\nbevel off\nshadow_obj a.obj", "5:1 settings for display are passed over (in 3 places)");
    row("commands", "call a.obj\ncsh -rm", "5:1 files to call and commands to run are passed over (in 2 places)");
    row("unknown words", "foo\nF 1 2 3\nv1 2 3\nvv 1 2 3\nusemtlm", "5:1 unknown words are passed over (in 5 places)");
    row("smoothing by a word", "s high\ns", "5:1 unknown words are passed over (in 2 places)");
    row("too small", "v 1e-400 0 -1e-999\nv 0 0 1e-400", "5:3 numbers too small for a double count as 0 (in 3 places)");
    row("colours", "v 1 2 3 0 1 1.01\nv 1 2 3 -0.1 0 0\nv 1 2 3 1 1 1",
        "5:1 colours are held between 0 and 1 (in 2 places)");
    row("several, by place", "foo\np 1\nfoo\np 1\nl 1 2",
        "5:1 unknown words are passed over (in 2 places)\n6:1 points are passed over (in 2 places)\n"
        "9:1 lines that bound no face are passed over (in 1 place)");
}

void TestObjReader::whatIsPassedOverIsCounted()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString() + "\nf 1 2 3";
    const ObjResult result = readObj(bytes);
    QTEST(remarks(result.diagnostics, bytes), "expected");
    QVERIFY(!hasErrors(result.diagnostics));
    QVERIFY(!result.mesh.faces.empty());
}

void TestObjReader::errorsNameTheirPlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const QByteArray &rest, const char *expected) {
        QTest::newRow(name) << square + rest << QString::fromUtf8(expected);
    };
    row("no z", "v 1 2", "5:1 a vertex has three coordinates, found 2");
    row("no coordinates", "\n  v # 1 2 3", "6:3 a vertex has three coordinates, found 0");
    row("NaN", "v 1 nan 3", "5:5 \"nan\" is not a number");
    row("infinity", "v 1 2 inf", "5:7 \"inf\" is not a number");
    row("too large", "v 1 2 1e400", "5:7 1e400 is too large for a number (at most 1.8e308)");
    row("decimal comma", "v 1,5 2 3", "5:3 \"1,5\" is not a number");
    row("two corners", "f 1 2", "5:1 a face has at least three corners, found 2");
    row("none", "f", "5:1 a face has at least three corners, found 0");
    row("zero", "f 1 2 0", "5:7 vertices are counted from 1; there is no vertex 0");
    row("minus zero", "f 1 2 -0/1", "5:7 vertices are counted from 1; there is no vertex 0");
    row("past the end", "f 1 2 5", "5:7 no vertex 5: 4 vertices so far");
    row("declared only later", "f 1 2 5\nv 0 0 0", "5:7 no vertex 5: 4 vertices so far");
    row("before the start", "f 1 2 -5", "5:7 no vertex -5: 4 vertices so far");
    row("2^31", "f 1 2 2147483648", "5:7 no vertex 2147483648: 4 vertices so far");
    row("2^32 + 1", "f 1 2 4294967297/1/1", "5:7 no vertex 4294967297: 4 vertices so far");
    row("2^64 + 1", "f 1 2 18446744073709551617", "5:7 no vertex 18446744073709551617: 4 vertices so far");
    row("-2^63", "f 1 2 -9223372036854775808", "5:7 no vertex -9223372036854775808: 4 vertices so far");
    row("a word", "f 1 2 x", "5:7 \"x\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("a fraction", "f 1 2 3.0", "5:7 \"3.0\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("nothing before the slash", "f 1 2 /3",
        "5:7 \"/3\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("two signs", "f 1 2 --3", "5:7 \"--3\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("plus", "f 1 2 +3", "5:7 \"+3\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("in a continued line", "f 1 \\\n2 \\\n9", "7:1 no vertex 9: 4 vertices so far");
    row("column in code points", "# \u00E9\nf 1 2 \u00E9",
        "6:7 \"\u00E9\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("backslash at the very end", "f 1 2 3 \\",
        "5:9 \"\\\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("backslash at the very end of a word", "f 1 2 3\\",
        "5:7 \"3\\\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("backslash in the middle of a line", "f 1\\ 2 3",
        "5:3 \"1\\\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("no z of a normal", "vn 1 2", "5:1 a normal has three coordinates, found 2");
    row("no texture coordinates", "vt", "5:1 texture coordinates are one number or more, found 0");
    row("texture coordinate that is none", "vt 1 x", "5:6 \"x\" is not a number");
    row("colour that is none", "v 1 2 3 0 x 1", "5:11 \"x\" is not a number");
    row("hexadecimal", "v 0x10 2 3", "5:3 \"0x10\" is not a number");
    row("two points", "v 1.2.3 2 3", "5:3 \"1.2.3\" is not a number");
    row("sign only", "vn 1 - 3", "5:6 \"-\" is not a number");
    row("a sign in the exponent's place", "v 3.1+e2 2 3", "5:3 \"3.1+e2\" is not a number");
    row("texture coordinate past the end", "vt 0\nf 1/1 2/2 3/1",
        "6:7 no texture coordinate 2: 1 texture coordinate so far");
    row("texture coordinate before the start", "vt 0\nf 1/1 2/-2 3/1",
        "6:7 no texture coordinate -2: 1 texture coordinate so far");
    row("texture coordinate 0", "vt 0\nf 1/1 2/0 3/1",
        "6:7 texture coordinates are counted from 1; there is no texture coordinate 0");
    row("normal past the end", "f 1//1 2//1 3//1", "5:3 no normal 1: 0 normals so far");
    row("normal 0", "vn 0 0 1\nf 1//1 2//0 3//1", "6:8 normals are counted from 1; there is no normal 0");
    row("four indices", "vt 0\nvn 0 0 1\nf 1/1/1/1 2 3",
        "7:3 \"1/1/1/1\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("a bad index behind a slash", "vt 0\nf 1/x 2 3",
        "6:3 \"1/x\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("a comment without a blank", "f 1 2 3#4",
        "5:7 \"3#4\" is not a corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    row("NUL", QByteArray("v 1 2 \0", 7), "5:7 \"\uFFFD\" is not a number");
    QTest::newRow("one vertex so far") << QByteArray("v 0 0 0\nf 1 1 2") << "2:7 no vertex 2: 1 vertex so far";
    QTest::newRow("no vertex so far") << QByteArray("f 1 2 3") << "1:3 no vertex 1: 0 vertices so far";
    QTest::newRow("gzip") << QByteArray("\x1F\x8B\x08\0", 4) << "1:1 the file is compressed; unpack it first";
    QTest::newRow("UTF-16") << QByteArray("\xFF\xFEv\0 \0", 6)
                            << "1:1 the file is not UTF-8 text (it looks like UTF-16)";
}

void TestObjReader::errorsNameTheirPlace()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    QTEST(remarks(readObj(bytes).diagnostics, bytes), "expected");
}

void TestObjReader::whatCameBeforeAnErrorIsKept()
{
    const ObjResult result = readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\nv 5 5 5\n");
    QCOMPARE(result.mesh.vertices.size(), 3u);
    QCOMPARE(faces(result.mesh), QStringLiteral("0 1 2"));
}

void TestObjReader::warningsStandBeforeTheError()
{
    const std::string text = "p 1\nv 1 2\nl 1 2\n";
    QCOMPARE(remarks(readObj(text).diagnostics, text),
             QStringLiteral("1:1 points are passed over (in 1 place)\n2:1 a vertex has three coordinates, found 2"));
}

void TestObjReader::largeFansAreRead()
{
    constexpr std::uint32_t corners = 20'000;
    std::string text;
    std::string face = "f";
    for (std::uint32_t i = 0; i < corners; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
        face += ' ' + std::to_string(i + 1);
    }
    const ObjResult result = readObj(text + face);
    QVERIFY(result.diagnostics.empty());
    QCOMPARE(result.mesh.faces.size(), corners - 2u);
    QVERIFY(result.mesh.faces.back() == (std::array<std::uint32_t, 3>{0, corners - 2, corners - 1}));
}

void TestObjReader::readingCanBeStopped()
{
    std::string text = "v 0 0 0\n";
    for (int i = 0; i < 200'000; ++i) {
        text += "f 1 1 1\n";
    }
    QCOMPARE(readObj(text).mesh.faces.size(), 200'000u);
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(readObj(text, stop.get_token()).mesh.faces.size() < 100'000u);
}

}

ROMANESCO_TEST(romanesco::test::TestObjReader)

#include "testobjreader.moc"
