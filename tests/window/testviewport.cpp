// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QSignalSpy>
#include <QWheelEvent>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/window/resourcefiles.h"
#include "app/window/viewport.h"
#include "core/scene/sceneloader.h"
#include "glapplication.h"
#include "pictures.h"

using namespace romanesco;
using romanesco::test::isLike;

namespace {

std::shared_ptr<const Scene> exampleScene(const char *name)
{
    const ResourceFiles files;
    const std::filesystem::path path = std::filesystem::path(":/examples") / name;
    return SceneLoader(files).load(path, files.read(path).value()).scene;
}

/// The Sierpinski example with a camera.
std::shared_ptr<const Scene> withCamera(const SceneDescription::Camera &camera)
{
    Scene scene = *exampleScene("sierpinski.fdo");
    scene.camera = camera;
    return std::make_shared<const Scene>(std::move(scene));
}

/// The share of pixels that are brighter than the background ever is.
double brightShare(const QImage &picture)
{
    qsizetype bright = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            bright += qGray(picture.pixel(x, y)) > 60 ? 1 : 0;
        }
    }
    return double(bright) / double(picture.width() * picture.height());
}

/// The Sierpinski example, as deep as a view ever goes.
std::shared_ptr<const Scene> deepScene()
{
    const ResourceFiles files;
    const std::filesystem::path path = ":/examples/sierpinski.fdo";
    std::string text = files.read(path).value();
    text = text.substr(0, text.rfind(' ')) + " 100000\n";
    return SceneLoader(files).load(path, text).scene;
}

/// Where the camera stands, from wherever it is counted.
glm::dvec3 placeInWorld(const Viewport &viewport)
{
    const Surroundings &all = *viewport.view().surroundings();
    return all.origin + std::exp2(all.unitExponent) * viewport.camera().position;
}

struct Sample {
    Viewport viewport;
    QSignalSpy finished{&viewport, &Viewport::pictureFinished};
    QSignalSpy clicks{&viewport, &Viewport::clicked};

    Sample()
    {
        viewport.resize(160, 120);
        viewport.setScene(exampleScene("sierpinski.fdo"));
        viewport.resetView();
        viewport.show();
    }
    bool waitForPicture()
    {
        return QTest::qWaitFor([&] { return viewport.isPictureFinished(); }, 60'000);
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint from, QPoint to)
    {
        const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton which, Qt::MouseButtons held) {
            QMouseEvent event(type, at, viewport.mapToGlobal(at), which, held, modifiers);
            QCoreApplication::sendEvent(&viewport, &event);
        };
        send(QEvent::MouseButtonPress, from, button, button);
        send(QEvent::MouseMove, to, Qt::NoButton, button);
        send(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
    }
};

bool isEqual(const glm::dmat3 &a, const glm::dmat3 &b)
{
    return a == b;
}

}

class TestViewport : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theWindowIsSeenBeforeAnythingIsDrawn();
    void thePictureShowsTheScene();
    void aFinishedPictureRests();
    void anotherSceneIsAnotherPicture();
    void noSceneIsTheBackground();
    void leftDragOrbits();
    void rightDragPans_data();
    void rightDragPans();
    void aShortDragIsAClick();
    void theWheelZoomsToThePointer();
    void sidesAndProjection();
    void theCameraStaysWhenTheSceneChanges();
    void aSceneIsSeenFromItsOwnCamera();
    void anOrthographicCameraIsTold();
    void anotherCameraInTheTextIsFollowed();
    void movementIsFollowedByAFinePicture();
    void whatIsDenseMovesCoarsely();
    void heldKeysFly();
    void resizingMakesANewPicture();
    void theWheelGoesIntoTheSurface_data();
    void theWheelGoesIntoTheSurface();
    void aClickLetsACopyStandOut_data();
    void aClickLetsACopyStandOut();
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

void TestViewport::leftDragOrbits()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const Camera before = sample.viewport.camera();
    sample.drag(Qt::LeftButton, {}, {50, 50}, {110, 70});
    const Camera after = sample.viewport.camera();
    QVERIFY(!isEqual(before.worldFromCamera, after.worldFromCamera));
    QCOMPARE(sample.clicks.count(), 0);
}

