// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/objreader.h"

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

const QByteArray square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}

class TestObjReader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void facesInEveryForm_data();
    void facesInEveryForm();
    void verticesPassUnchanged();
    void errorsNameTheirPlace_data();
    void errorsNameTheirPlace();
    void whatCameBeforeAnErrorIsKept();
    void largeFansAreRead();
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

void TestObjReader::verticesPassUnchanged()
{
    const ObjResult result = readObj("v 1 2 3\nv -1.5e-3 +.25 5.\nv\t1e300\t-1e-300 0\nv 1e-400 0 0\n");
    QVERIFY(result.diagnostics.empty());
    const std::vector<glm::dvec3> expected{{1, 2, 3}, {-1.5e-3, 0.25, 5}, {1e300, -1e-300, 0}, {0, 0, 0}};
    QVERIFY(result.mesh.vertices == expected);
}

void TestObjReader::errorsNameTheirPlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const QByteArray &rest, const char *expected) {
        QTest::newRow(name) << square + rest << QString::fromUtf8(expected);
    };
    row("no z", "v 1 2", "5:1 a vertex has three coordinates, found 2");
    row("no coordinates", "\n  v # 1 2 3", "6:1 a vertex has three coordinates, found 0");
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
    row("a fraction", "f 1 2 3.0", "5:7 \"3.0\" is not a vertex index");
    row("nothing before the slash", "f 1 2 /3", "5:7 \"/3\" is not a vertex index");
    row("two signs", "f 1 2 --3", "5:7 \"--3\" is not a vertex index");
    row("plus", "f 1 2 +3", "5:7 \"+3\" is not a vertex index");
    row("in a continued line", "f 1 \\\n2 \\\n9", "7:1 no vertex 9: 4 vertices so far");
    row("column in code points", "# \u00E9\nf 1 2 \u00E9", "6:7 \"\u00E9\" is not a vertex index");
    row("backslash at the very end", "f 1 2 3 \\", "5:9 \"\\\" is not a vertex index");
    row("backslash at the very end of a word", "f 1 2 3\\", "5:8 \"\\\" is not a vertex index");
    row("backslash in the middle of a line", "f 1\\ 2 3", "5:4 \"\\\" is not a vertex index");
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
    const ObjResult result = readObj(bytes);
    QCOMPARE(result.diagnostics.size(), 1u);
    const Diagnostic &first = result.diagnostics.front();
    const TextPosition at = LineMap(bytes).position(first.range.begin);
    QTEST(QString::fromStdString(std::to_string(at.line) + ':' + std::to_string(at.column) + ' ' + first.message()),
          "expected");
}

void TestObjReader::whatCameBeforeAnErrorIsKept()
{
    const ObjResult result = readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\nv 5 5 5\n");
    QCOMPARE(result.mesh.vertices.size(), 3u);
    QCOMPARE(faces(result.mesh), QStringLiteral("0 1 2"));
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

}

ROMANESCO_TEST(romanesco::test::TestObjReader)

#include "testobjreader.moc"
