// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>

#include "editor/inlaynumbers.h"
#include "shownsample.h"

using namespace romanesco;

namespace {

const QString sample =
    QStringLiteral("v 1 1 -2\nv 0 5 0 # 🌲\nt. (#, #, 2)\nu.a. (a, #, #)\nx. \"a.obj\"\n<$>. [t, u.2, u.1] x\n");

}

/// The numbers of vectors: beside their lines, and where they are used.
class TestVectorNumbers : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void numbersStandBehindVectors();
    void numbersFollowWhatIsTyped();
    void numbersAreSeenAndQuiet_data();
    void numbersAreSeenAndQuiet();
    void scenesHaveNone();
    void anInsertedVectorOffersToRenumber();
    void aRemovedVectorOffersToRenumber();
    void whatIsTypedKeepsTheOffer();
    void somethingElseWithdrawsTheOffer();
    void undoneVectorsOfferNothing();
    void anEditAfterUndoIsOffered();
    void dismissedItStaysAway();
    void anotherTextOffersNothing();

private:
    void putCursor(int position);
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void type(const QString &text);
    QStringList numbers();

    std::unique_ptr<FdoEditor> m_editor;
    std::unique_ptr<QSignalSpy> m_offers;
};

void TestVectorNumbers::init()
{
    m_editor = test::shownEditor(sample);
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    m_offers = std::make_unique<QSignalSpy>(m_editor.get(), &FdoEditor::renumberingOffered);
}

void TestVectorNumbers::putCursor(int position)
{
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(position);
    m_editor->setTextCursor(cursor);
}

void TestVectorNumbers::press(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(m_editor.get(), key, modifiers);
}

void TestVectorNumbers::type(const QString &text)
{
    QTest::keyClicks(m_editor.get(), text);
}

QStringList TestVectorNumbers::numbers()
{
    QStringList numbers;
    for (const InlayNumber &number : inlayNumbers(*m_editor)) {
        numbers += QString::number(number.line) + number.text;
    }
    return numbers;
}

void TestVectorNumbers::numbersStandBehindVectors()
{
    QCOMPARE(numbers(), (QStringList{"0·1", "1·2"}));
    QTextCursor end(m_editor->document()->findBlockByNumber(1));
    end.movePosition(QTextCursor::EndOfBlock);
    const InlayNumber second = inlayNumbers(*m_editor)[1];
    const QRect caret = m_editor->cursorRect(end);
    QVERIFY(second.place.x() > caret.right());
    QVERIFY(caret.top() < second.place.y() && second.place.y() <= caret.bottom());
}

void TestVectorNumbers::numbersFollowWhatIsTyped()
{
    putCursor(0);
    type(QStringLiteral("v 1 2 3"));
    press(Qt::Key_Return);
    QCOMPARE(numbers(), (QStringList{"0·1", "1·2", "2·3"}));
    QVERIFY(!m_editor->toPlainText().contains(u'·'));
}

void TestVectorNumbers::numbersAreSeenAndQuiet_data()
{
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void TestVectorNumbers::numbersAreSeenAndQuiet()
{
    QFETCH(const bool, isDark);
    QPalette palette;
    palette.setColor(QPalette::Base, isDark ? QColor(0x20, 0x20, 0x20) : QColor(Qt::white));
    palette.setColor(QPalette::Text, isDark ? Qt::white : Qt::black);
    m_editor->setPalette(palette);
    const InlayNumber second = inlayNumbers(*m_editor)[1];
    const QImage picture = m_editor->viewport()->grab().toImage();
    const int base = palette.color(QPalette::Base).lightness();
    int farthest = 0;
    for (int x = int(second.place.x()); x < int(second.place.x()) + 20; ++x) {
        for (int y = int(second.place.y()) - 12; y < int(second.place.y()); ++y) {
            farthest = std::max(farthest, std::abs(picture.pixelColor(x, y).lightness() - base));
        }
    }
    QVERIFY2(farthest > 30 && farthest < 200, qPrintable(QString::number(farthest)));
}

void TestVectorNumbers::scenesHaveNone()
{
    m_editor->setFileName(QStringLiteral("a.sdo"));
    QVERIFY(numbers().isEmpty());
}

void TestVectorNumbers::anInsertedVectorOffersToRenumber()
{
    putCursor(0);
    press(Qt::Key_Return);
    press(Qt::Key_Up);
    QCOMPARE(m_offers->size(), 0);
    type(QStringLiteral("v 7 7 7"));
    QVERIFY(!m_offers->isEmpty());
    QCOMPARE(m_offers->last()[0].toInt(), 3);
    const QString with = m_editor->toPlainText();
    m_editor->renumber();
    QCOMPARE(m_editor->toPlainText(),
             QStringLiteral("v 7 7 7\nv 1 1 -2\nv 0 5 0 # 🌲\nt. (#, #, 3)\nu.a. (a, #, #)\n"
                            "x. \"a.obj\"\n<$>. [t, u.3, u.2] x\n"));
    QCOMPARE(m_offers->last()[0].toInt(), 0);
    QCOMPARE(m_editor->textCursor().positionInBlock(), 7);
    m_editor->undo();
    QVERIFY(m_editor->toPlainText().endsWith(sample));
    QCOMPARE(m_offers->last()[0].toInt(), 0);
}

void TestVectorNumbers::aRemovedVectorOffersToRenumber()
{
    putCursor(0);
    press(Qt::Key_Down, Qt::ShiftModifier);
    press(Qt::Key_Delete);
    // That of the vector that is gone stays for its author to mend.
    QCOMPARE(m_offers->last()[0].toInt(), 2);
    m_editor->renumber();
    QVERIFY(m_editor->toPlainText().contains(QLatin1String("[t, u.1, u.1]")));
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample);
    m_editor->redo();
    QVERIFY(m_editor->toPlainText().contains(QLatin1String("[t, u.1, u.1]")));
    QCOMPARE(m_offers->last()[0].toInt(), 0);
}

