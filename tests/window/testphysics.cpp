// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>

#include "app/window/energygraph.h"
#include "physicssample.h"

using namespace romanesco;
using namespace romanesco::test;

/// Balls move, step by step or in time, whatever becomes of the text and of the rules meanwhile.
class TestPhysics : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ballsFallAndRestAndGoBack();
    void stepsAreSingle();
    void editsKeepTheBalls();
    void anErrorInTheTextStopsNothing();
    void anotherTextHasOtherBalls();
    void collidersTellTheirPromise();
    void rulesChangeWhileBallsMove();
    void selectedBallsStandOutAndGo();
    void theCameraGoesAlong();
    void recordingsAreReplayed();
    void contactsAreTold();
    void whoWalksEntersNothing();
    void nothingIsDoneBeforeItIsNeeded();
};

void TestPhysics::ballsFallAndRestAndGoBack()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    const QImage before = sample.viewport.grabFramebuffer();
    QCOMPARE(sample.orangePixels(), 0);
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForBalls(1));
    QVERIFY(sample.action(QStringLiteral("Play"))->isChecked());
    QVERIFY(sample.waitForRest(0));
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.isPictureFinished(); }, 60'000));
    // a disc of radius 0.25 in a view that is 8 high
    const double radius = 0.25 / 8.0 * sample.viewport.height();
    QVERIFY(sample.orangePixels() > 0.5 * 3.14 * radius * radius);
    QVERIFY(sample.physics.inspector().ballAt(sample.pixelOf(0.0, 1.75)));
    QVERIFY(sample.window.findChild<EnergyGraph *>()->values().size() > 2);
    sample.press(Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return !sample.action(QStringLiteral("Play"))->isChecked(); }));
    sample.press(Qt::Key_Backspace);
    QVERIFY(sample.waitForBalls(0));
    QVERIFY(QTest::qWaitFor(
        [&] { return sample.viewport.isPictureFinished() && sample.viewport.grabFramebuffer() == before; }, 60'000));
}

void TestPhysics::stepsAreSingle()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    for (int i = 1; i <= 3; ++i) {
        sample.press(Qt::Key_Period);
        QVERIFY(sample.waitForFigures(QStringLiteral("step %1").arg(i)));
    }
    QTest::qWait(100);
    QCOMPARE(sample.step(), 3);
}

void TestPhysics::editsKeepTheBalls()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForRest(0));
    const int step = sample.step();
    // the floor goes down by 1
    FdoEditor &editor = sample.visibleEditor();
    QTextCursor cursor = editor.document()->find(QStringLiteral("\"cube.obj\" #"));
    cursor.insertText(QStringLiteral("\"cube.obj\" ((0, -1, 0), #, #)"));
    QVERIFY(QTest::qWaitFor([&] { return sample.state(0) != QLatin1String("rests"); }, 60'000));
    QVERIFY(sample.waitForRest(0));
    QCOMPARE(sample.balls.rowCount(), 1);
    QVERIFY(sample.step() > step);
    QVERIFY(sample.physics.inspector().ballAt(sample.pixelOf(0.0, 0.75)));
}

void TestPhysics::anErrorInTheTextStopsNothing()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForStep(1));
    sample.visibleEditor().document()->find(QStringLiteral("cube")).insertText(QStringLiteral("nothing"));
    QVERIFY(sample.waitForStrip(true));
    QVERIFY(sample.waitForRest(0));
    QVERIFY(sample.physics.inspector().ballAt(sample.pixelOf(0.0, 1.75)));
}

void TestPhysics::anotherTextHasOtherBalls()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForStep(1));
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("other.sdo"), withoutBalls)));
    QVERIFY(sample.waitForBalls(0));
    QVERIFY(!sample.action(QStringLiteral("Play"))->isChecked());
    sample.action(QStringLiteral("Step"))->trigger();
    QVERIFY(sample.waitForStep(1));
    QCOMPARE(sample.balls.rowCount(), 0);
}

