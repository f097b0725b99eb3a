// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include "shownsample.h"

using namespace romanesco;

namespace {

const QString sample = QStringLiteral("# 🌲 7\nhalf 0.50 +1 -2e-3 # 9\nt. (#, #, 1)\nu.a. (#, #, a)\nx. \"a2.obj\"\n"
                                      "z<x>. [#, t, u.1] x\n<$>. z 3 # 5\n");

int at(const char *words, int further = 0)
{
    return int(sample.indexOf(QLatin1String(words))) + further;
}

QString with(const char *old, const char *now)
{
    return QString(sample).replace(QLatin1String(old), QLatin1String(now));
}

}

/// Numbers that are dragged and stepped.
class TestScrubber : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void draggingChangesTheNumberAtOnce();
    void aDragIsOneUndoStep();
    void shiftIsFiner();
    void aDragThatComesBackIsNoClick();
    void aClickOnANumberLeadsToItsVector();
    void keysStep_data();
    void keysStep();
    void steppingIsOneUndoStepUntilAltIsReleased();
    void whatIsNoNumberIsLeftAlone_data();
    void whatIsNoNumberIsLeftAlone();
    void scenesHaveNumbersToo();
    void aReadOnlyTextStays();

private:
    void putCursor(int position);
    QPoint pointAt(int position);
    void drag(QEvent::Type type, const QPoint &point, Qt::KeyboardModifiers modifiers = Qt::ControlModifier);

    std::unique_ptr<FdoEditor> m_editor;
};

void TestScrubber::init()
{
    m_editor = test::shownEditor(sample);
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
}

void TestScrubber::putCursor(int position)
{
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(position);
    m_editor->setTextCursor(cursor);
}

QPoint TestScrubber::pointAt(int position)
{
    QTextCursor cursor(m_editor->document());
    cursor.setPosition(position);
    return m_editor->cursorRect(cursor).center() + QPoint(2, 0);
}

void TestScrubber::drag(QEvent::Type type, const QPoint &point, Qt::KeyboardModifiers modifiers)
{
    const bool isMove = type == QEvent::MouseMove;
    const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, point, m_editor->viewport()->mapToGlobal(point), isMove ? Qt::NoButton : Qt::LeftButton,
                      buttons, modifiers);
    QCoreApplication::sendEvent(m_editor->viewport(), &event);
}

void TestScrubber::draggingChangesTheNumberAtOnce()
{
    putCursor(3);
    const QPoint from = pointAt(at("0.50", 1));
    drag(QEvent::MouseButtonPress, from);
    drag(QEvent::MouseMove, from + QPoint(2, 0));
    QCOMPARE(m_editor->toPlainText(), sample);
    drag(QEvent::MouseMove, from + QPoint(40, 0));
    QCOMPARE(m_editor->toPlainText(), with("0.50", "0.60"));
    QCOMPARE(m_editor->viewport()->cursor().shape(), Qt::SizeHorCursor);
    drag(QEvent::MouseMove, from - QPoint(240, 3));
    QCOMPARE(m_editor->toPlainText(), with("0.50", "-0.10"));
    drag(QEvent::MouseMove, from + QPoint(4, 0));
    QCOMPARE(m_editor->toPlainText(), with("0.50", "0.51"));
    drag(QEvent::MouseButtonRelease, from + QPoint(4, 0));
    QCOMPARE(m_editor->viewport()->cursor().shape(), Qt::IBeamCursor);
    QCOMPARE(m_editor->textCursor().position(), 3);
    QVERIFY(!m_editor->textCursor().hasSelection());
    drag(QEvent::MouseMove, from + QPoint(80, 0));
    QCOMPARE(m_editor->toPlainText(), with("0.50", "0.51"));
}

void TestScrubber::aDragIsOneUndoStep()
{
    for (const int distance : {20, -60}) {
        const QPoint from = pointAt(at("+1"));
        drag(QEvent::MouseButtonPress, from);
        for (int i = 0; i < 10; ++i) {
            drag(QEvent::MouseMove, from + QPoint(distance + i, 0));
        }
        drag(QEvent::MouseButtonRelease, from + QPoint(distance, 0));
    }
    QVERIFY(m_editor->toPlainText() != sample);
    m_editor->undo();
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample);
    QVERIFY(!m_editor->document()->isUndoAvailable());
}

void TestScrubber::shiftIsFiner()
{
    const auto finer = Qt::ControlModifier | Qt::ShiftModifier;
    const QPoint from = pointAt(at("0.50", 1));
    drag(QEvent::MouseButtonPress, from, finer);
    drag(QEvent::MouseMove, from + QPoint(40, 0), finer);
    QCOMPARE(m_editor->toPlainText(), with("0.50", "0.510"));
}

void TestScrubber::aDragThatComesBackIsNoClick()
{
    const QPoint from = pointAt(at("1]"));
    drag(QEvent::MouseButtonPress, from);
    drag(QEvent::MouseMove, from + QPoint(40, 0));
    drag(QEvent::MouseMove, from);
    drag(QEvent::MouseButtonRelease, from);
    QCOMPARE(m_editor->toPlainText(), sample);
    QCOMPARE(m_editor->textCursor().position(), 0);
}

