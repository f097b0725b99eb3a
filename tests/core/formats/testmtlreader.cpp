// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/mtlreader.h"

#include <string>

#include <QTest>

#include "core/text/linemap.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

QString number(float value)
{
    return QString::number(static_cast<double>(value), 'g', 6);
}

QString colour(const glm::vec3 &value)
{
    return number(value.x) + QLatin1Char(' ') + number(value.y) + QLatin1Char(' ') + number(value.z);
}

/// What differs from a material of which nothing is said: "name Kd 1 0 0 Ns 5", a line each.
QString described(const MtlResult &result)
{
    QStringList all;
    const Material plain;
    for (const auto &[material, texturePlace] : result.materials) {
        QString line = QString::fromStdString(material.name);
        if (material.diffuse != plain.diffuse) {
            line += QStringLiteral(" Kd ") + colour(material.diffuse);
        }
        if (material.specular != plain.specular) {
            line += QStringLiteral(" Ks ") + colour(material.specular);
        }
        if (material.emission != plain.emission) {
            line += QStringLiteral(" Ke ") + colour(material.emission);
        }
        if (material.shininess != plain.shininess) {
            line += QStringLiteral(" Ns ") + number(material.shininess);
        }
        if (material.opacity != plain.opacity) {
            line += QStringLiteral(" d ") + number(material.opacity);
        }
        if (!material.diffuseTexture.empty()) {
            line += QStringLiteral(" map ") + QString::fromStdString(material.diffuseTexture.string());
        }
        all.push_back(line);
    }
    return all.join(QLatin1Char('\n'));
}

}

class TestMtlReader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void materials_data();
    void materials();
    void texturesHavePlaces();
    void errorsNameTheirPlace_data();
    void errorsNameTheirPlace();
};

void TestMtlReader::materials_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *text, const char *expected) {
        QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(expected);
    };
    row("nothing", "", "");
    row("nothing said", "newmtl a", "a");
    row("all", "newmtl a\nKd 1 .5 0\nKs 0.25 0.25 0.5\nKe 0 0 1\nNs 96.5\nd 0.5\nmap_Kd a.png\n",
        "a Kd 1 0.5 0 Ks 0.25 0.25 0.5 Ke 0 0 1 Ns 96.5 d 0.5 map a.png");
    row("two", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n", "a Kd 1 0 0\nb Kd 0 1 0");
    row("names with blanks", "newmtl  Material #25 of many \r\nKd 1 0 0\r\n", "Material #25 of many Kd 1 0 0");
    row("grey", "newmtl a\nKd .5\nKs .25 # grey", "a Kd 0.5 0.5 0.5 Ks 0.25 0.25 0.25");
    row("transparent", "newmtl a\nTr 0.25", "a d 0.75");
    row("the later of both", "newmtl a\nd 0.5\nTr 0.25\nnewmtl b\nTr 0.25\nd 0.5", "a d 0.75\nb d 0.5");
    row("held to 0 and 1", "newmtl a\nKd 2 -1 255\nd 7\nNs -1\nnewmtl b\nd -1\nNs 1e300", "a Kd 1 0 1\nb Ns 1e+06 d 0");
    row("all else is passed over",
        "# Kd 1 1 1\nKd 0 0 0\nmap_Kd lost.png\nnewmtl a\nKa 1 1 1\nillum 2\nNi 1.5\nTf 1 1 1\nmap_Ks b.png\n"
        "map_Bump -bm 1 b.png\nbump b.png\nrefl -type sphere b.png\nd_ 0\nkd 0 0 0\nsharpness 60",
        "a");
    row("indented", "newmtl a\n\t Kd 1 0 0\n   d .5", "a Kd 1 0 0 d 0.5");
    row("goes on", "newmtl a\nKd 1 \\\n 0 0", "a Kd 1 0 0");
    row("BOM", "\xEF\xBB\xBFnewmtl a\nd 0", "a d 0");
    row("CR", "newmtl a\rd 0\r", "a d 0");
    row("texture with blanks", "newmtl a\nmap_Kd  my own tree.png \r\n", "a map my own tree.png");
    row("texture in folders", "newmtl a\nmap_Kd ..\\tex\\a.png", "a map ../tex/a.png");
    row("a drive", "newmtl a\nmap_Kd C:\\tex\\a.png", "a map C:/tex/a.png");
    row("options", "newmtl a\nmap_Kd -blendu on -cc off -mm 0 1 -texres 256 -imfchan r -type sphere a b.png",
        "a map a b.png");
    row("a vector of three", "newmtl a\nmap_Kd -s 1 2 3 -o .5 -1e0 0 a.png", "a map a.png");
    row("vectors of fewer", "newmtl a\nmap_Kd -s 1 2 -o .5 -t 1 3d.png", "a map 3d.png");
    row("a number behind three", "newmtl a\nmap_Kd -s 1 1 1 4 x.png", "a map 4 x.png");
    row("what looks like an option", "newmtl a\nmap_Kd -tree.png", "a map -tree.png");
    row("the last texture", "newmtl a\nmap_Kd a.png\nmap_Kd b.png", "a map b.png");
}

