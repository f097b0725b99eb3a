// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <glm/geometric.hpp>

#include "pictures.h"
#include "viewportsample.h"

using namespace romanesco;
using namespace romanesco::test;
using Sample = romanesco::test::ViewportSample;

namespace {

/// The Sierpinski example with a camera.
std::shared_ptr<const Scene> withCamera(const SceneDescription::Camera &camera)
{
    Scene scene = *exampleScene("sierpinski.fdo");
    scene.camera = camera;
    return std::make_shared<const Scene>(std::move(scene));
}

}

/// Which picture is seen, and from which camera.
class TestViewport : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theWindowIsSeenBeforeAnythingIsDrawn();
    void thePictureShowsTheScene();
    void aFinishedPictureRests();
    void anotherSceneIsAnotherPicture();
    void noSceneIsTheBackground();
    void sidesAndProjection();
    void theCameraStaysWhenTheSceneChanges();
    void aSceneIsSeenFromItsOwnCamera();
    void anOrthographicCameraIsTold();
    void anotherCameraInTheTextIsFollowed();
    void movementIsFollowedByAFinePicture();
    void whatIsDenseMovesCoarsely();
    void resizingMakesANewPicture();
    void appearancesMakeNewPictures();
};

/// What drawing needs takes a while to make.
void TestViewport::theWindowIsSeenBeforeAnythingIsDrawn()
{
    Sample sample;
    int swaps = 0;
    std::optional<int> swapsBefore;
    connect(&sample.viewport, &Viewport::frameSwapped, &sample.viewport, [&] { ++swaps; });
    connect(&sample.viewport, &Viewport::ready, &sample.viewport, [&] { swapsBefore = swaps; });
    QVERIFY(sample.waitForPicture());
    QVERIFY(swapsBefore && *swapsBefore > 0);
}

void TestViewport::thePictureShowsTheScene()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const double share = brightShare(sample.viewport.grabFramebuffer());
    QVERIFY2(share > 0.05 && share < 0.9, qPrintable(QString::number(share)));
}

void TestViewport::aFinishedPictureRests()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QCoreApplication::processEvents();
    const qsizetype count = sample.finished.count();
    QTest::qWait(200);
    QCOMPARE(sample.finished.count(), count);
}

void TestViewport::anotherSceneIsAnotherPicture()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QImage first = sample.viewport.grabFramebuffer();
    sample.viewport.setScene(exampleScene("menger.fdo"));
    QVERIFY(!sample.viewport.isPictureFinished());
    QVERIFY(sample.waitForPicture());
    QVERIFY(first != sample.viewport.grabFramebuffer());
}

void TestViewport::noSceneIsTheBackground()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.viewport.setScene(nullptr);
    QVERIFY(sample.waitForPicture());
    QCOMPARE(brightShare(sample.viewport.grabFramebuffer()), 0.0);
}

void TestViewport::sidesAndProjection()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const auto forward = [&] { return sample.viewport.camera().worldFromCamera[2]; };
    sample.viewport.lookFrom(Viewport::Side::Front);
    QVERIFY(glm::distance(forward(), glm::dvec3(0, 0, 1)) < 1e-12);
    sample.viewport.lookFrom(Viewport::Side::Right);
    QVERIFY(glm::distance(forward(), glm::dvec3(-1, 0, 0)) < 1e-12);
    sample.viewport.lookFrom(Viewport::Side::Top);
    QVERIFY(glm::distance(forward(), glm::dvec3(0, -1, 0)) < 1e-12);

    QSignalSpy changes(&sample.viewport, &Viewport::projectionChanged);
    sample.viewport.setProjection(Projection::Orthographic);
    sample.viewport.setProjection(Projection::Orthographic);
    QCOMPARE(changes.count(), 1);
    QVERIFY(sample.waitForPicture());
    QVERIFY(brightShare(sample.viewport.grabFramebuffer()) > 0.05);
}

void TestViewport::theCameraStaysWhenTheSceneChanges()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.drag(Qt::LeftButton, {}, {50, 50}, {110, 70});
    const glm::dvec3 place = placeInWorld(sample.viewport);
    sample.viewport.setScene(exampleScene("menger.fdo"));
    QVERIFY(sample.waitForPicture());
    QVERIFY(glm::distance(placeInWorld(sample.viewport), place) < 1e-12);
}

