// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include <QTest>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/collide/raywalk.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/rays.h"
#include "tests/core/collide/raytruth.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// All copies of an example, in long doubles.
struct WrittenExample {
    explicit WrittenExample(const Sample &sample)
    {
        naive::Fractal fractal;
        std::vector<naive::Affine> maps;
        naive::Levels levels;
        const LevelSequence &sequence = sample.description.levels;
        for (Position position = 0; position < sequence.levelCount(); ++position) {
            naive::Level &level = levels.emplace_back();
            const TransformSet &set = sample.description.sets[sequence.set(sequence.locate(position).slot)];
            level.mayPass = set.holdsIdentity;
            for (const AffineMap &map : set.maps) {
                const naive::Affine own = naive::fromCore(map);
                const auto known = std::ranges::find(maps, own);
                level.maps.push_back(static_cast<int>(known - maps.begin()));
                if (known == maps.end()) {
                    maps.push_back(own);
                }
            }
        }
        for (const naive::Picks &picks : naive::allPicks(levels)) {
            naive::Affine map;
            for (const int pick : picks) {
                map = naive::product(map, maps[static_cast<std::size_t>(pick)]);
            }
            for (std::uint32_t face = 0; face < sample.mesh.faces.size(); ++face) {
                std::array<naive::Point, 3> corners;
                for (std::size_t i = 0; i < 3; ++i) {
                    const glm::dvec3 &v = sample.mesh.vertices[sample.mesh.faces[face][i]];
                    corners[i] = naive::applied(map, {v.x, v.y, v.z});
                }
                long double square = 0;
                for (const naive::Point &corner : corners) {
                    const auto side = truth::difference(corner, corners[0]);
                    square = std::max(square, truth::dot(side, side));
                }
                faces.push_back({corners, face, map, square});
            }
        }
    }

    struct Face {
        std::array<naive::Point, 3> corners;
        std::uint32_t face;
        naive::Affine map;
        /// Of the distance from the first corner to the farthest.
        long double square;
    };
    std::vector<Face> faces;

    struct First {
        const Face *face = nullptr;
        long double t = infinity;
    };
    [[nodiscard]] First first(const Ray &ray) const
    {
        const naive::Point origin{ray.origin.x, ray.origin.y, ray.origin.z};
        const naive::Point direction{ray.direction.x, ray.direction.y, ray.direction.z};
        First found;
        for (const Face &face : faces) {
            const auto across = truth::cross(truth::difference(face.corners[0], origin), direction);
            if (truth::dot(across, across) > face.square * truth::dot(direction, direction)) {
                continue; // the ray passes farther off
            }
            const auto met = truth::meeting<long double>(face.corners, origin, direction);
            if (met && met->inside >= 0 && met->t >= 0 && met->t < found.t) {
                found = {&face, met->t};
            }
        }
        return found;
    }
};

/// What is drawn at a tolerance, found without looking where the ray goes.
struct NaiveCut {
    const FractalGraph &graph;
    const Ray &ray;
    StateTable table{graph};
    struct Copy {
        naive::Affine map;
        bool isStandIn;
    };
    std::vector<Copy> copies = {};

    void walk(StateId state, const AffineMap &map, double norm)
    {
        const Sphere bound = table.state(state).bound;
        const double way = std::max(
            0.0, glm::dot(map(bound.centre) - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction));
        if (norm * bound.radius < ray.width + way * ray.spread) {
            add(map, bound);
            return;
        }
        const Expansion expansion = table.expansion(state);
        if (expansion.hasLeaf) {
            copies.push_back({naive::fromCore(map), false});
        }
        for (const ChildRange &range : expansion.ranges) {
            for (std::uint32_t i = range.firstMap; i < range.endMap; ++i) {
                walk(range.next, map * graph.set(range.set).maps[i], norm * graph.facts(range.set)[i].norm);
            }
        }
    }

    void add(const AffineMap &map, const Sphere &bound)
    {
        const Sphere &base = graph.base();
        AffineMap fit;
        if (glm::distance(bound.centre, base.centre) + base.radius > 1.1 * bound.radius) {
            const double scale = bound.radius / base.radius;
            fit = {glm::dmat3(scale), bound.centre - scale * base.centre};
        }
        copies.push_back({naive::fromCore(map * fit), true});
    }
};

}

/// Rays as wide as pixels, and through pixels.
class TestRayPixels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pixelsShowWhatABruteForceFinds_data();
    void pixelsShowWhatABruteForceFinds();
    void standInsAreThoseOfACut();
    void aPixelOfADeepSpongeCostsFewNodes();
    void rootsBelowARootAreTheSame();
    void rootsFarInsideAreAsExact();
    void whatIsFarFromTheOriginIsAsExact();
};

