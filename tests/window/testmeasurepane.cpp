// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QProgressBar>
#include <QToolTip>

#include "app/window/measureview.h"
#include "app/window/qualitycontrol.h"
#include "measuresample.h"

using namespace romanesco;
using namespace romanesco::test;
using Sample = romanesco::test::WindowSample;

namespace {

const QStringList colliders{"exact",
                            "approximate 1e-6",
                            "approximate 1e-5",
                            "approximate 1e-4",
                            "approximate 0.001",
                            "approximate 0.01",
                            "approximate 0.1",
                            "approximate 0.5",
                            "greedy",
                            "octree",
                            "bvh",
                            "simple"};

}

/// What the scene that is seen costs, and how far off it is, in a panel.
class TestMeasurePane : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void nothingIsMadeBeforeItIsOpened();
    void allIsMeasuredAndShown();
    void theMouseTellsAndChooses();
    void keysChooseAndUse();
    void figuresAreSortedAsNumbers();
    void whatIsNotPossibleIsNotUsed();
    void timeStepsAreUsed();
    void tolerancesAreUsed();
    void depthsAndDigitsAreShown();
    void cancellingKeepsWhatWasThere();
    void thePageIsWritten();
    void coloursAreThoseOfThePalette();
    void anUprightPanelHasAllOneAboveTheOther();
};

void TestMeasurePane::nothingIsMadeBeforeItIsOpened()
{
    MeasureSample sample;
    sample.window.resize(1280, 800);
    QVERIFY(sample.waitForPicture());
    QVERIFY(!sample.dock.isVisible());
    QVERIFY(!sample.panel.findChild<MeasureView *>());
    const int before = sample.viewport.height();
    sample.open();
    QVERIFY(sample.dock.isVisible());
    QVERIFY(sample.panel.findChild<MeasureView *>());
    // a plot needs more room than a list
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.height() < before; }));
    QVERIFY(sample.plot().height() >= 150);
    QVERIFY(sample.words().contains(QStringLiteral("Measures on this scene")));
    QVERIFY(!sample.button(QStringLiteral("Use")).isEnabled());
    QVERIFY(!sample.button(QStringLiteral("Export")).isEnabled());
}

void TestMeasurePane::allIsMeasuredAndShown()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    const QProgressBar &bar = sample.named<QProgressBar>(QStringLiteral("How far measuring is"));
    QVERIFY(!bar.isVisible());
    QSignalSpy steps(&bar, &QProgressBar::valueChanged);
    sample.press(sample.button(QStringLiteral("Measure")));
    QVERIFY(bar.isVisible() && sample.words().startsWith(QStringLiteral("Measuring")));
    QVERIFY(sample.waitForEnd());
    QVERIFY(!bar.isVisible());
    // one after another, each farther than the one before
    int last = 0;
    for (qsizetype i = 0; i + 1 < steps.size(); ++i) { // in the end it goes back
        QVERIFY(steps[i][0].toInt() > last);
        last = steps[i][0].toInt();
    }
    QVERIFY(steps.size() > 12 && last > 900);

    QCOMPARE(sample.names(), colliders);
    const auto error = [&](int line) { return sample.cell(line, 3); };
    QCOMPARE(error(0), QStringLiteral("0"));
    QCOMPARE(error(10), QStringLiteral("0"));
    QVERIFY(sample.words().startsWith(QStringLiteral("12 faces, ")));
    QVERIFY(sample.words().contains(QStringLiteral("1,600 queries anywhere in 1.5 times the box")));
    // the plot has the same, and what is not off is lowest
    const auto lowest = sample.plot().placeOf(0).y();
    for (std::size_t i = 0; i < 12; ++i) {
        const bool isOff = error(static_cast<int>(i)) != QLatin1String("0");
        QCOMPARE(sample.plot().placeOf(i).y() < lowest - 1.0, isOff);
        QVERIFY(sample.plot().rect().contains(sample.placeOf(i)));
    }
    QComboBox &queries = sample.named<QComboBox>(QStringLiteral("From where"));
    QCOMPARE(queries.count(), 3);
    queries.setCurrentText(QStringLiteral("pocket"));
    QVERIFY(sample.words().contains(QStringLiteral("in the box, away from the surface")));
    const QPointF byTime = sample.plot().placeOf(0);
    QComboBox &kind = sample.named<QComboBox>(QStringLiteral("What is plotted"));
    kind.setCurrentText(QStringLiteral("face tests"));
    QVERIFY(sample.plot().placeOf(0).x() != byTime.x());
    sample.show(QStringLiteral("Time step"));
    QVERIFY(!queries.isVisible());
    QCOMPARE(sample.names().size(), 12);
    QCOMPARE(sample.names().first(), QStringLiteral("romanesco 1/30"));
    QCOMPARE(kind.count(), 2);
}