void TestViewport::rightDragPans_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("right") << Qt::RightButton << Qt::KeyboardModifiers();
    QTest::newRow("shift and left") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
}

void TestViewport::rightDragPans()
{
    QFETCH(const Qt::MouseButton, button);
    QFETCH(const Qt::KeyboardModifiers, modifiers);
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const Camera before = sample.viewport.camera();
    sample.drag(button, modifiers, {50, 50}, {110, 70});
    const Camera after = sample.viewport.camera();
    QVERIFY(isEqual(before.worldFromCamera, after.worldFromCamera));
    const glm::dvec3 shift = glm::transpose(before.worldFromCamera) * (after.position - before.position);
    // The scene follows the hand to the right and down, so the camera goes left and up.
    QVERIFY(shift.x < 0.0 && shift.y > 0.0 && std::abs(shift.z) < 1e-9);
}

void TestViewport::aShortDragIsAClick()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const Camera before = sample.viewport.camera();
    sample.drag(Qt::LeftButton, {}, {100, 100}, {102, 102});
    QCOMPARE(sample.clicks.count(), 1);
    QVERIFY(isEqual(before.worldFromCamera, sample.viewport.camera().worldFromCamera));
    sample.drag(Qt::LeftButton, {}, {100, 100}, {104, 100});
    QCOMPARE(sample.clicks.count(), 1);
    QVERIFY(!isEqual(before.worldFromCamera, sample.viewport.camera().worldFromCamera));
}

void TestViewport::theWheelZoomsToThePointer()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const Camera before = sample.viewport.camera();
    const QPointF place(120, 30);
    QWheelEvent event(place, sample.viewport.mapToGlobal(place), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&sample.viewport, &event);
    const glm::dvec3 shift =
        glm::transpose(before.worldFromCamera) * (sample.viewport.camera().position - before.position);
    QVERIFY(shift.z > 0.0 && shift.x > 0.0 && shift.y > 0.0);
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

