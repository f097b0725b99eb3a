// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/language/completion.h"

#include <algorithm>
#include <array>
#include <string>

#include <QStringList>
#include <QTest>
#include <rapidcheck.h>

#include "tests/core/language/marked.h"
#include "tests/core/language/sampletexts.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::vector<std::string> folder()
{
    return {"cube.obj", "Cliff.fdo", "parts/bud.OBJ", "picture.png", "cup.obj", "a\"b.obj"};
}

/// Two vectors, transformations, objects and recursives, then the line that is written.
std::string after(const std::string &line)
{
    return "v 1 1 -2\nhalf 0.5 .5 5e-1\nt.a. (a, #, 2)\nk. (1, #, #)\nx. \"x.obj\"\ny. [k] x\nz<x>. [k] y\n" + line;
}

QStringList labels(const std::vector<Completion> &completions)
{
    QStringList list;
    for (const Completion &completion : completions) {
        list += QString::fromStdString(completion.label);
    }
    return list;
}

std::vector<Completion> completedFdo(const std::string &marked)
{
    const auto [document, offset] = MarkedDocument(marked);
    return complete(document, offset, folder);
}

std::vector<Completion> completedSdo(const std::string &marked)
{
    const MarkedText text(marked);
    return complete(SdoSyntax(text.text), text.offset, folder);
}

/// The last line after the completion of that label was taken.
QString taken(const std::vector<Completion> &completions, const std::string &text, std::string_view label)
{
    const auto at = std::ranges::find(completions, label, &Completion::label);
    if (at == completions.end()) {
        return QStringLiteral("not offered");
    }
    const std::string whole = applied(text, {at->edit});
    return QString::fromStdString(whole.substr(whole.rfind('\n') + 1));
}

/// Whether a text takes a name for something that it is not.
bool isMisled(const std::string &text)
{
    using enum DiagnosticCode;
    return std::ranges::any_of(resolveFdo(FdoSyntax(text)).diagnostics, [](const Diagnostic &diagnostic) {
        constexpr std::array codes{UnknownName,        UnknownVectorName,  UnknownVectorIndex,
                                   RepeatedVectorName, NotATransformation, NotAnObject,
                                   NotARecursive,      BaseNotReached,     TooManyArguments};
        return std::ranges::contains(codes, diagnostic.code);
    });
}

void checkTotal(const std::vector<Completion> &completions, const std::string &text, std::size_t offset)
{
    RC_ASSERT(completions.size() <= mostCompletions);
    for (const Completion &completion : completions) {
        const SourceRange range = completion.edit.range;
        RC_ASSERT(range.begin <= offset);
        RC_ASSERT(offset <= range.end);
        RC_ASSERT(range.end <= text.size());
        RC_ASSERT(!completion.label.empty());
    }
}

}

class TestCompletion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatMayStandThere_data();
    void whatMayStandThere();
    void whatMayStandInAScene_data();
    void whatMayStandInAScene();
    void detailsTellThemApart();
    void takingOneReplacesTheWord_data();
    void takingOneReplacesTheWord();
    void takingOneInAScene_data();
    void takingOneInAScene();
    void bodiesStandOnTheirBase();
    void onlyWhatIsDeclaredAbove();
    void noMoreThanAPopUpHolds();
    void whatIsOfferedCanBeRead();
    void anyBytesAndAnyOffset();
};

void TestCompletion::whatMayStandThere_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QStringList>("expected");
    const auto row = [](const char *line, const char *expected) {
        QTest::newRow(line) << QString::fromUtf8(line)
                            << QString::fromUtf8(expected).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    };
    row("|", "v <$>.");
    row("  |", "v <$>.");
    row("v|", "v");
    row("<|", "<$>.");
    row("<$|", "<$>.");
    row("<$>|", "<$>.");
    row("t|", "");
    row("v |", "");
    row("v 1 1|", "");
    row("half |", "");
    row("w. |", "z y x cube.obj parts/bud.OBJ cup.obj");
    row("w.|", "z y x cube.obj parts/bud.OBJ cup.obj");
    row("w. c|", "cube.obj cup.obj");
    row("w. Cu|", "cube.obj cup.obj");
    row("w. \"|", "cube.obj parts/bud.OBJ cup.obj");
    row("w. \"p|", "parts/bud.OBJ");
    row("w. \"cube.obj\"|", "");
    row("w. z |", "");
    row("w. z 6|", "");
    row("w. z # |", "");
    row("w. [k] |", "z y x cube.obj parts/bud.OBJ cup.obj");
    row("w. [k]|", "z y x cube.obj parts/bud.OBJ cup.obj");
    row("<$>. |", "z y x cube.obj parts/bud.OBJ cup.obj");
    row("<$> . x|", "x");
    row("w. [|", "k t #");
    row("w. [k] [t.1, |", "k t #");
    row("w. [#, t|", "t");
    row("w. [# |", "");
    row("w. [k |", "");
    row("w. [|, k] x", "k t #");
    row("w. [t.|", "half 2 1");
    row("w. [t. |", "half 2 1");
    row("w. [t.h|", "half");
    row("w. [t.1|", "1");
    row("w. [t.1.|", "");
    row("w. [k.|", "");
    row("w. [unknown.1.1.|", "half 2 1");
    row("w. [unknown.1.1.1.|", "");
    row("w<|", "y x");
    row("w<x|", "x");
    row("w<x>|", "");
    row("w<x>. |", "z y x");
    row("w<y>. |", "y");
    row("w<y>. [k] \"|", "");
    row("w.a|.", "");
    row("w.a.|", "");
    row("w.a.(|", "a # half 2 1");
    row("w.a.b. (1, |", "a b # half 2 1");
    row("w.a.b. (1, #, b|)", "b");
    row("w.half. (|", "half # 2 1"); // the parameter hides the vector
    row("w.a. (1 |", "");
    row("w.a. (1, 1, 1, |", "");
    row("w.a. (1, 1, 1)|", "");
    row("# |", "");
    row("w. x # |", "");
    row("w. \u00E9|", "");
}

