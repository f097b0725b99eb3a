// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QAbstractItemView>
#include <QApplication>
#include <QTest>
#include <QTextBlock>
#include <QWindow>

#include "editor/fdoeditor.h"

using namespace romanesco;

namespace {

const QString above =
    QStringLiteral("# t t t\nhalf 0.5 0.5 0.5\nright 0 90 0\nt.a. (a, #, half)\ntwist. (#, right, #)\n"
                   "leaf. \"leaf.obj\"\nlong. leaf\n");

QAbstractItemView *list()
{
    return qobject_cast<QAbstractItemView *>(QApplication::activePopupWidget());
}

QStringList offered()
{
    QStringList labels;
    for (int row = 0; list() && row < list()->model()->rowCount(); ++row) {
        labels += list()->model()->index(row, 0).data().toString();
    }
    return labels;
}

}

/// What is offered while a person types, by the keys that the system gives to the window.
class TestCompletionPopup : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup();
    void namesAreOfferedWhileTheyAreTyped();
    void typingNarrows();
    void tabAndEnterWrite_data();
    void tabAndEnterWrite();
    void arrowsChoose();
    void escapeCloses();
    void detailsStandBeside();
    void nothingOpensByItselfForCommentsNumbersAndNewNames_data();
    void nothingOpensByItselfForCommentsNumbersAndNewNames();
    void aWholeWordLetsEnterBeANewLine();
    void askedForItOffersAllThatMayStand();
    void filesOfTheFolderAreOffered();
    void theFolderIsListedOnceForAPath();
    void scenesHaveTheirOwn();
    void theWordIsReplacedWholly();
    void aReadOnlyTextStays();

private:
    void start(const QString &text);
    void type(const QString &text);
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

    std::unique_ptr<FdoEditor> m_editor;
};

void TestCompletionPopup::init()
{
    m_editor = std::make_unique<FdoEditor>();
    m_editor->resize(500, 400);
    m_editor->setFileName(QStringLiteral("a.fdo"));
    m_editor->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    m_editor->setFocus();
}

void TestCompletionPopup::cleanup()
{
    m_editor.reset();
}

/// Puts the cursor at the end of a text.
void TestCompletionPopup::start(const QString &text)
{
    m_editor->setPlainText(text);
    m_editor->moveCursor(QTextCursor::End);
}

void TestCompletionPopup::type(const QString &text)
{
    for (const QChar c : text) {
        QTest::sendKeyEvent(QTest::Click, m_editor->windowHandle(), Qt::Key_unknown, QString(c), Qt::NoModifier);
    }
}

void TestCompletionPopup::press(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(m_editor->windowHandle(), key, modifiers);
}

void TestCompletionPopup::namesAreOfferedWhileTheyAreTyped()
{
    start(above);
    type(QStringLiteral("<$>. ["));
    QVERIFY(!list());
    type(QStringLiteral("t"));
    QCOMPARE(offered(), (QStringList{"twist", "t"}));
}

void TestCompletionPopup::typingNarrows()
{
    start(above + QStringLiteral("<$>. ["));
    type(QStringLiteral("tw"));
    QCOMPARE(offered(), QStringList{"twist"});
    press(Qt::Key_Backspace);
    QCOMPARE(offered(), (QStringList{"twist", "t"}));
    type(QStringLiteral("x"));
    QVERIFY(!list());
    QCOMPARE(m_editor->textCursor().block().text(), QStringLiteral("<$>. [tx"));
}

void TestCompletionPopup::tabAndEnterWrite_data()
{
    QTest::addColumn<int>("key");
    QTest::newRow("tab") << int(Qt::Key_Tab);
    QTest::newRow("return") << int(Qt::Key_Return);
    QTest::newRow("enter") << int(Qt::Key_Enter);
}

void TestCompletionPopup::tabAndEnterWrite()
{
    QFETCH(const int, key);
    start(above + QStringLiteral("<$>. [# "));
    type(QStringLiteral(", tw"));
    press(Qt::Key(key));
    QCOMPARE(m_editor->toPlainText(), above + QStringLiteral("<$>. [# , twist"));
    QVERIFY(m_editor->textCursor().atEnd());
    QVERIFY(!list());
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), above + QStringLiteral("<$>. [# , tw"));
}

void TestCompletionPopup::arrowsChoose()
{
    start(above + QStringLiteral("<$>. "));
    type(QStringLiteral("l"));
    QCOMPARE(offered(), (QStringList{"long", "leaf"}));
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    QCOMPARE(m_editor->textCursor().block().text(), QStringLiteral("<$>. leaf"));
}

void TestCompletionPopup::escapeCloses()
{
    start(above + QStringLiteral("<$>. "));
    type(QStringLiteral("l"));
    QVERIFY(list());
    press(Qt::Key_Escape);
    QVERIFY(!list());
    QCOMPARE(m_editor->textCursor().block().text(), QStringLiteral("<$>. l"));
}

