// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QActionGroup>
#include <QRegularExpression>
#include <QStatusBar>
#include <QWheelEvent>

#include <glm/geometric.hpp>

#include "pictures.h"
#include "windowsample.h"

using namespace romanesco;
using romanesco::test::shareOfDifferent;

namespace {

/// Of coarse pictures: it is where from that counts.
struct Sample : romanesco::test::WindowSample {
    Sample() { viewport.setPixelTolerance(4.0); }
};

QAction &action(Sample &sample, const QString &text)
{
    for (QAction *action : sample.window.findChildren<QAction *>()) {
        if (QString(action->text()).remove(u'&') == text) {
            return *action;
        }
    }
    qFatal("no action %s", qPrintable(text));
}

/// Turns the wheel so often, back where it is negative, over what the middle of the picture shows.
void zoom(Sample &sample, int notches)
{
    const QPointF middle(sample.viewport.width() / 2.0 + 8.0, sample.viewport.height() / 2.0 + 5.0);
    for (int i = 0; i < std::abs(notches); ++i) {
        QWheelEvent event(middle, sample.viewport.mapToGlobal(middle), {}, {0, notches > 0 ? 120 : -120}, {}, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&sample.viewport, &event);
    }
}

bool waitForSurfaces(const Sample &sample)
{
    return QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 20'000);
}

/// Waits for the other scene, behind which others may come that were under way.
bool goEndless(Sample &sample)
{
    const auto scene = [&] {
        const auto surroundings = sample.viewport.view().surroundings();
        return surroundings ? surroundings->scene : nullptr;
    };
    const auto before = scene();
    action(sample, QStringLiteral("Endless")).trigger();
    const auto isEndless = [](const Scene &any) { return any.items[0].model->graph.levels().levelCount() > 1'000; };
    return QTest::qWaitFor([&] { return scene() && scene() != before && isEndless(*scene()); }, 20'000);
}

std::size_t depthOfView(const Sample &sample)
{
    const auto surroundings = sample.viewport.view().surroundings();
    return surroundings ? surroundings->path.size() : 0;
}

}

/// Views without end, and views that are kept in the text.
class TestSavedViews : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void endlessGoesDeeperThanTheText();
    void whatDoesNotShrinkIsShownAsItIs();
    void aDeepViewIsKeptInTheText();
    void aSceneKeepsItsCamera();
    void aClickedCopyHasAnAddress();
    void theDissertationsZoomHasATrail();
};

void TestSavedViews::endlessGoesDeeperThanTheText()
{
    Sample sample;
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/menger.fdo")));
    QVERIFY(sample.waitForPicture());
    zoom(sample, 1);
    QVERIFY(waitForSurfaces(sample));
    zoom(sample, 200);
    QVERIFY(depthOfView(sample) <= 4);
    const QString text = sample.editor.toPlainText();
    sample.viewport.resetView();
    QVERIFY(sample.waitForPicture());
    QVERIFY(goEndless(sample));
    zoom(sample, 1);
    QVERIFY(waitForSurfaces(sample));
    zoom(sample, 200);
    QVERIFY(depthOfView(sample) > 15);
    QCOMPARE(sample.strip(), QString());
    // The text and its depth stay what they are.
    QCOMPARE(sample.editor.toPlainText(), text);
    action(sample, QStringLiteral("Endless")).trigger();
    QVERIFY(QTest::qWaitFor([&] { return depthOfView(sample) <= 4; }, 20'000));
}

void TestSavedViews::whatDoesNotShrinkIsShownAsItIs()
{
    Sample sample;
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    QVERIFY(sample.window.openFile(sample.write(
        QStringLiteral("row.fdo"), "step 3 0 0\nto.p. (p, #, #)\nx. \"cube.obj\"\nz<x>. [#, to.step] x\n<$>. z 5\n")));
    QVERIFY(sample.waitForPicture());
    const std::uint64_t drawn = sample.drawn;
    action(sample, QStringLiteral("Endless")).trigger();
    QVERIFY(sample.waitForStrip(true));
    QVERIFY2(sample.strip().contains(QStringLiteral("own depth")), qPrintable(sample.strip()));
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.drawn, drawn);
    action(sample, QStringLiteral("Endless")).trigger();
    QVERIFY(sample.waitForStrip(false));
}

void TestSavedViews::aDeepViewIsKeptInTheText()
{
    Sample sample;
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/menger.fdo")));
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.window.saveFile(sample.path(QStringLiteral("mine.fdo"))));
    QVERIFY(goEndless(sample));
    zoom(sample, 1);
    QVERIFY(waitForSurfaces(sample));
    zoom(sample, 250);
    const std::size_t depth = depthOfView(sample);
    const glm::dvec3 position = sample.viewport.camera().position;
    QVERIFY(depth > 15);
    const QString before = sample.editor.toPlainText();
    action(sample, QStringLiteral("Save View in Text")).trigger();
    QVERIFY2(sample.editor.toPlainText().startsWith(QStringLiteral("# view: endless, in 0: ")),
             qPrintable(sample.editor.toPlainText().left(80)));
    // One step back and forth.
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText(), before);
    sample.editor.redo();
    QVERIFY(sample.window.saveFile(sample.path(QStringLiteral("mine.fdo"))));

