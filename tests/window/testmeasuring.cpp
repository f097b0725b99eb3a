// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QStatusBar>
#include <QWheelEvent>

#include "app/window/tooloverlay.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// Cubes of side 3 whose fronts are at z = -1.5.
constexpr auto cubes = "v -4 0 0\nv 4 0 0\nx. \"cube.obj\"\nat.p. (p, #, #)\n<$>. [at.1, at.2] x\n";

/// Before the fronts of two cubes, measuring.
struct MeasuringSample : Sample {
    bool begin(const char *written)
    {
        const bool isThere = QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj")))
            && openAndWait(write(QStringLiteral("cubes.fdo"), written));
        viewport.lookFrom(Viewport::Side::Front);
        viewport.setProjection(Projection::Orthographic);
        viewport.fit();
        const bool hasKeys = focusViewport();
        QTest::mouseMove(&viewport, {5, 5});
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, {5, 5});
        const bool isFound = QTest::qWaitFor([&] { return viewport.view().hasRayWalk(); }, 20'000);
        QTest::keyClick(&viewport, Qt::Key_M);
        return isThere && hasKeys && isFound && isOn();
    }
    [[nodiscard]] bool isOn() const { return window.findChild<ToolOverlay *>()->isVisible(); }
    [[nodiscard]] QString said() const { return window.findChild<QStatusBar *>()->currentMessage(); }
    void click(QPoint place) { QTest::mouseClick(&viewport, Qt::LeftButton, {}, place); }
    /// The pixel whose middle shows a point of the plane before the camera, nearly.
    [[nodiscard]] QPoint pixelOf(double x, double y) const { return viewport.placeOf({x, y, 0.0})->toPoint(); }
    /// Of a pixel's middle.
    [[nodiscard]] double xOf(QPoint pixel) const
    {
        const Camera camera = viewport.view().cameraInWorld();
        return camera.position.x + (pixel.x() + 0.5 - viewport.width() / 2.0) * camera.viewHeight / viewport.height();
    }
};

/// The number after a word.
double numberAfter(const QString &text, const QString &word)
{
    const QRegularExpression pattern(word + QStringLiteral(" \\(?(-?[0-9.e-]+)"));
    return pattern.match(text).captured(1).toDouble();
}

}

class TestMeasuring : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aClickTellsPlaceAndNormal();
    void aSecondClickTellsTheDistance();
    void aThirdClickBeginsAnew();
    void besideTheSurfaceNothingIsMeasured();
    void theMeasurementIsCopied();
    void escapeEndsIt();
    void marksStayAtTheirPlace();
    void noSavedPictureHoldsMarks();
    void anotherTextIsAnotherMeasurement();
    void distancesAreTrueDeepInside();
};

void TestMeasuring::aClickTellsPlaceAndNormal()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    const QPoint place = sample.pixelOf(-4.3, 0.2);
    sample.click(place);
    QVERIFY(std::abs(numberAfter(sample.said(), QStringLiteral("Point")) - sample.xOf(place)) < 1e-9);
    QVERIFY2(sample.said().contains(QStringLiteral(", -1.5), normal (0, 0, -1)")), qPrintable(sample.said()));
    QVERIFY(!sample.viewport.appearance().colours.selection); // the click was the tool's
}

void TestMeasuring::aSecondClickTellsTheDistance()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    const QPoint left = sample.pixelOf(-4.3, 0.2);
    const QPoint right(sample.pixelOf(3.7, 0.0).x(), left.y());
    sample.click(left);
    sample.click(right);
    const double distance = numberAfter(sample.said(), QStringLiteral("Distance"));
    QVERIFY2(std::abs(distance - (sample.xOf(right) - sample.xOf(left))) < 1e-9, qPrintable(sample.said()));
    QVERIFY(distance > 7.0);
}

void TestMeasuring::aThirdClickBeginsAnew()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    sample.click(sample.pixelOf(-4.3, 0.2));
    sample.click(sample.pixelOf(4.3, 0.2));
    QCOMPARE(sample.viewport.view().marks().size(), std::size_t(2));
    sample.click(sample.pixelOf(4.0, 0.0));
    QCOMPARE(sample.viewport.view().marks().size(), std::size_t(1));
    QVERIFY(!sample.said().contains(QStringLiteral("Distance")));
}

void TestMeasuring::besideTheSurfaceNothingIsMeasured()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    sample.click({3, 3});
    QVERIFY(sample.viewport.view().marks().empty());
    QVERIFY(sample.said().contains(QStringLiteral("no surface")));
}

void TestMeasuring::theMeasurementIsCopied()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    sample.click(sample.pixelOf(-4.3, 0.2));
    sample.click(sample.pixelOf(4.3, 0.2));
    const QString said = sample.said();
    QTest::keyClick(&sample.viewport, Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n');
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines.join(QStringLiteral(" · ")), said);
}

