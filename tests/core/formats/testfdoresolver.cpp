// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/fdoreader.h"

#include <clocale>
#include <locale>
#include <string>

#include <QTest>

#include "core/text/linemap.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A to Z move by 1 to 26 along x, so that a set can be told by its letters. `#` is the identity.
std::string alphabet()
{
    std::string text;
    for (int i = 0; i < 26; ++i) {
        text += "v " + std::to_string(i + 1) + " 0 0\n";
    }
    for (int i = 0; i < 26; ++i) {
        text += std::string(1, static_cast<char>('A' + i)) + ". (" + std::to_string(i + 1) + ", #, #)\n";
    }
    return text;
}

/// "A (B C) A": the levels written out, sets of several maps in parentheses.
QString levels(const FractalDescription &description)
{
    QString text;
    for (Position position = 0; position < description.levels.levelCount(); ++position) {
        const TransformSet &set = description.sets[description.levels.set(description.levels.locate(position).slot)];
        QString entries = set.holdsIdentity ? QStringLiteral("#") : QString();
        for (const AffineMap &map : set.maps) {
            entries += QLatin1Char(static_cast<char>('A' - 1 + map.translation.x));
        }
        text += entries.size() == 1 ? entries : QLatin1Char('(') + entries + QLatin1Char(')');
    }
    return text;
}

FdoResult read(const std::string &text)
{
    return readFdo(text);
}

}

class TestFdoResolver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void levelsAreWrittenOut_data();
    void levelsAreWrittenOut();
    void transformationsBecomeMaps_data();
    void transformationsBecomeMaps();
    void theSliderMovesTheFirstDepth_data();
    void theSliderMovesTheFirstDepth();
    void setsKeepTheOrderAndThePlacesOfTheirUses();
    void meshPathAndItsPlace();
    void encodingsAndLineEnds_data();
    void encodingsAndLineEnds();
    void everyLocaleReadsAlike();
    void depthsUpToTheGreatest();
    void nothingButTheResultNeedsToBeRight();
};

void TestFdoResolver::levelsAreWrittenOut_data()
{
    QTest::addColumn<QString>("declarations");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *declarations, const char *expected) {
        QTest::newRow(name) << QString::fromLatin1(declarations) << QString::fromLatin1(expected);
    };
    row("a mesh", "<$>. \"x.obj\"", "");
    row("a set", "<$>. [A] \"x.obj\"", "A");
    row("outer to inner", "<$>. [A] [B] \"x.obj\"", "AB");
    row("a set with more", "<$>. [A, #, B] \"x.obj\"", "(#AB)");
    row("through names", "x. \"x.obj\"\ny. [B] x\n<$>. [A] y", "AB");
    row("a copy", "x. [B] \"x.obj\"\ny. x\n<$>. y", "B");
    row("n around x", "x. \"x.obj\"\ny. [Y] x\nz<x>. [Z] y\n<$>. z 3", "ZYZYZY");
    row("base with levels of its own", "a. \"x.obj\"\nx. [X] a\ny. [Y] x\nz<x>. [Z] y\n<$>. z 3", "ZYZYZYX");
    row("zero is the base", "a. \"x.obj\"\nx. [X] a\nz<x>. [Z] x\n<$>. z 0", "X");
    row("one", "x. \"x.obj\"\nz<x>. [Z] x\n<$>. z 1", "Z");
    row("sets around a recursive", "x. \"x.obj\"\nz<x>. [Z] x\n<$>. [A] [B] z 2", "ABZZ");
    row("a recursive named", "x. \"x.obj\"\nz<x>. [Z] x\ny. [A] z 2\n<$>. [B] y", "BAZZ");
    row("a recursive inside a recursive", "a. \"x.obj\"\nw<a>. [W] a\nr<a>. [T] w 3\n<$>. r 2", "TWWWTWWW");
    row("recursives one after another", "a. \"x.obj\"\nw<a>. [W] a\nb. w 2\nr<b>. [T] b\n<$>. r 3", "TTTWW");
    row("the base through a recursive", "a. \"x.obj\"\nw<a>. [W] a\nb. [B] w 1\nr<a>. [T] b\n<$>. r 2", "TBWTBW");
    row("three deep", "a. \"x.obj\"\nu<a>. [U] a\nw<a>. [W] u 2\nr<a>. [T] w 2\n<$>. r 2", "TWUUWUUTWUUWUU");
    row("an iteration by another only", "a. \"x.obj\"\nw<a>. [W] a\nr<a>. w 2\n<$>. r 3", "WWWWWW");
    row("an iteration of nothing", "a. \"x.obj\"\nr<a>. a\n<$>. r 5", "");
    row("an inner depth of zero", "a. \"x.obj\"\nw<a>. [W] a\nr<a>. [T] w 0\n<$>. r 3", "TTT");
    row("a base in the middle", "a. \"x.obj\"\nb. [B] a\nc. [C] b\nr<b>. [T] c\n<$>. r 2", "TCTCB");
    row("a hash level stays a level", "<$>. [#] [A] [#] \"x.obj\"", "#A#");
    row("equal maps once", "<$>. [A, B, A, #, #] \"x.obj\"", "(#AB)");
    row("maps in the order of the text", "<$>. [C, A, B] \"x.obj\"", "(CAB)");
    row("declared after the result", "<$>. [A] \"x.obj\"\ny. [B] \"x.obj\"", "A");
    row("long inner repeats", "a. \"x.obj\"\nw<a>. [W] a\nr<a>. [T] w 70\n<$>. r 2",
        "TWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW"
        "TWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW");
}