void TestRayPixels::pixelsShowWhatABruteForceFinds_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    const auto row = [](const char *name, quint64 depth) { QTest::newRow(name) << QString::fromLatin1(name) << depth; };
    row("appendix-b", 2);
    row("menger", 2);
    row("romanesco", 1);
    row("sierpinski", 5);
    row("snowflake", 2);
    row("terrain", 2);
    row("tree", 4);
    row("two-sets", 2);
}

/// 10,000 pixels of the eight examples, from far and from inside: the same face of the same copy, or one that is as near
/// but for rounding, where copies touch.
void TestRayPixels::pixelsShowWhatABruteForceFinds()
{
    QFETCH(const QString, name);
    QFETCH(const quint64, depth);
    const Sample fractal = sample(name, depth);
    const WrittenExample written(fractal);
    Walker walker(fractal.graph, fractal.mesh);
    const Sphere bound = fractal.graph.bound(0);
    const View view(bound);
    std::mt19937_64 random(seed(302));
    int metCount = 0;
    int sameCount = 0;
    for (int i = 0; i < 1'250; ++i) {
        const double size = std::array{0.3, 0.7, 1.0}[i % 3];
        const Ray ray = view.ray(uniform(random, -size, size), uniform(random, -size, size), i % 3 == 2 ? 0.3 : 1.5);
        const RayHit hit = walker.cast(ray);
        const auto [face, t] = written.first(ray);
        const double rounding = 1e-12;
        const auto words = [&] {
            return qPrintable(
                QStringLiteral("%1: %2, but %3").arg(i).arg(hit.t, 0, 'g', 17).arg(static_cast<double>(t), 0, 'g', 17));
        };
        QVERIFY2(hit.isFound() == (face != nullptr), words());
        if (!hit.isFound()) {
            continue;
        }
        ++metCount;
        QVERIFY2(std::abs(hit.t - static_cast<double>(t)) <= rounding, words());
        const AffineMap found = mapOf(fractal.graph, hit.address);
        const auto expected = naive::applied(face->map, {0.3L, 0.2L, 0.1L});
        const glm::dvec3 there = found({0.3, 0.2, 0.1});
        const double off = std::abs(there.x - static_cast<double>(expected[0]))
            + std::abs(there.y - static_cast<double>(expected[1]))
            + std::abs(there.z - static_cast<double>(expected[2]));
        if (hit.face == face->face && off <= 1e-9 * bound.radius) {
            ++sameCount;
        }
        // what is said of it is what the graph makes of it
        AffineMap byChoices;
        for (const Step &choice : hit.choices) {
            byChoices = byChoices * fractal.graph.set(choice.set).maps.at(choice.map);
        }
        QVERIFY(byChoices == found);
    }
    QVERIFY2(metCount > 60, qPrintable(QString::number(metCount)));
    QVERIFY2(sameCount > metCount * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(sameCount).arg(metCount)));
}

/// Also of maps that take the mesh far out of its place, so that it is fitted.
void TestRayPixels::standInsAreThoseOfACut()
{
    std::mt19937_64 random(seed(303));
    int standInCount = 0;
    int metCount = 0;
    for (int round = 0; round < 200; ++round) {
        naive::Fractal fractal;
        for (int i = 0; i < 3; ++i) {
            const double size = uniform(random, 0.3, 0.6);
            fractal.maps.push_back(
                mapFromParts(randomPoint(random, 1.0), randomPoint(random, 180), {size, size, -size}));
        }
        fractal.sets = {{{0, 1, 2}, random() % 2 == 0}, {{2}, false}};
        fractal.items = {{4, 0, {{0, 0, {}}}}, {1, 0, {{0, 1, {}}}}};
        const Mesh mesh = randomMesh(random);
        const FractalGraph graph = graphOf(fractal, mesh);
        Walker walker(graph, mesh);
        const View view(graph.bound(0));
        for (int i = 0; i < 60; ++i) {
            Ray ray = view.ray(uniform(random, -0.7, 0.7), uniform(random, -0.7, 0.7), uniform(random, 0.1, 2));
            (i % 2 == 0 ? ray.spread : ray.width) = uniform(random, 0.02, 0.3) * graph.bound(0).radius;
            NaiveCut cut{graph, ray};
            cut.walk(cut.table.root(), {}, 1.0);
            WrittenExample::First nearest;
            bool isStandIn = false;
            for (const NaiveCut::Copy &copy : cut.copies) {
                for (const Mesh::Face &face : mesh.faces) {
                    std::array<naive::Point, 3> corners;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const glm::dvec3 &v = mesh.vertices[face[k]];
                        corners[k] = naive::applied(copy.map, {v.x, v.y, v.z});
                    }
                    const auto met = truth::meeting<long double>(corners, {ray.origin.x, ray.origin.y, ray.origin.z},
                                                                 {ray.direction.x, ray.direction.y, ray.direction.z});
                    if (met && met->inside >= 0 && met->t >= 0 && met->t < nearest.t) {
                        nearest.t = met->t;
                        isStandIn = copy.isStandIn;
                    }
                }
            }
            const RayHit hit = walker.cast(ray);
            const auto t = static_cast<double>(nearest.t);
            QVERIFY2(hit.t == t || std::abs(hit.t - t) <= 1e-12 * (1 + t),
                     qPrintable(QStringLiteral("round %1, %2: %3, but %4").arg(round).arg(i).arg(hit.t).arg(t)));
            metCount += hit.isFound() ? 1 : 0;
            if (hit.isFound()) {
                QCOMPARE(hit.isStandIn, isStandIn);
                standInCount += isStandIn ? 1 : 0;
            }
        }
    }
    QVERIFY2(metCount > 300 && standInCount > 200, qPrintable(QStringLiteral("%1 %2").arg(metCount).arg(standInCount)));
}