void TestMtlReader::materials()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const MtlResult result = readMtl(bytes);
    QVERIFY(result.diagnostics.empty());
    QTEST(described(result), "expected");
}

void TestMtlReader::texturesHavePlaces()
{
    const std::string text = "newmtl a\nmap_Kd -s 1 my a.png\nnewmtl b\n";
    const MtlResult result = readMtl(text);
    const SourceRange place = result.materials.at(0).texturePlace;
    QCOMPARE(QString::fromStdString(text.substr(place.begin, place.length())), QStringLiteral("my a.png"));
    QCOMPARE(result.materials.at(1).texturePlace.length(), 0u);
}

void TestMtlReader::errorsNameTheirPlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *text, const char *expected) {
        QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(expected);
    };
    row("no number", "newmtl a\nNs x\nd .5", "a d 0.5\n2:4 \"x\" is not a number");
    row("two numbers", "newmtl a\nKd 1 0\nd .5", "a d 0.5\n2:7 a number expected, found the end of the line");
    row("none", "newmtl a\nKd\nd\nmap_Kd",
        "a\n2:3 a number expected, found the end of the line\n3:2 a number expected, found the end of the line\n"
        "4:7 the name of a file expected, found the end of the line");
    row("a spectrum", "newmtl a\nKd spectral a.rfl", "a\n2:4 \"spectral\" is not a number");
    row("NaN", "newmtl a\nKd 0 nan 0", "a\n2:6 \"nan\" is not a number");
    row("too large", "newmtl a\nKd 1 1 1e400", "a\n2:8 1e400 is too large for a number (at most 1.8e308)");
    row("options only", "newmtl a\nmap_Kd -s 1 1", "a\n2:14 the name of a file expected, found the end of the line");
    row("UTF-16", "\xFF\xFEn", "1:1 the file is not UTF-8 text (it looks like UTF-16)");
    row("gzip", "\x1F\x8B\x08", "1:1 the file is compressed; unpack it first");
}

void TestMtlReader::errorsNameTheirPlace()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const MtlResult result = readMtl(bytes);
    QStringList lines;
    if (!result.materials.empty()) {
        lines.push_back(described(result));
    }
    for (const Diagnostic &diagnostic : result.diagnostics) {
        const TextPosition at = LineMap(bytes).position(diagnostic.range.begin);
        lines.push_back(
            QStringLiteral("%1:%2 %3").arg(at.line).arg(at.column).arg(QString::fromStdString(diagnostic.message())));
    }
    QTEST(lines.join(QLatin1Char('\n')), "expected");
}

}

ROMANESCO_TEST(romanesco::test::TestMtlReader)

#include "testmtlreader.moc"
