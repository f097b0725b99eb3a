// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "app/window/gizmoshape.h"
#include "app/window/tooloverlay.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

constexpr auto pair = "far 4.00 0 0\nv -4 0 0\nx. \"cube.obj\"\nat.p. (p, #, #)\n<$>. [at.far, at.2] x\n";
constexpr auto scene = "o \"cube.obj\" ((4.0, 0, 0), (0, 0, 0), #)\no \"cube.obj\" #\n";

/// From the front, with a copy taken hold of.
struct GizmoSample : Sample {
    bool begin(const QString &name, const char *text, const Selection &copy, Qt::Key tool)
    {
        const bool isThere = QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj")))
            && openAndWait(write(name, text)) && focusViewport();
        viewport.lookFrom(Viewport::Side::Front);
        viewport.setProjection(Projection::Orthographic);
        viewport.fit();
        viewport.select(copy);
        Q_EMIT viewport.clicked({});
        QTest::keyClick(&viewport, tool);
        return isThere && window.findChild<ToolOverlay *>()->isVisible();
    }
    [[nodiscard]] QString text() const { return visibleEditor().toPlainText(); }
    [[nodiscard]] double pixelsOf(double worldUnits) const
    {
        return worldUnits / viewport.view().cameraInWorld().viewHeight * viewport.height();
    }
    [[nodiscard]] QPoint pixelAt(const glm::dvec3 &inWorld) const
    {
        return viewport.placeOf(viewport.view().surroundings()->hereFromWorld(inWorld))->toPoint();
    }
    void drag(QPoint from, QPoint way, Qt::KeyboardModifiers keys = {})
    {
        const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton which, Qt::MouseButtons held) {
            QMouseEvent event(type, at, viewport.mapToGlobal(at), which, held, keys);
            QCoreApplication::sendEvent(&viewport, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= 4; ++i) {
            send(QEvent::MouseMove, from + way * i / 4, Qt::NoButton, Qt::LeftButton);
        }
        send(QEvent::MouseButtonRelease, from + way, Qt::LeftButton, Qt::NoButton);
    }
    [[nodiscard]] double numberIn(const QString &before, const QString &after) const
    {
        const QString all = text();
        const qsizetype begin = all.indexOf(before) + before.size();
        return all.mid(begin, all.indexOf(after, begin) - begin).toDouble();
    }
};

}

/// Handles that rewrite the vector they come from.
class TestGizmo : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void movingRewritesOneVector();
    void aWholeNumberStaysOneUnlessItIsToBeFiner();
    void anObjectOfASceneIsMoved();
    void whatIsNotWrittenYetIsWritten();
    void scalingKeepsShape();
    void aRingTurnsOneAngle();
    void besideTheHandlesTheViewTurns();
    void theSelectionStaysAndCanBeDraggedAgain();
    void sharedVectorsAreTold();
    void aReadOnlyTextStays();
    void pointsGoWhereTheirSpeedSays();
};

void TestGizmo::movingRewritesOneVector()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("pair.fdo"), pair, Selection{0, {{0, 0}}}, Qt::Key_G));
    // along the x axis, which is 90 pixels long
    const QPoint tip = sample.pixelAt({4, 0, 0}) + QPoint(70, 0);
    const QPoint way(-qRound(sample.pixelsOf(1.0)), 25);
    sample.drag(tip, way);
    const double moved = sample.numberIn(QStringLiteral("far "), QStringLiteral(" "));
    QVERIFY2(std::abs(moved - (4.0 + way.x() / sample.pixelsOf(1.0))) < 0.006, qPrintable(sample.text()));
    const QString expected = QString::fromLatin1(pair).replace(QStringLiteral("4.00"), QString::number(moved, 'f', 2));
    QCOMPARE(sample.text(), expected);
    // the picture follows
    QVERIFY(QTest::qWaitFor(
        [&] { return std::abs(sample.viewport.view().surroundings()->scene->extent.greatest.x - moved - 1.5) < 0.1; },
        20'000));
    sample.visibleEditor().undo(); // all of it
    QCOMPARE(sample.text(), QString::fromLatin1(pair));
}

void TestGizmo::aWholeNumberStaysOneUnlessItIsToBeFiner()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("pair.fdo"), pair, Selection{0, {{0, 1}}}, Qt::Key_G));
    const QPoint tip = sample.pixelAt({-4, 0, 0}) + QPoint(0, -70);
    const QPoint up(0, -qRound(sample.pixelsOf(1.3)));
    sample.drag(tip, up, Qt::ShiftModifier);
    const double finer = sample.numberIn(QStringLiteral("v -4 "), QStringLiteral(" "));
    QVERIFY2(std::abs(finer - 1.3) < 0.02 && finer != 1.0, qPrintable(sample.text()));
    sample.visibleEditor().undo();
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.isPictureFinished(); }, 20'000));
    QTest::qWait(500);
    sample.drag(sample.pixelAt({-4, 0, 0}) + QPoint(0, -70), up);
    QVERIFY2(sample.text().contains(QStringLiteral("v -4 1 0\n")), qPrintable(sample.text()));
}