void TestCompletionPopup::detailsStandBeside()
{
    start(above + QStringLiteral("u. (#, "));
    type(QStringLiteral("r"));
    QVERIFY(list());
    const QAbstractItemModel &model = *list()->model();
    QCOMPARE(model.index(0, 0).data().toString(), QStringLiteral("right"));
    QCOMPARE(model.index(0, 1).data().toString(), QStringLiteral("0 90 0"));
}

void TestCompletionPopup::nothingOpensByItselfForCommentsNumbersAndNewNames_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("typed");
    QTest::newRow("comment") << "# " << "t";
    QTest::newRow("comment behind") << "<$>. leaf # " << "t";
    QTest::newRow("number") << "v " << "1";
    QTest::newRow("number of a vector") << "<$>. [t." << "1";
    QTest::newRow("depth") << "<$>. leaf " << "1";
    QTest::newRow("new name") << "" << "t";
    QTest::newRow("deleting") << "<$>. [tw" << "\b";
}

void TestCompletionPopup::nothingOpensByItselfForCommentsNumbersAndNewNames()
{
    QFETCH(const QString, before);
    QFETCH(const QString, typed);
    start(above + before);
    if (typed == u"\b") {
        press(Qt::Key_Backspace);
    } else {
        type(typed);
    }
    QVERIFY(!list());
}

void TestCompletionPopup::aWholeWordLetsEnterBeANewLine()
{
    start(above + QStringLiteral("lea. leaf\n<$>. le"));
    type(QStringLiteral("a"));
    QCOMPARE(offered(), (QStringList{"lea", "leaf"}));
    press(Qt::Key_Return);
    QVERIFY(m_editor->toPlainText().endsWith(QLatin1String("<$>. lea\n")));
    QVERIFY(!list());
}

void TestCompletionPopup::askedForItOffersAllThatMayStand()
{
    start(above + QStringLiteral("<$>. [t."));
    m_editor->complete();
    QCOMPARE(offered(), (QStringList{"right", "2", "half", "1"}));
    type(QStringLiteral("2"));
    QCOMPARE(offered(), QStringList{"2"});
    press(Qt::Key_Escape);
    start(QStringLiteral("# "));
    m_editor->complete();
    QVERIFY(!list());
}

void TestCompletionPopup::filesOfTheFolderAreOffered()
{
    m_editor->setFiles([] { return std::vector<std::string>{"b.fdo", "größe.obj", "x.obj"}; });
    start(QStringLiteral("x. \""));
    type(QStringLiteral("g"));
    QCOMPARE(offered(), QStringList{QStringLiteral("größe.obj")});
    press(Qt::Key_Tab);
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("x. \"größe.obj\""));
}

void TestCompletionPopup::theFolderIsListedOnceForAPath()
{
    int listings = 0;
    m_editor->setFiles([&listings] {
        ++listings;
        return std::vector<std::string>{"bud.obj", "budding.obj"};
    });
    start(above + QStringLiteral("<$>. ["));
    type(QStringLiteral("twi"));
    QCOMPARE(offered(), QStringList{"twist"});
    QCOMPARE(listings, 0);
    start(QStringLiteral("x. \""));
    type(QStringLiteral("bud"));
    QCOMPARE(offered(), (QStringList{"bud.obj", "budding.obj"}));
    QCOMPARE(listings, 1);
    type(QStringLiteral("yy"));
    QVERIFY(!list());
    QCOMPARE(listings, 1);
    // Another word, for which the folder may be another.
    start(QStringLiteral("y. \""));
    type(QStringLiteral("b"));
    QCOMPARE(listings, 2);
}

void TestCompletionPopup::scenesHaveTheirOwn()
{
    m_editor->setFileName(QStringLiteral("a.sdo"));
    m_editor->setFiles([] { return std::vector<std::string>{"b.fdo", "x.obj"}; });
    start(QStringLiteral("f "));
    m_editor->complete();
    QCOMPARE(offered(), QStringList{QStringLiteral("b.fdo")});
}

void TestCompletionPopup::theWordIsReplacedWholly()
{
    m_editor->setPlainText(above + QStringLiteral("<$>. [tist] leaf"));
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(int(above.size()) + 7);
    m_editor->setTextCursor(cursor);
    type(QStringLiteral("w"));
    press(Qt::Key_Tab);
    QVERIFY(m_editor->toPlainText().endsWith(QLatin1String("<$>. [twist] leaf")));
}

void TestCompletionPopup::aReadOnlyTextStays()
{
    start(above + QStringLiteral("<$>. [t"));
    m_editor->setReadOnly(true);
    m_editor->complete();
    QVERIFY(!list());
}

QTEST_MAIN(TestCompletionPopup)
#include "testcompletionpopup.moc"
