// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/cut.h"
#include "render/scenecut.h"
#include "scenes.h"
#include "tests/testmain.h"

using namespace romanesco;

namespace {

constexpr int width = 640;
constexpr int height = 480;

std::string sierpinski(const std::string &depth)
{
    return "v 0.5 0.5 0.5\nv 0.5 -0.5 -0.5\nv -0.5 0.5 -0.5\nv -0.5 -0.5 0.5\nhalf 0.5 0.5 0.5\nx. \"box.obj\"\n"
           "t.p. (p, #, half)\nz<x>. [t.1, t.2, t.3, t.4] x\n<$>. z "
        + depth + '\n';
}

std::vector<Instance> wholeCut(Cut &cut, const Projector &projector, double tolerance)
{
    std::vector<Instance> all;
    cut.begin(projector, test::rootAt({}), tolerance);
    while (!cut.isComplete()) {
        const std::vector<Instance> &some = cut.next(1'000);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

/// Of a scene of one item.
const Model &modelOf(const std::shared_ptr<const Scene> &scene)
{
    return *scene->items.at(0).model;
}

std::vector<Instance> wholeCut(const Scene &scene, const Camera &camera, double tolerance)
{
    Cut cut(*scene.items.at(0).model);
    return wholeCut(cut, Projector(camera, test::around(scene), 0.0, width, height), tolerance);
}

/// Instances of a one-set fractal without `#`, by plain nested loops over world maps.
std::vector<AffineMap> flattened(const std::vector<AffineMap> &set, int depth)
{
    std::vector<AffineMap> all{AffineMap{}};
    for (int level = 0; level < depth; ++level) {
        std::vector<AffineMap> next;
        for (const AffineMap &outer : all) {
            for (const AffineMap &inner : set) {
                next.push_back({outer.linear * inner.linear, outer.linear * inner.translation + outer.translation});
            }
        }
        all = std::move(next);
    }
    return all;
}

/// The depth at which a pixel shows a box that a map places, as a ray through the pixel's middle meets it; none where it
/// does not.
std::optional<double> depthAt(const Projector &projector, int x, int y, const AffineMap &map, const Box &box)
{
    const bool isPerspective = projector.projection == Projection::Perspective;
    const double u = ((x + 0.5) / projector.width * 2.0 - 1.0 - projector.jitter.x) / projector.scaleX;
    const double v = ((y + 0.5) / projector.height * 2.0 - 1.0 - projector.jitter.y) / projector.scaleY;
    const glm::dmat3 inwards = glm::inverse(map.linear);
    const glm::dvec3 from = inwards * ((isPerspective ? glm::dvec3(0.0) : glm::dvec3(u, v, 0.0)) - map.translation);
    const glm::dvec3 along = inwards * (isPerspective ? glm::dvec3(u, v, 1.0) : glm::dvec3(0.0, 0.0, 1.0));
    double enter = isPerspective ? projector.near : -projector.range;
    double leave = projector.range * 10.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.least[axis] - from[axis]) / along[axis];
        const double b = (box.greatest[axis] - from[axis]) / along[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave) {
        return std::nullopt;
    }
    const double way = projector.isDeep()
        ? std::copysign(std::log2(1.0 + std::abs(enter)) / std::log2(1.0 + projector.range), enter)
        : enter / projector.range;
    return isPerspective ? projector.near / enter : 0.5 - 0.5 * way;
}

}

class TestCut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void instancesAndMemoryAreTheSameAtDepths20And40()
    {
        struct Use {
            std::uint64_t instances;
            std::uint64_t states;
            std::size_t memory;
            bool operator==(const Use &) const = default;
        };
        const auto use = [](const std::string &depth) {
            const auto scene = test::sceneOf(sierpinski(depth));
            Cut cut(modelOf(scene));
            wholeCut(cut,
                     Projector(fittedCamera(*scene, double(width) / height), test::around(*scene), 0.0, width, height),
                     1.0);
            return Use{cut.instanceCount(), cut.statesVisited(), cut.memoryUse()};
        };
        const Use at20 = use("20");
        QVERIFY(at20.instances > 10'000);
        QVERIFY(at20.memory < 8'000'000);
        QVERIFY(at20 == use("40"));
        QVERIFY(at20 == use("9223372036854775807"));
    }

    void zeroToleranceGivesEveryInstance()
    {
        const auto scene = test::sceneOf(sierpinski("5"));
        const Camera camera = fittedCamera(*scene, double(width) / height);
        QCOMPARE(wholeCut(*scene, camera, 0.0).size(), std::size_t(1024));
    }

    /// Each instance of the plain loops whose place is well inside the view is in the cut, at its place.
    void nothingInViewIsMissingFromNearAndInside()
    {
        std::vector<AffineMap> set;
        for (const glm::dvec3 &p : {glm::dvec3(0.5, 0.5, 0.5), glm::dvec3(0.5, -0.5, -0.5), glm::dvec3(-0.5, 0.5, -0.5),
                                    glm::dvec3(-0.5, -0.5, 0.5)}) {
            set.push_back({glm::dmat3(0.5), p});
        }
        const std::vector<AffineMap> all = flattened(set, 5);
        const auto scene = test::sceneOf(sierpinski("5"));
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        for (int view = 0; view < 50; ++view) {
            Camera camera;
            camera.position = glm::dvec3(unit(random), unit(random), unit(random)) * 1.5;
            camera.worldFromCamera = rotationLooking(glm::dvec3(unit(random), unit(random), unit(random)));
            camera.fieldOfView = 60.0 + 50.0 * unit(random);
            camera.viewHeight = 1.0 + 0.9 * unit(random);
            camera.projection = view % 2 ? Projection::Perspective : Projection::Orthographic;
            const Projector projector(camera, test::around(*scene), 0.0, width, height);
            const std::vector<Instance> cut = wholeCut(*scene, camera, 0.0);
            std::size_t inView = 0;
            for (const AffineMap &map : all) {
                const glm::dvec3 p =
                    glm::transpose(camera.worldFromCamera) * (map.translation - camera.position) / projector.unit;
                const double reach = camera.projection == Projection::Perspective ? p.z : 1.0;
                if (p.z < 1e-3 || std::abs(p.x) * projector.scaleX > reach
                    || std::abs(p.y) * projector.scaleY > reach) {
                    continue;
                }
                ++inView;
                QVERIFY(std::ranges::any_of(cut, [&](const Instance &instance) {
                    return std::abs(double(instance.rows[0][3]) - p.x) < 1e-5
                        && std::abs(double(instance.rows[1][3]) - p.y) < 1e-5
                        && std::abs(double(instance.rows[2][3]) - p.z) < 1e-5;
                }));
            }
            QVERIFY(cut.size() >= inView);
            QVERIFY(cut.size() < all.size());
        }
    }

    void nothingIsDrawnBehindTheCamera()
    {
        const auto scene = test::sceneOf(sierpinski("20"));
        Camera camera;
        camera.position = {0, 0, 10};
        QCOMPARE(wholeCut(*scene, camera, 1.0).size(), std::size_t(0));
    }

    /// The largest piece that the cut leaves whole is smaller on the screen than the tolerance.
    void copiesThatStandForMoreAreSmallerThanTheTolerance_data()
    {
        QTest::addColumn<double>("tolerance");
        for (const double tolerance : {1.0, 4.0, 16.0}) {
            QTest::addRow("%g px", tolerance) << tolerance;
        }
    }

    void copiesThatStandForMoreAreSmallerThanTheTolerance()
    {
        QFETCH(const double, tolerance);
        const auto scene = test::sceneOf(sierpinski("40"));
        const Camera camera = fittedCamera(*scene, double(width) / height);
        const Projector projector(camera, test::around(*scene), 0.0, width, height);
        const std::vector<Instance> cut = wholeCut(*scene, camera, tolerance);
        QVERIFY(!cut.empty());
        for (const Instance &instance : cut) {
            // The unit sphere's radius under the map (all columns are alike here), over its distance, in pixels.
            const double radius = std::hypot(instance.rows[0][0], instance.rows[1][0], instance.rows[2][0]);
            QVERIFY(2.0 * radius * projector.pixels / double(instance.rows[2][3]) < tolerance);
        }
    }

    /// The innermost level throws the mesh far away: what stands for many copies must stand where they are.
    void aFarLastLevelIsDrawnWhereItIs()
    {
        const auto scene =
            test::sceneOf("v 1000 0 0\nv 0.5 0 0\nv -0.5 0 0\nhalf 0.5 0.5 0.5\nsmall 0.001 0.001 0.001\n"
                          "x. \"box.obj\"\nm.p. (p, #, small)\nt.p. (p, #, half)\n"
                          "y. [m.1] x\nz<y>. [t.2, t.3] y\n<$>. z 4\n");
        QVERIFY(scene);
        const Camera camera = fittedCamera(*scene, double(width) / height);
        const Projector projector(camera, test::around(*scene), 0.0, width, height);
        const std::vector<Instance> cut = wholeCut(*scene, camera, 1.0);
        QCOMPARE(cut.size(), std::size_t(16));
        for (const Instance &instance : cut) {
            const glm::dvec3 p(instance.rows[0][3], instance.rows[1][3], instance.rows[2][3]);
            QVERIFY(std::abs(p.x) * projector.scaleX <= p.z && std::abs(p.y) * projector.scaleY <= p.z);
        }
    }

    /// Where much is walked and little found, a call still comes back soon.
    void aCallIsShortHoweverLittleIsFound()
    {
        const auto scene =
            test::sceneOf("v 1 0 0\nv 0 1 0\nx. \"box.obj\"\nk.p. (p, #, #)\nz<x>. [k.1, k.2] x\n<$>. z 60000\n");
        QVERIFY(scene);
        Cut cut(modelOf(scene));
        cut.begin(Projector(fittedCamera(*scene, 1.0), test::around(*scene), 0.0, width, height), test::rootAt({}),
                  1.0);
        for (int call = 0; call < 20; ++call) {
            const std::uint64_t before = cut.statesVisited();
            const std::vector<Instance> &some = cut.next(1'000);
            QVERIFY(some.size() <= 1'001);
            QVERIFY(cut.statesVisited() - before <= 4'000);
        }
        QVERIFY(!cut.isComplete());
    }

    /// A chain of a million levels passes through as many states; what is behind is forgotten.
    void aChainOfAMillionLevelsTakesBoundedMemory()
    {
        const auto scene = test::sceneOf("v 1e-6 0 0\nx. \"box.obj\"\nk.p. (p, #, #)\nz<x>. [k.1] x\n<$>. z 1000000\n");
        QVERIFY(scene);
        Cut cut(modelOf(scene));
        const Projector projector(fittedCamera(*scene, double(width) / height), test::around(*scene), 0.0, width,
                                  height);
        const std::vector<Instance> drawn = wholeCut(cut, projector, 1.0);
        QCOMPARE(drawn.size(), std::size_t(1));
        QVERIFY(cut.memoryUse() < 64'000'000);
        // The end of the chain is at (1, 0, 0).
        const glm::dvec3 end = projector.cameraFrom(AffineMap{})(glm::dvec3(1, 0, 0));
        QVERIFY(std::abs(double(drawn[0].rows[0][3]) - end.x) < 1e-5);
    }

    void hiddenBoxesLieBehindAllThatIsDrawn_data()
    {
        QTest::addColumn<bool>("isPerspective");
        QTest::addColumn<double>("reach");
        QTest::newRow("perspective") << true << 0.0;
        QTest::newRow("orthographic") << false << 0.0;
        QTest::newRow("orthographic, over many sizes") << false << 1e6;
    }

    /// Against rays through the middles of all pixels. What is drawn is a wall that ends somewhere.
    void hiddenBoxesLieBehindAllThatIsDrawn()
    {
        QFETCH(const bool, isPerspective);
        QFETCH(const double, reach);
        std::mt19937 random(9);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const auto anywhere = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
        int hidden = 0;
        int missed = 0;
        for (int round = 0; round < 60; ++round) {
            Camera camera;
            camera.projection = isPerspective ? Projection::Perspective : Projection::Orthographic;
            camera.fieldOfView = 60.0 + 50.0 * unit(random);
            Projector projector(camera, {{0, 0, 1}, 1}, reach, 25 + 3 * (round % 3), 20);
            projector.jitter = anywhere() / 30.0;
            const double wall = 0.4 + 0.2 * unit(random);
            const Box endless{glm::dvec3(-1e3, -1e3, wall), glm::dvec3(1e3)};
            const bool isUpright = random() % 2;
            const int edge = static_cast<int>((isUpright ? projector.width : 20) * (0.5 + 0.3 * unit(random)));
            const bool isBefore = random() % 2;
            std::vector<float> depths;
            for (int i = 0; i < projector.width * projector.height; ++i) {
                const bool isWall = ((isUpright ? i % projector.width : i / projector.width) < edge) == isBefore;
                depths.push_back(isWall ? static_cast<float>(*depthAt(projector, 0, 0, {}, endless)) : 0.0f);
            }
            DepthPyramid drawn;
            drawn.build(depths, projector.width, projector.height);
            for (int i = 0; i < 100; ++i) {
                // by the wall or through it, near the camera too
                const double size = 0.3 * std::pow(unit(random), 2.0);
                const double away = wall + 2.0 * size * unit(random) - (i % 20 == 0 ? wall : 0.0);
                const AffineMap map{size * glm::dmat3(anywhere(), anywhere(), anywhere()),
                                    {0.4 * unit(random), 0.4 * unit(random), away}};
                const Box box{-0.5 + 0.4 * anywhere(), 0.5 + 0.4 * anywhere()};
                const auto footprint = projector.footprint(map, box);
                const bool isHidden = footprint && drawn.isHidden(*footprint);
                bool isInView = false;
                bool isSeen = false;
                for (std::size_t k = 0; k < depths.size(); ++k) {
                    const int at = static_cast<int>(k);
                    const auto depth = depthAt(projector, at % projector.width, at / projector.width, map, box);
                    isInView = isInView || depth;
                    isSeen = isSeen || (depth && *depth > double(depths[k]) * (1.0 + 1e-6));
                }
                QVERIFY(!isHidden || !isSeen);
                hidden += isHidden ? 1 : 0;
                missed += !isHidden && !isSeen && isInView ? 1 : 0;
            }
        }
        QVERIFY2(hidden > 5 * missed, qPrintable(QStringLiteral("%1 hidden, %2 missed").arg(hidden).arg(missed)));
    }

    /// Also where a model is so large that it is forgotten before the next one.
    void noCopyIsLostBetweenItems()
    {
        std::string forest = "v 1 0 0\nsmall 0.001 0.001 0.001\nt.p. (p, #, small)\nx. \"box.obj\"\n";
        std::string set;
        for (int i = 0; i < 120'000; ++i) {
            forest += "v " + std::to_string(i % 400) + ' ' + std::to_string(i / 400) + " 0\n";
            set += (i == 0 ? "t." : ", t.") + std::to_string(i + 3);
        }
        const auto large = test::sceneOf(forest + "<$>. [" + set + "] x\n");
        const auto house = test::sceneOf("x. \"box.obj\"\n<$>. x\n");
        Scene scene = *large;
        scene.items.push_back(house->items[0]);
        scene.items.push_back(large->items[0]);
        const Projector projector(fittedCamera(scene, double(width) / height), test::around(scene), 0.0, width, height);
        const auto shared = std::make_shared<const Scene>(std::move(scene));
        SceneCut cut(*shared);
        for (int picture = 0; picture < 2; ++picture) {
            cut.begin(projector, Anchor(shared).surroundings(), 0.0);
            std::size_t found = 0;
            while (!cut.isComplete()) {
                found += cut.next(100'000).size();
            }
            QCOMPARE(found, std::size_t{240'001});
            QCOMPARE(cut.instanceCount(), std::uint64_t{240'001});
        }
    }
};

ROMANESCO_TEST(TestCut)

#include "testcut.moc"
