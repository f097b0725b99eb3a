// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/language/navigation.h"

#include <algorithm>
#include <format>
#include <string>

#include <QTest>
#include <rapidcheck.h>

#include "core/formats/fdoreader.h"
#include "tests/core/language/marked.h"
#include "tests/core/language/sampletexts.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// The text with { } round every use of the word under the cursor, [ ] marks left as they are.
QString usesDrawn(const std::string &marked)
{
    const auto [document, offset] = MarkedDocument(marked);
    std::vector<SourceRange> ranges;
    for (const Occurrence &occurrence : uses(document, offset)) {
        ranges.push_back(occurrence.range);
    }
    return QString::fromStdString(withRanges(document.syntax.text(), ranges));
}

/// The text with { } round what the word under the cursor leads to, or the file's path.
QString definitionDrawn(const std::string &marked)
{
    const auto [document, offset] = MarkedDocument(marked);
    const std::optional<Target> target = definition(document, offset);
    if (!target) {
        return QStringLiteral("nothing");
    }
    return QString::fromStdString(target->path ? "file " + *target->path
                                               : withRanges(document.syntax.text(), {target->range}));
}

QString renamed(const std::string &marked, std::string_view newName)
{
    const auto [document, offset] = MarkedDocument(marked);
    const auto edits = rename(document, offset, newName);
    return QString::fromStdString(edits ? applied(document.syntax.text(), *edits) : edits.error());
}

bool isSame(const TransformSet &a, const TransformSet &b)
{
    return a.maps == b.maps && a.holdsIdentity == b.holdsIdentity;
}

/// Whether two texts say the same, whatever their names and places.
bool meanTheSame(const FractalDescription &a, const FractalDescription &b)
{
    const auto isSameRepeat = [](const LevelSequence::Repeat &x, const LevelSequence::Repeat &y) {
        return x.firstSlot == y.firstSlot && x.endSlot == y.endSlot && x.count == y.count && x.offset == y.offset;
    };
    if (a.meshPath != b.meshPath || a.levels.slotCount() != b.levels.slotCount()
        || !std::ranges::equal(a.levels.repeats(), b.levels.repeats(), isSameRepeat)
        || a.depth.has_value() != b.depth.has_value() || (a.depth && a.depth->value != b.depth->value)
        || !std::ranges::equal(a.sets, b.sets, isSame)) {
        return false;
    }
    for (LevelSequence::Slot slot = 0; slot < a.levels.slotCount(); ++slot) {
        if (a.levels.set(slot) != b.levels.set(slot)) {
            return false;
        }
    }
    return true;
}

}

class TestNavigation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void usesAreAllWordsThatMeanTheSame_data();
    void usesAreAllWordsThatMeanTheSame();
    void wordsLeadToTheirDeclaration_data();
    void wordsLeadToTheirDeclaration();
    void pathsOfASceneLeadToTheirFiles();
    void aCursorTouchesAWordAtEitherEnd();
    void renamesChangeTheWordsThatAreNames_data();
    void renamesChangeTheWordsThatAreNames();
    void renamesThatAreRefused_data();
    void renamesThatAreRefused();
    void onlyWhatHasANameCanBeRenamed();
    void aRenameKeepsTheMeaningAndCanBeUndone();
    void anyBytesAndAnyOffset();
};

