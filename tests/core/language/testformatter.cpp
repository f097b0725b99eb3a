// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/language/formatter.h"

#include <algorithm>
#include <string>
#include <vector>

#include <QDir>
#include <QTest>
#include <rapidcheck.h>

#include "tests/core/fractal/samples.h"
#include "tests/core/language/textwriter.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

struct Fdo {
    using Syntax = FdoSyntax;
    static FdoResult read(const std::string &text) { return readFdo(text); }
};

struct Sdo {
    using Syntax = SdoSyntax;
    static SdoResult read(const std::string &text) { return readSdo(text); }
};

template<typename Language>
std::string formatted(const std::string &text)
{
    const typename Language::Syntax syntax(text);
    const TextEdits edits = formatting(syntax);
    for (const TextEdit &edit : edits) {
        if (text.substr(edit.range.begin, edit.range.length()) == edit.text) {
            return "an edit that changes nothing";
        }
    }
    return applied(text, edits);
}

/// All that is no blank and no line end; a dot may go as well.
std::string squeezed(std::string text)
{
    std::erase_if(text, [](char c) { return std::string_view(" \t\v\f\r\n.").contains(c); });
    return text;
}

/// How many of the first lines, so many, are not blank: which stays when blank lines go.
std::size_t ordinal(std::string_view text, const std::string &line)
{
    const LineMap map(text);
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::stoul(line); ++i) {
        const std::string_view content = map.lineText(i).substr(i == 0 && text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
        count += content.find_first_not_of(" \t\v\f") == content.npos ? 0 : 1;
    }
    return count;
}

/// The codes and arguments. Words of several tokens may be quoted, so blanks in arguments are passed over.
std::vector<std::string> remarks(const std::string &text, const Diagnostics &diagnostics)
{
    std::vector<std::string> all;
    for (const Diagnostic &diagnostic : diagnostics) {
        std::string words(name(diagnostic.code));
        const bool isRedeclared = diagnostic.code == DiagnosticCode::Redeclared;
        const bool isSecond =
            diagnostic.code == DiagnosticCode::SecondResult || diagnostic.code == DiagnosticCode::SecondCamera;
        for (std::size_t i = 0; i < diagnostic.arguments.size(); ++i) {
            const std::string &argument = diagnostic.arguments[i];
            const bool isLine = isRedeclared ? i == 1 : isSecond;
            words += '|' + (isLine ? std::to_string(ordinal(text, argument)) : squeezed(argument));
        }
        for (const Note &note : diagnostic.notes) {
            words += std::string("|") + std::string(name(note.code));
        }
        all.push_back(words);
    }
    return all;
}

/// What would be taken for a mark of an encoding.
bool mayNotStart(std::string_view line)
{
    return line.starts_with("\xEF\xBB\xBF") || line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF");
}

/// What holds for any text. Gives it formatted.
template<typename Language>
std::string checkLayout(const std::string &before)
{
    const std::string after = formatted<Language>(before);
    RC_ASSERT(formatted<Language>(after) == after);
    RC_ASSERT(squeezed(after) == squeezed(before));
    const auto readBefore = Language::read(before);
    const auto readAfter = Language::read(after);
    RC_ASSERT(remarks(after, readAfter.diagnostics) == remarks(before, readBefore.diagnostics));
    RC_ASSERT(meaning(readAfter) == meaning(readBefore));
    const LineMap map(after);
    if (typename Language::Syntax(after).lineCount() == 0 || after.contains('\0')) {
        RC_ASSERT(after == before);
        return after;
    }
    for (std::size_t i = 0; i < map.lineCount(); ++i) {
        const std::string_view line = map.lineText(i);
        RC_ASSERT(line.find_last_of(" \t\v\f") != line.size() - 1 || line.empty());
        const bool isLast = i + 1 == map.lineCount();
        // a blank line is a single one, and has another line above and below, but for what may not start a text
        const bool isEmpty = line.empty() || (i == 0 && line == "\xEF\xBB\xBF");
        const bool isSingle = !isLast && !map.lineText(i + 1).empty();
        RC_ASSERT((isEmpty == isLast || (isSingle && (i > 0 || mayNotStart(map.lineText(1))))));
    }
    return after;
}

