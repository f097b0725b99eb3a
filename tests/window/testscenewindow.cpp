// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QSlider>

#include "windowsample.h"

using namespace romanesco;
using romanesco::test::squiggles;
using Sample = romanesco::test::WindowSample;

/// The window with an .sdo.
class TestSceneWindow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aSavedSceneBringsItsFiles();
    void aSceneIsDrawnFromItsCameraWithoutADepth();
    void whatASceneNamesIsAProblemAtItsName();
    void theProblemsOfAFileAreOneClickAway();
};

void TestSceneWindow::aSavedSceneBringsItsFiles()
{
    Sample sample;
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/terrain.sdo")));
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.window.saveFile(sample.path(QStringLiteral("mine.sdo"))));
    const QStringList files = QDir(sample.folder.path()).entryList(QDir::Files);
    QVERIFY2(files.contains(QStringLiteral("terrain.fdo")), qPrintable(files.join(u' ')));
    // Opened again, it lacks nothing.
    QVERIFY(sample.window.openFile(sample.path(QStringLiteral("mine.sdo"))));
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.strip(), QString());
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
}

void TestSceneWindow::aSceneIsDrawnFromItsCameraWithoutADepth()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QVERIFY(QFile::copy(QStringLiteral(":/examples/sierpinski.fdo"), sample.path(QStringLiteral("a.fdo"))));
    QVERIFY(QFile::copy(QStringLiteral(":/examples/tetrahedron.obj"), sample.path(QStringLiteral("tetrahedron.obj"))));
    QVERIFY(sample.window.openFile(sample.write(
        QStringLiteral("s.sdo"), "c (0, 0, -5) # 4 orthographic\nf \"a.fdo\" #\no \"tetrahedron.obj\" #\n")));
    QVERIFY(QTest::qWaitFor(
        [&] {
            return sample.viewport.camera().position == glm::dvec3(0, 0, -5) && sample.viewport.isPictureFinished();
        },
        60'000));
    QVERIFY(sample.drawn > 100);
    QVERIFY(!sample.depthSlider().isEnabled());
    const auto isOrthographicChecked = [&] {
        for (const QAction *action : sample.viewport.actions()) {
            if (action->isCheckable()) {
                return action->isChecked();
            }
        }
        return false;
    };
    QVERIFY(isOrthographicChecked());
    // A fractal by itself has its depth, and a view of its own.
    sample.window.openExample();
    QVERIFY(QTest::qWaitFor([&] { return sample.depthSlider().isEnabled(); }, 20'000));
}

void TestSceneWindow::whatASceneNamesIsAProblemAtItsName()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    (void)sample.write(QStringLiteral("bad.fdo"), "<$>. nothing\n");
    QVERIFY(sample.window.openFile(
        sample.write(QStringLiteral("s.sdo"), "# two files\nf \"bad.fdo\" #\no \"none.obj\" #\n")));
    QVERIFY(sample.waitForStrip(true));
    QCOMPARE(sample.problems.topLevelItemCount(), 2);
    QCOMPARE(sample.problems.topLevelItem(0)->text(0), QStringLiteral("s.sdo:2:3"));
    QVERIFY(sample.problems.topLevelItem(0)->text(1).startsWith(QStringLiteral("cannot use \"bad.fdo\": line 1")));
    QVERIFY(sample.problems.topLevelItem(1)->text(1).startsWith(QStringLiteral("cannot read \"none.obj\"")));
    QCOMPARE(squiggles(sample.editor), 2);
}

void TestSceneWindow::theProblemsOfAFileAreOneClickAway()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    (void)sample.write(QStringLiteral("bad.fdo"), "# größe\r\n\r\n<$>. nöthing\r\n");
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("s.sdo"), "f \"bad.fdo\" #\n")));
    QVERIFY(sample.waitForStrip(true));
    QTreeWidgetItem *problem = sample.problems.topLevelItem(0);
    QCOMPARE(problem->childCount(), 1);
    QTreeWidgetItem *note = problem->child(0);
    QCOMPARE(note->text(0), QStringLiteral("bad.fdo:3:6"));
    sample.problems.scrollToItem(note);
    QTest::mouseClick(sample.problems.viewport(), Qt::LeftButton, {}, sample.problems.visualItemRect(note).center());
    const FdoEditor &editor = sample.visibleEditor();
    QVERIFY(editor.toPlainText().startsWith(QString::fromUtf8("# größe")));
    QCOMPARE(editor.textCursor().blockNumber(), 2);
    QCOMPARE(editor.textCursor().positionInBlock(), 5);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestSceneWindow>(argc, argv);
}
#include "testscenewindow.moc"