void TestMeasurePane::theMouseTellsAndChooses()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.measureColliders());
    const auto greedy = static_cast<std::size_t>(colliders.indexOf(QStringLiteral("greedy")));
    const QPoint place = sample.placeOf(greedy);
    QTest::mouseMove(&sample.canvas(), place - QPoint(40, 40));
    QTest::mouseMove(&sample.canvas(), place);
    QVERIFY(QTest::qWaitFor([] { return QToolTip::isVisible(); }));
    // it or one that is as good
    const QString told = QToolTip::text().section(u'\n', 0, 0);
    QVERIFY2(colliders.contains(told), qPrintable(told));
    QVERIFY(QToolTip::text().contains(QStringLiteral("Largest error: ")));
    QCOMPARE(QToolTip::text(), sample.plot().wordsAt(place));
    QTest::mouseMove(&sample.canvas(), QPoint(2, 2));
    QVERIFY(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));

    const QImage before = sample.plot().grab().toImage();
    QTest::mouseClick(&sample.canvas(), Qt::LeftButton, {}, place);
    QCOMPARE(sample.chosen(), told);
    QVERIFY(QTest::qWaitFor([&] { return sample.plot().grab().toImage() != before; }));
    QPushButton &use = sample.button(QStringLiteral("Use"));
    QCOMPARE(use.text(), QStringLiteral("&Use “%1”").arg(told));
    sample.press(use);
    QCOMPARE(
        QString::fromStdString(std::string(colliderNames[static_cast<std::size_t>(sample.physics().collider().kind)])),
        told.section(u' ', 0, 0));
    QVERIFY(sample.said().contains(told));

    const QPoint simple = sample.placeOf(11);
    QTest::mouseDClick(&sample.canvas(), Qt::LeftButton, {}, simple);
    QCOMPARE(sample.physics().collider().kind, ColliderKind::Simple);
}

void TestMeasurePane::keysChooseAndUse()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.measure());
    sample.table().setFocus();
    const auto press = [&](Qt::Key key) { QTest::keyClick(&sample.table(), key); };
    press(Qt::Key_Home);
    for (int i = 0; i < 5; ++i) {
        press(Qt::Key_Down);
    }
    QCOMPARE(sample.chosen(), QStringLiteral("approximate 0.01"));
    press(Qt::Key_Return);
    QCOMPARE(sample.physics().collider().kind, ColliderKind::Approximate);
    QCOMPARE(sample.physics().collider().excess, 0.01);
    // the same in another set
    sample.named<QComboBox>(QStringLiteral("From where")).setCurrentText(QStringLiteral("near"));
    QCOMPARE(sample.chosen(), QStringLiteral("approximate 0.01"));
    sample.show(QStringLiteral("Time step"));
    QCOMPARE(sample.chosen(), QString());
    QVERIFY(!sample.button(QStringLiteral("Use")).isEnabled());
}

void TestMeasurePane::figuresAreSortedAsNumbers()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.measureColliders());
    const QHeaderView &head = *sample.table().horizontalHeader();
    constexpr int bytes = 7;
    const auto click = [&] {
        QTest::mouseClick(head.viewport(), Qt::LeftButton, {},
                          {head.sectionViewportPosition(bytes) + 10, head.height() / 2});
    };
    const auto bytesOf = [&] {
        QList<qint64> values;
        for (int i = 0; i < sample.table().model()->rowCount(); ++i) {
            values << sample.cell(i, bytes).remove(u',').toLongLong();
        }
        return values;
    };
    sample.table().scrollTo(sample.table().model()->index(0, bytes));
    click();
    const QList<qint64> once = bytesOf();
    click();
    const QList<qint64> twice = bytesOf();
    QVERIFY(once.first() != once.last());
    QVERIFY(std::ranges::is_sorted(once) != std::ranges::is_sorted(twice));
    QVERIFY(std::ranges::is_sorted(once, std::greater()) != std::ranges::is_sorted(twice, std::greater()));
}

