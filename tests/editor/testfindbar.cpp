// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/fdoeditor.h"
#include "editor/findbar.h"

using namespace romanesco;

namespace {

const QString sample = QStringLiteral("# Half 🌲 half\nhalf 0.5 0.5 0.5\nhalfway 1 1 1\nt. (#, #, half)\n");

}

/// Find and replace, by keys in the bar.
class TestFindBar : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup();
    void typingFindsFromWhereTheCursorIs();
    void enterGoesRound();
    void allMatchesAreMarkedAndCounted();
    void matchesFollowTheText();
    void optionsNarrow_data();
    void optionsNarrow();
    void aWrongExpressionSaysWhere();
    void anExpressionThatNeverEndsIsGivenUp();
    void emptyMatchesAreGoneThrough();
    void replacingGoesOn();
    void replacingAllIsOneUndoStep_data();
    void replacingAllIsOneUndoStep();
    void theNumberReplacedStaysToBeRead();
    void groupsAreWritten();
    void escapeCloses();
    void theSelectionIsLookedFor();
    void aHiddenWindowForgetsNothing();
    void nextOpensTheBar();
    void aReadOnlyTextIsSearchedOnly();
    void aLongLineStaysUsable();
    void aLongTextStaysUsable();

private:
    void type(const QString &text);
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void find(const QString &words, bool isExpression = false);
    [[nodiscard]] QLineEdit *line(int index) const { return m_bar->findChildren<QLineEdit *>()[index]; }
    [[nodiscard]] QToolButton *option(const QString &sign) const;
    [[nodiscard]] QLabel *label(int index) const { return m_bar->findChildren<QLabel *>()[index]; }
    [[nodiscard]] QString count() const { return label(0)->text(); }
    QStringList marked();
    [[nodiscard]] bool waitFor(const QString &words);

    std::unique_ptr<QWidget> m_window;
    FdoEditor *m_editor = nullptr;
    FindBar *m_bar = nullptr;
};

void TestFindBar::init()
{
    m_window = std::make_unique<QWidget>();
    m_editor = new FdoEditor;
    m_bar = new FindBar(*m_editor);
    auto *column = new QVBoxLayout(m_window.get());
    column->addWidget(m_editor);
    column->addWidget(m_bar);
    m_window->resize(600, 400);
    m_editor->setFileName(QStringLiteral("a.fdo"));
    m_editor->setPlainText(sample);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_editor->setFocus();
}

void TestFindBar::cleanup()
{
    // The bar knows the editor.
    delete m_bar;
    m_window.reset();
}

void TestFindBar::type(const QString &text)
{
    for (const char32_t c : text.toStdU32String()) {
        QTest::sendKeyEvent(QTest::Click, QApplication::focusWidget(), Qt::Key_unknown, QString::fromUcs4(&c, 1),
                            Qt::NoModifier);
    }
}

void TestFindBar::press(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
}

void TestFindBar::find(const QString &words, bool isExpression)
{
    m_bar->openReplace();
    option(QStringLiteral(".*"))->setChecked(isExpression);
    type(words);
}

QToolButton *TestFindBar::option(const QString &sign) const
{
    for (QToolButton *button : m_bar->findChildren<QToolButton *>()) {
        if (button->text() == sign) {
            return button;
        }
    }
    return nullptr;
}

QStringList TestFindBar::marked()
{
    QStringList words;
    for (const TextStretch stretch : m_editor->marks().stretches(MarkLayer::Matches)) {
        words += m_editor->toPlainText().sliced(stretch.begin, stretch.end - stretch.begin);
    }
    return words;
}

bool TestFindBar::waitFor(const QString &words)
{
    return QTest::qWaitFor([&] { return count() == words; }, 5'000);
}

void TestFindBar::typingFindsFromWhereTheCursorIs()
{
    m_editor->goToLine(3);
    m_bar->openFind();
    QVERIFY(line(0)->hasFocus());
    QVERIFY(!line(1)->isVisible());
    type(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("4 of 5")));
    QCOMPARE(m_editor->textCursor().selectedText(), QStringLiteral("half"));
    QCOMPARE(m_editor->textCursor().blockNumber(), 2);
    type(QStringLiteral(")"));
    QVERIFY(waitFor(QStringLiteral("1 of 1")));
    QCOMPARE(m_editor->textCursor().blockNumber(), 3);
    press(Qt::Key_Backspace);
    QVERIFY(waitFor(QStringLiteral("4 of 5")));
}

void TestFindBar::enterGoesRound()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    for (const char *expected : {"2 of 5", "3 of 5", "4 of 5", "5 of 5", "1 of 5"}) {
        press(Qt::Key_Return);
        QCOMPARE(count(), QString::fromLatin1(expected));
    }
    press(Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(count(), QStringLiteral("5 of 5"));
    press(Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(count(), QStringLiteral("4 of 5"));
    QVERIFY(line(0)->hasFocus());
}

void TestFindBar::allMatchesAreMarkedAndCounted()
{
    find(QStringLiteral("0.5"));
    QVERIFY(waitFor(QStringLiteral("1 of 3")));
    QCOMPARE(marked(), (QStringList{"0.5", "0.5", "0.5"}));
    press(Qt::Key_X);
    QVERIFY(waitFor(QStringLiteral("No matches")));
    QVERIFY(marked().isEmpty());
}

void TestFindBar::matchesFollowTheText()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    m_editor->moveCursor(QTextCursor::End);
    m_editor->setFocus();
    type(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("6 matches")));
    QCOMPARE(marked().size(), 6);
}

