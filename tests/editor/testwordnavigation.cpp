// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "core/formats/fdoreader.h"
#include "editor/fdoeditor.h"

using namespace romanesco;

namespace {

const QString sample =
    QStringLiteral("# größe 🌲 half\nhalf 0.5 0.5 0.5\nt. (#, #, half)\nu.a. (#, #, a)\nx. \"b/größe.obj\"\n"
                   "z<x>. [#, t, u.1] x\n<$>. z 3\n");

int at(const char *words, int further = 0)
{
    return int(sample.indexOf(QString::fromUtf8(words))) + further;
}

}

/// Ways from word to word, by key and by mouse.
class TestWordNavigation : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void wordsLeadToTheirDeclarations_data();
    void wordsLeadToTheirDeclarations();
    void aWordThatLeadsNowhereSaysSo();
    void aPathAsksForItsFile();
    void inAScenePathsLeadToo();
    void ctrlMakesALinkOfTheWordUnderTheMouse();
    void aClickWithCtrlFollows();
    void aDragWithCtrlDoesNot();
    void aClickWithoutCtrlOnlyMovesTheCursor();
    void usesStandOutOnceTheCursorRests();
    void marksGoWithTheirText();
    void usesGoRound();
    void renamingIsOneUndoStep();
    void aBadNameIsRefusedInWords();
    void escapeLeavesTheName();
    void whatHasNoNameIsNotRenamed();
    void formattingKeepsTheCursorAtItsWord();
    void scenesAreFormattedToo();
    void linesAreGoneToByNumber();
    void aReadOnlyTextStays();

private:
    void putCursor(int position);
    QPoint pointAt(int position);
    void move(const QPoint &point, Qt::KeyboardModifiers modifiers);
    void type(const QString &text);
    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
    [[nodiscard]] int cursor() const { return m_editor->textCursor().position(); }
    [[nodiscard]] QLineEdit *line() const { return m_editor->findChild<QLineEdit *>(); }
    QStringList marked(MarkLayer layer);

    std::unique_ptr<FdoEditor> m_editor;
};

void TestWordNavigation::init()
{
    m_editor = std::make_unique<FdoEditor>();
    m_editor->resize(600, 400);
    m_editor->setFileName(QStringLiteral("a.fdo"));
    m_editor->setPlainText(sample);
    m_editor->show();
    QVERIFY(QTest::qWaitForWindowActive(m_editor.get()));
    m_editor->setFocus();
    QToolTip::hideText();
    QVERIFY(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
}

void TestWordNavigation::putCursor(int position)
{
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(position);
    m_editor->setTextCursor(cursor);
}

QPoint TestWordNavigation::pointAt(int position)
{
    QTextCursor cursor(m_editor->document());
    cursor.setPosition(position);
    return m_editor->cursorRect(cursor).center() + QPoint(2, 0);
}

void TestWordNavigation::move(const QPoint &point, Qt::KeyboardModifiers modifiers)
{
    QMouseEvent event(QEvent::MouseMove, point, m_editor->viewport()->mapToGlobal(point), Qt::NoButton, Qt::NoButton,
                      modifiers);
    QCoreApplication::sendEvent(m_editor->viewport(), &event);
}

void TestWordNavigation::type(const QString &text)
{
    for (const QChar c : text) {
        QTest::sendKeyEvent(QTest::Click, QApplication::focusWidget(), Qt::Key_unknown, QString(c), Qt::NoModifier);
    }
}

QStringList TestWordNavigation::marked(MarkLayer layer)
{
    QStringList words;
    for (const TextStretch stretch : m_editor->marks().stretches(layer)) {
        words += m_editor->toPlainText().sliced(stretch.begin, stretch.end - stretch.begin);
    }
    return words;
}

void TestWordNavigation::wordsLeadToTheirDeclarations_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::newRow("vector") << at("half)") << at("half 0.5");
    QTest::newRow("vector by number") << at("1]") << at("half 0.5");
    QTest::newRow("transformation") << at("t, u") << at("t. (");
    QTest::newRow("parameter") << at("a)") << at("a. (");
    QTest::newRow("object") << at("x>") << at("x. \"");
    QTest::newRow("recursive, behind it") << at("z 3", 1) << at("z<x");
}

void TestWordNavigation::wordsLeadToTheirDeclarations()
{
    QFETCH(const int, from);
    QFETCH(const int, to);
    putCursor(from);
    m_editor->goToDefinition();
    QCOMPARE(cursor(), to);
    QVERIFY(!m_editor->textCursor().hasSelection());
}

