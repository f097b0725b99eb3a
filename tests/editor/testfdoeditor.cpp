// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QHelpEvent>
#include <QTest>
#include <QTextBlock>
#include <QTextDocumentFragment>
#include <QTextLayout>
#include <QToolTip>
#include <QWheelEvent>

#include "core/formats/fdoreader.h"
#include "editor/fdoeditor.h"
#include "editor/syntax.h"

using namespace romanesco;

namespace {

Diagnostic error(std::size_t begin, std::size_t end)
{
    return {DiagnosticCode::UnknownName, {begin, end}, {"something"}};
}

Diagnostic warning(std::size_t begin, std::size_t end)
{
    return {DiagnosticCode::EmptyIteration, {begin, end}, {"something"}};
}

Diagnostic hint(std::size_t begin, std::size_t end)
{
    return {DiagnosticCode::Unused, {begin, end}, {"something"}};
}

/// What is underlined with waves, as text.
QStringList squiggled(const FdoEditor &editor)
{
    QStringList texts;
    for (const QTextEdit::ExtraSelection &selection : editor.extraSelections()) {
        if (selection.format.underlineStyle() == QTextCharFormat::WaveUnderline) {
            texts += selection.cursor.selectedText();
        }
    }
    return texts;
}

QColor colourAt(const FdoEditor &editor, int line, int column)
{
    for (const QTextLayout::FormatRange &range : editor.document()->findBlockByNumber(line).layout()->formats()) {
        if (range.start <= column && column < range.start + range.length) {
            return range.format.foreground().color();
        }
    }
    return {};
}

}

class TestFdoEditor : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void textIsColouredByOurDefinition();
    void coloursFollowThePalette();
    void squigglesLieUnderWhatIsMeant_data();
    void squigglesLieUnderWhatIsMeant();
    void whatIsMissingIsMarkedBesideIt_data();
    void whatIsMissingIsMarkedBesideIt();
    void squigglesMoveWithTheText();
    void hintsAreNotMarked();
    void theMarginKnowsTheWorstOfALine();
    void hoveringSaysWhatIsWrong();
    void nextProblemGoesRound();
    void theWheelZoomsTheText();
    void colouringIsNoEdit();
};

void TestFdoEditor::textIsColouredByOurDefinition()
{
    QCOMPARE(syntaxFor(QStringLiteral("tree.fdo")).name(), QStringLiteral("Romanesco Fractal"));
    FdoEditor editor;
    editor.setFileName(QStringLiteral("tree.fdo"));
    editor.setPlainText(QStringLiteral("# größer\nhalf 0.5 0.5 0.5\nx. \"a.obj\""));
    QCoreApplication::processEvents();
    const QColor comment = colourAt(editor, 0, 3);
    const QColor number = colourAt(editor, 1, 6);
    const QColor string = colourAt(editor, 2, 5);
    QVERIFY(comment.isValid() && number.isValid() && string.isValid());
    QVERIFY(comment != number && number != string && string != comment);
}

void TestFdoEditor::coloursFollowThePalette()
{
    FdoEditor editor;
    editor.setFileName(QStringLiteral("tree.fdo"));
    editor.setPlainText(QStringLiteral("half 0.5 0.5 0.5"));
    QPalette dark;
    dark.setColor(QPalette::Base, QColor(0x20, 0x20, 0x20));
    dark.setColor(QPalette::Text, Qt::white);
    editor.setPalette(dark);
    QCoreApplication::processEvents();
    QVERIFY(editor.colour(KSyntaxHighlighting::Theme::CurrentLine).lightness() < 100);
    QVERIFY(colourAt(editor, 0, 6).lightness() > 100);
}

void TestFdoEditor::squigglesLieUnderWhatIsMeant_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("marked");
    const QString mesh = QStringLiteral("x. \"a.obj\"\n");
    QTest::newRow("ascii") << mesh + QStringLiteral("<$>. rigt") << QStringList{QStringLiteral("rigt")};
    QTest::newRow("umlauts above") << QStringLiteral("# größer äöü\n") + mesh + QStringLiteral("<$>. rigt")
                                   << QStringList{QStringLiteral("rigt")};
    QTest::newRow("in the same line") << mesh + QStringLiteral("größe<x>. [#, 木🌲] x\n<$>. größe 2")
                                      << QStringList{QStringLiteral("木🌲")};
    QTest::newRow("beyond the basic plane") << QStringLiteral("# 🌲🌲🌲\n") + mesh + QStringLiteral("<$>. rigt # 🌲")
                                            << QStringList{QStringLiteral("rigt")};
    QTest::newRow("cr lf") << QStringLiteral("# ä\r\n\r\nx. \"a.obj\"\r\n<$>. rigt\r\n")
                           << QStringList{QStringLiteral("rigt")};
}

void TestFdoEditor::squigglesLieUnderWhatIsMeant()
{
    QFETCH(const QString, text);
    FdoEditor editor;
    editor.setPlainText(text);
    const TextSnapshot snapshot = editor.snapshot();
    editor.setDiagnostics(readFdo(snapshot.bytes()).diagnostics, snapshot);
    QTEST(squiggled(editor), "marked");
}