void TestNavigation::usesAreAllWordsThatMeanTheSame_data()
{
    QTest::addColumn<QString>("marked");
    QTest::addColumn<QString>("drawn");
    const auto row = [](const char *name, const char *marked, const char *drawn) {
        QTest::newRow(name) << QString::fromUtf8(marked) << QString::fromUtf8(drawn);
    };
    row("a vector by number and name", "v 1 1 1\nhal|f 2 2 2\nt.a. (a, 2, half)\ny. [t.2, t.half, t.1] x",
        "v 1 1 1\n{half} 2 2 2\nt.a. (a, {2}, {half})\ny. [t.{2}, t.{half}, t.1] x");
    row("from the number", "v 1 1 1\nv 2 2 2\nt. (|2, 1, #)", "v 1 1 1\n{v} 2 2 2\nt. ({2}, 1, #)");
    row("numbers with noughts", "v 1 1 1\nt. (1, 0|01, #)", "{v} 1 1 1\nt. ({1}, {001}, #)");
    row("a parameter hides a vector", "a 1 1 1\nt.a. (|a, #, a)\nu. (a, #, #)",
        "a 1 1 1\nt.{a}. ({a}, #, {a})\nu. (a, #, #)");
    row("a vector that is hidden", "|a 1 1 1\nt.a. (a, 1, a)\nu. (a, #, #)",
        "{a} 1 1 1\nt.a. (a, {1}, a)\nu. ({a}, #, #)");
    row("a repeated parameter", "t.a.|a. (a, #, #)", "t.a.{a}. (a, #, #)");
    row("a transformation", "t. (#, #, #)\ny. [|t, #, t.] [t] x", "{t}. (#, #, #)\ny. [{t}, #, {t}.] [{t}] x");
    row("an object", "x. \"x.obj\"\nz<x>. x\n<$>. |x", "{x}. \"x.obj\"\nz<{x}>. {x}\n<$>. {x}");
    row("a recursive", "x. \"x.obj\"\n|z<x>. x\ny. z 3\n<$>. z 6", "x. \"x.obj\"\n{z}<x>. x\ny. {z} 3\n<$>. {z} 6");
    row("the result", "<$|>. x\n<$>. y", "{<$>}. x\n{<$>}. y");
    row("a path", "x. \"a|.obj\"\ny. \"b.obj\"\nz. \"a.obj\"", "x. {\"a.obj\"}\ny. \"b.obj\"\nz. {\"a.obj\"}");
    row("a path without its end", "x. \"a.obj\"\ny. \"a.ob|j", "x. {\"a.obj\"}\ny. {\"a.obj}");
    row("a repeated vector name", "a 1 1 1\nt. (|a, #, #)\na 2 2 2\nu. (a, 2, #)",
        "{a} 1 1 1\nt. ({a}, #, #)\na 2 2 2\nu. (a, 2, #)");
    row("the second of a repeated name", "a 1 1 1\n|a 2 2 2\nu. (a, 2, 1)", "a 1 1 1\n{a} 2 2 2\nu. (a, {2}, 1)");
    row("a name declared twice", "x. \"x.obj\"\n|x. \"y.obj\"\ny. x", "x. \"x.obj\"\n{x}. \"y.obj\"\ny. x");
    row("its first declaration", "x. \"x.obj\"\nx. \"y.obj\"\ny. |x", "{x}. \"x.obj\"\nx. \"y.obj\"\ny. {x}");
    row("a vector of a name that is taken", "x. \"x.obj\"\n|x 1 1 1\nt. (1, #, #)\ny. x",
        "x. \"x.obj\"\n{x} 1 1 1\nt. ({1}, #, #)\ny. x");
    row("of the wrong kind", "x. \"x.obj\"\ny. [|x] x", "{x}. \"x.obj\"\ny. [{x}] {x}");
    row("bad lines up to the error", "|x. \"x.obj\"\ny. [x.1 x] x\nz<x>. [",
        "{x}. \"x.obj\"\ny. [{x}.1 x] x\nz<{x}>. [");
    row("of a bad declaration", "|t nonsense\ny. [t] x", "{t} nonsense\ny. [{t}] x");
    row("a vector without a name", "1|a 1 1 1\nt. (1, #, #)", "{1a} 1 1 1\nt. ({1}, #, #)");
    row("declared below", "y. |x\nx. \"x.obj\"", "y. x\nx. \"x.obj\"");
    row("vector declared below", "t. (|1, #, #)\nv 1 1 1", "t. (1, #, #)\nv 1 1 1");
    row("no vector", "v 1 1 1\nt. (|0, 2, #)", "v 1 1 1\nt. (0, 2, #)");
    row("in a comment", "x. \"x.obj\" # |x", "x. \"x.obj\" # x");
    row("a depth", "x. \"x.obj\"\nz<x>. x\n<$>. z |6", "x. \"x.obj\"\nz<x>. x\n<$>. z 6");
}

