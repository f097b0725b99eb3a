// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/raywalk.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/collide/allocations.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/rays.h"
#include "tests/core/collide/raytruth.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct WrittenFace {
    std::size_t root;
    naive::Picks picks;
    std::uint32_t face;
    std::array<truth::Vector<Wide>, 3> corners;
};

/// A fractal as it stands at several places, written out.
struct Placed {
    Placed(const RandomFractal &sample, const std::vector<RayRoot> &roots)
    {
        naive::Fractal fractal = sample.fractal;
        const std::set<naive::Picks> words = naive::allPicks(fractal.levels());
        for (std::size_t root = 0; root < roots.size(); ++root) {
            const int map = static_cast<int>(fractal.maps.size());
            fractal.maps.push_back(roots[root].rayFromState);
            for (const naive::Picks &picks : words) {
                naive::Picks whole = picks;
                whole.insert(whole.begin(), map);
                for (std::uint32_t face = 0; face < sample.mesh.faces.size(); ++face) {
                    WrittenFace &written = faces.emplace_back(WrittenFace{root, picks, face, {}});
                    for (std::size_t i = 0; i < 3; ++i) {
                        written.corners[i] =
                            placed(whole, fractal.maps, sample.mesh.vertices[sample.mesh.faces[face][i]]);
                    }
                }
            }
        }
    }

    [[nodiscard]] const WrittenFace *find(std::size_t root, const naive::Picks &picks, std::uint32_t face) const
    {
        const auto found = std::ranges::find_if(faces, [&](const WrittenFace &written) {
            return written.root == root && written.face == face && written.picks == picks;
        });
        return found == faces.end() ? nullptr : &*found;
    }

    std::vector<WrittenFace> faces;
};

glm::dvec3 narrowed(const truth::Vector<Wide> &v)
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// No copy is farther from the origin.
double sizeOf(const RandomFractal &sample, const std::vector<RayRoot> &roots)
{
    const Sphere &bound = sample.graph.bound(0);
    double size = 0.0;
    for (const RayRoot &root : roots) {
        const AffineMap &map = root.rayFromState;
        const double reach = operatorNorm(map.linear) * (bound.radius + glm::length(bound.centre));
        size = std::max(size, reach + glm::length(map.translation));
    }
    return size;
}

/// From anywhere, to somewhere on a face or past it all.
Ray randomRay(std::mt19937_64 &random, const Placed &written, double size)
{
    const auto &corners = written.faces[random() % written.faces.size()].corners;
    const double s = uniform(random, 0, 1);
    const double t = uniform(random, 0, 1 - s);
    const glm::dvec3 target = (1 - s - t) * narrowed(corners[0]) + s * narrowed(corners[1]) + t * narrowed(corners[2]);
    Ray ray;
    ray.origin = random() % 4 == 0 ? target + randomPoint(random, 0.01 * size) : randomPoint(random, 2 * size);
    ray.direction = random() % 5 == 0 ? randomPoint(random, 1.0) : target - ray.origin;
    if (random() % 8 == 0) {
        ray.direction[static_cast<int>(random() % 3)] = 0.0; // beside an axis, or along one
    }
    const double length = std::pow(10.0, uniform(random, -12, 12));
    ray.direction *= length / glm::length(ray.direction);
    if (random() % 4 == 0) {
        ray.least = uniform(random, -size, size) / length;
        ray.greatest = ray.least + uniform(random, 0, size) / length;
    }
    return ray;
}

}

class TestRayWalk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itMeetsTheFirstOfAllFaces_data();
    void itMeetsTheFirstOfAllFaces();
    void aSpentBudgetIsAdmitted();
    void stoppingIsHeard();
    void facesWithoutAnInsideGiveNoNumbersThatAreNone();
    void raysTakeNoMemoryOnceItHasGrown();
};

void TestRayWalk::itMeetsTheFirstOfAllFaces_data()
{
    QTest::addColumn<double>("largest");
    QTest::addColumn<double>("placed");
    QTest::newRow("contracting") << 0.6 << 0.0;
    QTest::newRow("growing") << 1.5 << 0.0;
    QTest::newRow("contracting, at places") << 0.6 << 1.0;
    QTest::newRow("growing, at places") << 1.5 << 1.0;
    QTest::newRow("at places of 1e6") << 0.7 << 1e6;
}

