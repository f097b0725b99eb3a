// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTest>

#include "app/window/outlinepane.h"
#include "editor/fdoeditor.h"

using namespace romanesco;

namespace {

const QString fractal =
    QStringLiteral("half 0.5 0.5 0.5\nv 1 2 3\nt.p. (p, #, half)\nx. \"x.obj\"\nz<x>. [t.2] x\n<$>. z 3\n");
const QString scene =
    QStringLiteral("# A scene\nc (0, 1, -5) # 40\nf \"tree.fdo\" #\n# o \"cube.obj\" ((0, 1, 0), #, #)\n"
                   "# o is a mesh\nl (4, 6, -3) #\n");

struct Sample {
    FdoEditor editor;
    OutlinePane pane;

    explicit Sample(const QString &text, const QString &name = QStringLiteral("a.fdo"))
    {
        editor.setFileName(name);
        editor.setPlainText(text);
        editor.resize(500, 300);
        editor.show();
        pane.resize(300, 300);
        pane.show();
        pane.follow(editor);
    }
    [[nodiscard]] QStringList rows() const
    {
        QStringList found;
        for (int i = 0; i < pane.topLevelItemCount(); ++i) {
            const QTreeWidgetItem &item = *pane.topLevelItem(i);
            const QVariant tick = item.data(0, Qt::CheckStateRole);
            const QString mark = !tick.isValid() ? QString()
                : tick.toInt() == Qt::Checked    ? QStringLiteral("+")
                                                 : QStringLiteral("-");
            found << mark + item.text(0) + u' ' + item.text(1);
        }
        return found;
    }
    [[nodiscard]] QString marked() const
    {
        const QList<QTreeWidgetItem *> items = pane.selectedItems();
        return items.isEmpty() ? QString() : items.first()->text(0);
    }
    [[nodiscard]] QPoint rowPlace(int row) const { return pane.visualItemRect(pane.topLevelItem(row)).center(); }
    [[nodiscard]] QPoint tickPlace(int row) const
    {
        QStyleOptionViewItem option;
        option.initFrom(&pane);
        option.rect = pane.visualItemRect(pane.topLevelItem(row));
        option.features = QStyleOptionViewItem::HasCheckIndicator | QStyleOptionViewItem::HasDisplay;
        return pane.style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, &pane).center();
    }
    void click(const QPoint &place) { QTest::mouseClick(pane.viewport(), Qt::LeftButton, {}, place); }
};

}

/// What a text declares, to be clicked and ticked.
class TestOutlinePane : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void declarationsAreListedWithTheirKinds();
    void aClickLeadsToTheText();
    void theCursorsLineIsMarked();
    void theTextIsFollowed();
    void aTickCommentsOutAndIn();
    void theSpaceBarTicks();
    void aReadOnlyTextHasNoTicksToMove();
    void anotherTextHasItsOwn();
};

void TestOutlinePane::declarationsAreListedWithTheirKinds()
{
    QCOMPARE(Sample(fractal).rows(),
             (QStringList{QStringLiteral("half Vector"), QStringLiteral("t Transformation"), QStringLiteral("x Object"),
                          QStringLiteral("z Recursive"), QStringLiteral("<$> Object")}));
    QCOMPARE(Sample(scene, QStringLiteral("a.sdo")).rows(),
             (QStringList{QStringLiteral("Camera Camera"), QStringLiteral("+tree.fdo Fractal"),
                          QStringLiteral("-cube.obj Mesh"), QStringLiteral("Light Light")}));
}

void TestOutlinePane::aClickLeadsToTheText()
{
    Sample sample(fractal);
    sample.click(sample.rowPlace(3));
    QCOMPARE(sample.editor.textCursor().blockNumber(), 4);
    QCOMPARE(sample.editor.textCursor().positionInBlock(), 0);
    // Where it is by now, although the list is not made anew yet.
    QTextCursor(sample.editor.document()).insertText(QStringLiteral("# above\n"));
    sample.click(sample.rowPlace(2));
    QCOMPARE(sample.editor.textCursor().blockNumber(), 4);
}

void TestOutlinePane::theCursorsLineIsMarked()
{
    Sample sample(fractal);
    QCOMPARE(sample.marked(), QStringLiteral("half"));
    sample.editor.goToLine(5);
    QCOMPARE(sample.marked(), QStringLiteral("z"));
    sample.editor.goToLine(2);
    QCOMPARE(sample.marked(), QString());
}

void TestOutlinePane::theTextIsFollowed()
{
    Sample sample(fractal);
    sample.editor.goToLine(1);
    QTest::keyClicks(&sample.editor, QStringLiteral("be"));
    QVERIFY(QTest::qWaitFor([&] { return sample.rows().first() == QStringLiteral("behalf Vector"); }));
    QCOMPARE(sample.marked(), QStringLiteral("behalf"));
}

void TestOutlinePane::aTickCommentsOutAndIn()
{
    Sample sample(scene, QStringLiteral("a.sdo"));
    sample.editor.goToLine(1);
    sample.click(sample.tickPlace(1));
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("\n# f \"tree.fdo\" #\n")));
    QCOMPARE(sample.rows()[1], QStringLiteral("-tree.fdo Fractal"));
    // It is no way to go there.
    QCOMPARE(sample.editor.textCursor().blockNumber(), 0);
    sample.click(sample.tickPlace(2));
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("\no \"cube.obj\" ((0, 1, 0), #, #)\n")));
    QCOMPARE(sample.rows()[2], QStringLiteral("+cube.obj Mesh"));
    sample.editor.undo();
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText(), scene);
    QVERIFY(QTest::qWaitFor([&] { return sample.rows()[1] == QStringLiteral("+tree.fdo Fractal"); }));
    QCOMPARE(sample.rows()[2], QStringLiteral("-cube.obj Mesh"));
}

void TestOutlinePane::theSpaceBarTicks()
{
    Sample sample(scene, QStringLiteral("a.sdo"));
    sample.pane.setFocus();
    sample.pane.setCurrentItem(sample.pane.topLevelItem(1));
    QTest::keyClick(&sample.pane, Qt::Key_Space);
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("\n# f \"tree.fdo\" #\n")));
    QTest::keyClick(&sample.pane, Qt::Key_Return);
    QCOMPARE(sample.editor.textCursor().blockNumber(), 2);
}

void TestOutlinePane::aReadOnlyTextHasNoTicksToMove()
{
    Sample sample(scene, QStringLiteral("a.sdo"));
    sample.editor.setReadOnly(true);
    sample.pane.update();
    sample.click(sample.tickPlace(1));
    QCOMPARE(sample.rows()[1], QStringLiteral("+tree.fdo Fractal"));
    QCOMPARE(sample.editor.toPlainText(), scene);
}

void TestOutlinePane::anotherTextHasItsOwn()
{
    Sample sample(fractal);
    FdoEditor other;
    other.setFileName(QStringLiteral("b.sdo"));
    other.setPlainText(scene);
    sample.pane.follow(other);
    QCOMPARE(sample.rows().size(), 4);
    sample.click(sample.tickPlace(1));
    QVERIFY(other.toPlainText().contains(QStringLiteral("# f ")));
    QCOMPARE(sample.editor.toPlainText(), fractal);
}

QTEST_MAIN(TestOutlinePane)
#include "testoutlinepane.moc"