void TestGizmo::anObjectOfASceneIsMoved()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("a.sdo"), scene, Selection{0, {}}, Qt::Key_G));
    sample.drag(sample.pixelAt({4, 0, 0}) + QPoint(70, 0), {qRound(sample.pixelsOf(1.0)), 0});
    const double moved = sample.numberIn(QStringLiteral("(("), QStringLiteral(","));
    QVERIFY2(std::abs(moved - 5.0) < 0.11, qPrintable(sample.text()));
    QVERIFY(sample.text().endsWith(QStringLiteral(", 0, 0), (0, 0, 0), #)\no \"cube.obj\" #\n")));
}

void TestGizmo::whatIsNotWrittenYetIsWritten()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("a.sdo"), scene, Selection{1, {}}, Qt::Key_G));
    sample.drag(sample.pixelAt({0, 0, 0}) + QPoint(0, -70), {0, -qRound(sample.pixelsOf(2.0))});
    QVERIFY2(sample.text().endsWith(QStringLiteral("\no \"cube.obj\" ((0, 2, 0), #, #)\n")), qPrintable(sample.text()));
    sample.visibleEditor().undo();
    QCOMPARE(sample.text(), QString::fromLatin1(scene));
}

void TestGizmo::scalingKeepsShape()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("a.sdo"), scene, Selection{1, {}}, Qt::Key_T));
    // the middle takes all three along
    sample.drag(sample.pixelAt({0, 0, 0}), {40, -40});
    const double scale = sample.numberIn(QStringLiteral("(#, #, ("), QStringLiteral(","));
    QVERIFY2(scale > 1.05, qPrintable(sample.text()));
    const QString expected = QStringLiteral("(#, #, (%1, %1, %1))\n").arg(scale, 0, 'f', 2);
    QVERIFY2(sample.text().endsWith(expected), qPrintable(sample.text()));
}

void TestGizmo::aRingTurnsOneAngle()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("a.sdo"), scene, Selection{0, {}}, Qt::Key_R));
    // The ring about z is seen as a circle of 90 pixels; a quarter of a radian along its tangent.
    const QPoint right = sample.pixelAt({4, 0, 0}) + QPoint(64, -64);
    sample.drag(right, {qRound(22.5 * 0.7071), qRound(22.5 * 0.7071)});
    const QString before = QStringLiteral("(4.0, 0, 0), (0, 0, ");
    const double angle = sample.numberIn(before, QStringLiteral(")"));
    QVERIFY2(std::abs(std::abs(angle) - 14.3) < 1.5, qPrintable(sample.text()));
    // clockwise on the screen, as the pointer went
    const glm::dvec3 turned = mapFromParts({0, 0, 0}, {0, 0, angle}, {1, 1, 1}).linear * glm::dvec3(1, 1, 0);
    QVERIFY(turned.x > 1.0 && turned.y < 1.0);
}

void TestGizmo::besideTheHandlesTheViewTurns()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("pair.fdo"), pair, Selection{0, {{0, 0}}}, Qt::Key_G));
    const glm::dmat3 before = sample.viewport.camera().worldFromCamera;
    sample.drag({10, 10}, {60, 30});
    QVERIFY(!(sample.viewport.camera().worldFromCamera == before));
    QCOMPARE(sample.text(), QString::fromLatin1(pair));
    QTest::keyClick(&sample.viewport, Qt::Key_Escape);
    QVERIFY(!sample.window.findChild<ToolOverlay *>()->isVisible());
}