void TestViewport::heldKeysFly()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.viewport.setFocus();
    const Camera before = sample.viewport.camera();
    const auto fly = [&](Qt::Key key) {
        const glm::dvec3 from = placeInWorld(sample.viewport);
        QTest::keyPress(&sample.viewport, key);
        const bool hasMoved = QTest::qWaitFor([&] { return placeInWorld(sample.viewport) != from; }, 20'000);
        QTest::keyRelease(&sample.viewport, key);
        const glm::dvec3 way = placeInWorld(sample.viewport) - from;
        return hasMoved ? glm::normalize(glm::transpose(before.worldFromCamera) * way) : glm::dvec3(0.0);
    };
    QVERIFY(glm::distance(fly(Qt::Key_W), {0, 0, 1}) < 1e-6);
    QVERIFY(glm::distance(fly(Qt::Key_S), {0, 0, -1}) < 1e-6);
    QVERIFY(glm::distance(fly(Qt::Key_A), {-1, 0, 0}) < 1e-6);
    QVERIFY(glm::distance(fly(Qt::Key_D), {1, 0, 0}) < 1e-6);
    // It stays where it is then, and looks about while it flies.
    const glm::dvec3 place = placeInWorld(sample.viewport);
    QVERIFY(sample.waitForPicture());
    QVERIFY(placeInWorld(sample.viewport) == place);
    QVERIFY(isEqual(sample.viewport.camera().worldFromCamera, before.worldFromCamera));
    QTest::keyPress(&sample.viewport, Qt::Key_A);
    sample.drag(Qt::RightButton, {}, {50, 50}, {90, 50});
    QTest::keyRelease(&sample.viewport, Qt::Key_A);
    const glm::dvec3 forward = glm::transpose(before.worldFromCamera) * sample.viewport.camera().worldFromCamera[2];
    QVERIFY(forward.x > 0.5 && std::abs(glm::length(forward) - 1.0) < 1e-9);
    QVERIFY(sample.waitForPicture());
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

namespace {

/// A place on the surface, near a place; the scene's own surface finder has to be there.
QPoint placeOnSurface(const Viewport &viewport, QPoint near)
{
    for (int i = 0; i < 60 * 60; ++i) {
        const QPoint place = near + QPoint(i % 60 - 30, i / 60 - 30);
        const glm::dvec2 at(place.x() + 0.5 - viewport.width() / 2.0, viewport.height() / 2.0 - place.y() - 0.5);
        if (viewport.view().pick(at / double(viewport.height()), 1e-3)) {
            return place;
        }
    }
    return near;
}

/// How many clicks change the picture where they are; those do not that meet a copy of which less is seen than a sample
/// finds.
int clicksThatAreSeen(Sample &sample, std::initializer_list<QPoint> places)
{
    int seen = 0;
    for (const QPoint near : places) {
        const QImage before = sample.viewport.grabFramebuffer();
        const QPoint place = placeOnSurface(sample.viewport, near);
        sample.drag(Qt::LeftButton, Qt::NoModifier, place, place);
        const auto selected = sample.viewport.appearance().colours.selection;
        const bool isSelected = selected && !selected->steps.empty() && sample.waitForPicture();
        const qreal ratio = sample.viewport.devicePixelRatioF();
        const QRect there((place - QPoint(1, 1)) * ratio, QSize(3, 3) * ratio);
        seen += isSelected && sample.viewport.grabFramebuffer().copy(there) != before.copy(there) ? 1 : 0;
    }
    return seen;
}

void enter(Viewport &viewport)
{
    QEnterEvent event(QPointF(1, 1), QPointF(1, 1), QPointF(1, 1));
    QCoreApplication::sendEvent(&viewport, &event);
}

}

void TestViewport::theWheelGoesIntoTheSurface_data()
{
    QTest::addColumn<Projection>("projection");
    QTest::newRow("perspective") << Projection::Perspective;
    QTest::newRow("orthographic") << Projection::Orthographic;
}

void TestViewport::theWheelGoesIntoTheSurface()
{
    QFETCH(const Projection, projection);
    Sample sample;
    sample.viewport.setScene(deepScene());
    sample.viewport.resetView();
    QVERIFY(sample.waitForPicture());
    sample.viewport.setProjection(projection);
    enter(sample.viewport);
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }));
    QVERIFY(sample.waitForPicture());
    for (int notch = 0; notch < 400; ++notch) {
        const QPointF place = placeOnSurface(sample.viewport, {80, 60});
        QWheelEvent event(place, sample.viewport.mapToGlobal(place), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&sample.viewport, &event);
    }
    // A notch goes 15 % of the way, a level is half as large as the one above.
    const std::size_t expected = static_cast<std::size_t>(400 * std::log(0.85) / std::log(0.5));
    const std::size_t depth = sample.viewport.view().surroundings()->path.size();
    QVERIFY2(depth + 8 > expected && depth < expected + 8, qPrintable(QString::number(depth)));
    QVERIFY(sample.waitForPicture());
    QVERIFY(brightShare(sample.viewport.grabFramebuffer()) > 0.02);
    QVERIFY(clicksThatAreSeen(sample, {{80, 60}, {100, 90}, {60, 80}, {90, 70}, {70, 90}}) >= 1);
    sample.viewport.fit();
    QVERIFY(sample.viewport.view().surroundings()->path.size() < 3);
}

void TestViewport::aClickLetsACopyStandOut_data()
{
    theWheelGoesIntoTheSurface_data();
}

void TestViewport::aClickLetsACopyStandOut()
{
    QFETCH(const Projection, projection);
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.viewport.setProjection(projection);
    enter(sample.viewport);
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }));
    QVERIFY(sample.waitForPicture());
    const QImage before = sample.viewport.grabFramebuffer();
    QVERIFY(clicksThatAreSeen(sample, {{80, 60}, {100, 90}, {60, 80}, {90, 70}, {70, 90}}) >= 3);
    sample.drag(Qt::LeftButton, Qt::NoModifier, {1, 1}, {1, 1});
    QVERIFY(!sample.viewport.appearance().colours.selection);
    QVERIFY(sample.waitForPicture());
    QVERIFY(isLike(sample.viewport.grabFramebuffer(), before));
    QVERIFY(clicksThatAreSeen(sample, {{80, 60}, {100, 90}, {60, 80}, {90, 70}, {70, 90}}) >= 1);
    sample.viewport.setScene(exampleScene("menger.fdo"));
    QVERIFY2(!sample.viewport.appearance().colours.selection, "of another scene");
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
