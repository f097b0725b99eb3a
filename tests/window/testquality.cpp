// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <numbers>
#include <random>

#include <QSignalSpy>

#include "app/window/qualitycontrol.h"
#include "app/window/windowstate.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

QSlider &sliderOf(const Sample &sample)
{
    return *sample.pane.quality().findChild<QSlider *>();
}

}

/// How exact pictures are.
class TestQuality : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { WindowState().clear(); }
    void thePictureFollowsTheSlider();
    void aSliderThatMovesIsFollowedCoarsely();
    void theBoundHoldsInAllOfTheView();
    void theWordsTellToleranceAndBound();
    void theChoiceIsRemembered();
};

void TestQuality::thePictureFollowsTheSlider()
{
    Sample sample;
    QVERIFY(sample.openAndWait(QStringLiteral(":/examples/menger.fdo")));
    QSignalSpy advances(&sample.viewport, &Viewport::pictureAdvanced);
    const auto drawnAfter = [&](Qt::Key key, double tolerance) {
        sliderOf(sample).setFocus();
        QTest::keyClick(&sliderOf(sample), key);
        const bool isThere = sample.waitForPicture() && advances.last()[1].toDouble() == tolerance;
        return isThere ? sample.drawn : 0;
    };
    const std::uint64_t usual = sample.drawn;
    const std::uint64_t coarsest = drawnAfter(Qt::Key_Home, 16.0);
    QVERIFY2(coarsest > 0 && coarsest < usual, qPrintable(QString::number(coarsest)));
    QVERIFY(drawnAfter(Qt::Key_PageUp, 8.0) > coarsest);
    QVERIFY(drawnAfter(Qt::Key_End, 0.25) > coarsest);
}

void TestQuality::aSliderThatMovesIsFollowedCoarsely()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QSignalSpy advances(&sample.viewport, &Viewport::pictureAdvanced);
    sample.pane.quality().setTolerance(0.25);
    QVERIFY(sample.waitForPicture() && !advances.isEmpty());
    QVERIFY(advances.first()[1].toDouble() >= DragTolerance::finest);
    QCOMPARE(advances.last()[1].toDouble(), 0.25);
    // never finer than what is asked for at rest
    advances.clear();
    sample.pane.quality().setTolerance(16.0);
    QVERIFY(sample.waitForPicture());
    for (const QList<QVariant> &advance : advances) {
        QVERIFY(advance[1].toDouble() >= 16.0);
    }
}

/// Points of a bound a pixel wide, and of what stands for it, which may reach a tenth farther out.
void TestQuality::theBoundHoldsInAllOfTheView()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto inBall = [&](double radius) {
        glm::dvec3 place(2.0);
        while (glm::length(place) > 1.0) {
            place = {uniform(random), uniform(random), uniform(random)};
        }
        return radius * place;
    };
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        sample.viewport.setProjection(projection);
        const Camera &camera = sample.viewport.camera();
        const double height = sample.viewport.height();
        const double aspect = sample.viewport.width() / height;
        double worst = 0.0;
        for (int i = 0; i < 20'000; ++i) {
            const double away = 1.0 + std::abs(uniform(random));
            const double up = projection == Projection::Perspective
                ? away * std::tan(camera.fieldOfView * std::numbers::pi / 360.0)
                : 0.5 * camera.viewHeight;
            const double radius = up / height; // a pixel wide
            const glm::dvec3 middle(up * aspect * uniform(random), up * uniform(random), away);
            const auto seen = [&](const glm::dvec3 &inCamera) {
                return *seenAt(camera, camera.position + camera.worldFromCamera * inCamera) * height;
            };
            worst = std::max(worst, glm::distance(seen(middle + inBall(radius)), seen(middle + inBall(1.1 * radius))));
        }
        QVERIFY2(worst < sample.viewport.shiftOfTolerance(), qPrintable(QString::number(worst)));
        QVERIFY2(worst > 0.7 * sample.viewport.shiftOfTolerance(), qPrintable(QString::number(worst)));
    }
}

void TestQuality::theWordsTellToleranceAndBound()
{
    QualityControl control;
    control.setShift(1.26);
    control.setTolerance(2.0);
    const QString words = control.findChild<QSlider *>()->toolTip();
    QVERIFY2(words.contains(QStringLiteral("smaller than 2 pixels")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("more than 2.6 pixels")), qPrintable(words)); // 2.52, never rounded down
    QCOMPARE(control.tolerance(), 2.0);
    control.setTolerance(100.0);
    QCOMPARE(control.tolerance(), QualityControl::coarsest);
    control.setTolerance(0.0);
    QCOMPARE(control.tolerance(), QualityControl::finest);
}

void TestQuality::theChoiceIsRemembered()
{
    {
        Sample sample;
        sample.pane.quality().setTolerance(4.0);
    }
    Sample sample;
    QCOMPARE(sample.pane.quality().tolerance(), 4.0);
    QSignalSpy advances(&sample.viewport, &Viewport::pictureAdvanced);
    QVERIFY(sample.waitForPicture());
    QCOMPARE(advances.last()[1].toDouble(), 4.0);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestQuality>(argc, argv);
}
#include "testquality.moc"