void TestNavigation::usesAreAllWordsThatMeanTheSame()
{
    QFETCH(QString, marked);
    QTEST(usesDrawn(marked.toStdString()), "drawn");
}

void TestNavigation::wordsLeadToTheirDeclaration_data()
{
    QTest::addColumn<QString>("marked");
    QTest::addColumn<QString>("drawn");
    const auto row = [](const char *marked, const char *drawn) {
        QTest::newRow(oneLine(marked)) << QString::fromUtf8(marked) << QString::fromUtf8(drawn);
    };
    row("v 1 1 1\nv 2 2 2\nt. (|2, 1, #)", "v 1 1 1\n{v} 2 2 2\nt. (2, 1, #)");
    row("t.a. (|a, #, #)", "t.{a}. (a, #, #)");
    row("t. (#, #, #)\ny. [t|.] x", "{t}. (#, #, #)\ny. [t.] x");
    row("x. \"x.obj\"\nz<|x>. x", "{x}. \"x.obj\"\nz<x>. x");
    row("x. \"some fo|lder/x.obj\"", "file some folder/x.obj");
    row("x. \"x.ob|j", "file x.obj");
    row("x. \"|", "file ");
    row("<$>. x\n<|$>. x", "{<$>}. x\n<$>. x");
    row("|x. x", "{x}. x");
    row("x. |y", "nothing");
    row("|", "nothing");
    row("\u00E9. \"x.obj\"\r\ny. \u00E9|\r\n", "{\u00E9}. \"x.obj\"\r\ny. \u00E9\r\n");
}

void TestNavigation::wordsLeadToTheirDeclaration()
{
    QFETCH(QString, marked);
    QTEST(definitionDrawn(marked.toStdString()), "drawn");
}

void TestNavigation::pathsOfASceneLeadToTheirFiles()
{
    const auto leadsTo = [](const char *marked) {
        const MarkedText text(marked);
        const std::optional<Target> target = definition(SdoSyntax(text.text), text.offset);
        return target ? target->path.value() + ' ' + withRanges(text.text, {target->range}) : "nothing";
    };
    QCOMPARE(leadsTo("l # #\r\no \"car|.obj\" #"), "car.obj l # #\r\no {\"car.obj\"} #");
    QCOMPARE(leadsTo("f \"tree.fdo\"|"), "tree.fdo f {\"tree.fdo\"}");
    QCOMPARE(leadsTo("|o \"car.obj\" #"), "nothing");
    QCOMPARE(leadsTo("c # # |60"), "nothing");
    QCOMPARE(leadsTo("|o"), "nothing");
}

void TestNavigation::aCursorTouchesAWordAtEitherEnd()
{
    const FdoDocument document("x. \"x.obj\"\r\nyy. x\r\n");
    QString touched;
    for (std::size_t offset = 0; offset < endOfOffsets(document.syntax.text()); ++offset) {
        const std::optional<Occurrence> found = occurrenceAt(document, offset);
        touched += QLatin1Char(found ? document.syntax.text()[found->range.begin] : ' ');
    }
    QCOMPARE(touched, QStringLiteral("xx \"\"\"\"\"\"\"\" yyy xx     "));
}