void TestVectorNumbers::whatIsTypedKeepsTheOffer()
{
    putCursor(8);
    press(Qt::Key_Return);
    type(QStringLiteral("v 1 1 1"));
    press(Qt::Key_Return);
    type(QStringLiteral("v 2 2 2 # two"));
    QCOMPARE(m_offers->last()[0].toInt(), 2);
    m_editor->renumber();
    QVERIFY(m_editor->toPlainText().contains(QLatin1String("[t, u.4, u.1]")));
}

void TestVectorNumbers::somethingElseWithdrawsTheOffer()
{
    putCursor(int(sample.indexOf(QLatin1String("\nt. "))));
    press(Qt::Key_Return);
    type(QStringLiteral("v 1 1 1"));
    press(Qt::Key_Home);
    press(Qt::Key_Return);
    press(Qt::Key_Up);
    type(QStringLiteral("v 1 1 1"));
    putCursor(8);
    QVERIFY(m_offers->isEmpty()); // uses are of those above
    press(Qt::Key_Return);
    type(QStringLiteral("v 2 2 2"));
    QCOMPARE(m_offers->last()[0].toInt(), 2);
    putCursor(0);
    type(QStringLiteral("one"));
    QCOMPARE(m_offers->last()[0].toInt(), 0);
    const QString text = m_editor->toPlainText();
    m_editor->renumber();
    QCOMPARE(m_editor->toPlainText(), text);
}

void TestVectorNumbers::undoneVectorsOfferNothing()
{
    putCursor(8);
    press(Qt::Key_Return);
    type(QStringLiteral("v 1 1 1"));
    m_editor->moveCursor(QTextCursor::End);
    type(QStringLiteral("# note"));
    m_offers->clear();
    m_editor->undo();
    m_editor->undo();
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample);
    m_editor->redo();
    m_editor->redo();
    m_editor->redo();
    QVERIFY(m_editor->toPlainText().contains(QLatin1String("v 1 1 1")));
    QVERIFY(m_offers->isEmpty());
}

void TestVectorNumbers::anEditAfterUndoIsOffered()
{
    m_editor->moveCursor(QTextCursor::End);
    type(QStringLiteral("# note"));
    m_editor->undo();
    putCursor(0);
    press(Qt::Key_Down, Qt::ShiftModifier);
    press(Qt::Key_Delete);
    QCOMPARE(m_offers->last()[0].toInt(), 2);
}

void TestVectorNumbers::dismissedItStaysAway()
{
    putCursor(8);
    press(Qt::Key_Return);
    type(QStringLiteral("v 1 1 1"));
    m_editor->dismissRenumbering();
    QCOMPARE(m_offers->last()[0].toInt(), 0);
    m_offers->clear();
    type(QStringLiteral(" # one"));
    QVERIFY(m_offers->isEmpty());
}

void TestVectorNumbers::anotherTextOffersNothing()
{
    m_editor->setPlainText(QStringLiteral("v 1 1 1\n") + sample);
    QVERIFY(m_offers->isEmpty());
    putCursor(0);
    press(Qt::Key_Down, Qt::ShiftModifier);
    press(Qt::Key_Delete);
    QCOMPARE(m_offers->last()[0].toInt(), 2);
}

QTEST_MAIN(TestVectorNumbers)
#include "testvectornumbers.moc"
