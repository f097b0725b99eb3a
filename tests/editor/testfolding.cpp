// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QLineEdit>
#include <QTest>
#include <QTextBlock>

#include "editor/brackets.h"
#include "editor/editormargin.h"
#include "editor/findbar.h"
#include "editor/folding.h"
#include "shownsample.h"

using namespace romanesco;

namespace {

const QString sample = QStringLiteral("# one\nv 1 1 1\nv 2 2 2\n\n# two 🌲\nx. \"a.obj\"\n<$>. x\n");

}

/// Sections that are folded away, and brackets that belong together.
class TestFolding : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void aSectionFoldsToItsFirstLine();
    void theCursorLeavesWhatIsFolded();
    void arrowsGoPastAFold();
    void theCursorOpensWhatItComesInto();
    void editingTheFirstLineOpens_data();
    void editingTheFirstLineOpens();
    void editsElsewhereKeepTheFold();
    void undoOpensWhatItChanges();
    void coloursKeepTheFold();
    void findingOpens();
    void allFoldAndUnfold();
    void theMarginFolds();
    void linesKeepTheirNumbers();
    void aReadOnlyTextFoldsToo();
    void bracketsMatch_data();
    void bracketsMatch();
    void bracketsAreMarked();

private:
    void putCursor(int line, int column = 0);
    [[nodiscard]] QList<int> visible() const;

    std::unique_ptr<FdoEditor> m_editor;
};

void TestFolding::init()
{
    m_editor = test::shownEditor(sample);
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
}

void TestFolding::putCursor(int line, int column)
{
    QTextCursor cursor(m_editor->document()->findBlockByNumber(line));
    cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::MoveAnchor, column);
    m_editor->setTextCursor(cursor);
}

/// The lines that are drawn.
QList<int> TestFolding::visible() const
{
    QList<int> lines;
    for (const FdoEditor::VisibleLine &line : m_editor->visibleLines()) {
        if (line.area.height() > 1) {
            lines += line.number;
        }
    }
    return lines;
}

void TestFolding::aSectionFoldsToItsFirstLine()
{
    putCursor(6);
    m_editor->fold();
    QCOMPARE(visible(), (QList<int>{0, 1, 2, 3, 4, 7}));
    m_editor->unfold();
    QCOMPARE(visible().size(), 8);
    putCursor(3);
    m_editor->fold();
    QCOMPARE(visible().size(), 8);
    QCOMPARE(m_editor->toPlainText(), sample);
    QVERIFY(!m_editor->document()->isUndoAvailable());
}

void TestFolding::theCursorLeavesWhatIsFolded()
{
    putCursor(2, 3);
    m_editor->fold();
    QCOMPARE(m_editor->textCursor().blockNumber(), 0);
    QVERIFY(m_editor->textCursor().atBlockEnd());
    QCOMPARE(visible(), (QList<int>{0, 3, 4, 5, 6, 7}));
}

void TestFolding::arrowsGoPastAFold()
{
    putCursor(0);
    m_editor->fold();
    QTest::keyClick(m_editor.get(), Qt::Key_Down);
    QCOMPARE(m_editor->textCursor().blockNumber(), 3);
    QTest::keyClick(m_editor.get(), Qt::Key_Up);
    QCOMPARE(m_editor->textCursor().blockNumber(), 0);
    QVERIFY(m_editor->folding().isFolded(0));
}

void TestFolding::theCursorOpensWhatItComesInto()
{
    putCursor(0);
    m_editor->fold();
    m_editor->goToLine(2);
    QCOMPARE(m_editor->textCursor().blockNumber(), 1);
    QCOMPARE(visible().size(), 8);
}

void TestFolding::editingTheFirstLineOpens_data()
{
    QTest::addColumn<int>("column");
    QTest::addColumn<int>("key");
    QTest::newRow("typing") << 2 << int(Qt::Key_A);
    QTest::newRow("joining with the line below") << 5 << int(Qt::Key_Delete);
    QTest::newRow("splitting") << 5 << int(Qt::Key_Return);
}

void TestFolding::editingTheFirstLineOpens()
{
    QFETCH(const int, column);
    QFETCH(const int, key);
    putCursor(0, column);
    m_editor->fold();
    QVERIFY(m_editor->folding().isFolded(0));
    QTest::keyClick(m_editor.get(), Qt::Key(key));
    QCOMPARE(visible().size(), m_editor->blockCount());
}

void TestFolding::editsElsewhereKeepTheFold()
{
    putCursor(0);
    m_editor->fold();
    putCursor(6);
    QTest::keyClicks(m_editor.get(), QStringLiteral("# note"));
    QTest::keyClick(m_editor.get(), Qt::Key_Return);
    QVERIFY(m_editor->folding().isFolded(0));
    putCursor(3);
    QTest::keyClick(m_editor.get(), Qt::Key_Return);
    QVERIFY(m_editor->folding().isFolded(0));
}

