// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/window/axestripod.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

QPointF middleOf(const QWidget &widget)
{
    return {widget.width() / 2.0, widget.height() / 2.0};
}

QAction &axesAction(const MainWindow &window)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->text().remove(u'&') == QStringLiteral("Axes")) {
            return *action;
        }
    }
    qFatal("there is no such action");
}

}

class TestAxesTripod : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void axesPointWhereTheCameraSeesThem();
    void aClickLooksAlongAnAxis_data();
    void aClickLooksAlongAnAxis();
    void dragsBesideTheAxesGoToThePicture();
    void noSavedPictureHoldsThem();
    void whetherTheyAreShownIsRemembered();
};

void TestAxesTripod::axesPointWhereTheCameraSeesThem()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    AxesTripod &axes = sample.pane.axes();
    for (const QPoint way : {QPoint(0, 0), QPoint(37, 12), QPoint(-80, -25)}) {
        QTest::mousePress(&sample.viewport, Qt::LeftButton, {}, {200, 200});
        QTest::mouseMove(&sample.viewport, QPoint(200, 200) + way);
        QTest::mouseRelease(&sample.viewport, Qt::LeftButton, {}, QPoint(200, 200) + way);
        const QImage drawn = axes.grab().toImage();
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 unit(0.0);
            unit[axis] = 1.0;
            const glm::dvec3 seen = glm::inverse(sample.viewport.camera().worldFromCamera) * unit;
            const QPointF letter = axes.letterAt(axis) - middleOf(axes);
            QVERIFY(std::hypot(letter.x() - 38.0 * seen.x, letter.y() + 38.0 * seen.y) < 1e-9);
            QCOMPARE(axes.axisAt(axes.letterAt(axis)), axis);
            // its colour is there, and the letter's rim
            const QRect there(axes.letterAt(axis).toPoint() - QPoint(6, 6), QSize(13, 13));
            int light = 0;
            for (int y = there.top(); y <= there.bottom(); ++y) {
                for (int x = there.left(); x <= there.right(); ++x) {
                    light += qGray(drawn.pixel(x, y)) > 120 ? 1 : 0;
                }
            }
            QVERIFY2(light > 5, qPrintable(QString::number(axis)));
        }
    }
}

void TestAxesTripod::aClickLooksAlongAnAxis_data()
{
    QTest::addColumn<int>("axis");
    QTest::addColumn<Qt::Key>("key");
    QTest::newRow("x") << 0 << Qt::Key_3;
    QTest::newRow("y") << 1 << Qt::Key_7;
    QTest::newRow("z") << 2 << Qt::Key_1;
}

void TestAxesTripod::aClickLooksAlongAnAxis()
{
    QFETCH(const int, axis);
    QFETCH(const Qt::Key, key);
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const AxesTripod &axes = sample.pane.axes();
    QTest::mouseClick(&sample.pane.axes(), Qt::LeftButton, {}, axes.letterAt(axis).toPoint());
    const Camera clicked = sample.viewport.camera();
    QVERIFY(std::abs(clicked.worldFromCamera[2][axis]) > 1.0 - 1e-12);
    QVERIFY(sample.focusViewport());
    QTest::keyClick(&sample.viewport, Qt::Key_Left);
    QVERIFY(!(sample.viewport.camera().worldFromCamera == clicked.worldFromCamera));
    QTest::keyClick(&sample.viewport, key);
    QVERIFY(sample.viewport.camera().worldFromCamera == clicked.worldFromCamera);
}

void TestAxesTripod::dragsBesideTheAxesGoToThePicture()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    AxesTripod &axes = sample.pane.axes();
    const QPoint corner(axes.width() - 2, 2);
    QVERIFY(!axes.axisAt(corner));
    const Camera before = sample.viewport.camera();
    QTest::mousePress(&axes, Qt::LeftButton, {}, corner);
    QTest::mouseMove(&axes, corner + QPoint(40, -30));
    QTest::mouseRelease(&axes, Qt::LeftButton, {}, corner + QPoint(40, -30));
    QVERIFY(!(sample.viewport.camera().worldFromCamera == before.worldFromCamera));
}

void TestAxesTripod::noSavedPictureHoldsThem()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QImage saved = sample.viewport.grabFramebuffer();
    const QImage seen = sample.viewport.grab().toImage();
    axesAction(sample.window).setChecked(false);
    QVERIFY(!sample.pane.axes().isVisible());
    QCOMPARE(sample.viewport.grabFramebuffer(), saved);
    QVERIFY(sample.viewport.grab().toImage() != seen);
    axesAction(sample.window).setChecked(true);
}

void TestAxesTripod::whetherTheyAreShownIsRemembered()
{
    {
        Sample sample;
        QVERIFY(sample.pane.axes().isVisible());
        axesAction(sample.window).trigger();
    }
    {
        Sample sample;
        QVERIFY(!sample.pane.axes().isVisible());
        axesAction(sample.window).trigger();
        QVERIFY(sample.pane.axes().isVisible());
    }
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestAxesTripod>(argc, argv);
}
#include "testaxestripod.moc"