void TestCompletion::whatMayStandThere()
{
    QFETCH(QString, line);
    QTEST(labels(completedFdo(after(line.toStdString()))), "expected");
}

void TestCompletion::whatMayStandInAScene_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("expected");
    const auto row = [](const char *text, const char *expected) {
        QTest::newRow(oneLine(text)) << QString::fromUtf8(text)
                                     << QString::fromUtf8(expected).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    };
    row("|", "c o f p l");
    row("c # # 60\n|", "o f p l");
    row("|c # # 60", "c o f p l");
    row("f|", "f");
    row("x|", "");
    row("o |", "cube.obj parts/bud.OBJ cup.obj");
    row("p \"cu|", "cube.obj cup.obj");
    row("f \"|", "Cliff.fdo");
    row("f c|", "Cliff.fdo");
    row("l \"|", "");
    row("o \"cube.obj\" |", "#");
    row("o \"cube.obj\"|", "");
    row("o \"cube.obj\" (|", "#");
    row("o \"cube.obj\" ((1, 2, 3),|", "#");
    row("o \"cube.obj\" ((1, 2, |", "");
    row("o \"cube.obj\" (#, #, #)|", "");
    row("o \"cube.obj\" # |", "");
    row("c |", "#");
    row("c # |", "#");
    row("c #|", "");
    row("c # # |", "");
    row("c # # 60|", "");
    row("c # # 60 |", "perspective orthographic");
    row("c (1, 2, 3) # 60 o|", "orthographic");
    row("c # # 60 perspective |", "");
    row("l # |", "#");
    row("l # # |", "");
    row("p \"cube.obj\" # |", "");
    row("# |", "");
}

void TestCompletion::whatMayStandInAScene()
{
    QFETCH(QString, text);
    QTEST(labels(completedSdo(text.toStdString())), "expected");
}

void TestCompletion::detailsTellThemApart()
{
    const auto details = [](const std::string &line) {
        QStringList list;
        for (const Completion &completion : completedFdo(after(line))) {
            list += QString::fromStdString(completion.label + ": " + completion.detail);
        }
        return list.join(QLatin1String("; "));
    };
    QCOMPARE(details("w. [t.|"), QStringLiteral("half: 0.5 0.5 0.5; 2: 0.5 0.5 0.5; 1: 1 1 -2"));
    QCOMPARE(details("s.p.q. (p, q, 1)\nw. [|"), QStringLiteral("s: p, q; k: ; t: a; #: the identity"));
    QCOMPARE(details("w<x>. |"), QStringLiteral("z: around x; y: an object; x: an object"));
}

void TestCompletion::takingOneReplacesTheWord_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("label");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *line, const char *label, const char *expected) {
        QTest::addRow("%s to %s", line, label)
            << QString::fromUtf8(line) << QString::fromUtf8(label) << QString::fromUtf8(expected);
    };
    row("|", "v", "v ");
    row("<$|", "<$>.", "<$>. ");
    row("<|. x", "<$>.", "<$>. x");
    row("w. [|] x", "t", "w. [t.] x");
    row("w. [|] x", "k", "w. [k] x");
    row("w. [t|] x", "t", "w. [t.] x");
    row("w. [|tt.1] x", "t", "w. [t.tt.1] x");
    row("w. [t|t.1] x", "t", "w. [t.1] x");
    row("w. [t.|] x", "half", "w. [t.half] x");
    row("w. [t.h|alves] x", "half", "w. [t.half] x");
    row("w. [t.1|2] x", "1", "w. [t.1] x");
    row("w. |", "z", "w. z 6");
    row("w. z| 3", "z", "w. z 3");
    row("w. |", "cube.obj", "w. \"cube.obj\"");
    row("w. cu|", "cube.obj", "w. \"cube.obj\"");
    row("w. \"cu|", "cube.obj", "w. \"cube.obj\"");
    row("w. \"cu|x # note", "cube.obj", "w. \"cube.obj\" # note");
    row("w. \"cu|p x.obj\"", "cube.obj", "w. \"cube.obj\"");
    row("w.a.(|, #, #)", "a", "w.a.(a, #, #)");
}

