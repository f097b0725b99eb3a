// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Until it sleeps; nothing where it does not within so many steps.
std::optional<int> stepsToRest(BallState &ball, Ground &ground, const Laws &laws, int most)
{
    for (int step = 0; step < most; ++step) {
        if (ball.isAsleep) {
            return step;
        }
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    return std::nullopt;
}

}

class TestResting : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whereItComesToRestItStays_data();
    void whereItComesToRestItStays();
    void aBallThatIsPutDownRestsAtOnce();
    void restIsRestWhenItIsWoken();
    void onALevelFloorItGoesOnForEver();
};

void TestResting::whereItComesToRestItStays_data()
{
    QTest::addColumn<Mesh>("mesh");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("restitution");
    for (const double radius : {0.2, 0.01}) {
        for (const double e : {0.0, 0.5, 0.9}) {
            const auto name = [&](const char *what) {
                return QStringLiteral("%1, r = %2, e = %3").arg(QLatin1String(what)).arg(radius).arg(e).toUtf8();
            };
            QTest::newRow(name("floor").constData()) << floorMesh(1) << radius << e;
            QTest::newRow(name("groove").constData()) << grooveMesh(10, 1) << radius << e;
            QTest::newRow(name("flat groove").constData()) << grooveMesh(20, 0.2) << radius << e;
            QTest::newRow(name("steep groove").constData()) << grooveMesh(1, 5) << radius << e;
        }
    }
}

void TestResting::whereItComesToRestItStays()
{
    QFETCH(const Mesh, mesh);
    QFETCH(const double, radius);
    QFETCH(const double, restitution);
    Ground ground(mesh);
    const Laws laws;
    BallState ball = ballAt({mesh.faces.size() == 2 ? 0.01 : 0.02, 1.5, 0.03}, radius, restitution);
    const auto steps = stepsToRest(ball, ground, laws, 20'000);
    QVERIFY2(steps, qPrintable(QString::number(glm::length(ball.velocity))));
    QVERIFY(ball.velocity == glm::dvec3(0));
    QVERIFY(std::abs(ground.distance(ball.position) - radius) <= 1e-4 * radius);
    const BallState rested = ball;
    for (int step = 0; step < 1'000'000; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    QVERIFY(ball.position == rested.position && ball.isAsleep);
}

/// On a floor, in a corner of three walls that stands on its tip, and between two copies that touch.
void TestResting::aBallThatIsPutDownRestsAtOnce()
{
    const Laws laws;
    const double radius = 0.1;
    const double off = radius * (1 + 5e-5);
    {
        Ground ground(floorMesh(1));
        BallState ball = ballAt({0.3, off, 0.4}, radius, 1);
        QVERIFY(stepsToRest(ball, ground, laws, 2));
        QVERIFY(ball.position == glm::dvec3(0.3, off, 0.4));
    }
    {
        const AffineMap tip = mapFromParts({}, {0, 0, 45}, {1, 1, 1});
        const AffineMap corner = AffineMap{mapFromParts({}, {35.264389682754654, 0, 0}, {1, 1, 1})} * tip;
        Ground ground(boxMesh(1), corner);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 inside((i & 1) != 0 ? 1 - off : off - 1, (i & 2) != 0 ? 1 - off : off - 1,
                                    (i & 4) != 0 ? 1 - off : off - 1);
            BallState ball = ballAt(corner(inside), radius, 0.5);
            if (corner(inside).y < -1) {
                QVERIFY(stepsToRest(ball, ground, laws, 20));
                QVERIFY(glm::distance(ball.position, corner(inside)) < 2e-4 * radius);
            }
        }
    }
    {
        const auto model = modelOf(boxMesh(1));
        Ground ground({{.model = model, .worldFromModel = mapFromParts({-1.5, 0, 0}, {0, 0, 45}, {1, 1, 1})},
                       {.model = model, .worldFromModel = mapFromParts({1.5, 0, 0}, {0, 0, 45}, {1, 1, 1})}});
        BallState ball = ballAt({0.0, 2, 0.1}, 0.4, 0.5);
        QVERIFY(stepsToRest(ball, ground, laws, 5000));
        QVERIFY(std::abs(ball.position.x) < 1e-3 && ball.supports.count() == 2);
    }
}

/// What wakes it again and again moves it nowhere; and where what it lies on has to be found anew, not out of the skin.
void TestResting::restIsRestWhenItIsWoken()
{
    for (const Mesh &mesh : {floorMesh(1), grooveMesh(1, 1), grooveMesh(1, 5)}) {
        Ground ground(mesh);
        const Laws laws;
        BallState ball = ballAt({0.02, 1.5, 0.03}, 0.1, 0.4);
        QVERIFY(stepsToRest(ball, ground, laws, 20'000));
        const glm::dvec3 rested = ball.position;
        for (int step = 0; step < 10'000; ++step) {
            ball.isAsleep = false;
            stepBall(ball, laws, ground.probe, laws.timeStep);
        }
        QVERIFY(ball.position == rested && ball.isAsleep);
        for (int step = 0; step < 10'000; ++step) {
            ball.isAsleep = false;
            ball.clearance = 0;
            ball.supports.clear();
            stepBall(ball, laws, ground.probe, laws.timeStep);
        }
        QVERIFY2(glm::distance(ball.position, rested) < 1e-3 * ball.radius,
                 qPrintable(QString::number(glm::distance(ball.position, rested))));
        QVERIFY(ball.isAsleep);
    }
}

/// There is no friction: it does not sleep.
void TestResting::onALevelFloorItGoesOnForEver()
{
    Ground ground(floorMesh(100));
    const Laws laws;
    BallState ball = ballAt({0, 0.2, 0}, 0.1, 0.5, {0.01, 0, 0});
    for (int step = 0; step < 24'000; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    QVERIFY(!ball.isAsleep);
    QVERIFY2(std::abs(ball.position.x - 1) < 1e-9, qPrintable(QString::number(ball.position.x)));
}

}

ROMANESCO_TEST(romanesco::test::TestResting)

#include "testresting.moc"