void TestMeasuring::escapeEndsIt()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    const QPoint place = sample.pixelOf(-4.3, 0.2);
    sample.click(place);
    QTest::keyClick(&sample.viewport, Qt::Key_Escape);
    QVERIFY(!sample.isOn());
    QVERIFY(sample.viewport.view().marks().empty());
    sample.click(place);
    QVERIFY(sample.viewport.appearance().colours.selection);
    QTest::keyClick(&sample.viewport, Qt::Key_M);
    QVERIFY(sample.isOn());
}

void TestMeasuring::marksStayAtTheirPlace()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    sample.click(sample.pixelOf(-4.3, 0.2));
    const auto inWorld = [&] {
        return sample.viewport.view().surroundings()->worldFromHere(sample.viewport.view().marks()[0].point);
    };
    const glm::dvec3 before = inWorld();
    sample.viewport.setProjection(Projection::Perspective);
    const auto origin = [&] { return sample.viewport.view().surroundings()->unitExponent; };
    for (const int turns : {1, -1}) {
        for (int notch = 0; notch < 25; ++notch) {
            const QPointF place = *sample.viewport.placeOf(sample.viewport.view().marks()[0].point);
            QWheelEvent event(place, sample.viewport.mapToGlobal(place), {}, QPoint(0, 120 * turns), Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&sample.viewport, &event);
            QVERIFY(glm::distance(inWorld(), before) < 1e-12);
        }
        QVERIFY(turns < 0 || origin() != 0.0 || sample.viewport.view().surroundings()->path.size() > 0);
    }
}

void TestMeasuring::noSavedPictureHoldsMarks()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    QVERIFY(sample.waitForPicture());
    const QImage saved = sample.viewport.grabFramebuffer();
    const QImage seen = sample.viewport.grab().toImage();
    const QPoint place = sample.pixelOf(-4.3, 0.2);
    sample.click(place);
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.viewport.grabFramebuffer(), saved);
    const QRect there(place - QPoint(3, 3), QSize(7, 7));
    QVERIFY(sample.viewport.grab().toImage().copy(there) != seen.copy(there));
}

void TestMeasuring::anotherTextIsAnotherMeasurement()
{
    MeasuringSample sample;
    QVERIFY(sample.begin(cubes));
    sample.click(sample.pixelOf(-4.3, 0.2));
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/menger.fdo")));
    QVERIFY(sample.viewport.view().marks().empty());
    QTest::keyClick(&sample.viewport, Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(sample.said().contains(QStringLiteral("Nothing")));
}

/// In a sponge of 2,000 levels, where copies are 1e-380 of the whole.
void TestMeasuring::distancesAreTrueDeepInside()
{
    QFile example(QStringLiteral(":/examples/menger.fdo"));
    QVERIFY(example.open(QIODevice::ReadOnly));
    const QByteArray deep = example.readAll().replace("<$>. sponge 4", "<$>. sponge 2000");
    MeasuringSample sample;
    sample.viewport.setPixelTolerance(16.0); // the surface is measured, not the picture
    QVERIFY(sample.begin(deep.constData()));
    sample.viewport.select(Selection{0, std::vector<Step>(800, Step{0, 7})});
    sample.viewport.zoomToSelection();
    QVERIFY(sample.viewport.view().surroundings()->path.size() > 700);
    const QPoint middle = sample.viewport.rect().center();
    // two places of one plane before the camera
    std::vector<QPoint> places;
    double plane = 0.0;
    for (int x = 0; x < sample.viewport.width() && places.size() < 2; ++x) {
        const auto surface = sample.viewport.surfaceAt({double(x), double(middle.y())});
        if (surface && (places.empty() || (x > places[0].x() + 20 && std::abs(surface->distance - plane) < 1e-9))) {
            places.emplace_back(x, middle.y());
            plane = surface->distance;
        }
    }
    QCOMPARE(places.size(), std::size_t(2));
    sample.click(places[0]);
    sample.click(places[1]);
    const QRegularExpression pattern(QStringLiteral("Distance ([0-9.]+)e(-[0-9]+) "));
    const QRegularExpressionMatch match = pattern.match(sample.said());
    QVERIFY2(match.hasMatch(), qPrintable(sample.said()));
    const double said = std::log10(match.captured(1).toDouble()) + match.captured(2).toDouble();
    const double expected =
        std::log10((places[1].x() - places[0].x()) * sample.viewport.camera().viewHeight / sample.viewport.height())
        + sample.viewport.view().surroundings()->unitExponent * std::log10(2.0);
    QVERIFY2(std::abs(said - expected) < 1e-2, qPrintable(sample.said())); // three digits are true there
    QVERIFY(said < -350.0);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestMeasuring>(argc, argv);
}
#include "testmeasuring.moc"
