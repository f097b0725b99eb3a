// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QWheelEvent>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "pictures.h"
#include "viewportsample.h"

using namespace romanesco;
using namespace romanesco::test;
using Sample = romanesco::test::ViewportSample;

namespace {

/// The Sierpinski example, as deep as a view ever goes.
std::shared_ptr<const Scene> deepScene()
{
    const ResourceFiles files;
    const std::filesystem::path path = ":/examples/sierpinski.fdo";
    std::string text = files.read(path).value();
    text = text.substr(0, text.rfind(' ')) + " 100000\n";
    return SceneLoader(files).load(path, text).scene;
}

bool isEqual(const glm::dmat3 &a, const glm::dmat3 &b)
{
    return a == b;
}

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

/// What drags, clicks, the wheel and held keys do to the view.
class TestViewportInput : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void leftDragOrbits();
    void rightDragPans_data();
    void rightDragPans();
    void aShortDragIsAClick();
    void theWheelZoomsToThePointer();
    void heldKeysFly();
    void theWheelGoesIntoTheSurface_data();
    void theWheelGoesIntoTheSurface();
    void aClickLetsACopyStandOut_data();
    void aClickLetsACopyStandOut();
};

void TestViewportInput::leftDragOrbits()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const Camera before = sample.viewport.camera();
    sample.drag(Qt::LeftButton, {}, {50, 50}, {110, 70});
    const Camera after = sample.viewport.camera();
    QVERIFY(!isEqual(before.worldFromCamera, after.worldFromCamera));
    QCOMPARE(sample.clicks.count(), 0);
}

void TestViewportInput::rightDragPans_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("right") << Qt::RightButton << Qt::KeyboardModifiers();
    QTest::newRow("shift and left") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
}

void TestViewportInput::rightDragPans()
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

void TestViewportInput::aShortDragIsAClick()
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

void TestViewportInput::theWheelZoomsToThePointer()
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

void TestViewportInput::heldKeysFly()
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

void TestViewportInput::theWheelGoesIntoTheSurface_data()
{
    QTest::addColumn<Projection>("projection");
    QTest::newRow("perspective") << Projection::Perspective;
    QTest::newRow("orthographic") << Projection::Orthographic;
}

void TestViewportInput::theWheelGoesIntoTheSurface()
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

void TestViewportInput::aClickLetsACopyStandOut_data()
{
    theWheelGoesIntoTheSurface_data();
}

void TestViewportInput::aClickLetsACopyStandOut()
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

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestViewportInput>(argc, argv);
}
#include "testviewportinput.moc"
