// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QMimeData>
#include <QStatusBar>

#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

constexpr auto scene = "# a scene\no \"cube.obj\" ((9, 0, 0), #, #)\nl # #\n";

struct DropSample : Sample {
    DropSample()
    {
        QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj")));
        QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("other.OBJ")));
        QDir(folder.path()).mkdir(QStringLiteral("parts"));
        (void)write(QStringLiteral("parts/part.fdo"), "x. \"../cube.obj\"\n<$>. x\n");
    }
    void drop(const QStringList &names, const QWidget &onto)
    {
        QMimeData files;
        QList<QUrl> urls;
        for (const QString &name : names) {
            urls << QUrl::fromLocalFile(path(name));
        }
        files.setUrls(urls);
        const QPoint place = onto.mapTo(&window, onto.rect().center());
        QDragEnterEvent enter(place, Qt::CopyAction, &files, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(place), Qt::CopyAction, &files, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window, &event);
    }
};

}

/// Files that are dropped on a scene.
class TestSceneDrop : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aFileIsAddedToTheScene_data();
    void aFileIsAddedToTheScene();
    void severalAreOneUndoStep();
    void besideAndOnOtherTextsFilesOpen();
    void aTextWithoutAFolderHasWholePaths();
    void aSceneThatIsDroppedOpens();
};

void TestSceneDrop::aFileIsAddedToTheScene_data()
{
    QTest::addColumn<bool>("isOnPicture");
    QTest::newRow("picture") << true;
    QTest::newRow("text") << false;
}

void TestSceneDrop::aFileIsAddedToTheScene()
{
    QFETCH(const bool, isOnPicture);
    DropSample sample;
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("a.sdo"), scene)));
    const QWidget &onto = isOnPicture ? static_cast<const QWidget &>(sample.viewport) : sample.visibleEditor();
    sample.drop({QStringLiteral("parts/part.fdo")}, onto);
    QCOMPARE(sample.visibleEditor().toPlainText(),
             QStringLiteral("# a scene\no \"cube.obj\" ((9, 0, 0), #, #)\nf \"parts/part.fdo\" #\nl # #\n"));
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().surroundings()->scene->items.size() == 2; }, 20'000));
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
    sample.visibleEditor().undo();
    QCOMPARE(sample.visibleEditor().toPlainText(), QString::fromLatin1(scene));
}

void TestSceneDrop::severalAreOneUndoStep()
{
    DropSample sample;
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("a.sdo"), scene)));
    sample.drop({QStringLiteral("other.OBJ"), QStringLiteral("parts/part.fdo")}, sample.viewport);
    const QString text = sample.visibleEditor().toPlainText();
    QVERIFY2(text.contains(QStringLiteral("\no \"other.OBJ\" #\nf \"parts/part.fdo\" #\n")), qPrintable(text));
    sample.visibleEditor().undo();
    QCOMPARE(sample.visibleEditor().toPlainText(), QString::fromLatin1(scene));
}

void TestSceneDrop::besideAndOnOtherTextsFilesOpen()
{
    DropSample sample;
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("a.sdo"), scene)));
    sample.drop({QStringLiteral("parts/part.fdo")}, *sample.window.statusBar());
    QVERIFY(sample.visibleEditor().toPlainText().startsWith(QStringLiteral("x. ")));
    // now an .fdo is looked at
    sample.drop({QStringLiteral("other.OBJ")}, sample.viewport);
    QVERIFY(sample.visibleEditor().toPlainText().startsWith(QStringLiteral("# A cube")));
}

void TestSceneDrop::aTextWithoutAFolderHasWholePaths()
{
    DropSample sample;
    QVERIFY(sample.openAndWait(QStringLiteral(":/examples/terrain.sdo")));
    if (sample.visibleEditor().isReadOnly()) {
        QSKIP("examples are not edited");
    }
    sample.drop({QStringLiteral("cube.obj")}, sample.viewport);
    QVERIFY(sample.visibleEditor().toPlainText().contains(
        QStringLiteral("\no \"%1\" #").arg(sample.path(QStringLiteral("cube.obj")))));
}

void TestSceneDrop::aSceneThatIsDroppedOpens()
{
    DropSample sample;
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("a.sdo"), scene)));
    (void)sample.write(QStringLiteral("b.sdo"), "# b\n");
    sample.drop({QStringLiteral("b.sdo"), QStringLiteral("cube.obj")}, sample.viewport);
    QCOMPARE(sample.visibleEditor().toPlainText(), QStringLiteral("# b\n"));
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestSceneDrop>(argc, argv);
}
#include "testscenedrop.moc"