void TestFolding::undoOpensWhatItChanges()
{
    putCursor(1, 3);
    QTest::keyClick(m_editor.get(), Qt::Key_Delete);
    m_editor->fold();
    QVERIFY(m_editor->folding().isFolded(0));
    m_editor->undo();
    QCOMPARE(m_editor->toPlainText(), sample);
    QCOMPARE(visible().size(), 8);
}

void TestFolding::coloursKeepTheFold()
{
    putCursor(0);
    m_editor->fold();
    QPalette dark;
    dark.setColor(QPalette::Base, QColor(0x20, 0x20, 0x20));
    m_editor->setPalette(dark);
    QCoreApplication::processEvents();
    QVERIFY(m_editor->folding().isFolded(0));
    QCOMPARE(visible().size(), 6);
}

void TestFolding::findingOpens()
{
    FindBar bar(*m_editor);
    putCursor(0);
    m_editor->foldAll();
    bar.openFind();
    bar.findChild<QLineEdit *>()->setText(QStringLiteral("a.obj"));
    QVERIFY(QTest::qWaitFor([&] { return m_editor->textCursor().hasSelection(); }));
    QVERIFY(!m_editor->folding().isFolded(4));
    QVERIFY(m_editor->folding().isFolded(0));
}

void TestFolding::allFoldAndUnfold()
{
    m_editor->foldAll();
    QCOMPARE(visible(), (QList<int>{0, 3, 4, 7}));
    m_editor->unfoldAll();
    QCOMPARE(visible().size(), 8);
}

void TestFolding::theMarginFolds()
{
    auto *margin = m_editor->findChild<EditorMargin *>();
    const QRect head = m_editor->visibleLines()[4].area;
    const QPoint mark(margin->width() - 4, head.center().y());
    QTest::mouseClick(margin, Qt::LeftButton, Qt::NoModifier, mark);
    QCOMPARE(visible(), (QList<int>{0, 1, 2, 3, 4, 7}));
    QTest::mouseClick(margin, Qt::LeftButton, Qt::NoModifier, mark);
    QCOMPARE(visible().size(), 8);
    QTest::mouseClick(margin, Qt::LeftButton, Qt::NoModifier, {4, head.center().y()});
    QCOMPARE(visible().size(), 8);
    QCOMPARE(m_editor->textCursor().blockNumber(), 4);
    const QPoint noMark(margin->width() - 4, m_editor->visibleLines()[1].area.center().y());
    QTest::mouseClick(margin, Qt::LeftButton, Qt::NoModifier, noMark);
    QCOMPARE(visible().size(), 8);
}

void TestFolding::linesKeepTheirNumbers()
{
    putCursor(0);
    m_editor->fold();
    const std::vector<FdoEditor::VisibleLine> lines = m_editor->visibleLines();
    QCOMPARE(lines[1].number, 3);
    QCOMPARE(lines[1].area.top(), lines[0].area.top() + lines[0].area.height());
}

void TestFolding::aReadOnlyTextFoldsToo()
{
    m_editor->setReadOnly(true);
    m_editor->foldAll();
    QCOMPARE(visible(), (QList<int>{0, 3, 4, 7}));
}

void TestFolding::bracketsMatch_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("position");
    QTest::addColumn<QList<int>>("found");
    const QString line = QStringLiteral("🌲<x>. [#, t, (u)] \"[\"");
    QTest::newRow("before") << line << 2 << QList<int>{2, 4};
    QTest::newRow("behind") << line << 5 << QList<int>{2, 4};
    QTest::newRow("round others") << line << 8 << QList<int>{7, 17};
    QTest::newRow("inner") << line << 16 << QList<int>{14, 16};
    QTest::newRow("behind two") << line << 18 << QList<int>{7, 17};
    QTest::newRow("in quotes") << line << 20 << QList<int>();
    QTest::newRow("none") << line << 11 << QList<int>();
    QTest::newRow("alone") << QStringLiteral("[a") << 0 << QList<int>();
    QTest::newRow("of the line below") << QStringLiteral("[a\n]") << 0 << QList<int>();
    QTest::newRow("second line") << QStringLiteral("a\n(b)") << 2 << QList<int>{2, 4};
}

void TestFolding::bracketsMatch()
{
    QFETCH(const QString, text);
    QFETCH(const int, position);
    QFETCH(const QList<int>, found);
    const QTextDocument document(text);
    QList<int> places;
    for (const TextStretch stretch : matchingBrackets(document, position)) {
        QCOMPARE(stretch.end, stretch.begin + 1);
        places += stretch.begin;
    }
    QCOMPARE(places, found);
}

void TestFolding::bracketsAreMarked()
{
    putCursor(6);
    const std::vector<TextStretch> &marked = m_editor->marks().stretches(MarkLayer::Brackets);
    QCOMPARE(marked.size(), 2u);
    putCursor(1);
    QVERIFY(marked.empty());
    QTest::keyClicks(m_editor.get(), QStringLiteral("()"));
    QCOMPARE(marked.size(), 2u);
}

QTEST_MAIN(TestFolding)
#include "testfolding.moc"
