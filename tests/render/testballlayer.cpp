// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <array>
#include <cmath>

#include <QTest>

#include "drawing.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

const std::string box = "x. \"box.obj\"\n<$>. x\n";
constexpr std::array<float, 3> red{1.0f, 0.1f, 0.1f};
constexpr std::array<float, 3> green{0.1f, 1.0f, 0.1f};

bool isRed(const Pixel &p)
{
    return p[0] > 2 * p[1] && p[0] > 2 * p[2];
}

bool isGreen(const Pixel &p)
{
    return p[1] > 2 * p[0] && p[1] > 2 * p[2];
}

/// From a distance of 10 on the z axis, the way it points.
Camera front(Projection projection)
{
    Camera camera;
    camera.position = {0.0, 0.0, -10.0};
    camera.projection = projection;
    camera.fieldOfView = 60.0;
    camera.viewHeight = 8.0;
    return camera;
}

}

/// Balls that are drawn over a finished picture.
class TestBallLayer : public DrawingTest
{
    Q_OBJECT

    Picture drawWith(const std::shared_ptr<const Scene> &scene, View view, const std::vector<BallSprite> &balls)
    {
        view.leavesOutBalls = true;
        static_cast<void>(draw(scene, view));
        return m_renderer->read(balls);
    }

private Q_SLOTS:
    /// The outline of a sphere, wherever it is seen: an ellipse in perspective.
    void aBallCoversWhatItsSphereDoes_data()
    {
        QTest::addColumn<Projection>("projection");
        QTest::addColumn<glm::dvec3>("centre");
        QTest::addColumn<double>("radius");
        QTest::newRow("in the middle") << Projection::Perspective << glm::dvec3(0.0) << 1.0;
        QTest::newRow("in a corner") << Projection::Perspective << glm::dvec3(5.0, 3.5, 0.0) << 1.2;
        QTest::newRow("near") << Projection::Perspective << glm::dvec3(1.0, 0.5, -8.0) << 1.0;
        QTest::newRow("far") << Projection::Perspective << glm::dvec3(300.0, 100.0, 1000.0) << 60.0;
        QTest::newRow("half beside") << Projection::Perspective << glm::dvec3(0.0, 5.8, 0.0) << 1.0;
        QTest::newRow("orthographic") << Projection::Orthographic << glm::dvec3(2.0, -1.0, 3.0) << 1.5;
    }

    void aBallCoversWhatItsSphereDoes()
    {
        QFETCH(const Projection, projection);
        QFETCH(const glm::dvec3, centre);
        QFETCH(const double, radius);
        // something that is far out of the view
        const auto scene = assembled({{modelOf(box), {glm::dmat3(1.0), glm::dvec3(0.0, -40.0, -12.0)}}});
        View view = plainView(front(projection));
        view.appearance.isLit = false;
        const Picture picture = drawWith(scene, view, {{centre, radius, red}});
        const Camera &camera = view.camera;
        const double tangent = std::tan(0.5 * camera.fieldOfView * std::acos(-1.0) / 180.0);
        int covered = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double u = (2.0 * x + 1.0 - width) / height;
                const double v = (height - 2.0 * y - 1.0) / height;
                const bool isPerspective = projection == Projection::Perspective;
                const glm::dvec3 from = isPerspective ? camera.position : camera.position + 4.0 * glm::dvec3(u, v, 0.0);
                const glm::dvec3 ray = isPerspective ? glm::normalize(glm::dvec3(u * tangent, v * tangent, 1.0))
                                                     : glm::dvec3(0.0, 0.0, 1.0);
                const double away = glm::length(glm::cross(centre - from, ray));
                const double size = (isPerspective ? glm::length(centre - from) * tangent : 4.0) * 2.0 / height;
                if (std::abs(away - radius) > 1.5 * size) {
                    QCOMPARE(isRed(romanesco::test::pixel(picture, x, y)), away < radius);
                    covered += away < radius;
                }
            }
        }
        QVERIFY(covered > 100);
    }

    void whatIsBeforeABallHidesIt()
    {
        const auto scene = sceneOf(box);
        for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
            const View view = plainView(front(projection));
            const auto redShare = [&](const glm::dvec3 &centre) {
                const Picture picture = drawWith(scene, view, {{centre, 0.3, red}});
                return share(picture, [&](std::size_t i) { return isRed(pixel(picture, i)); });
            };
            const double whole = redShare({0.0, 0.0, -3.0});
            QVERIFY(whole > 1e-3);
            QCOMPARE(redShare({0.0, 0.0, 3.0}), 0.0);
            // half out of the face that is at z = -1
            const double half = redShare({0.0, 0.0, -1.0});
            QVERIFY(half > 0.0 && half <= whole);
        }
    }

    /// However they are listed; the small one is nearer, but its centre is not.
    void ballsHideOneAnother()
    {
        const auto scene = assembled({{modelOf(box), {glm::dmat3(1.0), glm::dvec3(0.0, -40.0, -12.0)}}});
        const View view = plainView(front(Projection::Perspective));
        const BallSprite large{{0.0, 0.0, 2.0}, 2.0, red};
        const BallSprite small{{0.0, 0.0, -0.3}, 0.2, green};
        for (const auto &balls : {std::vector{large, small}, std::vector{small, large}}) {
            const Picture picture = drawWith(scene, view, balls);
            QVERIFY(isGreen(pixel(picture, width / 2, height / 2)));
            QVERIFY(isRed(pixel(picture, width / 2 + 15, height / 2)));
        }
    }

    /// The large one's middle is farther away, but its rim is nearer.
    void aRimHidesWhatIsBehind()
    {
        const auto scene = assembled({{modelOf(box), {glm::dmat3(1.0), glm::dvec3(0.0, -40.0, -12.0)}}});
        const BallSprite large{{0.0, 0.0, 0.0}, 5.0, red};
        const BallSprite small{{5.246, 0.0, -1.604}, 0.48, green};
        for (const auto &balls : {std::vector{large, small}, std::vector{small, large}}) {
            const Picture picture = drawWith(scene, plainView(front(Projection::Perspective)), balls);
            QVERIFY(isRed(pixel(picture, 277, height / 2)));
            QVERIFY(isGreen(pixel(picture, 290, height / 2)));
        }
    }

    /// Those of the scene are left out, and come back.
    void theScenesOwnBallsGiveWay()
    {
        auto scene = std::make_shared<Scene>(*assembled({{modelOf(box), AffineMap{}}}));
        scene->items[0].kind = SceneDescription::Kind::Ball;
        View view = plainView(front(Projection::Perspective));
        QVERIFY(shareOfBackground(draw(scene, view)) < 0.99);
        QCOMPARE(shareOfBackground(drawWith(scene, view, {})), 1.0);
        QVERIFY(shareOfBackground(draw(scene, view)) < 0.99);
    }
};

ROMANESCO_TEST(TestBallLayer)

#include "testballlayer.moc"