void TestFdoResolver::levelsAreWrittenOut()
{
    QFETCH(QString, declarations);
    const FdoResult result = read(alphabet() + declarations.toStdString());
    QVERIFY(!hasErrors(result.diagnostics));
    QVERIFY(result.description.has_value());
    QTEST(levels(*result.description), "expected");
}

void TestFdoResolver::transformationsBecomeMaps_data()
{
    QTest::addColumn<QString>("transformation");
    QTest::addColumn<QString>("use");
    QTest::addColumn<QList<double>>("image"); // of (1, 10, 100)
    const auto row = [](const char *transformation, const char *use, const QList<double> &image) {
        QTest::addRow("%s %s", transformation, use)
            << QString::fromLatin1(transformation) << QString::fromLatin1(use) << image;
    };
    // Vectors: 1 (1, 2, 3), 2 (90, 0, 0), 3 (2, 3, 4), called scale.
    row("t. (1, #, #)", "t", {2, 12, 103});
    row("t. (#, #, 3)", "t", {2, 30, 400});
    row("t. (#, #, scale)", "t", {2, 30, 400});
    row("t. (#, 2, #)", "t", {1, 100, -10}); // pitch: (0, y, z) to (0, z, -y)
    row("t. (1, 2, 3)", "t", {3, 402, -27}); // scaled first, then turned, then moved
    row("t. (1, 2, 3)", "t.", {3, 402, -27});
    row("t.p. (p, #, #)", "t.1", {2, 12, 103});
    row("t.p. (p, #, #)", "t.scale", {3, 13, 104});
    row("t.s. (#, #, s)", "t.3.", {2, 30, 400});
    row("t.a.b. (b, #, a)", "t.3.1", {3, 32, 403});
    row("t.a.b.c. (c, a, b)", "t.2.3.1", {3, 402, -27});
    row("t.a. (a, #, a)", "t.3", {4, 33, 404});
    row("t.scale. (scale, #, #)", "t.1", {2, 12, 103}); // the parameter hides the vector
    row("t.a. (#, #, #)", "t.1", {1, 10, 100});         // an argument that is not used
}