/// However deep it is.
void TestRayPixels::aPixelOfADeepSpongeCostsFewNodes()
{
    const Sample shallow = sample(QStringLiteral("menger"), 40);
    const Sample deep = sample(QStringLiteral("menger"), 1'000);
    Walker ofShallow(shallow.graph, shallow.mesh);
    Walker ofDeep(deep.graph, deep.mesh);
    const View view(deep.graph.bound(0));
    std::mt19937_64 random(seed(304));
    std::uint64_t nodes = 0;
    int metCount = 0;
    for (int i = 0; i < 2'000; ++i) {
        // from outside, and from a hole of the sponge
        Ray ray = view.ray(uniform(random, -0.7, 0.7), uniform(random, -0.7, 0.7), i % 2 == 0 ? 2.0 : 0.01);
        ray.spread = glm::length(ray.direction) / 1'000;
        const RayHit hit = ofDeep.cast(ray);
        const RayHit same = ofShallow.cast(ray);
        QVERIFY(hit.promise == Promise::Exact);
        QVERIFY2(hit.cost.nodeVisits < 1'500, qPrintable(QString::number(hit.cost.nodeVisits)));
        nodes += hit.cost.nodeVisits;
        metCount += hit.isFound() ? 1 : 0;
        QCOMPARE(hit.isFound(), same.isFound());
        QVERIFY(!hit.isFound() || std::abs(hit.t - same.t) * glm::length(ray.direction) <= ray.spread * hit.t);
        QVERIFY(hit.choices == same.choices && hit.face == same.face);
    }
    QVERIFY2(metCount > 1'000 && nodes < 80'000, qPrintable(QStringLiteral("%1 %2").arg(metCount).arg(nodes)));
}

/// A fractal as the children of its root's children, and the meshes above those.
void TestRayPixels::rootsBelowARootAreTheSame()
{
    std::mt19937_64 random(seed(305));
    for (const char *name : {"menger", "sierpinski", "two-sets"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 4);
        StateTable table(fractal.graph);
        struct Below {
            StateId state;
            AffineMap map;
            Address address;
        };
        std::vector<Below> below{{table.root(), {}, {}}};
        std::vector<RayRoot> roots;
        std::vector<Address> addresses;
        for (int level = 0; level < 2; ++level) {
            std::vector<Below> next;
            for (const Below &one : below) {
                if (table.expansion(one.state).hasLeaf) {
                    roots.push_back({table.state(one.state).positions, one.map, true});
                    addresses.push_back(one.address);
                }
                for (const ChildRange &range : table.expansion(one.state).ranges) {
                    for (std::uint32_t map = range.firstMap; map < range.endMap; ++map) {
                        Below &child = next.emplace_back(one);
                        child.state = range.next;
                        child.map = one.map * fractal.graph.set(range.set).maps[map];
                        child.address.push_back({table.state(range.next).positions.front() - 1, map});
                    }
                }
            }
            below = std::move(next);
        }
        for (const Below &one : below) {
            roots.push_back({table.state(one.state).positions, one.map});
            addresses.push_back(one.address);
        }
        std::vector<RayRoot> meshes;
        std::ranges::copy_if(roots, std::back_inserter(meshes), &RayRoot::isMeshOnly);
        Walker walker(fractal.graph, fractal.mesh);
        const View view(fractal.graph.bound(0));
        int metCount = 0;
        for (int i = 0; i < 300; ++i) {
            const Ray ray = view.ray(uniform(random, -0.7, 0.7), uniform(random, -0.7, 0.7));
            const RayHit hit = walker.cast(ray);
            const RayHit same = walker.cast(ray, roots);
            const RayHit ofMeshes = walker.cast(ray, meshes);
            QVERIFY(ofMeshes.t >= hit.t - 1e-13 && ofMeshes.choices.empty());
            QVERIFY2(
                hit.t == same.t || std::abs(hit.t - same.t) <= 1e-13,
                qPrintable(QStringLiteral("%1: %2, but %3").arg(i).arg(hit.t, 0, 'g', 17).arg(same.t, 0, 'g', 17)));
            if (hit.isFound()) {
                ++metCount;
                Address address = addresses.at(same.root);
                address.insert(address.end(), same.address.begin(), same.address.end());
                const glm::dvec3 p(0.3, 0.2, 0.1);
                const double apart =
                    glm::distance(mapOf(fractal.graph, address)(p), mapOf(fractal.graph, hit.address)(p));
                QVERIFY(address == hit.address || apart < 1e-9 || hit.face != same.face);
            }
        }
        QVERIFY2(metCount > 20, name);
    }
}

/// A copy twenty levels down a gasket of forty, as a root with all that stands beside its ancestors, and the whole as a
/// root, a million times as large.
void TestRayPixels::rootsFarInsideAreAsExact()
{
    const Sample fractal = sample(QStringLiteral("sierpinski"), 40);
    const TransformSet &set = fractal.graph.setAt(0);
    Walker walker(fractal.graph, fractal.mesh);
    std::mt19937_64 random(seed(306));
    std::vector<RayRoot> spine{{{20}, {}}};
    AffineMap ancestor;
    std::vector<std::uint32_t> path(20);
    std::ranges::generate(path, [&] { return static_cast<std::uint32_t>(random() % 4); });
    for (Position level = 20; level-- > 0;) {
        const AffineMap &taken = set.maps[path[level]];
        ancestor = ancestor * inverse(taken).value();
        for (std::uint32_t map = 0; map < set.maps.size(); ++map) {
            if (map != path[level]) {
                spine.push_back({{level + 1}, ancestor * set.maps[map]});
            }
        }
    }
    const std::vector<RayRoot> whole{{{0}, ancestor}};
    QVERIFY(operatorNorm(ancestor.linear) > 1e6);
    int metCount = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 origin = randomPoint(random, 1.0);
        const Ray ray{.origin = origin, .direction = 0.5 * randomPoint(random, 1.0) - origin, .spread = 1e-3};
        const RayHit hit = walker.cast(ray, spine);
        const RayHit same = walker.cast(ray, whole);
        QVERIFY(hit.promise == Promise::Exact && hit.cost.nodeVisits < 3'000);
        QVERIFY2(hit.t == same.t || std::abs(hit.t - same.t) <= 1e-8 * hit.t,
                 qPrintable(QStringLiteral("%1: %2, but %3").arg(i).arg(hit.t, 0, 'g', 17).arg(same.t, 0, 'g', 17)));
        if (hit.isFound() && hit.root == 0) {
            ++metCount;
            QVERIFY(same.choices.size() == hit.choices.size() + 20);
            QVERIFY(std::ranges::equal(hit.choices, std::span(same.choices).subspan(20)));
            QVERIFY(std::ranges::equal(hit.address, std::span(same.address).subspan(20)));
            for (std::size_t level = 0; level < path.size(); ++level) {
                QVERIFY(same.choices[level].map == path[level] && same.address[level].map == path[level]);
            }
        }
    }
    QVERIFY2(metCount > 40, qPrintable(QString::number(metCount)));
}

/// Where the ray's origin is as far off, in numbers that can be added without rounding: the same bits.
void TestRayPixels::whatIsFarFromTheOriginIsAsExact()
{
    const Sample fractal = sample(QStringLiteral("tree"), 6);
    Walker walker(fractal.graph, fractal.mesh);
    std::mt19937_64 random(seed(309));
    const glm::dvec3 far(std::ldexp(1.0, 40), -std::ldexp(1.0, 41), std::ldexp(1.0, 39));
    const std::vector<RayRoot> moved{{{0}, {glm::dmat3(1.0), far}}};
    int metCount = 0;
    for (int i = 0; i < 300; ++i) {
        Ray ray{.origin = glm::round(256.0 * randomPoint(random, 3.0)) / 256.0};
        ray.direction = randomPoint(random, 0.5) + glm::dvec3(0, 1, 0) - ray.origin;
        const RayHit hit = walker.cast(ray);
        ray.origin += far;
        const RayHit same = walker.cast(ray, moved);
        QVERIFY(same.t == hit.t && same.address == hit.address && same.face == hit.face);
        metCount += hit.isFound() ? 1 : 0;
    }
    QVERIFY2(metCount > 100, qPrintable(QString::number(metCount)));
}

ROMANESCO_TEST(TestRayPixels)

}

#include "testraypixels.moc"