void TestNavigation::renamesChangeTheWordsThatAreNames_data()
{
    QTest::addColumn<QString>("marked");
    QTest::addColumn<QString>("newName");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *marked, const char *newName, const char *expected) {
        QTest::newRow(oneLine(marked)) << QString::fromUtf8(marked) << QString::fromUtf8(newName)
                                       << QString::fromUtf8(expected);
    };
    row("half 1 1 1\nt. (|half, 1, #)", "third", "third 1 1 1\nt. (third, 1, #)");
    row("v 1 1 1\nt. (|1, 1, #)", "corner", "corner 1 1 1\nt. (1, 1, #)");
    row("|v 1 1 1\nv 2 2 2", "corner", "corner 1 1 1\nv 2 2 2");
    row("x. \"x.obj\"\nz<|x>. x", "\u00E9t\u00E9", "\u00E9t\u00E9. \"x.obj\"\nz<\u00E9t\u00E9>. \u00E9t\u00E9");
    row("a 1 1 1\nt.a.b. (|a, b, a)\nu. (a, #, #)", "c", "a 1 1 1\nt.c.b. (c, b, c)\nu. (a, #, #)");
    row("t.|a. (a, #, #)\nb. \"x.obj\"", "b", "t.b. (b, #, #)\nb. \"x.obj\"");
    row("b 1 1 1\nt.|a. (a, 1, #)", "b", "b 1 1 1\nt.b. (b, 1, #)"); // hides it, which nobody minds
    row("|a 1 1 1\nt.b. (1, b, #)", "b", "b 1 1 1\nt.b. (1, b, #)");
    row("|x. \"x.obj\"\nt.b. (b, #, #)", "b", "b. \"x.obj\"\nt.b. (b, #, #)");
    row("|x. \"x.obj\"", "x", "x. \"x.obj\"");
    row("x. \"x.obj\"\n|x. \"y.obj\"\ny. x", "w", "x. \"x.obj\"\nw. \"y.obj\"\ny. x");
    row("|t nonsense\ny. [t] x", "u", "u nonsense\ny. [u] x");
}

void TestNavigation::renamesChangeTheWordsThatAreNames()
{
    QFETCH(QString, marked);
    QFETCH(QString, newName);
    QTEST(renamed(marked.toStdString(), newName.toStdString()), "expected");
}

void TestNavigation::renamesThatAreRefused_data()
{
    QTest::addColumn<QString>("marked");
    QTest::addColumn<QString>("newName");
    QTest::addColumn<QString>("why");
    const auto row = [](const char *marked, const char *newName, const char *why) {
        QTest::addRow("%s to %s", oneLine(marked).constData(), newName)
            << QString::fromUtf8(marked) << QString::fromUtf8(newName) << QString::fromUtf8(why);
    };
    const char *const notAName = "\"%1\" is not a name: a letter or _, then letters, digits and _.";
    for (const char *const name : {"", "1a", "a b", "a.", "#", "a\u2013", "<$>"}) {
        row("|x. \"x.obj\"", name, QString::fromUtf8(notAName).arg(QString::fromUtf8(name)).toUtf8().constData());
    }
    row("|x. \"x.obj\"", "v", "v is the name that all vectors may have; choose another.");
    row("t.|a. (a, #, #)", "v", "v is the name that all vectors may have; choose another.");
    row("x. \"x.obj\"\n|y. x", "x", "x is declared already, in line 1.");
    row("|x. \"x.obj\"\nb 1 1 1", "b", "b is declared already, in line 2.");
    row("t.|a.b. (a, b, #)", "b", "This transformation has a parameter b already.");
    row("b 1 1 1\nt.|a. (a, b, #)", "b", "This transformation uses the vector b, which the parameter would hide.");
    row("|a 1 1 1\nt.b. (a, b, #)", "b", "In line 2 the parameter b would hide it.");
    row("<|$>. x", "r", "<$> is the result and cannot be renamed.");
    row("x. \"|x.obj\"", "r", "A file is renamed on the disk, not in the text.");
    row("x. |y", "r", "No name that is declared stands here.");
    row("|1a 1 1 1", "r", "This vector's line has no name yet.");
}

