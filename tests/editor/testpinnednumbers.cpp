// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QMenu>
#include <QTest>

#include "editor/fdoeditor.h"
#include "editor/pinnednumbers.h"

using namespace romanesco;

namespace {

const QString text = QStringLiteral("# half 0.5\nhalf 0.50 1 2\nv 3 4 5\n<$>. z 6\n");

struct Sample {
    FdoEditor editor;
    PinnedNumbers &numbers = editor.pinnedNumbers();

    Sample()
    {
        editor.setFileName(QStringLiteral("a.fdo"));
        editor.setPlainText(text);
        editor.resize(500, 300);
        editor.show();
    }
    [[nodiscard]] int placeOf(const QString &word) const { return editor.document()->find(word).selectionStart(); }
    bool pin(const QString &word) const { return numbers.pin(placeOf(word)); }
    [[nodiscard]] QStringList pins() const
    {
        QStringList found;
        for (const PinnedNumbers::Pin &pin : numbers.pins()) {
            found << QStringLiteral("%1 %2: %3").arg(pin.line).arg(pin.name, pin.number);
        }
        return found;
    }
    [[nodiscard]] int id(std::size_t index = 0) const { return numbers.pins()[index].id; }
    void replace(const QString &before, const QString &after)
    {
        editor.setTextCursor(editor.document()->find(before));
        editor.insertPlainText(after);
    }
};

}

/// Numbers that are followed through edits, and moved.
class TestPinnedNumbers : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void onlyNumbersArePinned();
    void theMenuPins();
    void theKeyOfTheMenuPinsAtTheCursor();
    void stepsKeepTheDecimals();
    void aGestureIsOneStepBack();
    void placesAreFollowed();
    void whatGoesIsForgotten_data();
    void whatGoesIsForgotten();
    void wholeNumbersStayAboveTheirLeast();
    void unpinnedItIsGone();
};

void TestPinnedNumbers::onlyNumbersArePinned()
{
    const Sample sample;
    QVERIFY(!sample.numbers.pin(2)); // in the comment
    QVERIFY(!sample.pin(QStringLiteral("half 0.50")));
    QVERIFY(sample.pin(QStringLiteral("0.50")));
    QVERIFY(!sample.pin(QStringLiteral("0.50")));
    QVERIFY(sample.pin(QStringLiteral("6")));
    QCOMPARE(sample.pins(), (QStringList{QStringLiteral("2 half: 0.50"), QStringLiteral("4 <$>: 6")}));
}

void TestPinnedNumbers::theMenuPins()
{
    Sample sample;
    const auto entryAt = [&](const QString &word) -> QAction * {
        QTextCursor cursor(sample.editor.document());
        cursor.setPosition(sample.placeOf(word) + 1);
        const QPoint place = sample.editor.cursorRect(cursor).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, sample.editor.viewport()->mapToGlobal(place));
        QApplication::sendEvent(sample.editor.viewport(), &event);
        const auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        for (QAction *action : menu ? menu->actions() : QList<QAction *>()) {
            if (action->text().contains(QStringLiteral("Slider"))) {
                return action;
            }
        }
        return nullptr;
    };
    QVERIFY(!entryAt(QStringLiteral("half 0.50")));
    QVERIFY(QApplication::activePopupWidget());
    QApplication::activePopupWidget()->close();
    QAction *pin = entryAt(QStringLiteral("0.50"));
    QVERIFY(pin);
    pin->trigger();
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("2 half: 0.50")});
    QApplication::activePopupWidget()->close();
    sample.editor.setReadOnly(true);
    pin = entryAt(QStringLiteral("0.50"));
    QVERIFY(pin && !pin->isEnabled());
    QApplication::activePopupWidget()->close();
}