/// Against every face of every copy: what is found is on the ray and on its face, and no other face is surely met before.
void TestRayWalk::itMeetsTheFirstOfAllFaces()
{
    QFETCH(const double, largest);
    QFETCH(const double, placed);
    std::mt19937_64 random(seed(301));
    int metCount = 0;
    int surelyMetCount = 0;
    int standInCount = 0;
    int missedCount = 0;
    for (int round = 0; round < 120; ++round) {
        const RandomFractal sample = randomFractalWithMesh(random, largest);
        std::vector<RayRoot> roots(placed == 0.0 ? 1 : random() % 3 + 1);
        for (RayRoot &root : roots) {
            if (placed > 0.0) {
                root.rayFromState = randomMap(random, placed);
                root.rayFromState.translation *= placed;
            }
        }
        const Placed written(sample, roots);
        Walker walker(sample.graph, sample.mesh);
        const double size = sizeOf(sample, roots);
        for (int i = 0; i < 10; ++i) {
            const Ray ray = randomRay(random, written, size);
            const RayHit hit = walker.cast(ray, roots);
            const double length = glm::length(ray.direction);
            const double rounding = 1e-13 * (size + glm::length(ray.origin));
            const auto words = [&](const char *what, double number) {
                return qPrintable(QStringLiteral("%1: round %2, %3: %4, t %5")
                                      .arg(QLatin1String(what))
                                      .arg(round)
                                      .arg(i)
                                      .arg(number, 0, 'g', 17)
                                      .arg(hit.t, 0, 'g', 17));
            };
            QVERIFY(hit.promise == Promise::Exact);
            if (hit.isFound()) {
                ++metCount;
                QVERIFY(hit.t >= ray.least && hit.t <= ray.greatest);
                if (hit.isStandIn) { // for copies that are points, or lines: maps have made them flat twice
                    ++standInCount;
                    continue;
                }
                const WrittenFace *face = written.find(hit.root, picksOf(hit.address, sample.fractal), hit.face);
                QVERIFY(face);
                const auto met = truth::meeting<Wide>(face->corners, wide(ray.origin), wide(ray.direction));
                const auto off = static_cast<double>(truth::distance<Wide>(face->corners, wide(hit.point)));
                // a needle is met somewhere along it
                const double thinness = met ? static_cast<double>(met->thinness) : infinity;
                QVERIFY2(off <= rounding * (1 + 0.1 * thinness), words("off the face", off / rounding));
                surelyMetCount += thinness < 100 ? 1 : 0;
                const double offRay = glm::distance(hit.point, ray.origin + hit.t * ray.direction);
                QVERIFY2(offRay <= rounding, words("off the ray", offRay));
                QVERIFY(std::abs(glm::length(hit.direction) - 1) < 1e-14);
                QVERIFY(glm::dot(hit.direction, ray.direction) <= 1e-12 * length);
                QCOMPARE(hit.choices.size(), hit.address.size());
            } else {
                ++missedCount;
            }
            for (const WrittenFace &face : written.faces) {
                const auto met = truth::meeting<Wide>(face.corners, wide(ray.origin), wide(ray.direction));
                if (met && met->inside > rounding) {
                    const auto t = static_cast<double>(met->t);
                    const double slack =
                        rounding * (1 / static_cast<double>(met->cosine) + static_cast<double>(met->thinness)) / length;
                    const bool isWithin = t >= ray.least + slack && t <= ray.greatest - slack;
                    QVERIFY2(!isWithin || hit.t <= t + slack, words("before", t));
                }
            }
        }
    }
    QVERIFY2(surelyMetCount > 300 && missedCount > 200 && standInCount < 10,
             qPrintable(QStringLiteral("%1 of %2, %3").arg(surelyMetCount).arg(metCount).arg(missedCount)));
}