void TestCompletion::takingOneReplacesTheWord()
{
    QFETCH(QString, line);
    QFETCH(QString, label);
    const MarkedText text(after(line.toStdString()));
    const FdoDocument document(text.text);
    QTEST(taken(complete(document, text.offset, folder), text.text, label.toStdString()), "expected");
}

void TestCompletion::takingOneInAScene_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("label");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *line, const char *label, const char *expected) {
        QTest::addRow("%s to %s", line, label)
            << QString::fromUtf8(line) << QString::fromUtf8(label) << QString::fromUtf8(expected);
    };
    row("|", "c", "c ");
    row("o |", "cube.obj", "o \"cube.obj\"");
    row("f \"|\" #", "Cliff.fdo", "f \"Cliff.fdo\" #");
    row("c # # 60 persp|", "perspective", "c # # 60 perspective");
}

void TestCompletion::takingOneInAScene()
{
    QFETCH(QString, line);
    QFETCH(QString, label);
    const MarkedText text(line.toStdString());
    QTEST(taken(complete(SdoSyntax(text.text), text.offset, folder), text.text, label.toStdString()), "expected");
}

void TestCompletion::bodiesStandOnTheirBase()
{
    const std::string text = "a. \"a.obj\"\nb. \"b.obj\"\nc. a\nd<a>. c\n";
    QCOMPARE(labels(completedFdo(text + "w<a>. |")), QStringList({"d", "c", "a"}));
    QCOMPARE(labels(completedFdo(text + "w<b>. |")), QStringList({"b"}));
}

void TestCompletion::onlyWhatIsDeclaredAbove()
{
    QCOMPARE(labels(completedFdo("a 1 1 1\nt. (|\nv 2 2 2")), QStringList({"#", "a", "1"}));
    QCOMPARE(labels(completedFdo("a 1 1 1\na 2 2 2\nt. (|")), QStringList({"#", "2", "1"})); // which a?
    QCOMPARE(labels(completedFdo("t. (#, #, #)\nt. (#, #, #)\ny. [|\nu. (#, #, #)")), QStringList({"t", "#"}));
    QCOMPARE(labels(completedFdo("|\nx. \"x.obj\"\n<$>. x")), QStringList({"v"}));
    QCOMPARE(labels(completedFdo("x. \"x.obj\"\r\n|<$>. x\r\n")), QStringList({"v", "<$>."}));
    const MarkedText crlf("x. \"x.obj\"\r|\n");
    QVERIFY(complete(FdoDocument(crlf.text), crlf.offset, folder).empty());
    QVERIFY(complete(FdoDocument("\xEF\xBB\xBF"), 1, folder).empty());
    QCOMPARE(complete(FdoDocument("\xEF\xBB\xBF"), 3, folder).size(), std::size_t{2});
}

void TestCompletion::noMoreThanAPopUpHolds()
{
    std::string text;
    for (int i = 1; i <= 2'500; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
    }
    QCOMPARE(completedFdo(text + "t. (|").size(), mostCompletions);
    QCOMPARE(completedFdo(text + "t. (|").back().label, std::string("1502"));
    QCOMPARE(completedFdo(text + "t. (25|").size(), std::size_t{12});
}

void TestCompletion::whatIsOfferedCanBeRead()
{
    // Cut a good text anywhere: what is offered there makes no name unknown.
    QVERIFY(rc::check([] {
        const std::string text = *validFdo();
        for (std::size_t offset = *rc::gen::inRange<std::size_t>(0, 3); offset <= text.size(); offset += 3) {
            const std::string cut = text.substr(0, offset);
            const std::vector<Completion> offered = complete(FdoDocument(cut), offset, folder);
            if (!offered.empty()) {
                const Completion &chosen = offered[offset % offered.size()];
                RC_ASSERT(!isMisled(applied(cut, {chosen.edit})));
            }
        }
    }));
}

void TestCompletion::anyBytesAndAnyOffset()
{
    QVERIFY(rc::check([] {
        const std::string text = *anyBytes();
        const FdoDocument document(text);
        const SdoSyntax scene(text);
        for (std::size_t offset = 0; offset < endOfOffsets(text); ++offset) {
            checkTotal(complete(document, offset, folder), text, offset);
            checkTotal(complete(scene, offset, folder), text, offset);
        }
    }));
}

}

ROMANESCO_TEST(romanesco::test::TestCompletion)

#include "testcompletion.moc"
