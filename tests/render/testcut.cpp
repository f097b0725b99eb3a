// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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