void TestWordNavigation::aWordThatLeadsNowhereSaysSo()
{
    putCursor(2);
    m_editor->goToDefinition();
    QCOMPARE(cursor(), 2);
    QVERIFY(QToolTip::isVisible());
}

void TestWordNavigation::aPathAsksForItsFile()
{
    QSignalSpy asked(m_editor.get(), &FdoEditor::openFileRequested);
    putCursor(at("b/"));
    m_editor->goToDefinition();
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked[0][0].toString(), QStringLiteral("b/größe.obj"));
}

void TestWordNavigation::inAScenePathsLeadToo()
{
    m_editor->setFileName(QStringLiteral("a.sdo"));
    m_editor->setPlainText(QStringLiteral("f \"tree.fdo\" #"));
    QSignalSpy asked(m_editor.get(), &FdoEditor::openFileRequested);
    putCursor(5);
    m_editor->goToDefinition();
    QCOMPARE(asked.value(0).value(0).toString(), QStringLiteral("tree.fdo"));
}

void TestWordNavigation::ctrlMakesALinkOfTheWordUnderTheMouse()
{
    const QPoint word = pointAt(at("half)", 1));
    move(word, Qt::NoModifier);
    QVERIFY(marked(MarkLayer::Link).isEmpty());
    QTest::keyPress(m_editor.get(), Qt::Key_Control);
    QCOMPARE(marked(MarkLayer::Link), QStringList{"half"});
    QCOMPARE(m_editor->viewport()->cursor().shape(), Qt::PointingHandCursor);
    move(pointAt(2), Qt::ControlModifier);
    QVERIFY(marked(MarkLayer::Link).isEmpty());
    QCOMPARE(m_editor->viewport()->cursor().shape(), Qt::IBeamCursor);
    move(word, Qt::ControlModifier);
    QCOMPARE(marked(MarkLayer::Link), QStringList{"half"});
    QTest::keyRelease(m_editor.get(), Qt::Key_Control);
    QVERIFY(marked(MarkLayer::Link).isEmpty());
    move(word, Qt::ControlModifier);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(m_editor->viewport(), &leave);
    QVERIFY(marked(MarkLayer::Link).isEmpty());
}

void TestWordNavigation::aClickWithCtrlFollows()
{
    QTest::mouseClick(m_editor->viewport(), Qt::LeftButton, Qt::ControlModifier, pointAt(at("half)", 1)));
    QCOMPARE(cursor(), at("half 0.5"));
}

void TestWordNavigation::aDragWithCtrlDoesNot()
{
    const QPoint from = pointAt(at("half)", 1));
    const QPoint to = pointAt(at("t, u"));
    QTest::mousePress(m_editor->viewport(), Qt::LeftButton, Qt::ControlModifier, from);
    QTest::mouseRelease(m_editor->viewport(), Qt::LeftButton, Qt::ControlModifier, to);
    QCOMPARE(cursor(), 0);
}

void TestWordNavigation::aClickWithoutCtrlOnlyMovesTheCursor()
{
    QTest::mouseClick(m_editor->viewport(), Qt::LeftButton, Qt::NoModifier, pointAt(at("half)", 1)));
    QVERIFY(cursor() >= at("half)") && cursor() <= at("half)", 4));
}

void TestWordNavigation::usesStandOutOnceTheCursorRests()
{
    putCursor(at("half)", 2));
    QVERIFY(QTest::qWaitFor([&] { return !marked(MarkLayer::Uses).isEmpty(); }));
    QCOMPARE(marked(MarkLayer::Uses), (QStringList{"half", "half", "1"}));
    QStringList shown;
    for (const QTextEdit::ExtraSelection &selection : m_editor->extraSelections()) {
        if (selection.cursor.hasSelection()) {
            shown += selection.cursor.selectedText();
        }
    }
    QCOMPARE(shown, (QStringList{"half", "half", "1"}));
}

void TestWordNavigation::marksGoWithTheirText()
{
    m_editor->mark(MarkLayer::Uses, {{0, 5}}, {});
    putCursor(0);
    type(QStringLiteral("#"));
    QVERIFY(marked(MarkLayer::Uses).isEmpty());
}

void TestWordNavigation::usesGoRound()
{
    putCursor(at("half)", 1));
    for (const int expected : {at("1]"), at("half 0.5"), at("half)")}) {
        m_editor->goToNextUse();
        QCOMPARE(cursor(), expected);
    }
    m_editor->goToPreviousUse();
    QCOMPARE(cursor(), at("half 0.5"));
    m_editor->goToPreviousUse();
    QCOMPARE(cursor(), at("1]"));
    putCursor(2);
    m_editor->goToNextUse();
    QCOMPARE(cursor(), 2);
}

