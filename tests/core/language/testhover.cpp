// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/language/hover.h"

#include <string>

#include <QTest>
#include <rapidcheck.h>

#include "core/formats/fdoreader.h"
#include "core/fractal/counts.h"
#include "core/language/levelfacts.h"
#include "tests/core/language/marked.h"
#include "tests/core/language/sampletexts.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

QString words(const std::optional<Hover> &hover, const std::string &text)
{
    if (!hover) {
        return QStringLiteral("nothing");
    }
    std::string all = text.substr(hover->range.begin, hover->range.length()) + " = " + hover->title;
    for (const std::string &line : hover->lines) {
        all += "; " + line;
    }
    return QString::fromStdString(all);
}

QString hoveredFdo(const std::string &marked)
{
    const auto [document, offset] = MarkedDocument(marked);
    return words(hover(document, offset), document.syntax.text());
}

QString hoveredSdo(const std::string &marked)
{
    const MarkedText text(marked);
    return words(hover(SdoSyntax(text.text), text.offset), text.text);
}

/// A text with two vectors, transformations, an object and two recursives before the line.
std::string after(const std::string &line)
{
    return "v 1 1 -2\nhalf 0.5 .5 5e-1\nt.a. (a, #, half)\nk. (1, #, #)\nx. [k, #] \"x.obj\"\n"
           "z<x>. [k, #, t.1] [k, t.2] x\nw<x>. [#] z 2\n"
        + line;
}

void checkTotal(const std::optional<Hover> &hover, const std::string &text)
{
    if (hover) {
        RC_ASSERT(hover->range.begin < hover->range.end);
        RC_ASSERT(hover->range.end <= text.size());
        RC_ASSERT(!hover->lines.empty());
    }
}

}

class TestHover : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wordsSayWhatTheyAre_data();
    void wordsSayWhatTheyAre();
    void mapsAreJudged_data();
    void mapsAreJudged();
    void objectsSumUpTheirLevels_data();
    void objectsSumUpTheirLevels();
    void linesOfAScene_data();
    void linesOfAScene();
    void countsAreThoseOfTheFractal();
    void anyBytesAndAnyOffset();
};

void TestHover::wordsSayWhatTheyAre_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *line, const char *expected) {
        QTest::newRow(oneLine(line)) << QString::fromUtf8(line) << QString::fromUtf8(expected);
    };
    row("|v 1 2 -0", "v = vector 3; 1 2 0");
    row("|m 1, 2, 1e-9", "m = m, vector 3; 1 2 1e-09");
    row("m 1, |2, 3.0000001 # half", "m 1, 2, 3.0000001 = m, vector 3; 1 2 3");
    row("m 1, 2, 3 # ha|lf", "nothing");
    row("|v 1 nan 3", "v = vector 3; its line has an error");
    row("n. (|2, #, #)", "2 = half, vector 2; 0.5 0.5 0.5");
    row("n. (hal|f, #, #)", "half = half, vector 2; 0.5 0.5 0.5");
    row("n. (|3, #, #)", "nothing");
    row("n.a|. (a, #, a)", "a = parameter a of n; the position, the scale");
    row("n.a. (1, #, #|)", "nothing");
    row("n.a.b. (b, #, |b)", "b = parameter b of n; the position, the scale");
    row("n.|a.b. (b, #, b)", "a = parameter a of n; not used");
    row("|n.a. (a, #, 2)", "n = transformation n.a; position a; rotation #; scale 0.5 0.5 0.5");
    row("|n. (9, nobody, half)", "n = transformation n; position 9; rotation nobody; scale 0.5 0.5 0.5");
    row("|n.a. (a, #", "n = transformation n.a; its line has an error");
    row("y. [t.|2] x", "2 = half, vector 2; 0.5 0.5 0.5");
    row("y. [|t] x", "t = transformation t.a; position a; rotation #; scale 0.5 0.5 0.5"); // an argument is missing
    row("y. [|u] x", "nothing");
    row("y. [|x] x", "nothing");
    row("y. \"a|.obj\"", "\"a.obj\" = a.obj; the base mesh");
    row("y. z |6", "6 = depth 6 of z; 6 iterations around x; each multiplies the instances by 6");
    row("y. z |1", "1 = depth 1 of z; 1 iteration around x; each multiplies the instances by 6");
    row("y. x |1", "nothing");
    row("bad. [\n<$>. ba|d", "bad = object bad; its line has an error");
    row("bad nonsense\n<$>. ba|d", "bad = bad; its line has an error");
    row("# x|", "nothing");
    row("|", "nothing");
}