void TestFindBar::optionsNarrow_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("count");
    QTest::newRow("plain") << "half" << QStringList() << 5;
    QTest::newRow("case") << "half" << QStringList{"Aa"} << 4;
    QTest::newRow("whole") << "half" << QStringList{"|a|"} << 4;
    QTest::newRow("case, whole") << "half" << QStringList{"Aa", "|a|"} << 3;
    QTest::newRow("signs") << "." << QStringList() << 4;
    QTest::newRow("expression") << "\\d\\.\\d" << QStringList{".*"} << 3;
    QTest::newRow("line starts") << "^half" << QStringList{".*"} << 2;
    QTest::newRow("alternatives, whole") << "half|way" << QStringList{".*", "|a|"} << 4;
    QTest::newRow("whole signs") << "(#" << QStringList{"|a|"} << 1;
    QTest::newRow("beyond the basic plane") << "🌲 h" << QStringList() << 1;
}

void TestFindBar::optionsNarrow()
{
    QFETCH(const QString, words);
    QFETCH(const QStringList, options);
    QFETCH(const int, count);
    m_bar->openFind();
    type(words);
    for (const QString &each : options) {
        QTest::mouseClick(option(each), Qt::LeftButton);
        QVERIFY(!option(each)->accessibleName().isEmpty());
    }
    QVERIFY(waitFor(QStringLiteral("1 of %1").arg(count)));
}

void TestFindBar::aWrongExpressionSaysWhere()
{
    find(QStringLiteral("half(x"), true);
    QVERIFY(QTest::qWaitFor([&] { return label(1)->isVisible(); }));
    QVERIFY2(label(1)->text().contains(QStringLiteral("after “half(x”")), qPrintable(label(1)->text()));
    QCOMPARE(count(), QString());
    press(Qt::Key_Return);
    type(QStringLiteral("?)?"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    QVERIFY(!label(1)->isVisible());
}

void TestFindBar::anExpressionThatNeverEndsIsGivenUp()
{
    m_editor->setPlainText((QString(40, u'a') + QStringLiteral("b\n")).repeated(1'000));
    find(QStringLiteral("(a|aa)+$"), true);
    QVERIFY(QTest::qWaitFor([&] { return label(1)->isVisible(); }));
    QVERIFY2(label(1)->text().contains(QStringLiteral("too long in line 1")), qPrintable(label(1)->text()));
    m_bar->replaceAll();
    QTest::qWait(20);
    QVERIFY(!m_editor->document()->isUndoAvailable());
}

void TestFindBar::emptyMatchesAreGoneThrough()
{
    m_editor->setPlainText(QStringLiteral("a🌲\n\nb"));
    find(QStringLiteral("^"), true);
    QVERIFY(waitFor(QStringLiteral("1 of 3")));
    for (const int expected : {4, 5, 0}) {
        press(Qt::Key_Return);
        QCOMPARE(m_editor->textCursor().position(), expected);
    }
    line(1)->setText(QStringLiteral("# "));
    m_bar->replaceAll();
    QVERIFY(QTest::qWaitFor([&] { return m_editor->document()->isUndoAvailable(); }));
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("# a🌲\n# \n# b"));
}

void TestFindBar::replacingGoesOn()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    line(1)->setFocus();
    type(QStringLiteral("hälfte"));
    press(Qt::Key_Return);
    QVERIFY(waitFor(QStringLiteral("1 of 4")));
    QCOMPARE(m_editor->textCursor().selectedText(), QStringLiteral("half"));
    QTest::mouseClick(m_bar->findChildren<QPushButton *>()[0], Qt::LeftButton);
    QVERIFY(waitFor(QStringLiteral("1 of 3")));
    QVERIFY(m_editor->toPlainText().startsWith(QStringLiteral("# hälfte 🌲 hälfte\nhalf 0.5")));
    m_editor->undo();
    QVERIFY(m_editor->toPlainText().startsWith(QStringLiteral("# hälfte 🌲 half\nhalf 0.5")));
}

void TestFindBar::replacingAllIsOneUndoStep_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("replacement");
    QTest::addColumn<QString>("result");
    QTest::newRow("plain") << sample << "half" << "🌳\\1"
                           << QStringLiteral("# 🌳\\1 🌲 🌳\\1\n🌳\\1 0.5 0.5 0.5\n🌳\\1way 1 1 1\nt. (#, #, 🌳\\1)\n");
    QTest::newRow("nothing") << "aXbX\nX" << "X" << "" << "ab\n";
    QTest::newRow("what would match again") << "aaa" << "a" << "aa" << "aaaaaa";
    QTest::newRow("side by side") << "abab" << "ab" << "ba" << "baba";
}

void TestFindBar::replacingAllIsOneUndoStep()
{
    QFETCH(const QString, text);
    QFETCH(const QString, words);
    QFETCH(const QString, replacement);
    m_editor->setPlainText(text);
    find(words);
    line(1)->setText(replacement);
    QTest::mouseClick(m_bar->findChildren<QPushButton *>()[1], Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return m_editor->document()->isUndoAvailable(); }));
    QTEST(m_editor->toPlainText(), "result");
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), text);
    QVERIFY(!m_editor->document()->isUndoAvailable());
}