void TestViewport::aSceneIsSeenFromItsOwnCamera()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const auto scene = withCamera({{1, 2, -9}, {0.1, 0.2, 0.3}, false, 40, {}});
    sample.viewport.setScene(scene);
    sample.viewport.resetView();
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.viewport.camera() == cameraOf(*scene->camera));
    // From there it orbits as usual, and comes back.
    sample.drag(Qt::LeftButton, {}, {50, 50}, {51, 56});
    QVERIFY(!(sample.viewport.camera() == cameraOf(*scene->camera)));
    QVERIFY(glm::distance(sample.viewport.camera().position, glm::dvec3(1, 2, -9)) < 3.0);
    sample.viewport.resetView();
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.viewport.camera() == cameraOf(*scene->camera));
}

void TestViewport::anOrthographicCameraIsTold()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QSignalSpy changes(&sample.viewport, &Viewport::projectionChanged);
    sample.viewport.setScene(withCamera({{0, 0, -9}, {0, 0, 0}, true, 4, {}}));
    sample.viewport.resetView();
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.viewport.camera().projection, Projection::Orthographic);
    QCOMPARE(changes.count(), 1);
    QVERIFY(brightShare(sample.viewport.grabFramebuffer()) > 0.02);
}

void TestViewport::anotherCameraInTheTextIsFollowed()
{
    Sample sample;
    sample.viewport.setScene(withCamera({{1, 2, -9}, {0, 0, 0}, false, 40, {}}));
    QVERIFY(sample.waitForPicture());
    sample.drag(Qt::LeftButton, {}, {50, 50}, {110, 70});
    const Camera moved = sample.viewport.camera();
    // The same camera in another place of another text is no news.
    sample.viewport.setScene(withCamera({{1, 2, -9}, {0, 0, 0}, false, 40, {7, 9}}));
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.viewport.camera() == moved);
    sample.viewport.setScene(withCamera({{1, 2, -8}, {0, 0, 0}, false, 40, {}}));
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.viewport.camera().position == glm::dvec3(1, 2, -8));
}

void TestViewport::movementIsFollowedByAFinePicture()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QSignalSpy advances(&sample.viewport, &Viewport::pictureAdvanced);
    sample.drag(Qt::LeftButton, {}, {50, 50}, {110, 70});
    QVERIFY(!sample.viewport.isPictureFinished());
    // The movement's own picture is coarse; a fine one follows by itself once the camera rests.
    const auto tolerance = [&] { return advances.isEmpty() ? 0.0 : advances.last()[1].toDouble(); };
    QVERIFY(QTest::qWaitFor([&] { return tolerance() > 0.0; }, 60'000));
    QVERIFY(QTest::qWaitFor([&] { return tolerance() == 1.0; }, 60'000));
    QVERIFY(sample.waitForPicture());
}

void TestViewport::whatIsDenseMovesCoarsely()
{
    Sample sample;
    sample.viewport.resize(640, 480);
    sample.viewport.setScene(exampleScene("menger.fdo"));
    QSignalSpy advances(&sample.viewport, &Viewport::pictureAdvanced);
    QPoint at(200, 200);
    for (int pictures = 0; pictures < 8; ++pictures) {
        const qsizetype before = advances.size();
        sample.drag(Qt::LeftButton, {}, at, at + QPoint(10, 3));
        QVERIFY(QTest::qWaitFor([&] { return advances.size() > before; }, 60'000));
    }
    const auto tolerance = [&] { return advances.last()[1].toDouble(); };
    const auto drawn = [&] { return advances.last()[0].value<DrawStatistics>(); };
    const double moving = tolerance();
    const DrawStatistics whileMoving = drawn();
    QVERIFY(QTest::qWaitFor([&] { return tolerance() == 1.0; }, 60'000));
    const bool isFast = drawn().milliseconds < 2.0 * DragTolerance::budgetMilliseconds; // as some cards are
    QVERIFY2(isFast || (moving > 1.5 && whileMoving.instances < drawn().instances),
             qPrintable(QString::number(moving)));
}

void TestViewport::resizingMakesANewPicture()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.viewport.resize(400, 200);
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.size() == QSize(400, 200); }));
    QVERIFY(sample.waitForPicture());
    QVERIFY(brightShare(sample.viewport.grabFramebuffer()) > 0.02);
}

void TestViewport::appearancesMakeNewPictures()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QImage before = sample.viewport.grabFramebuffer();
    Appearance appearance;
    appearance.colours.colouring = Colouring::Branch;
    sample.viewport.setAppearance(appearance);
    QVERIFY(!sample.viewport.isPictureFinished());
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.viewport.grabFramebuffer() != before);
    sample.viewport.setAppearance({});
    QVERIFY(sample.waitForPicture());
    QVERIFY(isLike(sample.viewport.grabFramebuffer(), before));
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestViewport>(argc, argv);
}
#include "testviewport.moc"
