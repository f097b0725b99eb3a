// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QLabel>
#include <QSignalSpy>
#include <QSplitter>

#include "pictures.h"
#include "tests/render/gldoubles.h"
#include "windowsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

/// What stands in place of the picture.
QString reason(const WindowSample &sample)
{
    for (const QLabel *label : sample.pane.findChildren<QLabel *>()) {
        if (label->isVisible() && label->parent() == &sample.pane) {
            return label->text();
        }
    }
    return {};
}

/// A slip in the text is found, and mended.
bool checksTheText(WindowSample &sample)
{
    QTest::keyClicks(&sample.editor, QStringLiteral("x"));
    const bool isFound = QTest::qWaitFor([&] { return sample.problems.topLevelItemCount() > 0; }, 20'000);
    QTest::keyClick(&sample.editor, Qt::Key_Backspace);
    return isFound && QTest::qWaitFor([&] { return sample.problems.topLevelItemCount() == 0; }, 20'000);
}

/// Opens a text with a mesh that was not drawn yet.
void openAnother(WindowSample &sample)
{
    static_cast<void>(sample.write(QStringLiteral("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    sample.drawn = 0;
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("flat.fdo"), "<$>. \"flat.obj\"\n")));
}

}

/// What can fail of OpenGL in the window is told there, and the text is edited and checked all the same.
class TestGlFailures : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aShaderThatDoesNotCompileIsTold();
    void aSceneWithoutMemoryIsTold_data();
    void aSceneWithoutMemoryIsTold();
    void theDriverMayBeReset();
    void whereTheContextIsLostTheReasonIsTold();
    void anotherWindowsContextDrawsOn();
};

void TestGlFailures::aShaderThatDoesNotCompileIsTold()
{
    const BrokenShaders broken;
    WindowSample sample;
    QVERIFY(QTest::qWaitFor([&] { return reason(sample).contains(QStringLiteral("A shader does not compile")); }));
    QVERIFY(checksTheText(sample));
}

void TestGlFailures::aSceneWithoutMemoryIsTold_data()
{
    QTest::addColumn<NoMemory::For>("what");
    QTest::newRow("buffers") << NoMemory::For::Buffers;
    QTest::newRow("drawing") << NoMemory::For::Drawing;
}

void TestGlFailures::aSceneWithoutMemoryIsTold()
{
    QFETCH(const NoMemory::For, what);
    WindowSample sample;
    QVERIFY(sample.waitForPicture());
    {
        const NoMemory none(what);
        openAnother(sample);
        QVERIFY(sample.waitForStrip(true));
        QVERIFY2(sample.strip().startsWith(QStringLiteral("The graphics driver ")), qPrintable(sample.strip()));
        QVERIFY(checksTheText(sample));
    }
    QTest::keyClick(&sample.editor, Qt::Key_Return); // another text, the same mesh
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.waitForStrip(false));
}

/// A driver that comes back within its context.
void TestGlFailures::theDriverMayBeReset()
{
    WindowSample sample;
    QVERIFY(sample.waitForPicture());
    const QImage before = sample.viewport.grabFramebuffer();
    QSignalSpy ready(&sample.viewport, &Viewport::ready);
    sample.drawn = 0;
    {
        const DriverReset reset(1);
        sample.viewport.resetView();
        QVERIFY(ready.wait());
    }
    QVERIFY(sample.waitForPicture());
    QCOMPARE(reason(sample), QString());
    QVERIFY(isLike(sample.viewport.grabFramebuffer(), before));
}

void TestGlFailures::whereTheContextIsLostTheReasonIsTold()
{
    WindowSample sample;
    QVERIFY(sample.waitForPicture());
    const DriverReset reset(1'000'000);
    sample.viewport.resetView();
    QVERIFY(
        QTest::qWaitFor([&] { return reason(sample).contains(QStringLiteral("when the program is started anew")); }));
    QVERIFY(checksTheText(sample));
}

/// Contexts are not shared in this program, so that one goes with its window.
void TestGlFailures::anotherWindowsContextDrawsOn()
{
    WindowSample sample;
    QVERIFY(sample.waitForPicture());
    const QImage before = sample.viewport.grabFramebuffer();
    QSignalSpy ready(&sample.viewport, &Viewport::ready);
    sample.drawn = 0;
    const QSize size = sample.pane.size();
    sample.pane.setParent(nullptr);
    sample.pane.resize(size);
    sample.pane.show();
    QVERIFY(ready.count() == 1 || ready.wait());
    QVERIFY(sample.waitForPicture());
    QVERIFY(isLike(sample.viewport.grabFramebuffer(), before));
    sample.window.findChild<QSplitter *>()->addWidget(&sample.pane);
    QVERIFY(ready.count() == 2 || ready.wait());
    QVERIFY(sample.waitForPicture());
}

int main(int argc, char **argv)
{
    return runWithGl<TestGlFailures>(argc, argv);
}
#include "testglfailures.moc"
