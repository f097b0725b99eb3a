// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QComboBox>
#include <QProgressBar>

#include "app/window/physicscontroller.h"
#include "measuresample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

constexpr auto nowhere = "c (0, 0, -12) # 8\n";

}

/// Which scene the panel measures: that of the last text without errors, with the balls that fall in it.
class TestMeasuredScene : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theTextIsEditedMeanwhile();
    void errorsLeaveTheLastGoodVersion();
    void whatCannotBeMeasuredIsSaid();
    void ballsThatFallAreAsked();
    void theWindowClosesMeanwhile();
};

void TestMeasuredScene::theTextIsEditedMeanwhile()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    sample.press(sample.button(QStringLiteral("Measure")));
    FdoEditor &editor = sample.visibleEditor();
    editor.setFocus();
    QTest::keyClick(&editor, Qt::Key_End, Qt::ControlModifier);
    QTest::keyClicks(&editor, QStringLiteral("o \"cube.obj\" ((4, 0, 0), #, #)"));
    QVERIFY(sample.waitForEnd());
    const QString older = QStringLiteral("The figures are of an older text.");
    QVERIFY(QTest::qWaitFor([&] { return sample.words().contains(older); }, 20'000));
    QVERIFY(sample.words().contains(QStringLiteral("12 faces")));
    sample.press(sample.button(QStringLiteral("Measure")));
    QVERIFY(QTest::qWaitFor([&] { return sample.words().contains(QStringLiteral("24 faces")); }, 120'000));
    QVERIFY(!sample.words().contains(older));
    // another text
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("other.sdo"), cube)));
    QVERIFY(QTest::qWaitFor([&] { return sample.words().contains(QStringLiteral("of “scene.sdo”")); }, 20'000));
}

void TestMeasuredScene::errorsLeaveTheLastGoodVersion()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QTest::keyClicks(&sample.visibleEditor(), QStringLiteral("nonsense "));
    const QString lastGood = QStringLiteral("its last good version");
    QVERIFY(QTest::qWaitFor([&] { return sample.words().contains(lastGood); }, 20'000));
    QVERIFY(sample.measureColliders());
    QVERIFY(sample.words().contains(QStringLiteral("12 faces")));
    QVERIFY(sample.words().contains(lastGood));
    // where there was none
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("bad.fdo"), "nonsense\n")));
    const QPushButton &measure = sample.button(QStringLiteral("Measure"));
    QVERIFY(QTest::qWaitFor([&] { return !measure.isEnabled() && sample.words().contains(QStringLiteral("errors")); },
                            20'000));
    QVERIFY(measure.toolTip().startsWith(QStringLiteral("There is nothing to measure")));
}

void TestMeasuredScene::whatCannotBeMeasuredIsSaid()
{
    MeasureSample sample;
    QVERIFY(sample.begin(nowhere));
    QVERIFY(sample.measure());
    QVERIFY2(sample.words().contains(QStringLiteral("There is no surface to measure.")), qPrintable(sample.words()));
    QVERIFY(sample.names().isEmpty());
    QVERIFY(!sample.button(QStringLiteral("Export")).isEnabled());
    QVERIFY(!sample.button(QStringLiteral("Export")).toolTip().isEmpty());
}

void TestMeasuredScene::ballsThatFallAreAsked()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.measureColliders());
    QComboBox &queries = sample.named<QComboBox>(QStringLiteral("From where"));
    QCOMPARE(queries.findText(QStringLiteral("balls")), -1);
    for (QAction *action : sample.window.findChildren<QAction *>()) {
        if (action->iconText() == QLatin1String("Rain")) {
            action->trigger();
        }
    }
    const auto *physics = sample.window.findChild<PhysicsController *>();
    QVERIFY(QTest::qWaitFor([&] { return physics->balls().has_value(); }, 20'000));
    QCOMPARE(physics->balls()->size(), 100U);
    sample.press(sample.button(QStringLiteral("Measure")));
    QVERIFY(QTest::qWaitFor([&] { return queries.findText(QStringLiteral("balls")) >= 0; }, 120'000));
    queries.setCurrentText(QStringLiteral("balls"));
    QVERIFY(sample.words().contains(QStringLiteral("as the balls of the scene ask")));
    // the radius of those that were dropped: 2 % of a side of 3
    QVERIFY(sample.words().contains(QStringLiteral("a ball of radius 0.06,"))
            || sample.words().contains(QStringLiteral("a ball of radius 0.06.")));
}

/// Whoever waits for it would wait for seconds.
void TestMeasuredScene::theWindowClosesMeanwhile()
{
    MeasureSample sample;
    QVERIFY(sample.begin(row, QStringLiteral("row.fdo")));
    sample.press(sample.button(QStringLiteral("Measure")));
    const QProgressBar &bar = sample.named<QProgressBar>(QStringLiteral("How far measuring is"));
    QVERIFY(QTest::qWaitFor([&] { return bar.value() > 0; }, 60'000));
    QVERIFY(sample.window.close());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestMeasuredScene>(argc, argv);
}
#include "testmeasuredscene.moc"
