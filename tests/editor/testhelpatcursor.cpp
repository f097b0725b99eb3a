// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QTest>
#include <QTextDocumentFragment>
#include <QToolTip>

#include "core/formats/fdoreader.h"
#include "editor/fdoeditor.h"

using namespace romanesco;

namespace {

const QString sample = QStringLiteral("# größe 🌲\nhalf 0.5 0.5 0.5\nt. (#, #, half)\nx. \"a.obj\"\nz<x>. [#, t] x\n"
                                      "<$>. z 3\n");

QMenu *menu()
{
    return qobject_cast<QMenu *>(QApplication::activePopupWidget());
}

}

/// What is said about a place, and the fixes that are offered there.
class TestHelpAtCursor : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void restingTheMouseSaysWhatAWordStandsFor_data();
    void restingTheMouseSaysWhatAWordStandsFor();
    void theCursorIsAskedByKey();
    void problemsComeFirst();
    void namesInAngleBracketsAreNoTags();
    void beyondALineNothingIsSaid();
    void aFixIsOfferedWhereItIsNeeded_data();
    void aFixIsOfferedWhereItIsNeeded();
    void nothingToFixIsSaid();
    void anOldFixIsNotOffered();
    void aReadOnlyTextHasNoFixes();
    void thousandsOfProblemsAreNoTrouble();

private:
    void setText(const QString &text);
    void putCursor(int position);
    QString restOn(int position, int aside = 2);

    std::unique_ptr<FdoEditor> m_editor;
};

void TestHelpAtCursor::init()
{
    m_editor = std::make_unique<FdoEditor>();
    m_editor->resize(600, 400);
    m_editor->setFileName(QStringLiteral("a.fdo"));
    m_editor->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
    m_editor->setFocus();
    QToolTip::hideText();
    QVERIFY(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
}

/// With the problems that the reader finds.
void TestHelpAtCursor::setText(const QString &text)
{
    m_editor->setPlainText(text);
    const TextSnapshot snapshot = m_editor->snapshot();
    m_editor->setDiagnostics(readFdo(snapshot.bytes()).diagnostics, snapshot);
}

void TestHelpAtCursor::putCursor(int position)
{
    QTextCursor cursor = m_editor->textCursor();
    cursor.setPosition(position);
    m_editor->setTextCursor(cursor);
}

QString TestHelpAtCursor::restOn(int position, int aside)
{
    QTextCursor cursor(m_editor->document());
    cursor.setPosition(position);
    const QPoint point = m_editor->cursorRect(cursor).center() + QPoint(aside, 0);
    QHelpEvent event(QEvent::ToolTip, point, m_editor->viewport()->mapToGlobal(point));
    QCoreApplication::sendEvent(m_editor->viewport(), &event);
    return QToolTip::isVisible() ? QTextDocumentFragment::fromHtml(QToolTip::text()).toPlainText() : QString();
}

void TestHelpAtCursor::restingTheMouseSaysWhatAWordStandsFor_data()
{
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("words");
    QTest::newRow("vector") << "half)" << "0.5 0.5 0.5";
    QTest::newRow("map") << "t]" << "determinant";
    QTest::newRow("count") << "z 3" << "2 instances";
}

void TestHelpAtCursor::restingTheMouseSaysWhatAWordStandsFor()
{
    QFETCH(const QString, word);
    QFETCH(const QString, words);
    setText(sample);
    const QString said = restOn(int(sample.indexOf(word)));
    QVERIFY2(said.contains(words), qPrintable(said));
}

void TestHelpAtCursor::theCursorIsAskedByKey()
{
    setText(sample);
    putCursor(int(sample.indexOf(QLatin1String("half)"))));
    m_editor->showTip();
    QVERIFY(QToolTip::isVisible());
    QVERIFY(QToolTip::text().contains(QLatin1String("0.5 0.5 0.5")));
}

void TestHelpAtCursor::problemsComeFirst()
{
    setText(sample + QStringLiteral("half. x"));
    QCOMPARE(m_editor->problems().size(), 1u);
    const QString said = restOn(int(sample.size()) + 1);
    QVERIFY2(said.startsWith(m_editor->problems().front().message), qPrintable(said));
}

void TestHelpAtCursor::namesInAngleBracketsAreNoTags()
{
    setText(QStringLiteral("u<b>. x"));
    m_editor->setDiagnostics({{DiagnosticCode::UnknownName, {0, 1}, {"<b>bold</b>"}}}, m_editor->snapshot());
    QVERIFY(restOn(0).contains(QLatin1String("<b>bold</b>")));
}

void TestHelpAtCursor::beyondALineNothingIsSaid()
{
    setText(sample);
    const auto end = int(sample.indexOf(QLatin1String("z 3"))) + 3;
    QVERIFY(!restOn(end).isEmpty());
    QToolTip::hideText();
    QVERIFY(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
    QVERIFY(restOn(end, 200).isEmpty());
}

void TestHelpAtCursor::aFixIsOfferedWhereItIsNeeded_data()
{
    QTest::addColumn<bool>("isAtIt");
    QTest::newRow("at it") << true;
    QTest::newRow("elsewhere in the line") << false;
}

void TestHelpAtCursor::aFixIsOfferedWhereItIsNeeded()
{
    QFETCH(const bool, isAtIt);
    const QString wrong = QStringLiteral("y. [t, # x # 🌲");
    setText(sample + wrong);
    QCOMPARE(m_editor->problems().size(), 1u);
    putCursor(isAtIt ? m_editor->problems().front().place.selectionEnd() : int(sample.size()));
    m_editor->offerFixes();
    QVERIFY(menu());
    QCOMPARE(menu()->actions().size(), 1);
    QTest::keyClick(m_editor->windowHandle(), Qt::Key_Return);
    QVERIFY(m_editor->toPlainText() != sample + wrong);
    QVERIFY(readFdo(m_editor->snapshot().bytes()).diagnostics.empty()
            || !hasErrors(readFdo(m_editor->snapshot().bytes()).diagnostics));
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample + wrong);
}

void TestHelpAtCursor::nothingToFixIsSaid()
{
    setText(sample);
    m_editor->offerFixes();
    QVERIFY(!menu());
    QVERIFY(QToolTip::isVisible());
}

void TestHelpAtCursor::anOldFixIsNotOffered()
{
    setText(sample + QStringLiteral("y. [t, # x"));
    putCursor(int(sample.size()));
    m_editor->insertPlainText(QStringLiteral("# "));
    m_editor->offerFixes();
    QVERIFY(!menu());
}

void TestHelpAtCursor::aReadOnlyTextHasNoFixes()
{
    setText(sample + QStringLiteral("y. [t, # x"));
    putCursor(int(sample.size()));
    m_editor->setReadOnly(true);
    m_editor->offerFixes();
    QVERIFY(!menu());
}

void TestHelpAtCursor::thousandsOfProblemsAreNoTrouble()
{
    setText(sample + QStringLiteral("y. [t, # x\n").repeated(10'000));
    QVERIFY(m_editor->problems().size() >= 1'000);
    m_editor->moveCursor(QTextCursor::End);
    m_editor->moveCursor(QTextCursor::Up);
    m_editor->offerFixes();
    QVERIFY(menu());
    QTest::keyClick(m_editor->windowHandle(), Qt::Key_Escape);
    QVERIFY(!menu());
}

QTEST_MAIN(TestHelpAtCursor)
#include "testhelpatcursor.moc"