void TestWordNavigation::renamingIsOneUndoStep()
{
    putCursor(at("half)", 1));
    m_editor->rename();
    QVERIFY(line() && line()->hasFocus());
    QCOMPARE(line()->text(), QStringLiteral("half"));
    QVERIFY(!line()->accessibleName().isEmpty());
    type(QStringLiteral("hälfte"));
    press(Qt::Key_Return);
    QCOMPARE(m_editor->toPlainText(),
             QString(sample)
                 .replace(QLatin1String("half 0"), QStringLiteral("hälfte 0"))
                 .replace(QLatin1String("half)"), QStringLiteral("hälfte)")));
    QVERIFY(m_editor->hasFocus());
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample);
    QVERIFY(!m_editor->document()->isUndoAvailable());
}

void TestWordNavigation::aBadNameIsRefusedInWords()
{
    putCursor(at("half)", 1));
    m_editor->rename();
    const QLabel *reason = m_editor->findChild<QLabel *>();
    QVERIFY(!reason->isVisible());
    type(QStringLiteral("t"));
    QVERIFY(reason->isVisible());
    QVERIFY(reason->text().contains(QLatin1String("declared already, in line 3")));
    press(Qt::Key_Return);
    QVERIFY(line()->isVisible());
    QCOMPARE(m_editor->toPlainText(), sample);
    type(QStringLiteral("t"));
    QVERIFY(!reason->isVisible());
}

void TestWordNavigation::escapeLeavesTheName()
{
    putCursor(at("half)", 1));
    m_editor->rename();
    type(QStringLiteral("other"));
    press(Qt::Key_Escape);
    QCOMPARE(m_editor->toPlainText(), sample);
    QVERIFY(m_editor->hasFocus());
    QVERIFY(QTest::qWaitFor([&] { return line() == nullptr; }));
}

void TestWordNavigation::whatHasNoNameIsNotRenamed()
{
    putCursor(at("<$>"));
    m_editor->rename();
    QVERIFY(!line());
    QVERIFY(QToolTip::text().contains(QLatin1String("cannot be renamed")));
}

void TestWordNavigation::formattingKeepsTheCursorAtItsWord()
{
    const QString loose =
        QStringLiteral("\n\n# größe\n\n\n\nhalf   0.5 0.5   0.5  \nx.   \"a.obj\"\n<$>.   [ # ]  x\n\n\n");
    m_editor->setPlainText(loose);
    putCursor(int(loose.indexOf(QLatin1String("x\n\n"))));
    m_editor->format();
    const QString tidy = QStringLiteral("# größe\n\nhalf 0.5 0.5 0.5\nx. \"a.obj\"\n<$>. [#] x\n");
    QCOMPARE(m_editor->toPlainText(), tidy);
    QCOMPARE(cursor(), int(tidy.size()) - 2);
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), loose);
}

void TestWordNavigation::scenesAreFormattedToo()
{
    m_editor->setFileName(QStringLiteral("a.sdo"));
    m_editor->setPlainText(QStringLiteral("o   \"x.obj\"   #\n"));
    m_editor->format();
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("o \"x.obj\" #\n"));
}

void TestWordNavigation::linesAreGoneToByNumber()
{
    m_editor->askForLine();
    QVERIFY(line() && line()->hasFocus());
    type(QStringLiteral("99"));
    QVERIFY(m_editor->findChild<QLabel *>()->isVisible());
    press(Qt::Key_Return);
    QVERIFY(line()->isVisible());
    press(Qt::Key_Backspace);
    press(Qt::Key_Backspace);
    type(QStringLiteral("3"));
    press(Qt::Key_Return);
    QCOMPARE(cursor(), at("t. ("));
    m_editor->goToLine(1'000);
    QCOMPARE(m_editor->textCursor().blockNumber(), m_editor->blockCount() - 1);
    m_editor->goToLine(-1);
    QCOMPARE(m_editor->textCursor().blockNumber(), 0);
}

void TestWordNavigation::aReadOnlyTextStays()
{
    m_editor->setReadOnly(true);
    putCursor(at("half)", 1));
    m_editor->rename();
    QVERIFY(!line());
    QVERIFY(QToolTip::isVisible());
    m_editor->setPlainText(QStringLiteral("x.   \"a\"\n"));
    m_editor->format();
    m_editor->toggleComment();
    m_editor->duplicateLines();
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("x.   \"a\"\n"));
}

QTEST_MAIN(TestWordNavigation)
#include "testwordnavigation.moc"