void TestGizmo::theSelectionStaysAndCanBeDraggedAgain()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("pair.fdo"), pair, Selection{0, {{0, 0}}}, Qt::Key_G));
    for (int drags = 1; drags <= 2; ++drags) {
        const double from = sample.numberIn(QStringLiteral("far "), QStringLiteral(" "));
        const auto before = sample.viewport.view().surroundings()->scene;
        sample.drag(sample.pixelAt({from, 0, 0}) + QPoint(70, 0), {20, 0});
        QVERIFY(sample.numberIn(QStringLiteral("far "), QStringLiteral(" ")) > from);
        QVERIFY(QTest::qWaitFor(
            [&] {
                return sample.viewport.view().surroundings()->scene != before
                    && std::abs(sample.viewport.view().surroundings()->scene->extent.greatest.x
                                - sample.numberIn(QStringLiteral("far "), QStringLiteral(" ")) - 1.5)
                    < 0.1;
            },
            20'000));
        QVERIFY((sample.viewport.appearance().colours.selection == Selection{0, {{0, 0}}}));
    }
}

void TestGizmo::sharedVectorsAreTold()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("shared.fdo"),
                         "far 1 2 1\nx. \"cube.obj\"\nat.p. (p, #, #)\nsize.s. (#, #, s)\ny. [at.far] x\n"
                         "<$>. [size.far] y\n",
                         Selection{0, {{1, 0}, {0, 0}}}, Qt::Key_G));
    QVERIFY2(sample.strip().contains(QStringLiteral("used in 2 places")), qPrintable(sample.strip()));
    QTest::keyClick(&sample.viewport, Qt::Key_R);
    QVERIFY2(sample.strip().contains(QStringLiteral("nothing to drag")), qPrintable(sample.strip()));
    QTest::keyClick(&sample.viewport, Qt::Key_R);
    QCOMPARE(sample.strip(), QString());
}

void TestGizmo::aReadOnlyTextStays()
{
    GizmoSample sample;
    QVERIFY(sample.begin(QStringLiteral("pair.fdo"), pair, Selection{0, {{0, 0}}}, Qt::Key_G));
    sample.visibleEditor().setReadOnly(true);
    QTest::keyClick(&sample.viewport, Qt::Key_G);
    QTest::keyClick(&sample.viewport, Qt::Key_G);
    QVERIFY2(sample.strip().contains(QStringLiteral("cannot be edited")), qPrintable(sample.strip()));
    sample.drag(sample.pixelAt({4, 0, 0}) + QPoint(70, 0), {30, 0});
    QCOMPARE(sample.text(), QString::fromLatin1(pair));
}

/// The point of a handle, placed anew with a component a little larger, against the speed.
void TestGizmo::pointsGoWhereTheirSpeedSays()
{
    Camera camera;
    camera.position = {3, 4, -20};
    camera.worldFromCamera = rotationLooking(glm::dvec3(-0.1, -0.15, 1.0));
    GizmoFrame frame;
    frame.hereFromParent = mapFromParts({1, -1, 0.5}, {20, 50, -35}, {0.7, 0.7, 0.7});
    frame.parts = {{1, 2, 0.5}, {25, -40, 70}, {0.5, 1.5, 2.0}};
    for (const GizmoKind kind : {GizmoKind::Move, GizmoKind::Rotate, GizmoKind::Scale}) {
        const std::vector<GizmoHandle> handles = gizmoHandles(kind, frame, 2.0);
        QVERIFY(handles.size() >= 3);
        for (const GizmoHandle &handle : handles) {
            if (handle.axis == GizmoHandle::all) {
                continue;
            }
            const std::size_t point = handle.line.size() / 2;
            // what of the copy is at that point now
            const auto whole = [&](const TransformParts &parts) {
                return frame.hereFromParent * mapFromParts(parts.position, parts.rotation, parts.scale);
            };
            const AffineMap now = whole(frame.parts);
            const glm::dvec3 inCopy = glm::inverse(now.linear) * (handle.line[point] - now.translation);
            TransformParts more = frame.parts;
            const double step = 1e-5;
            if (kind == GizmoKind::Move) {
                more.position[handle.axis] += step;
            } else if (kind == GizmoKind::Rotate) {
                more.rotation[handle.axis] += step;
            } else {
                more.scale[handle.axis] *= 1.0 + step;
            }
            const glm::dvec2 went = (*seenAt(camera, whole(more)(inCopy)) - *seenAt(camera, handle.line[point])) / step;
            const glm::dvec2 said = gizmoSpeed(kind, frame, handle, point, camera);
            QVERIFY2(glm::distance(went, said) < 2e-3 * glm::length(went),
                     qPrintable(QStringLiteral("%1 %2: %3 %4")
                                    .arg(int(kind))
                                    .arg(handle.axis)
                                    .arg(glm::length(went))
                                    .arg(glm::distance(went, said))));
        }
    }
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestGizmo>(argc, argv);
}
#include "testgizmo.moc"