void TestMeasurePane::whatIsNotPossibleIsNotUsed()
{
    MeasureSample sample;
    QVERIFY(sample.begin(row, QStringLiteral("row.fdo")));
    QVERIFY(sample.measureColliders());
    const auto line = static_cast<int>(sample.names().indexOf(QStringLiteral("bvh")));
    QVERIFY(sample.cell(line, 1).startsWith(QStringLiteral("not possible: ")));
    QCOMPARE(sample.table().columnSpan(line, 1), sample.table().model()->columnCount() - 1);
    sample.table().selectRow(line);
    const QPushButton &use = sample.button(QStringLiteral("Use"));
    QVERIFY(!use.isEnabled());
    QVERIFY(use.toolTip().startsWith(QStringLiteral("Not possible: ")));
    QTest::keyClick(&sample.table(), Qt::Key_Return);
    QCOMPARE(sample.physics().collider().kind, ColliderKind::Exact);
    // wherever its row goes, the reason goes along
    sample.table().sortByColumn(0, Qt::DescendingOrder);
    const auto now = static_cast<int>(sample.names().indexOf(QStringLiteral("bvh")));
    QVERIFY(now != line);
    QVERIFY(sample.table().columnSpan(now, 1) > 1);
}

void TestMeasurePane::timeStepsAreUsed()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    sample.show(QStringLiteral("Time step"));
    sample.press(sample.button(QStringLiteral("Measure")));
    // what is looked at comes first
    QVERIFY(QTest::qWaitFor([&] { return !sample.names().isEmpty(); }, 120'000));
    QCOMPARE(sample.finished.count(), 0);
    sample.table().selectRow(static_cast<int>(sample.names().indexOf(QStringLiteral("dissertation 1/60"))));
    sample.press(sample.button(QStringLiteral("Use")));
    QCOMPARE(sample.physics().rules().laws.timeStep, 1.0 / 60.0);
    QVERIFY(sample.physics().rules().isAsInDissertation);
    sample.table().selectRow(static_cast<int>(sample.names().indexOf(QStringLiteral("romanesco 1/960"))));
    sample.press(sample.button(QStringLiteral("Use")));
    QCOMPARE(sample.physics().rules().laws.timeStep, 1.0 / 960.0);
    QVERIFY(!sample.physics().rules().isAsInDissertation);
    QVERIFY(sample.cancel());
}

void TestMeasurePane::tolerancesAreUsed()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    sample.show(QStringLiteral("Rendering"));
    sample.press(sample.button(QStringLiteral("Measure")));
    QVERIFY(QTest::qWaitFor([&] { return !sample.names().isEmpty(); }, 120'000));
    QVERIFY(sample.words().contains(QStringLiteral("Pictures of 640 x 360, drawn by ")));
    const QStringList tolerances{"0 px", "0.25 px", "0.5 px", "1 px", "2 px", "4 px", "8 px", "16 px"};
    QCOMPARE(sample.names(), tolerances);
    const QPushButton &use = sample.button(QStringLiteral("Use"));
    // finer than the slider goes
    sample.table().selectRow(0);
    QVERIFY(!use.isEnabled() && use.toolTip().contains(QStringLiteral("0.25 px")));
    QComboBox &places = sample.named<QComboBox>(QStringLiteral("From where"));
    QCOMPARE(places.count(), 2);
    places.setCurrentText(QStringLiteral("near"));
    QVERIFY(sample.words().contains(QStringLiteral("sixteenth of the way")));
    sample.table().selectRow(5);
    QTest::keyClick(&sample.table(), Qt::Key_Return);
    QCOMPARE(sample.pane.quality().tolerance(), 4.0);
    QVERIFY(sample.said().contains(QStringLiteral("4 px")));
    QVERIFY(sample.cancel());
}

/// Neither is used by the window from then on.
void TestMeasurePane::depthsAndDigitsAreShown()
{
    MeasureSample sample;
    QVERIFY(sample.begin(row, QStringLiteral("row.fdo")));
    QVERIFY(sample.measure());
    const QPushButton &use = sample.button(QStringLiteral("Use"));
    QVERIFY(use.isVisible());
    sample.show(QStringLiteral("Depth"));
    QCOMPARE(sample.names().size(), qsizetype(trialDepths().size()));
    for (int i = 0; i < sample.names().size(); ++i) {
        QCOMPARE(sample.cell(i, 0), QString::number(trialDepths()[static_cast<std::size_t>(i)]));
        QVERIFY2(sample.cell(i, 5).toDouble() < 0.1, qPrintable(sample.cell(i, 5)));
    }
    const int deepest = sample.table().model()->rowCount() - 1;
    const QString byDouble = sample.cell(deepest, 4).remove(u',');
    QVERIFY2(byDouble == QLatin1String("not seen") || byDouble.toDouble() > 10.0, qPrintable(byDouble));
    QVERIFY(!sample.plot().isVisible() && !use.isVisible());
    sample.table().selectRow(deepest);
    QTest::keyClick(&sample.table(), Qt::Key_Return);
    QVERIFY(!sample.said().contains(QStringLiteral("from now on")));

    sample.show(QStringLiteral("Export digits"));
    QCOMPARE(sample.names().first(), QStringLiteral("3 digits"));
    QCOMPARE(sample.names().last(), QStringLiteral("shortest"));
    QVERIFY(sample.cell(0, 1) != QLatin1String("0"));
    QCOMPARE(sample.cell(sample.table().model()->rowCount() - 1, 1), QStringLiteral("0"));
    QVERIFY(sample.plot().isVisible() && !use.isVisible());
}

void TestMeasurePane::cancellingKeepsWhatWasThere()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    sample.press(sample.button(QStringLiteral("Measure")));
    QVERIFY(!sample.button(QStringLiteral("Measure")).isVisible());
    QVERIFY(sample.button(QStringLiteral("Cancel")).hasFocus());
    QTest::keyClick(&sample.button(QStringLiteral("Cancel")), Qt::Key_Space);
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.names().isEmpty());
    QVERIFY(sample.button(QStringLiteral("Measure")).hasFocus());
    QVERIFY(!sample.button(QStringLiteral("Export")).isEnabled());
    QVERIFY(!sample.words().contains(QStringLiteral("ancelled")));
    QVERIFY(sample.measure());
    QCOMPARE(sample.names(), colliders);
    // once more, in the middle: all of the last time is still there
    sample.press(sample.button(QStringLiteral("Measure")));
    const QProgressBar &bar = sample.named<QProgressBar>(QStringLiteral("How far measuring is"));
    QVERIFY(QTest::qWaitFor([&] { return bar.value() > 100; }, 60'000));
    QVERIFY(sample.cancel());
    QCOMPARE(sample.names(), colliders);
    sample.show(QStringLiteral("Time step"));
    QCOMPARE(sample.names().size(), 12);
}

void TestMeasurePane::thePageIsWritten()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.measure());
    QSignalSpy exported(&sample.controller, &MeasureController::exported);
    const auto exportTo = [&](const QString &file) {
        sample.press(sample.button(QStringLiteral("Export")));
        auto *dialog = sample.window.findChild<QFileDialog *>();
        const QString proposed = dialog->selectedFiles().value(0);
        Q_EMIT dialog->fileSelected(file);
        dialog->close();
        const bool isDone = QTest::qWaitFor([&] { return !exported.isEmpty(); }, 20'000)
            && QTest::qWaitFor([&] { return !sample.window.findChild<QFileDialog *>(); }, 20'000);
        return isDone ? proposed : QString();
    };
    const QString page = sample.path(QStringLiteral("page.html"));
    QCOMPARE(exportTo(page), sample.path(QStringLiteral("scene-measured.html")));
    QVERIFY(exported.takeFirst()[0].toBool());
    const QByteArray bytes = Sample::read(page);
    QVERIFY(bytes.startsWith("<!DOCTYPE html>") && bytes.endsWith("</html>\n"));
    QVERIFY(bytes.contains("scene.sdo"));
    QVERIFY(bytes.count("<svg ") >= 3 * 2 + 2);
    // where it cannot be
    (void)exportTo(sample.path(QStringLiteral("no/such/page.html")));
    QVERIFY(!exported.takeFirst()[0].toBool());
    QVERIFY2(sample.words().contains(QStringLiteral("was not written: ")), qPrintable(sample.words()));
    (void)exportTo(page);
    QVERIFY(!sample.words().contains(QStringLiteral("was not written")));
}

void TestMeasurePane::coloursAreThoseOfThePalette()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.measureColliders());
    for (const QColor &base : {QColor(20, 30, 40), QColor(250, 240, 230)}) {
        QPalette palette = sample.window.palette();
        palette.setColor(QPalette::Base, base);
        palette.setColor(QPalette::Text, base.lightness() > 128 ? Qt::black : Qt::white);
        sample.window.setPalette(palette);
        const auto corner = [&] { return sample.canvas().grab().toImage().pixelColor(3, 3); };
        QVERIFY(QTest::qWaitFor([&] { return corner() == base; }, 5'000));
    }
}

void TestMeasurePane::anUprightPanelHasAllOneAboveTheOther()
{
    MeasureSample sample;
    QVERIFY(sample.begin(cube));
    QVERIFY(sample.table().x() > sample.plot().x());
    sample.window.addDockWidget(Qt::RightDockWidgetArea, &sample.dock);
    sample.window.resize(1280, 1000);
    QVERIFY(QTest::qWaitFor([&] { return sample.panel.width() < sample.panel.height(); }));
    QVERIFY(QTest::qWaitFor([&] { return sample.table().x() == sample.plot().x(); }));
    QVERIFY(sample.table().y() > sample.plot().y());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestMeasurePane>(argc, argv);
}
#include "testmeasurepane.moc"
