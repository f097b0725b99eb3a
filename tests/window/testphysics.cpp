// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>

#include "app/window/ballmodel.h"
#include "app/window/energygraph.h"
#include "app/window/physicscontroller.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// A cube of side 3, seen from the front, and a ball above its top.
constexpr auto cubeScene = "c (0, 0, -12) # 8 orthographic\n"
                           "o \"cube.obj\" #\n"
                           "p \"ball.obj\" ((0, 2.25, 0), #, (0.25, 0.25, 0.25)) 0.5\n";
constexpr auto withoutBalls = "c (0, 0, -12) # 8 orthographic\no \"cube.obj\" #\n";

struct PhysicsSample : Sample {
    BallModel &balls = *window.findChild<BallModel *>();
    QTableView &list = *named<QTableView>(QStringLiteral("Balls"));
    PhysicsController &physics = *window.findChild<PhysicsController *>();

    template<typename Widget>
    Widget *named(const QString &name) const
    {
        for (auto *widget : window.findChildren<Widget *>()) {
            if (widget->accessibleName() == name) {
                return widget;
            }
        }
        qFatal("there is no %s", qPrintable(name));
    }
    QAction *action(const QString &words) const
    {
        for (QAction *found : window.findChildren<QAction *>()) {
            if (found->text().remove(u'&').remove(u'…') == words) {
                return found;
            }
        }
        qFatal("there is no %s", qPrintable(words));
    }
    bool begin(const char *text)
    {
        const bool isThere = QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj")));
        return isThere && begins(text);
    }
    bool begins(const char *text)
    {
        if (QByteArray(text).contains("ball.obj")
            && !QFile::copy(QStringLiteral(":/examples/ball.obj"), path(QStringLiteral("ball.obj")))) {
            return false;
        }
        return openAndWait(write(QStringLiteral("scene.sdo"), text)) && focusViewport();
    }
    void press(int key) { QTest::keyClick(&viewport, Qt::Key(key)); }
    bool waitForBalls(int count) const
    {
        return QTest::qWaitFor([&] { return balls.rowCount() == count; }, 60'000);
    }
    [[nodiscard]] QString figures() const { return named<QLabel>(QStringLiteral("Figures"))->text(); }
    bool waitForFigures(const QString &words) const
    {
        return QTest::qWaitFor([&] { return figures().contains(words); }, 60'000);
    }
    /// "1.25 s, step 300".
    [[nodiscard]] int step() const
    {
        return figures().section(QStringLiteral("step "), 1).section(u'\n', 0, 0).remove(u',').toInt();
    }
    bool waitForStep(int count) const
    {
        return QTest::qWaitFor([&] { return step() >= count; }, 60'000);
    }
    [[nodiscard]] QString state(int row) const
    {
        return balls.data(balls.index(row, BallModel::State), Qt::DisplayRole).toString();
    }
    bool waitForRest(int row) const
    {
        return QTest::qWaitFor([&] { return balls.rowCount() > row && state(row) == QLatin1String("rests"); }, 60'000);
    }
    [[nodiscard]] QString said() const { return window.findChild<QStatusBar *>()->currentMessage(); }
    /// The first ball's own colour.
    [[nodiscard]] int orangePixels() const
    {
        const QImage picture = viewport.grabFramebuffer();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor c = picture.pixelColor(x, y);
                count += c.red() > 90 && c.red() > 5 * c.blue() && c.red() > c.green() ? 1 : 0;
            }
        }
        return count;
    }
    /// Of the plane through the axes, which the camera looks at along z.
    [[nodiscard]] QPoint pixelOf(double x, double y) const
    {
        return viewport.placeOf(viewport.view().surroundings()->hereFromWorld({x, y, 0.0}))->toPoint();
    }
};

}

class TestPhysics : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ballsFallAndRestAndGoBack();
    void stepsAreSingle();
    void aClickDropsABall();
    void besideTheSurfaceNothingIsDropped();
    void deepInsideBallsAreAsSmallAsWhatIsSeen();
    void itRains();
    void editsKeepTheBalls();
    void anErrorInTheTextStopsNothing();
    void anotherTextHasOtherBalls();
    void collidersTellTheirPromise();
    void rulesChangeWhileBallsMove();
    void selectedBallsStandOutAndGo();
    void theCameraGoesAlong();
    void ballsAreKeptInTheText();
    void droppedBallsGetAMesh();
    void whatCannotBeKeptIsTold();
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

void TestPhysics::aClickDropsABall()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(withoutBalls));
    sample.press(Qt::Key_B);
    const QPoint place = sample.pixelOf(0.5, 0.0);
    QTest::mouseMove(&sample.viewport, place);
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 60'000));
    // it falls at once: before the front face
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, place);
    QVERIFY(sample.waitForBalls(1));
    QVERIFY(QTest::qWaitFor([&] { return sample.action(QStringLiteral("Play"))->isChecked(); }, 60'000));
    QVERIFY(sample.waitForStep(120)); // away from there
    const double radius = sample.balls.data(sample.balls.index(0, BallModel::Radius), Qt::DisplayRole).toDouble();
    QVERIFY(std::abs(radius - 0.02 * 3.0) < 1e-3); // two per cent of the cube
    // who holds balls where they are places others among them
    sample.press(Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return !sample.action(QStringLiteral("Play"))->isChecked(); }));
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, place);
    QVERIFY(sample.waitForBalls(2));
    QVERIFY(!sample.action(QStringLiteral("Play"))->isChecked());
    // above what was clicked
    const auto *ball = sample.physics.inspector().ballAt(sample.pixelOf(0.5, 4.0 * 0.06));
    QVERIFY(ball);
    QCOMPARE(ball->number, 1U);
    QVERIFY(std::abs(ball->after.z - (-1.5 - 1.02 * 0.06)) < 1e-6);
    // of the colour that was chosen: the third after orange and sky comes in turn, so it is wished for
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.isPictureFinished(); }, 60'000));
    const int before = sample.orangePixels();
    sample.named<QComboBox>(QStringLiteral("Colour"))->setCurrentText(QStringLiteral("Orange"));
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, sample.pixelOf(-0.5, 0.0));
    QVERIFY(sample.waitForBalls(3));
    QVERIFY(sample.orangePixels() > before);
}