void TestPhysics::collidersTellTheirPromise()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    auto &collider = *sample.named<QComboBox>(QStringLiteral("Collider"));
    const auto promise = [&] {
        for (const QLabel *label : sample.window.findChildren<QLabel *>()) {
            if (label->text().contains(QLatin1String("through"))) {
                return label->text();
            }
        }
        return QString();
    };
    QCOMPARE(collider.currentText(), QStringLiteral("exact"));
    QVERIFY(promise().contains(QLatin1String("No ball goes through")));
    QVERIFY(!sample.named<QDoubleSpinBox>(QStringLiteral("Tolerance"))->isEnabled());
    collider.setCurrentText(QStringLiteral("approximate"));
    QVERIFY(sample.named<QDoubleSpinBox>(QStringLiteral("Tolerance"))->isEnabled());
    for (const auto *name : {"greedy", "octree"}) {
        collider.setCurrentText(QLatin1String(name));
        QVERIFY(promise().contains(QLatin1String("Balls may go through")));
    }
    // and what they promise is true
    const auto &status = *sample.named<QLabel>(QStringLiteral("Collider"));
    QVERIFY(!status.isVisible());
    for (const auto *name : {"approximate", "bvh", "simple", "exact"}) {
        collider.setCurrentText(QLatin1String(name));
        sample.press(Qt::Key_Backspace);
        QVERIFY(sample.waitForBalls(0));
        sample.press(Qt::Key_Space);
        QVERIFY2(sample.waitForRest(0), name);
        QCOMPARE(status.text(), QStringLiteral("%1 · no ball goes through").arg(QLatin1String(name)));
    }
}

void TestPhysics::rulesChangeWhileBallsMove()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForRest(0));
    // up and away
    sample.named<QDoubleSpinBox>(QStringLiteral("Gravity along y"))->setValue(5.0);
    QVERIFY(QTest::qWaitFor([&] { return sample.state(0) == QLatin1String("flies"); }, 60'000));
    sample.named<QDoubleSpinBox>(QStringLiteral("Shrinking"))->setValue(10.0);
    const auto radius = [&] {
        return sample.balls.data(sample.balls.index(0, BallModel::Radius), Qt::DisplayRole).toDouble();
    };
    QVERIFY(QTest::qWaitFor([&] { return radius() < 0.01; }, 60'000));
}

void TestPhysics::selectedBallsStandOutAndGo()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Period);
    QVERIFY(sample.waitForBalls(1));
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.isPictureFinished(); }, 60'000));
    QVERIFY(sample.orangePixels() > 0);
    QVERIFY(!sample.action(QStringLiteral("Remove Ball"))->isEnabled());
    sample.list.selectRow(0);
    QCOMPARE(sample.orangePixels(), 0);
    QVERIFY(sample.action(QStringLiteral("Remove Ball"))->isEnabled());
    sample.action(QStringLiteral("Remove Ball"))->trigger();
    QVERIFY(sample.waitForBalls(0));
    QVERIFY(!sample.action(QStringLiteral("Remove Ball"))->isEnabled());
}