void TestFdoResolver::transformationsBecomeMaps()
{
    QFETCH(QString, transformation);
    QFETCH(QString, use);
    QFETCH(QList<double>, image);
    const FdoResult result = read("v 1 2 3\nv 90 0 0\nscale 2 3 4\n" + transformation.toStdString() + "\n<$>. ["
                                  + use.toStdString() + "] \"x.obj\"\n");
    QVERIFY(result.description.has_value());
    const TransformSet &set = result.description->sets.front();
    const glm::dvec3 found = set.maps.empty() ? glm::dvec3(1, 10, 100) : set.maps.front()({1, 10, 100});
    QCOMPARE(set.holdsIdentity, set.maps.empty());
    QCOMPARE((QList<double>{found.x, found.y, found.z}), image);
}

void TestFdoResolver::theSliderMovesTheFirstDepth_data()
{
    QTest::addColumn<QString>("declarations");
    QTest::addColumn<QString>("digits"); // with a letter that is found nowhere else before them
    const auto row = [](const char *declarations, const char *digits) {
        QTest::newRow(declarations) << QString::fromLatin1(declarations) << QString::fromLatin1(digits);
    };
    row("<$>. [A] x", "");
    row("<$>. z 31", "31");
    row("<$>. z 0031", "0031");
    row("<$>. [A] [B] z 31", "31");
    row("y. z 31\n<$>. [A] y", "31");
    row("y. [A] z 31\nr<y>. [B] y\n<$>. r 47", "47");
    row("y. [A] z 31\nr<x>. [B] y\n<$>. [C] y", "31");
    row("<$>. z 0", "0");
}

void TestFdoResolver::theSliderMovesTheFirstDepth()
{
    QFETCH(QString, declarations);
    QFETCH(QString, digits);
    const std::string text = alphabet() + "x. \"x.obj\"\nz<x>. [Z] x\n" + declarations.toStdString();
    const FdoResult result = read(text);
    QVERIFY(result.description.has_value());
    QCOMPARE(result.description->depth.has_value(), !digits.isEmpty());
    if (result.description->depth) {
        const auto &[value, range] = *result.description->depth;
        QCOMPARE(QString::fromStdString(text.substr(range.begin, range.length())), digits);
        QCOMPARE(value, digits.toULongLong());
    }
}

void TestFdoResolver::setsKeepTheOrderAndThePlacesOfTheirUses()
{
    const std::string text = alphabet() + "<$>. [#, B, #, A, B ] \"x.obj\"";
    const FdoResult result = read(text);
    const TransformSet &set = result.description->sets.front();
    QCOMPARE(set.size(), 3u);
    QCOMPARE(set.uses.size(), set.maps.size());
    QCOMPARE(text.substr(set.uses[0].begin, set.uses[0].length()), "B");
    QCOMPARE(text.substr(set.uses[1].begin, set.uses[1].length()), "A");
    QCOMPARE(text.substr(set.range.begin, set.range.length()), "[#, B, #, A, B ]");
    QCOMPARE(result.diagnostics.size(), 1u + 24u); // one remark on what is repeated, and the letters that are not used
}

void TestFdoResolver::meshPathAndItsPlace()
{
    const std::string text = "x. \"some folder/\u00FC #1.OBJ\"\ny. x\n<$>. y";
    const FdoResult result = read(text);
    QCOMPARE(result.description->meshPath, "some folder/\u00FC #1.OBJ");
    const SourceRange range = result.description->meshRange;
    QCOMPARE(text.substr(range.begin, range.length()), "\"some folder/\u00FC #1.OBJ\"");
}