void TestHover::wordsSayWhatTheyAre()
{
    QFETCH(QString, line);
    QTEST(hoveredFdo(after(line.toStdString())), "expected");
}

void TestHover::mapsAreJudged_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *text, const char *expected) {
        QTest::newRow(oneLine(text)) << QString::fromUtf8(text) << QString::fromUtf8(expected);
    };
    row("v 1 2 3\nv 0 90 0\nv .5 .5 .5\nt. (1, 2, 3)\nx. [|t] \"x.obj\"",
        "t = t; position 1 2 3; rotation 0 90 0 degrees; scale 0.5 0.5 0.5; "
        "[0 0 -0.5 | 1]; [0 0.5 0 | 2]; [0.5 0 0 | 3]; operator norm 0.5, determinant 0.125; a similarity");
    row("v -2 1 1\nt.a. (#, #, a)\nx. [t|.1.] \"x.obj\"",
        "t.1 = t.1; position 0 0 0; rotation 0 0 0 degrees; scale -2 1 1; "
        "[-2 0 0 | 0]; [0 1 0 | 0]; [0 0 1 | 0]; operator norm 2, determinant -2; not a similarity, mirrored");
    row("v 1 1 0\nt. (#, #, 1)\nx. [t|] \"x.obj\"",
        "t = t; position 0 0 0; rotation 0 0 0 degrees; scale 1 1 0; "
        "[1 0 0 | 0]; [0 1 0 | 0]; [0 0 0 | 0]; operator norm 1, determinant 0; flat: it has no inverse");
}

void TestHover::mapsAreJudged()
{
    QFETCH(QString, text);
    QTEST(hoveredFdo(text.toStdString()), "expected");
}

void TestHover::objectsSumUpTheirLevels_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *line, const char *expected) {
        QTest::newRow(oneLine(line)) << QString::fromUtf8(line) << QString::fromUtf8(expected);
    };
    row("|y. \"y.obj\"", "y = object y; no levels; 1 instance as written; mesh \"y.obj\"");
    row("y. |x", "x = object x; level size 2; 2 instances as written; mesh \"x.obj\"");
    row("|y. [k, #, k, #] x", "y = object y; level sizes 2, 2; 4 instances as written; mesh \"x.obj\"");
    row("y. |z 6", "z = recursive z around x; one iteration: level sizes 3, 2; 6 instances as written; mesh \"x.obj\"");
    row("|y. z 2", "y = object y; level sizes 3, 2, 3, 2, 2; 72 instances as written; mesh \"x.obj\"");
    row("y. |w 1",
        "w = recursive w around x; one iteration: level sizes 1, 3, 2, 3, 2; 36 instances as written; "
        "mesh \"x.obj\"");
    row("|y. [k] z 9",
        "y = object y; level sizes 1, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, … (20 levels); "
        "20,155,392 instances as written; mesh \"x.obj\"");
    row("m. \"m.obj\"\nr<m>. [k, #, t.1] [k, t.1] m\n<|$>. r 2",
        "<$> = <$>, the result; level sizes 3, 2, 3, 2; t = 6, d = 2; 36 instances as written; mesh \"m.obj\"");
    row("m. \"m.obj\"\nr<m>. [k, #] m\n<|$>. r 1000000000000000000",
        "<$> = <$>, the result; level sizes 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, … "
        "(1,000,000,000,000,000,000 levels); "
        "t = 2, d = 1,000,000,000,000,000,000; ~1.64e301029995663981195 instances as written; mesh \"m.obj\"");
    row("m. \"m.obj\"\nr<m>. [k, #] m\ns<m>. [#] r 9223372036854775807\n<|$>. s 9223372036854775807",
        "<$> = <$>, the result; too many levels to count here; mesh \"m.obj\"");
    // 9.99986e462
    row("m. \"m.obj\"\nr<m>. [k, #, t.1] [k, t.1] m\n<|$>. r 595",
        "<$> = <$>, the result; level sizes 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, … (1,190 levels); "
        "t = 6, d = 595; ~1.00e463 instances as written; mesh \"m.obj\"");
    // many levels one by one
    const std::string pair = "[k, #] ";
    std::string many = "|y. ";
    for (int i = 0; i < 150; ++i) {
        many += pair;
    }
    row((many + "\"y.obj\"").c_str(),
        "y = object y; level sizes 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, … (150 levels); "
        "~1.43e45 instances as written; mesh \"y.obj\"");
    // five levels of its own round five repeated ones
    row("m. \"m.obj\"\nr<m>. [k, #] m\nn. r 5\n|q<n>. [#] [#] [#] [#] [#] n",
        "q = recursive q around n; one iteration: level sizes 1, 1, 1, 1, 1; 1 instance as written; mesh \"m.obj\"");
}

