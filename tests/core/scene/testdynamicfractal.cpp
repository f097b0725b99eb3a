// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <random>

#include <QTest>

#include "core/scene/dynamicfractal.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// As the dissertation writes it (4.3.2 to 4.3.4), with matrices of its own: rows of four.
namespace written {

using Vector = std::array<double, 3>;
using Matrix4 = std::array<std::array<double, 4>, 4>;

Matrix4 product(const Matrix4 &a, const Matrix4 &b)
{
    Matrix4 result{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            for (std::size_t i = 0; i < 4; ++i) {
                result[row][column] += a[row][i] * b[i][column];
            }
        }
    }
    return result;
}

Vector times(const Matrix4 &m, const Vector &v)
{
    Vector result;
    for (std::size_t row = 0; row < 3; ++row) {
        result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2] + m[row][3];
    }
    return result;
}

Vector positionOf(const Matrix4 &m)
{
    return {m[0][3], m[1][3], m[2][3]};
}

double magnitude(const Vector &a, const Vector &b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A uniform scale, then a move.
Matrix4 moved(const Vector &position, double scale)
{
    return {{{scale, 0, 0, position[0]}, {0, scale, 0, position[1]}, {0, 0, scale, position[2]}, {0, 0, 0, 1}}};
}

const Matrix4 identity = moved({0, 0, 0}, 1);

struct Fractal {
    std::vector<Matrix4> transformations;
    std::vector<Vector> vertices;
    Matrix4 m = identity;

    [[nodiscard]] double radius(const Matrix4 &at) const
    {
        double greatest = 0;
        for (const Vector &v : vertices) {
            greatest = std::max(greatest, magnitude(times(at, v), positionOf(at)));
        }
        return greatest;
    }

    struct Reloaded {
        Matrix4 m;
        int depth = 0;
    };
    [[nodiscard]] Reloaded reload(const Vector &camera, std::size_t trail) const
    {
        Matrix4 at = m;
        std::deque<Matrix4> queue{at};
        int depth = 0;
        while (true) {
            Matrix4 closest = product(at, transformations[0]);
            for (std::size_t i = 1; i < transformations.size(); ++i) {
                const Matrix4 other = product(at, transformations[i]);
                if (magnitude(camera, positionOf(other)) < magnitude(camera, positionOf(closest))) {
                    closest = other;
                }
            }
            if (!(magnitude(camera, positionOf(closest)) < radius(closest))) {
                return {queue.front(), depth};
            }
            at = closest;
            ++depth;
            queue.push_back(at);
            if (queue.size() > trail + 1) {
                queue.pop_front();
            }
        }
    }
};

Fractal menger()
{
    Fractal made;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (std::abs(x) + std::abs(y) + std::abs(z) >= 2) {
                    made.transformations.push_back(moved({double(x), double(y), double(z)}, 1.0 / 3.0));
                }
                if (x != 0 && y != 0 && z != 0) {
                    made.vertices.push_back({1.5 * x, 1.5 * y, 1.5 * z});
                }
            }
        }
    }
    return made;
}

Fractal sierpinski()
{
    return {{moved({-0.5, 0, 0.28868}, 0.5), moved({0.5, 0, 0.28868}, 0.5), moved({0, 0, -0.57735}, 0.5),
             moved({0, 0.8165, 0}, 0.5)},
            {{-1, 0, 0.57736}, {1, 0, 0.57736}, {0, 0, -1.1547}, {0, 1.633, 0}}};
}

const char *const passedOverText = "a 1 0 0\nb 0 1 0\nc 0 0 1\nhalf 0.5 0.5 0.5\nto.p. (p, #, half)\nx. \"m.obj\"\n"
                                   "inner. [to.c, to.a] x\nouter<x>. [#, to.b] inner\n<$>. outer 3\n";