void TestFdoResolver::encodingsAndLineEnds_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message"); // none: it reads well
    const QByteArray good = "x. \"x.obj\"\nt. (#, #, #)\n<$>. [t] x\n";
    QTest::newRow("LF") << good << "";
    QTest::newRow("no final end") << good.chopped(1) << "";
    QTest::newRow("CR LF") << QByteArray(good).replace("\n", "\r\n") << "";
    QTest::newRow("CR") << QByteArray(good).replace("\n", "\r") << "";
    QTest::newRow("BOM") << "\xEF\xBB\xBF" + good << "";
    QTest::newRow("tabs and form feeds") << QByteArray(good).replace(" ", "\t\f ") << "";
    QTest::newRow("second BOM") << "\n\xEF\xBB\xBF" + good
                                << QString::fromUtf8("2:1 a declaration starts with a name or <$>, found \"\uFEFF\"");
    QTest::newRow("UTF-16 LE") << QByteArray("\xFF\xFEx\0.\0", 6)
                               << "1:1 the file is not UTF-8 text (it looks like UTF-16)";
    QTest::newRow("UTF-16 BE") << QByteArray("\xFE\xFF\0x\0.", 6)
                               << "1:1 the file is not UTF-8 text (it looks like UTF-16)";
    QTest::newRow("UTF-16 without a mark")
        << QByteArray("x\0.\0", 4) << "1:1 the file is not UTF-8 text (it holds NUL bytes)";
    QTest::newRow("NUL") << good + QByteArray("y\0", 2) << "1:1 the file is not UTF-8 text (it holds NUL bytes)";
    QTest::newRow("NUL far in") << QByteArray(5'000, '\n') + good + QByteArray("\0", 1)
                                << "5004:1 a declaration starts with a name or <$>, found a control character";
    QTest::newRow("empty") << QByteArray() << "1:1 the file has no result: a line \"<$>. NAME\" is missing";
    QTest::newRow("BOM alone") << QByteArray("\xEF\xBB\xBF")
                               << "1:2 the file has no result: a line \"<$>. NAME\" is missing";
    QTest::newRow("column after a BOM") << QByteArray("\xEF\xBB\xBF?")
                                        << "1:2 a declaration starts with a name or <$>, found \"?\"";
}

void TestFdoResolver::encodingsAndLineEnds()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const std::string text = bytes.toStdString();
    const FdoResult result = read(text);
    if (message.isEmpty()) {
        QVERIFY(result.diagnostics.empty());
        QVERIFY(result.description.has_value());
        return;
    }
    QVERIFY(!result.diagnostics.empty());
    const Diagnostic &first = result.diagnostics.front();
    const TextPosition at = LineMap(text).position(first.range.begin);
    QCOMPARE(QString::fromStdString(std::to_string(at.line) + ':' + std::to_string(at.column) + ' ' + first.message()),
             message);
}

void TestFdoResolver::everyLocaleReadsAlike()
{
    // A decimal comma in the streams of C++, and in those of C where such a locale is installed.
    struct Comma : std::numpunct<char> {
        [[nodiscard]] char do_decimal_point() const override { return ','; }
    };
    const std::locale previous = std::locale::global(std::locale(std::locale::classic(), new Comma));
    for (const char *name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
        std::setlocale(LC_ALL, name);
    }
    const FdoSyntax syntax("v 0.5 1.25 1e-3");
    std::setlocale(LC_ALL, "C");
    std::locale::global(previous);
    QVERIFY(syntax.diagnostics().empty());
    QVERIFY(std::get<VectorDeclaration>(syntax.line(0).declaration).value == glm::dvec3(0.5, 1.25, 1e-3));
}

void TestFdoResolver::depthsUpToTheGreatest()
{
    const std::string start = alphabet() + "x. \"x.obj\"\nz<x>. [Z] x\nzz<x>. [A] z 2\n<$>. ";
    const FdoResult deepest = read(start + "z 9223372036854775807");
    QVERIFY(deepest.description.has_value());
    QCOMPARE(deepest.description->levels.levelCount(), Position(9'223'372'036'854'775'807u));
    QVERIFY(!read(start + "z 9223372036854775808").description.has_value());
    QVERIFY(!read(start + "zz 9223372036854775807").description.has_value()); // three levels each
}

void TestFdoResolver::nothingButTheResultNeedsToBeRight()
{
    QVERIFY(read("bad line\nx. \"x.obj\"\n<$>. x\n").description.has_value());
    QVERIFY(!read("x. \"x.obj\"\ny. [t] x\n<$>. y\n").description.has_value());
}

}

ROMANESCO_TEST(romanesco::test::TestFdoResolver)

#include "testfdoresolver.moc"
