// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTest>

#include "editor/textnumber.h"

using namespace romanesco;

namespace {

const QString before = QStringLiteral("# bäume\n<$>. z ");
const QString after = QStringLiteral(" # end\n");

/// An editor with a number in its text, which is tracked.
struct Sample {
    QPlainTextEdit editor;
    TextNumber number{editor};

    explicit Sample(const QString &digits = QStringLiteral("7"))
    {
        editor.setPlainText(before + digits + after);
        number.track(int(before.size()), int(before.size() + digits.size()));
    }
    [[nodiscard]] QString text() const { return editor.toPlainText(); }
    void select(int anchor, int position)
    {
        QTextCursor cursor = editor.textCursor();
        cursor.setPosition(anchor);
        cursor.setPosition(position, QTextCursor::KeepAnchor);
        editor.setTextCursor(cursor);
    }
};

}

class TestTextNumber : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void settingIsOneUndoStep();
    void aGestureIsOneUndoStep();
    void whatIsTypedDuringAGestureIsNotUndoneWithIt();
    void twoGesturesAreTwoSteps();
    void theOldValueIsNoEdit();
    void cursorAndSelectionStay_data();
    void cursorAndSelectionStay();
    void theViewStays();
    void theNumberIsFoundAgainAfterEdits();
    void whatIsNoNumberIsLeftAlone();
    void aReadOnlyTextStays();
};

void TestTextNumber::settingIsOneUndoStep()
{
    Sample sample;
    const QString original = sample.text();
    sample.number.setValue(12);
    QCOMPARE(sample.text(), before + QStringLiteral("12") + after);
    sample.editor.undo();
    QCOMPARE(sample.text(), original);
    QVERIFY(!sample.editor.document()->isUndoAvailable());
}

void TestTextNumber::aGestureIsOneUndoStep()
{
    Sample sample;
    QTextCursor typing(sample.editor.document());
    typing.insertText(QStringLiteral("#"));
    const QString original = sample.text();

    sample.number.beginGesture();
    for (const quint64 value : {8u, 9u, 10u, 11u, 3u}) {
        sample.number.setValue(value);
    }
    sample.number.endGesture();
    QCOMPARE(sample.number.value(), std::optional<quint64>(3));
    sample.editor.undo();
    QCOMPARE(sample.text(), original);
    sample.editor.redo();
    QCOMPARE(sample.text(), QStringLiteral("#") + before + QStringLiteral("3") + after);
}

void TestTextNumber::whatIsTypedDuringAGestureIsNotUndoneWithIt()
{
    Sample sample;
    sample.number.beginGesture();
    sample.number.setValue(8);
    // Replacing a selection is an edit of two parts, which Qt would join to.
    QTextCursor typing(sample.editor.document());
    typing.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    typing.insertText(QStringLiteral("typed"));
    sample.number.setValue(9);
    sample.number.endGesture();
    sample.editor.undo();
    QCOMPARE(sample.text(), QStringLiteral("typed") + before.sliced(1) + QStringLiteral("8") + after);
}

void TestTextNumber::twoGesturesAreTwoSteps()
{
    Sample sample;
    for (const quint64 value : {8u, 9u}) {
        sample.number.beginGesture();
        sample.number.setValue(value);
        sample.number.endGesture();
    }
    sample.editor.undo();
    QCOMPARE(sample.text(), before + QStringLiteral("8") + after);
}

void TestTextNumber::theOldValueIsNoEdit()
{
    Sample sample(QStringLiteral("07"));
    sample.number.setValue(7);
    QVERIFY(!sample.editor.document()->isModified());
    QCOMPARE(sample.text(), before + QStringLiteral("07") + after);
}

void TestTextNumber::cursorAndSelectionStay_data()
{
    QTest::addColumn<int>("anchor");
    QTest::addColumn<int>("position");
    QTest::addColumn<int>("newAnchor");
    QTest::addColumn<int>("newPosition");
    // "77" at [begin, end) becomes "5".
    const int begin = int(before.size());
    const int end = begin + 2;
    const auto row = [](const char *name, int a, int p, int na, int np) { QTest::newRow(name) << a << p << na << np; };
    row("before", 2, 2, 2, 2);
    row("at its begin", begin, begin, begin, begin);
    row("inside", begin + 1, begin + 1, begin + 1, begin + 1);
    row("at its end", end, end, end - 1, end - 1);
    row("after", end + 3, end + 3, end + 2, end + 2);
    row("the number selected", begin, end, begin, end - 1);
    row("selected backwards", end, begin, end - 1, begin);
    row("all selected", 0, end + 3, 0, end + 2);
    row("selected up to it", 2, begin, 2, begin);
}

void TestTextNumber::cursorAndSelectionStay()
{
    QFETCH(const int, anchor);
    QFETCH(const int, position);
    Sample sample(QStringLiteral("77"));
    sample.select(anchor, position);
    sample.number.setValue(5);
    QTEST(sample.editor.textCursor().anchor(), "newAnchor");
    QTEST(sample.editor.textCursor().position(), "newPosition");
}

void TestTextNumber::theViewStays()
{
    Sample sample;
    QTextCursor end(sample.editor.document());
    end.movePosition(QTextCursor::End);
    end.insertText(QString(200, u'\n'));
    sample.editor.resize(300, 200);
    sample.editor.show();
    const int begin = int(before.size());
    sample.select(begin, begin);
    sample.editor.verticalScrollBar()->setValue(100);
    QCOMPARE(sample.editor.verticalScrollBar()->value(), 100);
    sample.number.setValue(12);
    QCOMPARE(sample.editor.verticalScrollBar()->value(), 100);
    QCOMPARE(sample.editor.textCursor().position(), begin);
}

void TestTextNumber::theNumberIsFoundAgainAfterEdits()
{
    Sample sample;
    QTextCursor typing(sample.editor.document());
    typing.insertText(QStringLiteral("new line\n"));
    sample.number.setValue(8);
    QCOMPARE(sample.text(), QStringLiteral("new line\n") + before + QStringLiteral("8") + after);
}

void TestTextNumber::whatIsNoNumberIsLeftAlone()
{
    Sample sample;
    sample.select(int(before.size()), int(before.size()) + 1);
    sample.editor.textCursor().insertText(QStringLiteral("x"));
    const QString text = sample.text();
    QCOMPARE(sample.number.value(), std::nullopt);
    sample.number.setValue(8);
    QCOMPARE(sample.text(), text);

    sample.number.clear();
    QCOMPARE(sample.number.value(), std::nullopt);
    sample.number.setValue(8);
    QCOMPARE(sample.text(), text);
}

void TestTextNumber::aReadOnlyTextStays()
{
    Sample sample;
    const QString text = sample.text();
    sample.editor.setReadOnly(true);
    sample.number.setValue(8);
    QCOMPARE(sample.text(), text);
}

QTEST_MAIN(TestTextNumber)
#include "testtextnumber.moc"