void TestScrubber::aClickOnANumberLeadsToItsVector()
{
    const QPoint from = pointAt(at("1]"));
    drag(QEvent::MouseButtonPress, from);
    drag(QEvent::MouseButtonRelease, from);
    QCOMPARE(m_editor->textCursor().position(), at("half"));
    QCOMPARE(m_editor->toPlainText(), sample);
    const QPoint other = pointAt(at("0.50", 1));
    drag(QEvent::MouseButtonPress, other);
    drag(QEvent::MouseButtonRelease, other);
    QCOMPARE(m_editor->textCursor().position(), at("half"));
    QCOMPARE(m_editor->toPlainText(), sample);
}

void TestScrubber::keysStep_data()
{
    QTest::addColumn<int>("cursor");
    QTest::addColumn<int>("key");
    QTest::addColumn<bool>("isFiner");
    QTest::addColumn<QString>("text");
    QTest::newRow("up") << at("0.50") << int(Qt::Key_Up) << false << with("0.50", "0.51");
    QTest::newRow("down, behind it") << at("0.50", 4) << int(Qt::Key_Down) << false << with("0.50", "0.49");
    QTest::newRow("finer") << at("0.50") << int(Qt::Key_Up) << true << with("0.50", "0.501");
    QTest::newRow("a sign") << at("+1", 1) << int(Qt::Key_Up) << false << with("+1", "+2");
    QTest::newRow("an exponent") << at("-2e-3", 2) << int(Qt::Key_Up) << false << with("-2e-3", "-1e-3");
    QTest::newRow("a vector's number") << at("1]") << int(Qt::Key_Up) << false << with("u.1]", "u.2]");
    QTest::newRow("the first vector") << at("1]") << int(Qt::Key_Down) << false << sample;
    QTest::newRow("a part") << at("1)") << int(Qt::Key_Up) << false << with("1)", "2)");
    QTest::newRow("a depth") << at("z 3", 2) << int(Qt::Key_Down) << false << with("z 3", "z 2");
    QTest::newRow("a depth stays whole") << at("z 3", 2) << int(Qt::Key_Up) << true << with("z 3", "z 4");
}

void TestScrubber::keysStep()
{
    QFETCH(const int, cursor);
    QFETCH(const int, key);
    QFETCH(const bool, isFiner);
    putCursor(cursor);
    const auto modifiers = isFiner ? Qt::AltModifier | Qt::ShiftModifier : Qt::KeyboardModifiers(Qt::AltModifier);
    QTest::keyClick(m_editor.get(), Qt::Key(key), modifiers);
    QTEST(m_editor->toPlainText(), "text");
}

void TestScrubber::steppingIsOneUndoStepUntilAltIsReleased()
{
    putCursor(at("0.50", 1));
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 3; ++j) {
            // QTest would release Alt after each.
            QKeyEvent up(QEvent::KeyPress, Qt::Key_Up, Qt::AltModifier);
            QCoreApplication::sendEvent(m_editor.get(), &up);
        }
        QTest::keyRelease(m_editor.get(), Qt::Key_Alt);
    }
    QCOMPARE(m_editor->toPlainText(), with("0.50", "0.56"));
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), with("0.50", "0.53"));
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample);
}

void TestScrubber::whatIsNoNumberIsLeftAlone_data()
{
    QTest::addColumn<int>("cursor");
    QTest::newRow("comment") << at("7");
    QTest::newRow("comment behind a vector") << at("# 9", 2);
    QTest::newRow("comment behind a depth") << at("# 5", 2);
    QTest::newRow("path") << at("2.obj");
    QTest::newRow("name") << at("half", 1);
    QTest::newRow("end") << int(sample.size());
}

void TestScrubber::whatIsNoNumberIsLeftAlone()
{
    QFETCH(const int, cursor);
    putCursor(cursor);
    m_editor->stepNumber(1, false);
    QCOMPARE(m_editor->toPlainText(), sample);
}

void TestScrubber::scenesHaveNumbersToo()
{
    m_editor->setFileName(QStringLiteral("a.sdo"));
    m_editor->setPlainText(QStringLiteral("p \"b1.obj\" (#, #, (0.1, 1, 1)) 0.5 # 3"));
    for (const int cursor : {24, 37, 5}) {
        putCursor(cursor);
        m_editor->stepNumber(1, false);
    }
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("p \"b1.obj\" (#, #, (0.1, 2, 1)) 0.5 # 3"));
    putCursor(32);
    m_editor->stepNumber(-1, true);
    QCOMPARE(m_editor->toPlainText(), QStringLiteral("p \"b1.obj\" (#, #, (0.1, 2, 1)) 0.49 # 3"));
}

void TestScrubber::aReadOnlyTextStays()
{
    m_editor->setReadOnly(true);
    putCursor(at("0.50"));
    m_editor->stepNumber(1, false);
    const QPoint from = pointAt(at("0.50", 1));
    drag(QEvent::MouseButtonPress, from);
    drag(QEvent::MouseMove, from + QPoint(40, 0));
    QCOMPARE(m_editor->toPlainText(), sample);
}

QTEST_MAIN(TestScrubber)
#include "testscrubber.moc"
