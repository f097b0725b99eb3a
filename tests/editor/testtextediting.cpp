// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QPlainTextEdit>
#include <QTest>

#include "editor/documentbytes.h"
#include "editor/textediting.h"
#include "editsample.h"

using namespace romanesco;
using namespace romanesco::test;

/// Edits of a text in an editor. In the samples | is the cursor, and [ the other end of a selection.
class TestTextEditing : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theCursorStaysAtItsWord_data();
    void theCursorStaysAtItsWord();
    void manyEditsAreOneUndoStep();
    void linesBecomeCommentsAndBack_data();
    void linesBecomeCommentsAndBack();
    void linesAreDuplicated_data();
    void linesAreDuplicated();
    void lineEndsAreDuplicatedToo();
    void aReadOnlyTextStays();
};

void TestTextEditing::theCursorStaysAtItsWord_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<int>("begin");
    QTest::addColumn<int>("end");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("after");
    QTest::newRow("far behind") << "ä bb  cc|" << 4 << 6 << " " << "ä bb cc|";
    QTest::newRow("far before") << "|ä bb  cc" << 4 << 6 << " " << "|ä bb cc";
    QTest::newRow("at the end of the word before a gap") << "bb|  cc" << 2 << 4 << "   " << "bb|   cc";
    QTest::newRow("at the start of the word after a gap") << "bb  |cc" << 2 << 4 << " " << "bb |cc";
    QTest::newRow("in a gap") << "bb  |  cc" << 2 << 6 << " " << "bb |cc";
    QTest::newRow("in front of what moves") << "bb |cc" << 3 << 3 << "  " << "bb   |cc";
    QTest::newRow("behind what is added to") << "bb| cc" << 2 << 2 << "x" << "bb|x cc";
    QTest::newRow("at the start of a new name") << "|bb cc" << 0 << 2 << "long" << "|long cc";
    QTest::newRow("at the end of a new name") << "bb| cc" << 0 << 2 << "long" << "long| cc";
    QTest::newRow("in a new name") << "bbb|b cc" << 0 << 4 << "s" << "s| cc";
    QTest::newRow("a selection") << "[bb  cc|" << 2 << 4 << " " << "[bb cc|";
}

void TestTextEditing::theCursorStaysAtItsWord()
{
    QFETCH(const QString, before);
    QFETCH(const int, begin);
    QFETCH(const int, end);
    QFETCH(const QString, text);
    QFETCH(const QString, after);
    QPlainTextEdit editor;
    setMarked(editor, before);
    const TextSnapshot snapshot(*editor.document());
    const SourceRange range{snapshot.offset(begin), snapshot.offset(end)};
    applyEdits(editor, {{range, text.toStdString()}}, snapshot);
    QCOMPARE(marked(editor), after);
    editor.undo();
    QCOMPARE(editor.toPlainText(), unmarked(before));
}

void TestTextEditing::manyEditsAreOneUndoStep()
{
    QPlainTextEdit editor;
    setMarked(editor, QStringLiteral("ä b\n🌲 b|"));
    const TextSnapshot snapshot(*editor.document());
    applyEdits(editor, {{{0, 2}, "first"}, {{3, 4}, ""}, {{5, 9}, "🌳"}}, snapshot);
    QCOMPARE(editor.toPlainText(), QStringLiteral("first \n🌳 b"));
    editor.undo();
    QCOMPARE(editor.toPlainText(), QStringLiteral("ä b\n🌲 b"));
    QVERIFY(!editor.document()->isUndoAvailable());
}

void TestTextEditing::linesBecomeCommentsAndBack_data()
{
    QTest::addColumn<QString>("plain");
    QTest::addColumn<QString>("commented");
    QTest::newRow("one") << "a\nv| 1\nb" << "a\n# v| 1\nb";
    QTest::newRow("several") << "[a\n\n  b\nc|" << "[# a\n\n#   b\n# c|";
    QTest::newRow("not the one it ends at") << "[a\n|b" << "[# a\n|b";
    QTest::newRow("one that is one already") << "[# a\nb|" << "[# # a\n# b|";
}

void TestTextEditing::linesBecomeCommentsAndBack()
{
    QFETCH(const QString, plain);
    QFETCH(const QString, commented);
    QPlainTextEdit editor;
    setMarked(editor, plain);
    toggleComment(editor);
    QCOMPARE(editor.toPlainText(), unmarked(commented));
    toggleComment(editor);
    QCOMPARE(editor.toPlainText(), unmarked(plain));
    editor.undo();
    QCOMPARE(editor.toPlainText(), unmarked(commented));
    editor.undo();
    QCOMPARE(editor.toPlainText(), unmarked(plain));
}

void TestTextEditing::linesAreDuplicated_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    QTest::newRow("one") << "a\nb|c\nd" << "a\nbc\nb|c\nd";
    QTest::newRow("the last") << "a\nb|" << "a\nb\nb|";
    QTest::newRow("an empty one") << "a\n|\nb" << "a\n\n|\nb";
    QTest::newRow("several") << "x[a\nb|c\nd" << "xa\nbc\nx[a\nb|c\nd";
    QTest::newRow("with the end of the last") << "[a\nb\n|c" << "a\nb\n[a\nb\n|c";
    QTest::newRow("beyond the basic plane") << "🌲|" << "🌲\n🌲|";
}

void TestTextEditing::linesAreDuplicated()
{
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    QPlainTextEdit editor;
    setMarked(editor, before);
    duplicateLines(editor);
    QCOMPARE(marked(editor), after);
    editor.undo();
    QCOMPARE(editor.toPlainText(), unmarked(before));
}

void TestTextEditing::lineEndsAreDuplicatedToo()
{
    QPlainTextEdit editor;
    QVERIFY(loadBytes(*editor.document(), "a\r\nb\nc\r\nd"));
    QTextCursor cursor(editor.document());
    editor.setTextCursor(cursor);
    duplicateLines(editor);
    QCOMPARE(toBytes(*editor.document(), false), QByteArray("a\r\na\r\nb\nc\r\nd"));
    editor.undo();
    cursor.movePosition(QTextCursor::Start);
    cursor.movePosition(QTextCursor::NextBlock, QTextCursor::KeepAnchor, 2);
    editor.setTextCursor(cursor);
    duplicateLines(editor);
    QCOMPARE(toBytes(*editor.document(), false), QByteArray("a\r\nb\na\r\nb\nc\r\nd"));
}

void TestTextEditing::aReadOnlyTextStays()
{
    QPlainTextEdit editor;
    setMarked(editor, QStringLiteral("a|"));
    editor.setReadOnly(true);
    applyEdits(editor, {{{0, 1}, "b"}}, TextSnapshot(*editor.document()));
    toggleComment(editor);
    duplicateLines(editor);
    QCOMPARE(editor.toPlainText(), QStringLiteral("a"));
}

QTEST_MAIN(TestTextEditing)
#include "testtextediting.moc"