Fractal passedOver()
{
    return {{moved({0, 1, 0}, 0.5), moved({0, 0, 1}, 0.5), moved({1, 0, 0}, 0.5)},
            {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
}

/// Mirrored, sheared, far from the origin.
const Matrix4 somewhere{{{1.5, 0.25, 0, 7}, {0, -1.25, 0.5, -3}, {0.125, 0, 0.75, 11}, {0, 0, 0, 1}}};

/// From touching a copy of any size to some times its size away.
Vector randomCamera(const Fractal &fractal, std::mt19937_64 &random)
{
    Matrix4 at = fractal.m;
    const std::uint64_t levels = random() % 12;
    for (std::uint64_t i = 0; i < levels; ++i) {
        at = product(at, fractal.transformations[random() % fractal.transformations.size()]);
    }
    Vector camera = times(at, fractal.vertices[random() % fractal.vertices.size()]);
    const double away = fractal.radius(at) * std::exp2(uniform(random, -10, 3));
    for (double &number : camera) {
        number += away * uniform(random, -1, 1);
    }
    return camera;
}

}

AffineMap mapOf(const written::Matrix4 &m)
{
    AffineMap map;
    for (int row = 0; row < 3; ++row) {
        const auto &numbers = m[static_cast<std::size_t>(row)];
        for (int column = 0; column < 3; ++column) {
            map.linear[column][row] = numbers[static_cast<std::size_t>(column)];
        }
        map.translation[row] = numbers[3];
    }
    return map;
}

/// The greatest difference, of the matrices as a share of the size, of the places of theirs.
double difference(const AffineMap &found, const AffineMap &expected)
{
    double most = 0;
    const double size =
        std::hypot(glm::length(expected.linear[0]), glm::length(expected.linear[1]), glm::length(expected.linear[2]));
    for (int column = 0; column < 3; ++column) {
        most = std::max(most, glm::length(found.linear[column] - expected.linear[column]) / size);
    }
    return std::max(most,
                    glm::distance(found.translation, expected.translation)
                        / std::max(1.0, glm::length(expected.translation)));
}

std::shared_ptr<const Model> modelOfText(const std::string &text, const Mesh &mesh)
{
    return modelOf(FractalGraph::build(readFdo(text).description.value(), boundingSphere(mesh)).value(), mesh);
}

const Mesh corner{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};

/// A fractal of this transformation alone.
std::shared_ptr<const Model> modelOfOne(const std::string &transformation)
{
    return modelOfText("one 1 1 1\nhalf 0.5 0.5 0.5\ntwice 2 2 2\nquarter 0 90 0\nx. \"m.obj\"\nt. " + transformation
                           + "\nz<x>. [t] x\n<$>. z 3\n",
                       corner);
}

std::shared_ptr<const Scene> sceneWith(std::vector<SceneItem> items)
{
    Scene scene;
    scene.extent = extentOf(items);
    scene.items = std::move(items);
    return std::make_shared<const Scene>(std::move(scene));
}

AffineMap placeIn(const std::shared_ptr<const Scene> &scene, const glm::dvec3 &camera, std::size_t trail)
{
    return dynamicSurroundings(scene, camera, trail)->nodes.at(0).hereFromNode;
}

}

class TestDynamicFractal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fractalsStandWhereTheDissertationSays_data();
    void fractalsStandWhereTheDissertationSays();
    void farAwayTheyStandWhereTheyAre();
    void eachItemMovesByItself();
    void whatHasNoMapsStays();
    void endlessWaysEnd();
    void whatIsNearbyIsAsSmallAsWhatIsNear();
};

void TestDynamicFractal::fractalsStandWhereTheDissertationSays_data()
{
    QTest::addColumn<std::shared_ptr<const Model>>("model");
    QTest::addColumn<written::Fractal>("fractal");
    const auto addRows = [](const char *name, const std::shared_ptr<const Model> &model, written::Fractal fractal) {
        QTest::newRow(name) << model << fractal;
        fractal.m = written::somewhere;
        QTest::addRow("%s, placed", name) << model << fractal;
    };
    addRows("menger", modelOf(QStringLiteral("menger"), 4), written::menger());
    addRows("sierpinski", modelOf(QStringLiteral("sierpinski"), 6), written::sierpinski());
    addRows("levels passed over", modelOfText(written::passedOverText, corner), written::passedOver());
}