void TestPinnedNumbers::theKeyOfTheMenuPinsAtTheCursor()
{
    Sample sample;
    QTextCursor cursor = sample.editor.textCursor();
    cursor.setPosition(sample.placeOf(QStringLiteral("3 4 5")));
    sample.editor.setTextCursor(cursor);
    const QPoint place = sample.editor.cursorRect().center();
    QContextMenuEvent event(QContextMenuEvent::Keyboard, place, sample.editor.viewport()->mapToGlobal(place));
    QApplication::sendEvent(sample.editor.viewport(), &event);
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    QVERIFY(menu);
    QTest::keyClick(menu, Qt::Key_Up); // the last
    QTest::keyClick(menu, Qt::Key_Return);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 v: 3")});
}

void TestPinnedNumbers::stepsKeepTheDecimals()
{
    const Sample sample;
    QVERIFY(sample.pin(QStringLiteral("0.50")));
    sample.numbers.step(sample.id(), 7);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("2 half: 0.57")});
    sample.numbers.step(sample.id(), -57);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("2 half: 0.00")});
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("half 0.00 1 2\n")));
}

void TestPinnedNumbers::aGestureIsOneStepBack()
{
    Sample sample;
    QVERIFY(sample.pin(QStringLiteral("0.50")));
    sample.numbers.beginGesture(sample.id());
    for (const int steps : {1, 90, -30, 12}) {
        sample.numbers.step(sample.id(), steps);
    }
    sample.numbers.endGesture(sample.id());
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("2 half: 0.62")});
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText(), text);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("2 half: 0.50")});
    sample.editor.redo();
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("2 half: 0.62")});
}

void TestPinnedNumbers::placesAreFollowed()
{
    Sample sample;
    QVERIFY(sample.pin(QStringLiteral("0.50")));
    sample.replace(QStringLiteral("# half 0.5"), QStringLiteral("# more\nv 0 0 0"));
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 half: 0.50")});
    sample.replace(QStringLiteral("half"), QStringLiteral("third"));
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 third: 0.50")});
    // Another in its place, which is then typed in.
    sample.replace(QStringLiteral(" 0.50"), QStringLiteral(" -10.507"));
    QTextCursor cursor = sample.editor.document()->find(QStringLiteral(".507"));
    cursor.setPosition(cursor.selectionStart());
    sample.editor.setTextCursor(cursor);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 third: -10.507")});
    QTest::keyClicks(&sample.editor, QStringLiteral("2"));
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 third: -102.507")});
    sample.editor.moveCursor(QTextCursor::EndOfWord);
    sample.numbers.step(sample.id(), 1);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 third: -102.506")});
}

void TestPinnedNumbers::whatGoesIsForgotten_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    QTest::newRow("deleted") << "0.50" << "";
    QTest::newRow("with the blank") << "0.50 " << "";
    QTest::newRow("its line") << "half 0.50 1 2" << "";
    QTest::newRow("a name now") << "0.50" << "x";
    QTest::newRow("a comment now") << "half 0.50" << "# half 0.50";
}

void TestPinnedNumbers::whatGoesIsForgotten()
{
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    Sample sample;
    QVERIFY(sample.pin(QStringLiteral("0.50")));
    int changes = 0;
    connect(&sample.numbers, &PinnedNumbers::changed, this, [&changes] { ++changes; });
    sample.replace(before, after);
    QCOMPARE(sample.pins(), QStringList());
    QVERIFY(changes > 0);
}

void TestPinnedNumbers::wholeNumbersStayAboveTheirLeast()
{
    const Sample sample;
    QVERIFY(sample.pin(QStringLiteral("6")));
    sample.numbers.step(sample.id(), -50);
    QVERIFY(sample.editor.toPlainText().endsWith(QStringLiteral("z 0\n")));
}

void TestPinnedNumbers::unpinnedItIsGone()
{
    const Sample sample;
    QVERIFY(sample.pin(QStringLiteral("0.50")) && sample.pin(QStringLiteral("3")));
    const int first = sample.id();
    sample.numbers.unpin(first);
    QCOMPARE(sample.pins(), QStringList{QStringLiteral("3 v: 3")});
    sample.numbers.step(first, 1);
    QCOMPARE(sample.editor.toPlainText(), text);
}

QTEST_MAIN(TestPinnedNumbers)
#include "testpinnednumbers.moc"