void TestPhysics::theCameraGoesAlong()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Period);
    QVERIFY(sample.waitForBalls(1));
    sample.list.selectRow(0);
    sample.action(QStringLiteral("Follow Ball"))->trigger();
    sample.press(Qt::Key_Period);
    QVERIFY(sample.waitForStep(2));
    const glm::dvec3 before = sample.viewport.view().cameraInWorld().position;
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForRest(0));
    // from 2.25 to 1.75, but for the first two steps
    const glm::dvec3 after = sample.viewport.view().cameraInWorld().position;
    QVERIFY(QTest::qWaitFor(
        [&] { return std::abs(sample.viewport.view().cameraInWorld().position.y - before.y + 0.5) < 0.01; }, 5'000));
    QCOMPARE(after.x, before.x);
    QCOMPARE(after.z, before.z);
    sample.action(QStringLiteral("Follow Ball"))->trigger();
}

void TestPhysics::recordingsAreReplayed()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    for (int i = 0; i < 5; ++i) {
        sample.press(Qt::Key_Period);
    }
    QVERIFY(sample.waitForStep(5));
    const QString file = sample.path(QStringLiteral("five.recording"));
    const auto choose = [&](const QString &words) {
        sample.action(words)->trigger();
        auto *dialog = sample.window.findChild<QFileDialog *>();
        dialog->selectFile(file);
        Q_EMIT dialog->fileSelected(file);
        dialog->close();
    };
    choose(QStringLiteral("Save Recording"));
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file); }, 60'000));
    QVERIFY(QTest::qWaitFor([&] { return !sample.window.findChild<QFileDialog *>(); }, 60'000));
    choose(QStringLiteral("Replay Recording"));
    QVERIFY(sample.waitForFigures(QStringLiteral("came to the same state")));
    QCOMPARE(sample.step(), 5);
    QVERIFY(QTest::qWaitFor([&] { return !sample.window.findChild<QFileDialog *>(); }, 60'000));
    // what is no recording is told
    QCOMPARE(sample.write(QStringLiteral("five.recording"), "nonsense\n"), file);
    choose(QStringLiteral("Replay Recording"));
    QVERIFY(QTest::qWaitFor([&] { return sample.said().contains(QLatin1String("this is no recording")); }, 60'000));
}

void TestPhysics::contactsAreTold()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.press(Qt::Key_Period);
    QVERIFY(sample.waitForBalls(1));
    const auto *ball = sample.physics.inspector().ballAt(sample.pixelOf(0.0, 2.25));
    QVERIFY(ball);
    QVERIFY2(sample.physics.inspector().wordsOf(*ball).contains(QLatin1String("touches nothing")),
             qPrintable(sample.physics.inspector().wordsOf(*ball)));
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForRest(0));
    sample.press(Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return !sample.action(QStringLiteral("Play"))->isChecked(); }));
    ball = sample.physics.inspector().ballAt(sample.pixelOf(0.0, 1.75));
    QVERIFY(ball);
    const QString words = sample.physics.inspector().wordsOf(*ball);
    QVERIFY2(words.contains(QLatin1String("at rest")), qPrintable(words));
    QVERIFY2(words.contains(QLatin1String("of cube.obj")), qPrintable(words));
    QVERIFY2(words.contains(QLatin1String("Normal (0, 1, 0)")), qPrintable(words));
    QVERIFY(!sample.physics.inspector().ballAt(sample.pixelOf(1.0, 1.0)));
}

void TestPhysics::whoWalksEntersNothing()
{
    PhysicsSample sample;
    QVERIFY(sample.begin("c (0, 0, -8) # 60\no \"cube.obj\" #\n"));
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.isPictureFinished(); }, 60'000));
    const auto place = [&] { return sample.viewport.view().cameraInWorld().position; };
    sample.action(QStringLiteral("Gravity While Walking"))->setChecked(false);
    sample.press(Qt::Key_V);
    QVERIFY(sample.action(QStringLiteral("Walk"))->isChecked());
    // ahead, until the front face holds it up
    const double start = place().z;
    QVERIFY(QTest::qWaitFor(
        [&] {
            sample.press(Qt::Key_Plus);
            return place().z > start;
        },
        60'000));
    for (int i = 0; i < 60; ++i) {
        sample.press(Qt::Key_Plus);
    }
    const double held = place().z;
    QVERIFY(held < -1.5 && held > -2.2);
    // a drag looks about and moves nothing
    QTest::mousePress(&sample.viewport, Qt::LeftButton, {}, {100, 100});
    QTest::mouseMove(&sample.viewport, {160, 100});
    QTest::mouseRelease(&sample.viewport, Qt::LeftButton, {}, {160, 100});
    QVERIFY(glm::distance(place(), {0.0, 0.0, held}) < 1e-6);
    QVERIFY(std::abs(sample.viewport.camera().worldFromCamera[2].x) > 0.05);
    // along the face, past its end
    for (int i = 0; i < 60; ++i) {
        sample.press(Qt::Key_Plus);
    }
    QVERIFY(std::abs(place().x) > 1.5);
    QVERIFY(place().z < -1.4 || std::abs(place().x) > 1.5);
    // what pulls lets it fall, and an end of walking ends that
    sample.action(QStringLiteral("Gravity While Walking"))->setChecked(true);
    QVERIFY(QTest::qWaitFor([&] { return place().y < -1.0; }, 60'000));
    sample.press(Qt::Key_V);
    const glm::dvec3 there = place();
    QTest::qWait(100);
    QVERIFY(place() == there);
}

/// A window in which nothing falls has no simulation, and does nothing.
void TestPhysics::nothingIsDoneBeforeItIsNeeded()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    QTest::qWait(100);
    QVERIFY(sample.figures().startsWith(QLatin1String("Play lets")));
    QCOMPARE(sample.balls.rowCount(), 0);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestPhysics>(argc, argv);
}
#include "testphysics.moc"