void TestDynamicFractal::fractalsStandWhereTheDissertationSays()
{
    QFETCH(const std::shared_ptr<const Model>, model);
    QFETCH(const written::Fractal, fractal);
    const auto scene = sceneWith({{.model = model, .worldFromModel = mapOf(fractal.m)}});
    std::mt19937_64 random(seed(11));
    std::array<int, 3> cameras{};
    for (int i = 0; i < 200; ++i) {
        const written::Vector camera = written::randomCamera(fractal, random);
        const int depth = fractal.reload(camera, 0).depth;
        cameras[depth == 0 ? 0 : depth < 7 ? 1 : 2] += 1;
        for (const std::size_t trail : {0, 1, 2, 5}) {
            const auto seen = dynamicSurroundings(scene, {camera[0], camera[1], camera[2]}, trail);
            QCOMPARE(seen->nodes.size(), 1u);
            const Surroundings::Node &node = seen->nodes.front();
            const double off = difference(node.hereFromNode, mapOf(fractal.reload(camera, trail).m));
            QVERIFY2(
                off <= 1e-12,
                qPrintable(QStringLiteral("camera %1, trail %2, depth %3: %4").arg(i).arg(trail).arg(depth).arg(off)));
            QVERIFY(node.state == Positions{0} && node.steps.empty() && !node.isMeshOnly && node.sharedSteps == 0);
            QVERIFY(seen->path.empty() && seen->origin == glm::dvec3(0.0) && seen->unitExponent == 0.0);
        }
    }
    QVERIFY2(cameras[0] >= 5 && cameras[1] >= 30 && cameras[2] >= 30,
             qPrintable(QStringLiteral("%1, %2, %3").arg(cameras[0]).arg(cameras[1]).arg(cameras[2])));
}

void TestDynamicFractal::farAwayTheyStandWhereTheyAre()
{
    const AffineMap place = mapOf(written::somewhere);
    const auto scene = sceneWith({{.model = modelOf(QStringLiteral("menger"), 4), .worldFromModel = place}});
    for (const std::size_t trail : {0, 3}) {
        QVERIFY(placeIn(scene, {100, 50, -30}, trail) == place);
        QVERIFY(placeIn(scene, {1e300, 0, 0}, trail) == place);
    }
    const auto seen = dynamicSurroundings(scene, {100, 50, -30}, 0);
    const auto world = Anchor(scene).surroundings();
    QVERIFY(seen->nearby.centre == world->nearby.centre && seen->nearby.radius == world->nearby.radius);
    QCOMPARE(seen->reach, world->reach);
}

void TestDynamicFractal::eachItemMovesByItself()
{
    written::Fractal sponge = written::menger();
    sponge.m = written::moved({10, 0, 0}, 2);
    const AffineMap side = mapOf(written::moved({-10, 1, 2}, 1));
    const AffineMap placeOfMesh = mapOf(written::moved({10, 0, 0}, 0.5));
    const auto scene =
        sceneWith({{.model = modelOf(QStringLiteral("sierpinski"), 6), .worldFromModel = side},
                   {.model = modelOf(corner), .worldFromModel = placeOfMesh, .kind = SceneDescription::Kind::Object},
                   {.model = modelOf(Mesh{}), .worldFromModel = side, .kind = SceneDescription::Kind::Object},
                   {.model = modelOf(QStringLiteral("menger"), 4), .worldFromModel = mapOf(sponge.m)}});
    const written::Vector camera{12.9001, 2.9001, -2.9002};
    const auto seen = dynamicSurroundings(scene, {camera[0], camera[1], camera[2]}, 1);
    QCOMPARE(seen->nodes.size(), 3u);
    QVERIFY(seen->nodes[0].item == 0 && seen->nodes[0].hereFromNode == side);
    QVERIFY(seen->nodes[1].item == 1 && seen->nodes[1].hereFromNode == placeOfMesh);
    QVERIFY(seen->nodes[2].item == 3);
    const written::Fractal::Reloaded expected = sponge.reload(camera, 1);
    QVERIFY(expected.depth >= 3);
    QVERIFY(difference(seen->nodes[2].hereFromNode, mapOf(expected.m)) <= 1e-12);
}

void TestDynamicFractal::whatHasNoMapsStays()
{
    const AffineMap place = mapOf(written::somewhere);
    for (const auto &model : {modelOf(corner), modelOfText("x. \"m.obj\"\n<$>. x\n", corner)}) {
        const auto scene = sceneWith({{.model = model, .worldFromModel = place}});
        const auto seen = dynamicSurroundings(scene, place.translation, 2);
        QCOMPARE(seen->nodes.size(), 1u);
        QVERIFY(seen->nodes.front().hereFromNode == place);
        QCOMPARE(seen->reach, Anchor(scene).surroundings()->reach);
    }
    QVERIFY(dynamicSurroundings(sceneWith({}), {1, 2, 3}, 2)->nodes.empty());
}