template<typename Language>
bool keepsMeaningAndComments(const Patterns &patterns)
{
    return rc::check([&](std::uint32_t seed) {
        const TextWriter writer(patterns, seed);
        RC_CLASSIFY(Language::read(writer.text).description.has_value());
        std::string after = checkLayout<Language>(writer.text);
        std::ranges::replace(after, '\r', '\n');
        std::size_t at = 0;
        for (const std::string &comment : writer.comments) {
            at = after.find(comment + '\n', at);
            RC_ASSERT(at != after.npos);
            at += comment.size();
        }
    });
}

}

class TestFormatter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fdoIsTidied_data();
    void fdoIsTidied();
    void sdoIsTidied_data();
    void sdoIsTidied();
    void aNulDoesNotMove();
    void examplesAreTidy_data();
    void examplesAreTidy();
    void appendixBKeepsItsMeaning();
    void anyFdoKeepsItsMeaningAndComments();
    void anySdoKeepsItsMeaningAndComments();
    void anyBytesKeepTheirRemarks();
};

void TestFormatter::fdoIsTidied_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char *name, const char *before, const char *after) {
        QTest::newRow(name) << QByteArray(before) << QByteArray(after);
    };
    const auto same = [&](const char *name, const char *text) { row(name, text, text); };
    row("vector", "  v\t1   1  -2 \n", "v 1 1 -2\n");
    row("vector with commas", "v 0.1,0.1 ,  0.1\n", "v 0.1, 0.1, 0.1\n");
    same("numbers keep their spelling", "v +1 5. .50\nv 1E+05 -0 007\n");
    row("transformation", "t . a .( a,#,5 )\n", "t.a. (a, #, 5)\n");
    row("transformation without parameters", "k.(1,#,5)\n", "k. (1, #, 5)\n");
    row("set", "y.[#,t.1 ,t . 2,  k]x\n", "y. [#, t.1, t.2, k] x\n");
    row("recursive", "z < x >.[ # , u.6 .10 ]y\n", "z<x>. [#, u.6.10] y\n");
    row("sets", "a.[#][t.1]\t[k] x\n", "a. [#] [t.1] [k] x\n");
    row("result", "< $ > .z  06\n", "<$>. z 06\n");
    row("mesh", "x.\"a  b#.obj\"\n", "x. \"a  b#.obj\"\n");
    row("copy", "z.y\n", "z. y\n");
    row("trailing dots", "y. [u.6.10., k., t.half . , #, k . ] x\n", "y. [u.6.10, k, t.half, #, k] x\n");
    row("comment after code", "x. y#  like it is \nv 1 2 3#c\n", "x. y #  like it is\nv 1 2 3 #c\n");
    row("comment after #", "t. (#,#,#)# #\n", "t. (#, #, #) # #\n");
    row("comments at the margin", "  # a  b\t\n\t#\n", "# a  b\n#\n");
    row("blank lines", "\n \n# a\n\n\t\n\nx. y\n\n \n", "# a\n\nx. y\n");
    row("nothing but blanks", " \n\n\t", "");
    same("nothing", "");
    row("no line end", "x. y", "x. y\n");
    row("line ends stay", "x.y\r\n\r\n\r\nz.y\r# a\nb.y", "x. y\r\n\r\nz. y\r# a\nb. y\r\n");
    row("CR alone", "x.y\r \r\rz.y", "x. y\r\rz. y\r");
    row("a CR and an LF with blanks between", "x. y\r  \nz. y\n", "x. y\r\rz. y\n");
    row("byte order mark", "\xEF\xBB\xBF \n  x.y", "\xEF\xBB\xBFx. y\n");
    row("byte order mark in the line", "\xEF\xBB\xBF  x.y\n", "\xEF\xBB\xBFx. y\n");
    row("what would become a byte order mark", "\n \n\xEF\xBB\xBFx\n", "\n\xEF\xBB\xBFx\n");
    row("what would become UTF-16", "\n\n\xFE\xFFx", "\n\xFE\xFFx\n");
    same("byte order mark alone", "\xEF\xBB\xBF");
    row("slips keep their layout", "  t.a.(a,#  \nx.  # a\t\n y. \"open  # \n", "  t.a.(a,#\nx.  # a\n y. \"open  #\n");
    same("UTF-16", "\xFF\xFEx  y");
    row("underflow is no slip", "v 1e-400  0 0\n", "v 1e-400 0 0\n");

    same("names in a column", "up     0 1 0\nleft   0 0 35\nright  0 0 -35\n");
    row("one name moves to the column", "up     0 1 0\nmiddle 0 0 35\nright  0 0 -35\na 1 2 3\n",
        "up     0 1 0\nmiddle 0 0 35\nright  0 0 -35\na      1 2 3\n");
    row("one name is too long", "up    0 1 0\nleft  0 0 35\nlongest 1 1 1\n",
        "up    0 1 0\nleft  0 0 35\nlongest 1 1 1\n");
    row("a column ends with its run", "up    0 1 0\n\nleft  0 0 35\n", "up 0 1 0\n\nleft 0 0 35\n");
    row("another declaration ends a column", "up    0 1 0\nx. y\nleft  0 0 35\n", "up 0 1 0\nx. y\nleft 0 0 35\n");
    row("equal names need no column", "v  1 1 1\nv  2 2 2\n", "v 1 1 1\nv 2 2 2\n");
    row("no column", "up  0 1 0\nleft  0 0 35\n", "up 0 1 0\nleft 0 0 35\n");
    same("columns count code points", "\xC3\xA9t\xC3\xA9   0 1 0\nleft  0 0 35\n");
    same("comments in a column", "turn   0 137 0   # a\nshrink 1 1 1\nx. y             # b\n");
    row("a comment beyond the column", "v 1 1 1    # a\nx. y       # b\nz. [#, t.1, t.2] x   # c\nb. y # d\n",
        "v 1 1 1    # a\nx. y       # b\nz. [#, t.1, t.2] x # c\nb. y       # d\n");
    row("a far column is none",
        ("x. y" + std::string(300, ' ') + "# a\nxx. y" + std::string(299, ' ') + "# b\n").c_str(),
        "x. y # a\nxx. y # b\n");
}

