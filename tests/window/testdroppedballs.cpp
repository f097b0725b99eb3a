// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>

#include "physicssample.h"

using namespace romanesco;
using namespace romanesco::test;
using Sample = romanesco::test::WindowSample;

/// Where balls come from: by a click or as rain; and how they are kept in the text.
class TestDroppedBalls : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aClickDropsABall();
    void besideTheSurfaceNothingIsDropped();
    void deepInsideBallsAreAsSmallAsWhatIsSeen();
    void itRains();
    void ballsAreKeptInTheText();
    void droppedBallsGetAMesh();
    void whatCannotBeKeptIsTold();
};

void TestDroppedBalls::aClickDropsABall()
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

void TestDroppedBalls::besideTheSurfaceNothingIsDropped()
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
void TestDroppedBalls::deepInsideBallsAreAsSmallAsWhatIsSeen()
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

void TestDroppedBalls::itRains()
{
    PhysicsSample sample;
    QVERIFY(sample.begin(cubeScene));
    sample.named<QSpinBox>(QStringLiteral("Balls of a rain"))->setValue(50);
    sample.action(QStringLiteral("Rain"))->trigger();
    QVERIFY(sample.waitForBalls(51));
    QVERIFY(sample.action(QStringLiteral("Play"))->isChecked());
    QVERIFY(QTest::qWaitFor([&] { return sample.figures().contains(QLatin1String("real time")); }, 60'000));
}

void TestDroppedBalls::ballsAreKeptInTheText()
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

void TestDroppedBalls::droppedBallsGetAMesh()
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

void TestDroppedBalls::whatCannotBeKeptIsTold()
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

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestDroppedBalls>(argc, argv);
}
#include "testdroppedballs.moc"
