// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include <QTest>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <rapidcheck.h>

#include "render/cut.h"
#include "render/orbitcamera.h"
#include "scenes.h"
#include "tests/testmain.h"

using namespace romanesco;

namespace {

/// Where a point falls on the screen, ±1 at the edges, from the textbook: x right, y up, z forward, divided by z.
glm::dvec3 onScreen(const Camera &camera, const glm::dvec3 &point, double aspect)
{
    const glm::dvec3 p = glm::transpose(camera.worldFromCamera) * (point - camera.position);
    const bool isPerspective = camera.projection == Projection::Perspective;
    const double half =
        isPerspective ? p.z * std::tan(camera.fieldOfView * std::acos(-1.0) / 360.0) : 0.5 * camera.viewHeight;
    return {p.x / (half * aspect), p.y / half, p.z};
}

}

class TestCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fittedViewHoldsTheSceneAndFillsIt_data()
    {
        QTest::addColumn<double>("aspect");
        QTest::addColumn<bool>("isPerspective");
        for (const double aspect : {0.4, 1.0, 16.0 / 9.0}) {
            QTest::addRow("perspective, aspect %g", aspect) << aspect << true;
            QTest::addRow("orthographic, aspect %g", aspect) << aspect << false;
        }
    }

    void fittedViewHoldsTheSceneAndFillsIt()
    {
        QFETCH(const double, aspect);
        QFETCH(const bool, isPerspective);
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n", test::boxObj({3, -7, 100}, {5, 2, 100.5}));
        QVERIFY(scene);
        Camera camera = fittedCamera(*scene, aspect);
        camera.projection = isPerspective ? Projection::Perspective : Projection::Orthographic;
        camera = fittedCamera(camera, *scene, aspect);
        double reach = 0.0;
        for (const glm::dvec3 &vertex : scene->items.front().model->mesh->vertices) {
            const glm::dvec3 p = onScreen(camera, vertex, aspect);
            QVERIFY(p.z > 0.0);
            reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
        }
        QVERIFY2(reach <= 1.0, qPrintable(QString::number(reach)));
        QVERIFY2(reach > 0.9, qPrintable(QString::number(reach)));
    }

    /// x right, y up, z forward: with z forward, what lies to the right in the world is on the right of the screen.
    void coordinatesAreLeftHanded()
    {
        const glm::dmat3 rotation = rotationLooking({0, 0, 1});
        QCOMPARE(rotation[0], glm::dvec3(1, 0, 0));
        QCOMPARE(rotation[1], glm::dvec3(0, 1, 0));
        QCOMPARE(rotation[2], glm::dvec3(0, 0, 1));
    }

    /// The dissertation's camera (appendix A) has the origin in view, 20.8 degrees off its axis, as worked out by hand.
    void aSceneCameraIsReadInRadians()
    {
        const Camera camera =
            cameraOf({{-48.761894, 25.567242, 64.429054}, {-0.071402885, -2.4999454, 0}, false, 60, {}});
        const glm::dvec3 p = glm::transpose(camera.worldFromCamera) * -camera.position;
        QVERIFY(std::abs(p.x / p.z - -0.02) < 0.005);
        QVERIFY(std::abs(p.y / p.z - -0.38) < 0.005);
        const double degrees = std::acos(p.z / glm::length(p)) * 180.0 / std::acos(-1.0);
        QVERIFY2(std::abs(degrees - 20.8) < 0.05, qPrintable(QString::number(degrees)));
        const glm::dvec3 screen = onScreen(camera, {0, 0, 0}, 1.0);
        QVERIFY(std::abs(screen.y * 0.57735 - p.y / p.z) < 1e-5);
        QVERIFY(std::abs(glm::determinant(camera.worldFromCamera) - 1.0) < 1e-12);
    }

    void aSceneCameraHasItsProjection()
    {
        const Camera perspective = cameraOf({{1, 2, 3}, {0, 0, 0}, false, 35, {}});
        QVERIFY(perspective.projection == Projection::Perspective && perspective.fieldOfView == 35.0);
        const Camera orthographic = cameraOf({{1, 2, 3}, {0, 0, 0}, true, 35, {}});
        QVERIFY(orthographic.projection == Projection::Orthographic && orthographic.viewHeight == 35.0);
    }

    void viewsOfEveryWidthAreNumbers_data()
    {
        QTest::addColumn<double>("view");
        for (const double view : {1e-320, 1e-100, 1e-9, 60.0, 179.999999999999}) {
            QTest::addRow("%g", view) << view;
        }
        QTest::newRow("greatest") << 1.7e308;
    }

    void viewsOfEveryWidthAreNumbers()
    {
        QFETCH(const double, view);
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        for (const bool isOrthographic : {true, false}) {
            if (!isOrthographic && view >= 180.0) {
                continue;
            }
            const Camera camera = cameraOf({{1, 2, -9}, {0, 0, 0}, isOrthographic, view, {}});
            const Projector projector(camera, test::around(*scene), 0.0, 640, 480);
            for (const double number : {projector.scaleX, projector.scaleY, projector.pixels}) {
                QVERIFY(std::isfinite(static_cast<float>(number)));
            }
            Cut cut(*scene->items[0].model);
            cut.begin(projector, test::rootAt({}), 1.0);
            while (!cut.isComplete()) {
                for (const Instance &instance : cut.next(100)) {
                    QVERIFY(!std::isnan(instance.rows[0][3]));
                }
            }
        }
    }

    /// Moving by nothing changes nothing, whatever way up the camera is; and the pivot is on its axis, before it.
    void orbitStartsFromAnyCamera_data()
    {
        QTest::addColumn<glm::dvec3>("position");
        QTest::addColumn<glm::dvec3>("rotation");
        QTest::newRow("level") << glm::dvec3(0, 0, -9) << glm::dvec3(0, 0, 0);
        QTest::newRow("rolled") << glm::dvec3(0, 0, -9) << glm::dvec3(0.1, 0.2, 1.3);
        QTest::newRow("appendix A") << glm::dvec3(-48, 25, 64) << glm::dvec3(-0.0714, -2.5, 0);
        QTest::newRow("upside down") << glm::dvec3(0, 0, -9) << glm::dvec3(0, 0, 3.14159);
        QTest::newRow("straight down") << glm::dvec3(0, 9, 0) << glm::dvec3(-1.5707963267948966, 0, 0);
        QTest::newRow("looking away") << glm::dvec3(0, 0, 9) << glm::dvec3(0, 0, 0);
        QTest::newRow("inside") << glm::dvec3(0, 0, 0) << glm::dvec3(0.5, 1, 0);
    }

    void orbitStartsFromAnyCamera()
    {
        QFETCH(const glm::dvec3, position);
        QFETCH(const glm::dvec3, rotation);
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        const Camera camera = cameraOf({position, rotation, false, 40, {}});
        OrbitCamera orbit;
        orbit.start(camera, test::around(*scene));
        QVERIFY(orbit.camera() == camera);
        const glm::dvec3 pivot = onScreen(camera, orbit.pivot(), 1.0);
        QVERIFY(pivot.z > 0.0 && std::abs(pivot.x) < 1e-9 && std::abs(pivot.y) < 1e-9);
        orbit.orbit({0.0, 0.0});
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(glm::distance(orbit.camera().worldFromCamera[axis], camera.worldFromCamera[axis]) < 1e-9);
        }
        QVERIFY(glm::distance(orbit.camera().position, camera.position) < 1e-9);
        QCOMPARE(orbit.camera().fieldOfView, 40.0);
        orbit.fit(*scene, 1.0);
        QVERIFY(std::abs(orbit.camera().worldFromCamera[0].y) < 1e-12);
        QCOMPARE(orbit.camera().fieldOfView, 60.0);
    }

    void startsFromTheDocumentedDirection()
    {
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        const Camera camera = fittedCamera(*scene, 1.0);
        const glm::dvec3 expected = glm::normalize(glm::dvec3(-1.0, -0.8, 1.2));
        QVERIFY(glm::distance(camera.worldFromCamera[2], expected) < 1e-12);
    }

    void orbitKeepsThePivotWhereItIs()
    {
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        QVERIFY(rc::check([&] {
            const double x = *rc::gen::inRange(-100'000, 100'000) / 1e3;
            const double y = *rc::gen::inRange(-2'000, 2'000) / 1e3;
            OrbitCamera orbit;
            orbit.fit(*scene, 1.0);
            const glm::dvec3 before = onScreen(orbit.camera(), orbit.pivot(), 1.0);
            orbit.orbit({x, y});
            const glm::dvec3 after = onScreen(orbit.camera(), orbit.pivot(), 1.0);
            RC_ASSERT(glm::distance(before, after) < 1e-9);
            RC_ASSERT(std::abs(glm::determinant(orbit.camera().worldFromCamera) - 1.0) < 1e-12);
        }));
    }

    void panMovesThePivotWithThePointer()
    {
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        OrbitCamera orbit;
        orbit.fit(*scene, 1.0);
        const glm::dvec3 pivot = orbit.pivot();
        const glm::dvec3 before = onScreen(orbit.camera(), pivot, 1.0);
        orbit.pan({0.25, -0.1});
        const glm::dvec3 after = onScreen(orbit.camera(), pivot, 1.0);
        // Fractions of the height against ±1: twice as much.
        QVERIFY(std::abs(after.x - before.x - 0.5) < 1e-9);
        QVERIFY(std::abs(after.y - before.y + 0.2) < 1e-9);
    }

    void zoomKeepsThePointUnderThePointer_data()
    {
        QTest::addColumn<bool>("isPerspective");
        QTest::newRow("perspective") << true;
        QTest::newRow("orthographic") << false;
    }

    void zoomKeepsThePointUnderThePointer()
    {
        QFETCH(const bool, isPerspective);
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        OrbitCamera orbit;
        orbit.fit(*scene, 1.0);
        orbit.setProjection(isPerspective ? Projection::Perspective : Projection::Orthographic);
        const glm::dvec2 pointer(0.3, -0.2);
        // The point of the pivot's plane that is under the pointer.
        OrbitCamera moved = orbit;
        moved.pan(-pointer);
        const glm::dvec3 target = moved.pivot();
        const glm::dvec3 before = onScreen(orbit.camera(), target, 1.0);
        QVERIFY(glm::distance(glm::dvec2(before), 2.0 * pointer) < 1e-9);
        orbit.zoom(0.01, pointer);
        const glm::dvec3 after = onScreen(orbit.camera(), target, 1.0);
        QVERIFY(glm::distance(glm::dvec2(after), glm::dvec2(before)) < 1e-6);
    }

    void zoomComesBackFromBothEnds()
    {
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        OrbitCamera orbit;
        orbit.fit(*scene, 1.0);
        const double distance = glm::distance(orbit.camera().position, orbit.pivot());
        for (const double factor : {0.1, 10.0}) {
            for (int notch = 0; notch < 500; ++notch) {
                orbit.zoom(factor, {0.0, 0.0});
            }
            const double ratio = glm::distance(orbit.camera().position, orbit.pivot()) / distance;
            QVERIFY(ratio > 1e-5 && ratio < 1e7);
            orbit.zoom(1.0 / ratio, {0.0, 0.0});
            QVERIFY(std::abs(glm::distance(orbit.camera().position, orbit.pivot()) / distance - 1.0) < 1e-6);
        }
    }

    void projectionsShowThePivotAtTheSameSize()
    {
        const auto scene = test::sceneOf("<$>. \"box.obj\"\n");
        OrbitCamera orbit;
        orbit.fit(*scene, 1.0);
        const glm::dvec3 beside = orbit.pivot() + orbit.camera().worldFromCamera[0] * 0.7;
        const glm::dvec3 perspective = onScreen(orbit.camera(), beside, 1.0);
        orbit.setProjection(Projection::Orthographic);
        const glm::dvec3 orthographic = onScreen(orbit.camera(), beside, 1.0);
        QVERIFY(glm::distance(glm::dvec2(perspective), glm::dvec2(orthographic)) < 1e-9);
        orbit.setProjection(Projection::Perspective);
        QVERIFY(glm::distance(glm::dvec2(onScreen(orbit.camera(), beside, 1.0)), glm::dvec2(perspective)) < 1e-9);
    }
};

ROMANESCO_TEST(TestCamera)

#include "testcamera.moc"