void TestFormatter::fdoIsTidied()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QCOMPARE(QByteArray::fromStdString(formatted<Fdo>(before.toStdString())), after);
    QCOMPARE(QByteArray::fromStdString(formatted<Fdo>(after.toStdString())), after);
}

void TestFormatter::sdoIsTidied_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char *name, const char *before, const char *after) {
        QTest::newRow(name) << QByteArray(before) << QByteArray(after);
    };
    row("camera", " c(-48.7,25.5 , 64.4)( -0.07,-2.49,0 )60\n", "c (-48.7, 25.5, 64.4) (-0.07, -2.49, 0) 60\n");
    row("camera of identities", "c##60  orthographic#a\n", "c # # 60 orthographic #a\n");
    row("object", "o\"car.obj\"( (0,2.,0),#,# )\n", "o \"car.obj\" ((0, 2., 0), #, #)\n");
    row("# as a value and as a comment", "o \"a.obj\"## note\n", "o \"a.obj\" # # note\n");
    row("fractal", "f  \"cliff.fdo\"\t#\n", "f \"cliff.fdo\" #\n");
    row("ball", "p \"b.obj\"#  .6(1,0,0)# a\n", "p \"b.obj\" # .6 (1, 0, 0) # a\n");
    row("a velocity is no #", "p \"b.obj\" #  1#\n", "p \"b.obj\" # 1 #\n");
    row("light", "l#(1,0.95,0.9)\n", "l # (1, 0.95, 0.9)\n");
    row("comments in a column", "l # #     # a\nf \"a.fdo\" # # b\no \"a\tb.obj\"  #\nl (1,1,1) # # c\n",
        "l # # # a\nf \"a.fdo\" # # b\no \"a\tb.obj\" #\nl (1, 1, 1) # # c\n");
    row("slips keep their layout", " o \"a.obj\"   \nc  # #  60 x\n", " o \"a.obj\"\nc  # #  60 x\n");
    row("lines", "\n#  a\r\n\r\n\r\n l # #", "#  a\r\n\r\nl # #\r\n");
}