    Sample other;
    QVERIFY(other.waitForPicture());
    QVERIFY(other.window.openFile(sample.path(QStringLiteral("mine.fdo"))));
    QVERIFY(QTest::qWaitFor([&] { return depthOfView(other) == depth; }, 20'000));
    QVERIFY(other.viewport.camera().position == position);
    QVERIFY(action(other, QStringLiteral("Endless")).isChecked());
}

void TestSavedViews::aSceneKeepsItsCamera()
{
    Sample sample;
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    const QString file = sample.write(QStringLiteral("s.sdo"), "# mine\nc (0, 0, -5) # 40 # look\no \"cube.obj\" #\n");
    QVERIFY(sample.window.openFile(file));
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.camera().position == glm::dvec3(0, 0, -5); }, 20'000));
    QVERIFY(sample.waitForPicture());
    QTest::keyClick(&sample.viewport, Qt::Key_Right);
    QTest::keyClick(&sample.viewport, Qt::Key_Up);
    const Camera turned = sample.viewport.view().cameraInWorld();
    action(sample, QStringLiteral("Save View in Text")).trigger();
    const QStringList lines = sample.editor.toPlainText().split(u'\n');
    QCOMPARE(lines.size(), 4);
    QCOMPARE(lines[0], QStringLiteral("# mine"));
    QVERIFY2(lines[1].startsWith(QStringLiteral("c (")) && lines[1].endsWith(QStringLiteral("40 perspective # look")),
             qPrintable(lines[1]));
    QVERIFY(sample.waitForPicture());
    const Camera again = sample.viewport.view().cameraInWorld();
    QVERIFY(glm::distance(again.position, turned.position) < 1e-9);
    QVERIFY(glm::distance(again.worldFromCamera[2], turned.worldFromCamera[2]) < 1e-12);
}

void TestSavedViews::aClickedCopyHasAnAddress()
{
    Sample sample;
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/menger.fdo")));
    QVERIFY(sample.waitForPicture());
    zoom(sample, 1);
    QVERIFY(waitForSurfaces(sample));
    const auto click = [&](QPoint place) { QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, place); };
    const QStatusBar &bar = *sample.window.findChild<QStatusBar *>();
    click(QPoint(sample.viewport.width() / 2 + 8, sample.viewport.height() / 2 + 5));
    static const QRegularExpression words(
        QStringLiteral("^sponge\\[1\\] box\\.\\d+ › sponge\\[2\\] box\\.\\d+ › sponge\\[3\\] box\\.\\d+ › "
                       "sponge\\[4\\] box\\.\\d+$"));
    QVERIFY2(words.match(bar.currentMessage()).hasMatch(), qPrintable(bar.currentMessage()));
    zoom(sample, -8);
    click(QPoint(3, 3));
    QCOMPARE(bar.currentMessage(), QString());
    QVERIFY(goEndless(sample));
    zoom(sample, 8);
    QVERIFY(waitForSurfaces(sample));
    click(QPoint(sample.viewport.width() / 2 + 8, sample.viewport.height() / 2 + 5));
    QVERIFY2(bar.currentMessage().startsWith(QStringLiteral("sponge[1] box.")), qPrintable(bar.currentMessage()));
}

void TestSavedViews::theDissertationsZoomHasATrail()
{
    Sample sample;
    // so that the zoom leads to where the dynamic fractal is seen too
    sample.window.resize(900, 650);
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/menger.fdo")));
    QVERIFY(sample.waitForPicture());
    zoom(sample, 1);
    QVERIFY(waitForSurfaces(sample));
    zoom(sample, 25);
    QVERIFY(sample.waitForPicture());
    const QImage plain = sample.viewport.grabFramebuffer();
    action(sample, QStringLiteral("Trail of 0")).trigger();
    QVERIFY(sample.waitForPicture());
    const QImage dynamic = sample.viewport.grabFramebuffer();
    QVERIFY(shareOfDifferent(dynamic, plain) > 0.1);
    // What is clicked is what is seen, but for copies of which less is seen than a sample finds.
    int seen = 0;
    for (const QPoint off : {QPoint(0, 0), QPoint(30, 20), QPoint(-40, 10), QPoint(20, -50), QPoint(-30, -30)}) {
        const QPoint place = QPoint(sample.viewport.width() / 2, sample.viewport.height() / 2) + off;
        QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, place);
        QVERIFY(sample.waitForPicture());
        const QRect there(place - QPoint(1, 1), QSize(3, 3));
        seen += sample.viewport.grabFramebuffer().copy(there) != dynamic.copy(there) ? 1 : 0;
    }
    QVERIFY2(seen >= 3, qPrintable(QString::number(seen)));
    sample.viewport.select(std::nullopt);
    QActionGroup *trail = action(sample, QStringLiteral("Trail of 0")).actionGroup();
    trail->actions().first()->trigger();
    QVERIFY(sample.waitForPicture());
    QVERIFY(shareOfDifferent(sample.viewport.grabFramebuffer(), plain) < 0.01);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestSavedViews>(argc, argv);
}
#include "testsavedviews.moc"