void TestFdoEditor::whatIsMissingIsMarkedBesideIt_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("at");
    QTest::addColumn<QString>("marked");
    QTest::newRow("end of line") << QStringLiteral("ab\ncd") << 2 << QStringLiteral("b");
    QTest::newRow("begin of line") << QStringLiteral("ab\ncd") << 3 << QStringLiteral("c");
    QTest::newRow("empty line") << QStringLiteral("ab\n\ncd") << 3 << QString();
    QTest::newRow("end of text") << QStringLiteral("ab\ncd") << 5 << QStringLiteral("d");
}

void TestFdoEditor::whatIsMissingIsMarkedBesideIt()
{
    QFETCH(const QString, text);
    QFETCH(const int, at);
    QFETCH(const QString, marked);
    FdoEditor editor;
    editor.setPlainText(text);
    const auto offset = static_cast<std::size_t>(at);
    editor.setDiagnostics({error(offset, offset)}, editor.snapshot());
    QCOMPARE(squiggled(editor), QStringList{marked});
}

void TestFdoEditor::squigglesMoveWithTheText()
{
    FdoEditor editor;
    editor.setPlainText(QStringLiteral("<$>. rigt"));
    editor.setDiagnostics({error(5, 9)}, editor.snapshot());
    QTextCursor(editor.document()).insertText(QStringLiteral("# above\n"));
    QCOMPARE(squiggled(editor), QStringList{QStringLiteral("rigt")});
}

void TestFdoEditor::hintsAreNotMarked()
{
    FdoEditor editor;
    editor.setPlainText(QStringLiteral("a b c"));
    editor.setDiagnostics({hint(0, 1), warning(2, 3)}, editor.snapshot());
    QCOMPARE(squiggled(editor), QStringList{QStringLiteral("b")});
    QCOMPARE(editor.problems().size(), 1u);
}

void TestFdoEditor::theMarginKnowsTheWorstOfALine()
{
    FdoEditor editor;
    editor.resize(400, 300);
    editor.setPlainText(QStringLiteral("a b\nc\nd"));
    editor.setDiagnostics({warning(0, 1), error(2, 3), warning(6, 7)}, editor.snapshot());
    editor.show();
    const std::vector<FdoEditor::VisibleLine> lines = editor.visibleLines();
    QCOMPARE(lines.size(), 3u);
    QCOMPARE(lines[0].worst->severity, Severity::Error);
    QVERIFY(!lines[1].worst);
    QCOMPARE(lines[2].worst->severity, Severity::Warning);
    QCOMPARE(editor.messagesInLine(0).count(u'\n'), 1);
}

void TestFdoEditor::hoveringSaysWhatIsWrong()
{
    FdoEditor editor;
    editor.resize(400, 300);
    editor.setPlainText(QStringLiteral("ä <$>. rigt"));
    const TextSnapshot snapshot = editor.snapshot();
    editor.setDiagnostics({error(8, 12)}, snapshot);
    editor.show();
    QVERIFY(QTest::qWaitForWindowExposed(&editor));
    const auto hover = [&](int position) {
        QTextCursor cursor(editor.document());
        cursor.setPosition(position);
        const QPoint point = editor.cursorRect(cursor).center() + QPoint(2, 0);
        QHelpEvent event(QEvent::ToolTip, point, editor.viewport()->mapToGlobal(point));
        QCoreApplication::sendEvent(editor.viewport(), &event);
        return QTextDocumentFragment::fromHtml(QToolTip::text()).toPlainText();
    };
    QCOMPARE(hover(8), editor.problems().front().message);
    QToolTip::hideText();
    QVERIFY(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
    QCOMPARE(hover(1), QString());
}

void TestFdoEditor::nextProblemGoesRound()
{
    FdoEditor editor;
    editor.setPlainText(QStringLiteral("ä b c d"));
    editor.goToNextProblem();
    QCOMPARE(editor.textCursor().position(), 0);
    editor.setDiagnostics({error(3, 4), warning(7, 8)}, editor.snapshot());
    for (const int expected : {2, 6, 2}) {
        editor.goToNextProblem();
        QCOMPARE(editor.textCursor().position(), expected);
    }
}

void TestFdoEditor::theWheelZoomsTheText()
{
    FdoEditor editor;
    const qreal usual = editor.font().pointSizeF();
    const auto turn = [&](Qt::KeyboardModifiers modifiers, QPoint delta) {
        QWheelEvent event({10, 10}, editor.mapToGlobal(QPointF(10, 10)), {}, delta, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(editor.viewport(), &event);
    };
    turn(Qt::NoModifier, {0, 120});
    QCOMPARE(editor.font().pointSizeF(), usual);
    turn(Qt::ControlModifier, {0, 120});
    QCOMPARE(editor.font().pointSizeF(), usual + 1);
    turn(Qt::AltModifier, {-120, 0});
    turn(Qt::ControlModifier, {0, -120});
    QCOMPARE(editor.font().pointSizeF(), usual - 1);
    editor.zoomBy(-1'000);
    QVERIFY(editor.font().pointSizeF() > 0);
    editor.resetZoom();
    QCOMPARE(editor.font().pointSizeF(), usual);
}

void TestFdoEditor::colouringIsNoEdit()
{
    FdoEditor editor;
    editor.setPlainText(QStringLiteral("x. \"a.obj\""));
    editor.setFileName(QStringLiteral("a.fdo"));
    QCoreApplication::processEvents();
    QVERIFY(!editor.document()->isModified());
    QVERIFY(!editor.document()->isUndoAvailable());
}

QTEST_MAIN(TestFdoEditor)
#include "testfdoeditor.moc"