void TestFormatter::sdoIsTidied()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QCOMPARE(QByteArray::fromStdString(formatted<Sdo>(before.toStdString())), after);
    QCOMPARE(QByteArray::fromStdString(formatted<Sdo>(after.toStdString())), after);
}

/// A NUL near the start is what a text that is none is told by.
void TestFormatter::aNulDoesNotMove()
{
    std::string text = std::string(5'000, ' ') + "# a";
    text += '\0';
    QVERIFY(FdoSyntax(text).lineCount() > 0);
    QCOMPARE(formatted<Fdo>(text).size(), text.size());
}

void TestFormatter::examplesAreTidy_data()
{
    QTest::addColumn<QString>("name");
    const QDir folder(test::sourcePath("resources/examples"));
    for (const QString &name : folder.entryList({QStringLiteral("*.fdo")}, QDir::Files)) {
        if (name != QLatin1String("appendix-b.fdo")) { // as it was printed
            QTest::newRow(qPrintable(name)) << name;
        }
    }
}

void TestFormatter::examplesAreTidy()
{
    QFETCH(QString, name);
    const std::string text = exampleText(name);
    QVERIFY(!text.empty());
    QCOMPARE(QByteArray::fromStdString(formatted<Fdo>(text)), QByteArray::fromStdString(text));
}

void TestFormatter::appendixBKeepsItsMeaning()
{
    const std::string text = exampleText(QStringLiteral("appendix-b.fdo"));
    std::string tidy = text;
    tidy.erase(text.find("\n \n"), 2); // the blank line that is one too many
    QCOMPARE(QByteArray::fromStdString(formatted<Fdo>(text)), QByteArray::fromStdString(tidy));
    QCOMPARE(meaning(readFdo(tidy)), meaning(readFdo(text)));
}

void TestFormatter::anyFdoKeepsItsMeaningAndComments()
{
    QVERIFY(keepsMeaningAndComments<Fdo>(fdoPatterns));
}

void TestFormatter::anySdoKeepsItsMeaningAndComments()
{
    QVERIFY(keepsMeaningAndComments<Sdo>(sdoPatterns));
}

void TestFormatter::anyBytesKeepTheirRemarks()
{
    QVERIFY(rc::check([] {
        static const std::vector<std::string> pieces = {" ",
                                                        "  ",
                                                        "\t",
                                                        "\v",
                                                        "\n",
                                                        "\n",
                                                        "\r",
                                                        "\r\n",
                                                        "#",
                                                        "# ",
                                                        ".",
                                                        ". ",
                                                        ",",
                                                        "(",
                                                        ")",
                                                        "[",
                                                        "]",
                                                        "<",
                                                        ">",
                                                        "$",
                                                        "\"",
                                                        "v",
                                                        "x",
                                                        "1",
                                                        "2",
                                                        "-",
                                                        "v ",
                                                        "x. ",
                                                        "<$>",
                                                        "\"x.obj\"",
                                                        "\xC3\xA9",
                                                        "\xFF",
                                                        "v 1 2 3",
                                                        "t. (#, #, 1)",
                                                        "[#, t.]",
                                                        "\xEF\xBB\xBF",
                                                        std::string(1, '\0')};
        std::string text;
        for (const std::string &piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces))) {
            text += piece;
        }
        checkLayout<Fdo>(text);
        checkLayout<Sdo>(text);
    }));
}

}

ROMANESCO_TEST(romanesco::test::TestFormatter)

#include "testformatter.moc"