void TestDynamicFractal::endlessWaysEnd()
{
    // doubles end before the camera is reached; at the origin nothing is too small for them
    const auto shrinking = sceneWith({{.model = modelOfOne("(half, #, half)")}});
    const AffineMap least = placeIn(shrinking, {1, 1, 1}, 0);
    QVERIFY(least.linear[0].x > 1e-15 && least.linear[0].x < 4e-15);
    QVERIFY(placeIn(shrinking, {1, 1, 1}, 3).linear[0].x == 8.0 * least.linear[0].x);
    const AffineMap inPlace = placeIn(sceneWith({{.model = modelOfOne("(#, #, half)")}}), {0, 0, 0}, 0);
    QVERIFY(inPlace.linear[0].x > 1e-163 && inPlace.linear[0].x < 1e-160);

    const AffineMap largest = placeIn(sceneWith({{.model = modelOfOne("(#, #, twice)")}}), {1, 0, 0}, 0);
    QVERIFY(largest.linear[0].x > 1e145 && largest.linear[0].x < 1e155);

    // a quarter of a turn each: one short of 2000 of them is three of four
    const auto turning = sceneWith({{.model = modelOfOne("(#, quarter, one)")}});
    QVERIFY(placeIn(turning, {1, 0, 0}, 0) == AffineMap());
    QVERIFY(placeIn(turning, {1, 0, 0}, 1) == mapFromParts({0, 0, 0}, {0, 270, 0}, {1, 1, 1}));
    QVERIFY(placeIn(turning, {1, 0, 0}, 1999) == mapFromParts({0, 0, 0}, {0, 90, 0}, {1, 1, 1}));
    QVERIFY(placeIn(turning, {1, 0, 0}, 5000) == AffineMap());
}

void TestDynamicFractal::whatIsNearbyIsAsSmallAsWhatIsNear()
{
    const written::Fractal sponge = written::menger();
    const auto model = modelOf(QStringLiteral("menger"), 4);
    const auto scene = sceneWith(
        {{.model = model},
         {.model = modelOf(QStringLiteral("sierpinski"), 6), .worldFromModel = mapOf(written::moved({0, 0, -40}, 3))}});
    const glm::dvec3 camera(1e-6, 1.5 - 1e-6, -1.5 - 1e-6);
    const AffineMap last = placeIn(scene, camera, 0);
    for (const std::size_t trail : {0, 4}) {
        const auto seen = dynamicSurroundings(scene, camera, trail);
        const Sphere &nearby = seen->nearby;
        QVERIFY(nearby.radius < 5e-6 && nearby.radius < 4.0 * last.linear[0].x);
        QVERIFY(glm::distance(nearby.centre, camera) < 2.0 * nearby.radius);
        for (const auto &v : sponge.vertices) {
            const double away = glm::distance(last({v[0], v[1], v[2]}), nearby.centre);
            QVERIFY(away <= nearby.radius);
            const double farthest = glm::distance(seen->nodes[0].hereFromNode({v[0], v[1], v[2]}), nearby.centre);
            QVERIFY(farthest <= seen->reach);
        }
        QVERIFY(seen->reach > 40 && seen->reach < 60);
    }
    // From far behind nothing smaller is drawn than after the four levels that there are.
    const Sphere behind = dynamicSurroundings(scene, camera, 100)->nearby;
    const double smallest = 1.5 * std::sqrt(3.0) / 81.0;
    QVERIFY(behind.radius > 0.999 * smallest && behind.radius < 1.2 * smallest);
    QVERIFY(glm::distance(behind.centre, camera) < behind.radius);
    // at the origin doubles never end
    const auto shrinking = sceneWith({{.model = modelOfOne("(#, #, half)")}});
    const auto seen = dynamicSurroundings(shrinking, {0, 0, 0}, 0);
    QVERIFY(seen->nodes[0].hereFromNode.linear[0].x < 1e-160);
    QVERIFY(seen->nearby.radius >= 1e-15 * Anchor(shrinking).bound().radius);
}

}

ROMANESCO_TEST(romanesco::test::TestDynamicFractal)
#include "testdynamicfractal.moc"