void TestFindBar::theNumberReplacedStaysToBeRead()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    line(1)->setText(QStringLiteral("a half"));
    m_bar->replaceAll();
    // Until the new matches are found, and after.
    QVERIFY(waitFor(QStringLiteral("5 replaced")));
    QVERIFY(QTest::qWaitFor([&] { return marked().size() == 5 && marked().contains(QStringLiteral("half")); }));
    QCOMPARE(count(), QStringLiteral("5 replaced"));
    press(Qt::Key_Return);
    QVERIFY(count().endsWith(QStringLiteral(" of 5")));
    m_editor->undo();
    m_bar->replaceAll();
    QVERIFY(waitFor(QStringLiteral("5 replaced")));
    m_editor->setFocus();
    m_editor->moveCursor(QTextCursor::End);
    type(QStringLiteral("x"));
    QVERIFY(waitFor(QStringLiteral("5 matches")));
}

void TestFindBar::groupsAreWritten()
{
    m_editor->setPlainText(QStringLiteral("v 1 2\nv 3 4"));
    find(QStringLiteral("(\\d) (\\d)"), true);
    line(1)->setText(QStringLiteral("\\2\\\\\\1\\n\\0"));
    QVERIFY(waitFor(QStringLiteral("1 of 2")));
    m_bar->replaceOne();
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("v 2\\1\n1 2\nv 3 4"));
    m_editor->undo();
    m_bar->replaceAll();
    QVERIFY(QTest::qWaitFor([&] { return m_editor->document()->isUndoAvailable(); }));
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("v 2\\1\n1 2\nv 4\\3\n3 4"));
}

void TestFindBar::escapeCloses()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    press(Qt::Key_Escape);
    QVERIFY(!m_bar->isVisible());
    QVERIFY(m_editor->hasFocus());
    QVERIFY(marked().isEmpty());
    type(QStringLiteral("x"));
    QTest::qWait(20);
    QVERIFY(marked().isEmpty());
}

void TestFindBar::theSelectionIsLookedFor()
{
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(2);
    cursor.setPosition(6, QTextCursor::KeepAnchor);
    m_editor->setTextCursor(cursor);
    m_bar->openFind();
    QCOMPARE(line(0)->text(), QStringLiteral("Half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
}

void TestFindBar::aHiddenWindowForgetsNothing()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    m_window->hide();
    m_window->show();
    m_bar->findNext();
    QVERIFY(waitFor(QStringLiteral("2 of 5")));
    QCOMPARE(marked().size(), 5);
}

void TestFindBar::nextOpensTheBar()
{
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    press(Qt::Key_Escape);
    m_bar->findNext();
    QVERIFY(m_bar->isVisible());
    QVERIFY(m_editor->hasFocus());
    QVERIFY(waitFor(QStringLiteral("2 of 5")));
    m_bar->findPrevious();
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
}

void TestFindBar::aReadOnlyTextIsSearchedOnly()
{
    m_editor->setReadOnly(true);
    find(QStringLiteral("half"));
    QVERIFY(waitFor(QStringLiteral("1 of 5")));
    QVERIFY(!line(1)->isVisible());
    m_bar->replaceAll();
    m_bar->replaceOne();
    QTest::qWait(20);
    QCOMPARE(m_editor->toPlainText(), sample);
}

void TestFindBar::aLongLineStaysUsable()
{
    m_editor->setPlainText(QStringLiteral("# ") + QStringLiteral("ab ").repeated(330'000));
    find(QStringLiteral("a"));
    QVERIFY(QTest::qWaitFor([&] { return count() == QStringLiteral("1 of 330000"); }, 60'000));
    line(1)->setText(QStringLiteral("c"));
    m_bar->replaceAll();
    QVERIFY(QTest::qWaitFor([&] { return m_editor->document()->isUndoAvailable(); }, 60'000));
    QVERIFY(!m_editor->toPlainText().contains(u'a'));
}

void TestFindBar::aLongTextStaysUsable()
{
    m_editor->setPlainText(QStringLiteral("half 0.5 0.5 0.5 # größe\n").repeated(100'000));
    m_editor->moveCursor(QTextCursor::End);
    find(QStringLiteral("0.5"));
    // Nothing is found there yet; it waits for what is.
    m_bar->findPrevious();
    QVERIFY(QTest::qWaitFor([&] { return count() == QStringLiteral("300000 of 300000"); }, 60'000));
    m_bar->findNext();
    QCOMPARE(count(), QStringLiteral("1 of 300000"));
}

QTEST_MAIN(TestFindBar)
#include "testfindbar.moc"