void TestNavigation::renamesThatAreRefused()
{
    QFETCH(QString, marked);
    QFETCH(QString, newName);
    QTEST(renamed(marked.toStdString(), newName.toStdString()), "why");
}

void TestNavigation::onlyWhatHasANameCanBeRenamed()
{
    const auto drawn = [](const char *marked) {
        const auto [document, offset] = MarkedDocument(marked);
        const std::optional<SourceRange> range = renamable(document, offset);
        return range ? withRanges(document.syntax.text(), {*range}) : "nothing";
    };
    QCOMPARE(drawn("half 1 1 1\nt. (hal|f, 1, #)"), "half 1 1 1\nt. ({half}, 1, #)");
    QCOMPARE(drawn("half 1 1 1\nt. (half, |1, #)"), "{half} 1 1 1\nt. (half, 1, #)");
    QCOMPARE(drawn("1a 1 1 1\nt. (|1, #, #)"), "nothing");
    QCOMPARE(drawn("<|$>. x"), "nothing");
    QCOMPARE(drawn("x. \"x|.obj\""), "nothing");
}

void TestNavigation::aRenameKeepsTheMeaningAndCanBeUndone()
{
    QVERIFY(rc::check([] {
        const std::string text = *validFdo();
        const FdoDocument document(text);
        const FdoResult before = readFdo(text);
        RC_ASSERT(!hasErrors(before.diagnostics));
        const std::size_t offset = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
        const std::optional<SourceRange> word = renamable(document, offset);
        RC_PRE(word.has_value());

        const std::string newName = *rc::gen::element<std::string>("p", "q", "new", "\u00FC", "a1", "v2", "t3");
        const auto edits = rename(document, offset, newName);
        RC_TAG(edits ? "renamed" : "refused");
        if (!edits) {
            return;
        }
        const std::string changed = applied(text, *edits);
        const FdoResult after = readFdo(changed);
        RC_ASSERT(!hasErrors(after.diagnostics));
        RC_ASSERT(meanTheSame(*before.description, *after.description));

        const std::string oldName = text.substr(word->begin, word->length());
        if (oldName != "v" && !edits->empty()) {
            const FdoDocument changedDocument(changed);
            const auto back = rename(changedDocument, edits->front().range.begin, oldName);
            RC_ASSERT(back.has_value());
            RC_ASSERT(applied(changed, *back) == text);
        }
    }));
}

void TestNavigation::anyBytesAndAnyOffset()
{
    QVERIFY(rc::check([] {
        const std::string text = *anyBytes();
        const FdoDocument document(text);
        const SdoSyntax scene(text);
        for (std::size_t offset = 0; offset < endOfOffsets(text); ++offset) {
            const std::optional<Target> file = definition(scene, offset);
            RC_ASSERT((!file || (file->range.begin < file->range.end && file->range.end <= text.size())));
            const std::vector<Occurrence> found = uses(document, offset);
            const std::optional<Occurrence> here = occurrenceAt(document, offset);
            RC_ASSERT((here ? std::ranges::contains(found, here->range, &Occurrence::range) : found.empty()));
            std::size_t last = 0;
            for (const Occurrence &occurrence : found) {
                RC_ASSERT(last <= occurrence.range.begin);
                RC_ASSERT(occurrence.range.begin <= occurrence.range.end);
                RC_ASSERT(occurrence.range.end <= text.size());
                last = occurrence.range.end;
            }
            const std::optional<Target> target = definition(document, offset);
            RC_ASSERT(target.has_value() == here.has_value());
            RC_ASSERT((!target || target->range.end <= text.size()));
            if (const auto edits = rename(document, offset, "new_name")) {
                RC_ASSERT(renamable(document, offset).has_value());
                (void)applied(text, *edits);
            }
        }
    }));
}

}

ROMANESCO_TEST(romanesco::test::TestNavigation)

#include "testnavigation.moc"