void TestRayWalk::aSpentBudgetIsAdmitted()
{
    const Sample fractal = sample(QStringLiteral("tree"), 8);
    Walker walker(fractal.graph, fractal.mesh);
    const View view(fractal.graph.bound(0));
    std::mt19937_64 random(seed(307));
    int cutCount = 0;
    for (int i = 0; i < 200; ++i) {
        Ray ray = view.ray(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
        const RayHit truth = walker.cast(ray);
        QVERIFY(truth.promise == Promise::Exact && truth.lower == truth.t);
        for (const std::uint64_t budget : {0u, 1u, 2u, 10u, 50u, 1'000u, 100'000u}) {
            ray.nodeBudget = budget;
            const RayHit hit = walker.cast(ray);
            QVERIFY(hit.cost.nodeVisits <= budget);
            QVERIFY(hit.t >= truth.t && hit.lower <= truth.t);
            if (budget >= truth.cost.nodeVisits) {
                QVERIFY(hit.promise == Promise::Exact && hit.t == truth.t);
            } else {
                QVERIFY(hit.promise == Promise::UpperBound);
                ++cutCount;
            }
        }
    }
    QVERIFY(cutCount > 200);
}

void TestRayWalk::stoppingIsHeard()
{
    const Sample fractal = sample(QStringLiteral("menger"), 40);
    Walker walker(fractal.graph, fractal.mesh);
    Ray ray = View(fractal.graph.bound(0)).ray(0.01, 0.02);
    QVERIFY(walker.cast(ray).isFound());
    std::stop_source stop;
    stop.request_stop();
    ray.stop = stop.get_token();
    const RayHit hit = walker.cast(ray);
    QVERIFY(!hit.isFound() && hit.promise == Promise::UpperBound && hit.cost.nodeVisits == 0);
    QVERIFY(hit.address.empty() && hit.choices.empty());
}

/// Corners thrice, faces that are lines, copies that are a point, rays along faces and from corners.
void TestRayWalk::facesWithoutAnInsideGiveNoNumbersThatAreNone()
{
    std::mt19937_64 random(seed(308));
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.faces = {{0, 0, 0}, {0, 1, 1}, {0, 1, 2}, {0, 1, 3}, {0, 3, 4}};
    for (const glm::dvec3 &scale : {glm::dvec3(0.5), glm::dvec3(0.5, 0.5, 0), glm::dvec3(0.5, 0, 0), glm::dvec3(0)}) {
        naive::Fractal fractal;
        fractal.maps = {mapFromParts({1, 0, 0}, {0, 0, 0}, scale), mapFromParts({0, 1, 0}, {0, 90, 0}, scale)};
        fractal.sets = {{{0, 1}, true}};
        fractal.items = {{6, 0, {{0, 0, {}}}}};
        const FractalGraph graph = graphOf(fractal, mesh);
        Walker walker(graph, mesh);
        int metCount = 0;
        for (int i = 0; i < 2'000; ++i) {
            const auto whole = [&] { return glm::dvec3(glm::ivec3(randomPoint(random, 3.0))); };
            Ray ray{.origin = whole(), .direction = whole()};
            ray.direction.x += ray.direction == glm::dvec3(0) ? 1.0 : 0.0;
            const RayHit hit = walker.cast(ray);
            QVERIFY(!std::isnan(hit.t) && !std::isnan(hit.lower) && hit.t >= 0.0);
            QVERIFY(std::isfinite(glm::dot(hit.point, hit.direction)));
            QVERIFY(!hit.isFound() || std::abs(glm::length(hit.direction) - 1.0) < 1e-12);
            metCount += hit.isFound() ? 1 : 0;
        }
        QVERIFY(metCount > 20);
    }
    Mesh none;
    none.vertices = {{1, 2, 3}};
    for (const auto &faces : {std::vector<Mesh::Face>{}, std::vector<Mesh::Face>{{0, 0, 0}}}) {
        none.faces = faces;
        const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(none));
        const RayHit hit = Walker(graph, none).cast({.direction = {1, 2, 3}});
        QVERIFY(!hit.isFound() && hit.promise == Promise::Exact);
    }
}

void TestRayWalk::raysTakeNoMemoryOnceItHasGrown()
{
    for (const char *name : {"tree", "menger", "romanesco"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 2);
        Walker walker(fractal.graph, fractal.mesh);
        const View view(fractal.graph.bound(0));
        RayHit hit;
        const auto castAll = [&] {
            for (int i = 0; i < 400; ++i) {
                walker.walk.cast(view.ray(0.03 * (i % 20) - 0.3, 0.03 * (i / 20) - 0.3), asItIs, hit);
            }
        };
        castAll();
        const std::size_t before = allocationCount();
        castAll();
        QCOMPARE(allocationCount(), before);
    }
}

ROMANESCO_TEST(TestRayWalk)

}

#include "testraywalk.moc"