void TestPhysics::besideTheSurfaceNothingIsDropped()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(withoutBalls));
    sample.press(Qt::Key_B);
    QTest::mouseMove(&sample.viewport, {5, 5});
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 60'000));
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, {5, 5});
    QCOMPARE(sample.said(), QStringLiteral("There is no surface to drop a ball on."));
    QTest::qWait(50);
    QCOMPARE(sample.balls.rowCount(), 0);
}

/// 1e-23 of the sponge.
void TestPhysics::deepInsideBallsAreAsSmallAsWhatIsSeen()
{
    PhysicsSample sample;
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    QFile example(QStringLiteral(":/examples/menger.fdo"));
    QVERIFY(example.open(QIODevice::ReadOnly));
    QByteArray text = "# view: in 0: 0.9*50 at (0.2, 0.7, -9) (0, 0, 0) 40 perspective\n" + example.readAll();
    text.replace("<$>. sponge 4", "<$>. sponge 54");
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("deep.fdo"), text)) && sample.focusViewport());
    QVERIFY(sample.viewport.view().surroundings()->unitExponent < -75.0);
    sample.press(Qt::Key_B);
    const QPoint place = sample.viewport.rect().center();
    QTest::mouseMove(&sample.viewport, place);
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 60'000));
    sample.named<QComboBox>(QStringLiteral("Colour"))->setCurrentText(QStringLiteral("Orange"));

    // it leaves what is seen before it is seen to fall
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, place);
    QVERIFY(sample.waitForBalls(1));
    QVERIFY2(sample.said().contains(QStringLiteral("Count it in radii")), qPrintable(sample.said()));
    sample.action(QStringLiteral("Reset"))->trigger();
    QVERIFY(sample.waitForBalls(0));

    sample.named<QComboBox>(QStringLiteral("Unit of gravity"))->setCurrentText(QStringLiteral("radii"));
    // into what is seen
    sample.named<QDoubleSpinBox>(QStringLiteral("Gravity along y"))->setValue(0.0);
    sample.named<QDoubleSpinBox>(QStringLiteral("Gravity along z"))->setValue(40.0);
    const int before = sample.orangePixels();
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, place);
    QVERIFY(sample.waitForBalls(1));
    const double radius = sample.balls.data(sample.balls.index(0, BallModel::Radius), Qt::DisplayRole).toDouble();
    QVERIFY(radius > 1e-26 && radius < 1e-23);
    QVERIFY(sample.waitForStep(10));
    QVERIFY(QTest::qWaitFor([&] { return sample.orangePixels() > before + 20; }, 5'000));
    QVERIFY(sample.waitForRest(0));
    const auto *ball = sample.physics.inspector().ballAt(place);
    QVERIFY(ball);
    const QString words = sample.physics.inspector().wordsOf(*ball);
    QVERIFY2(words.contains(QStringLiteral("Touches face")), qPrintable(words));
}

void TestPhysics::itRains()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.named<QSpinBox>(QStringLiteral("Balls of a rain"))->setValue(50);
    sample.action(QStringLiteral("Rain"))->trigger();
    QVERIFY(sample.waitForBalls(51));
    QVERIFY(sample.action(QStringLiteral("Play"))->isChecked());
    QVERIFY(QTest::qWaitFor([&] { return sample.figures().contains(QLatin1String("real time")); }, 60'000));
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

void TestPhysics::ballsAreKeptInTheText()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    FdoEditor &editor = sample.visibleEditor();
    const QString text = editor.toPlainText();
    sample.press(Qt::Key_Space);
    QVERIFY(sample.waitForRest(0));
    sample.press(Qt::Key_Space);
    sample.action(QStringLiteral("Keep Balls in Text"))->trigger();
    QCOMPARE(sample.said(), QStringLiteral("The balls are kept in the text"));
    const QString kept = editor.toPlainText().section(u'\n', 2, 2);
    QVERIFY2(kept.startsWith(QLatin1String("p \"ball.obj\" ((0, 1.75")), qPrintable(kept));
    QVERIFY2(kept.endsWith(QLatin1String("(0.25, 0.25, 0.25)) 0.5")), qPrintable(kept));
    QVERIFY(sample.problems.topLevelItemCount() == 0);
    editor.undo();
    QCOMPARE(editor.toPlainText(), text);
}

void TestPhysics::droppedBallsGetAMesh()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(withoutBalls));
    // another's file stays as it is
    const QString other = sample.write(QStringLiteral("ball.obj"), "v 0 0 0\n");
    sample.named<QSpinBox>(QStringLiteral("Balls of a rain"))->setValue(3);
    sample.action(QStringLiteral("Rain"))->trigger();
    QVERIFY(sample.waitForBalls(3));
    sample.press(Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return !sample.action(QStringLiteral("Play"))->isChecked(); }));
    sample.action(QStringLiteral("Keep Balls in Text"))->trigger();
    const QString text = sample.visibleEditor().toPlainText();
    QCOMPARE(text.count(QStringLiteral("p \"ball-2.obj\" ((")), 3);
    QCOMPARE(text.count(QStringLiteral("(0.06, 0.06, 0.06)) 0.5")), 3);
    QCOMPARE(Sample::read(other), QByteArray("v 0 0 0\n"));
    QVERIFY(QFile::exists(sample.path(QStringLiteral("ball-2.obj"))));
    // and they fall from there
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().surroundings()->scene->items.size() == 4U; }, 60'000));
    sample.press(Qt::Key_Backspace);
    QVERIFY(sample.waitForBalls(0));
    sample.press(Qt::Key_Period);
    QVERIFY(sample.waitForBalls(3));
    QVERIFY(sample.strip().isEmpty());
}

void TestPhysics::whatCannotBeKeptIsTold()
{
    PhysicsSample sample;
    QVERIFY(sample.waitForPicture()); // an .fdo
    sample.action(QStringLiteral("Keep Balls in Text"))->trigger();
    QVERIFY(sample.said().contains(QLatin1String("this text is none")));
    QVERIFY(sample.begin(cubeScene));
    sample.action(QStringLiteral("Keep Balls in Text"))->trigger();
    QVERIFY(sample.said().contains(QLatin1String("nothing to keep")));
    sample.press(Qt::Key_Period);
    QVERIFY(sample.waitForBalls(1));
    const QString scene = sample.visibleEditor().toPlainText();
    sample.visibleEditor().appendPlainText(QStringLiteral("p \"ball.obj\" # 1"));
    sample.action(QStringLiteral("Keep Balls in Text"))->trigger();
    QVERIFY(sample.said().contains(QLatin1String("other balls now")));
    sample.visibleEditor().undo();
    QCOMPARE(sample.visibleEditor().toPlainText(), scene);
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
    // the pace is a part of the way ahead, which is known once the mouse is there
    QTest::mouseMove(&sample.viewport, sample.viewport.rect().center());
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 60'000));
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