void TestHover::objectsSumUpTheirLevels()
{
    QFETCH(QString, line);
    QTEST(hoveredFdo(after(line.toStdString())), "expected");
}

void TestHover::linesOfAScene_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *text, const char *expected) {
        QTest::newRow(oneLine(text)) << QString::fromUtf8(text) << QString::fromUtf8(expected);
    };
    row("|c (1, 2, 3) # 60 # note",
        "c (1, 2, 3) # 60 = camera; at 1 2 3; looks along 0 0 1; turned by 0 0 0 degrees; "
        "sees 60 degrees from top to bottom");
    row("c # (0, 1.5707963267948966, 0) 10 ortho|graphic",
        "c # (0, 1.5707963267948966, 0) 10 orthographic = orthographic camera; at 0 0 0; looks along -1 0 0; "
        "turned by 0 90 0 degrees; sees a height of 10");
    row("c # # 60 # no|te", "nothing");
    row("|c # # 700", "nothing");
    row("o \"c|.obj\" #", "\"c.obj\" = c.obj; object");
    row("f \"c.fdo\" |#",
        "# = placed by; position 0 0 0; rotation 0 0 0 degrees; scale 1 1 1; [1 0 0 | 0]; "
        "[0 1 0 | 0]; [0 0 1 | 0]; operator norm 1, determinant 1; a similarity");
    row("|o \"c.obj\" ((1, 2, 3), #, #)", "o \"c.obj\" ((1, 2, 3), #, #) = object c.obj; at 1 2 3");
    row("p \"b.obj\" # 0.|6 (1, 0, 0)",
        "p \"b.obj\" # 0.6 (1, 0, 0) = ball b.obj; at 0 0 0; "
        "coefficient of restitution 0.6; starts with velocity 1 0 0");
    row("|l (1, 2, 3) #", "l (1, 2, 3) # = point light; at 1 2 3; colour 1 1 1 (linear)");
    row("# c|", "nothing");
    row("|", "nothing");
}

void TestHover::linesOfAScene()
{
    QFETCH(QString, text);
    QTEST(hoveredSdo(text.toStdString()), "expected");
}

void TestHover::countsAreThoseOfTheFractal()
{
    // the graph's own count, which is made another way
    QVERIFY(rc::check([] {
        const std::string text = *validFdo();
        const FdoDocument document(text);
        const FdoResult result = describeFdo(document.syntax, document.model);
        const auto graph = FractalGraph::build(*result.description, {glm::dvec3(0), 1.0});
        RC_PRE(graph.has_value());
        const std::optional<LevelFacts> facts = levelFacts(document, document.model.result);
        RC_ASSERT(facts.has_value());
        RC_ASSERT(facts->levelCount == graph->levels().levelCount());
        RC_ASSERT(facts->instances == instancesAsWritten(*graph));
    }));
}

void TestHover::anyBytesAndAnyOffset()
{
    QVERIFY(rc::check([] {
        const std::string text = *anyBytes();
        const FdoDocument document(text);
        const SdoSyntax scene(text);
        for (std::size_t offset = 0; offset < endOfOffsets(text); ++offset) {
            checkTotal(hover(document, offset), text);
            checkTotal(hover(scene, offset), text);
        }
    }));
}

}

ROMANESCO_TEST(romanesco::test::TestHover)

#include "testhover.moc"
