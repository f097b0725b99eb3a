// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <glm/geometric.hpp>

#include "core/collide/bvhcollider.h"
#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/octreecollider.h"
#include "core/collide/simplecollider.h"
#include "core/collide/writtenout.h"
#include "tests/core/collide/deepsweeps.h"
#include "tests/core/collide/sweeptruth.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is promised of an answer that proves, of faces that are off by so much. Whether something was touched.
bool requireFirst(const SweepTruth &truth, const Sweep &sweep, const Touch &touch, double off = 0.0)
{
    const double rounding = roundingOf(sweep, truth.size());
    const double speed = glm::length(sweep.v);
    const double reach = truth.size() + glm::length(sweep.p) + sweep.radius;
    if (sweep.radius < 1e-9 * reach) {
        off = std::max(off, 2e-16 * reach); // 113 bits tell small distances apart so far
    }
    const auto text = words(sweep, touch).toStdString();
    const auto require = [&](bool isTrue, const char *what) {
        if (!isTrue) {
            throw std::runtime_error(std::string(what) + ": " + text);
        }
    };
    require(touch.promise == Promise::Exact, "exact");
    require(touch.lower >= 0 && touch.lower <= std::min(touch.time, sweep.time), "lower in order");
    require(std::abs(glm::length(touch.direction) - 1) < 1e-14, "direction of length 1");
    const double enough = sweep.radius + rounding;
    if (touch.lower > 0) {
        require(truth.leastUntil(sweep, touch.lower * (1 - 1e-15), enough) > sweep.radius - off,
                "nothing before lower");
    }
    if (!touch.isFound()) {
        require(touch.lower >= sweep.time * (1 - 1e-5) - (speed > 0 ? 1e-5 * sweep.radius / speed : 0),
                "proved to the end");
        require(truth.leastUntil(sweep, sweep.time, enough) > sweep.radius - off, "not missed");
        return false;
    }
    require(touch.time <= sweep.time, "in time");
    require(truth.distanceAt(sweep, touch.time) <= enough, "not extra");
    const double late = speed > 0 ? 1.001e-5 * sweep.radius / speed : 0;
    if (touch.time > late) {
        require(truth.leastUntil(sweep, touch.time - late, enough) > sweep.radius - rounding, "not late");
    }
    const glm::dvec3 centre = sweep.p + touch.time * sweep.v;
    const double distance = glm::distance(centre, touch.point);
    require(distance <= enough, "the point is touched");
    if (distance > 1e3 * rounding) {
        require(glm::dot(touch.direction, (centre - touch.point) / distance) > 1 - 1e-5, "direction to the centre");
    }
    return true;
}

/// And of where it says that it is.
void requireFace(const naive::Fractal &fractal, const Mesh &mesh, const naive::Picks &picks, const Sweep &sweep,
                 const Touch &touch, double size)
{
    if (touch.isFound() && touch.face != Mesh::none) {
        Mesh alone = mesh;
        alone.faces = {mesh.faces.at(touch.face)};
        const Wide toFace = distanceToCopy(fractal, alone, picks, touch.point);
        if (toFace > roundingOf(sweep, size)) {
            throw std::runtime_error("the point is of the face: " + words(sweep, touch).toStdString());
        }
    }
}

}

class TestSweep : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstTouchOfAllFacesIsFound_data();
    void theFirstTouchOfAllFacesIsFound();
    void whatIsRoundedMoreIsGrownForByMore();
    void whatIsVeryFarIsTouched();
    void whatIsNearlyGlidedAlongHidesNothing();
    void stoppingIsHeard();
    void greedyTouchesWhatItDescendsTo();
    void octreesTouchTheirWalls();
    void meshesWithoutFacesAreNotTouched();
};

void TestSweep::theFirstTouchOfAllFacesIsFound_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<bool>("isSimilar");
    QTest::addColumn<double>("largest");
    for (const char *kind : {"exact", "simple", "bvh"}) {
        QTest::addRow("%s, similarities, contracting", kind) << kind << true << 0.6;
        QTest::addRow("%s, similarities, growing", kind) << kind << true << 1.5;
        QTest::addRow("%s, any maps, contracting", kind) << kind << false << 0.6;
        QTest::addRow("%s, any maps, growing", kind) << kind << false << 1.5;
    }
}

void TestSweep::theFirstTouchOfAllFacesIsFound()
{
    QFETCH(const QString, kind);
    QFETCH(const bool, isSimilar);
    QFETCH(const double, largest);
    std::mt19937_64 random(seed(51));
    constexpr int rounds = 25;
    int touched = 0;
    int missed = 0;
    for (int round = 0; round < rounds; ++round) {
        const RandomFractal sample =
            isSimilar ? randomSimilarFractalWithMesh(random, largest) : randomFractalWithMesh(random, largest);
        const BoxBounds boxes(sample.graph, sample.mesh);
        const Mesh all = writtenOut(sample.graph, sample.mesh, {}, 1'000'000).value();
        std::unique_ptr<Collider> collider;
        if (kind == QLatin1String("exact")) {
            collider = std::make_unique<ExactCollider>(ExactCollider::create(sample.graph, boxes, sample.mesh).value());
        } else if (kind == QLatin1String("bvh")) {
            collider = std::make_unique<BvhCollider>(BvhCollider::create(all).value());
        } else {
            collider = std::make_unique<SimpleCollider>(sample.graph, sample.mesh);
        }
        const auto search = collider->search();
        const bool isMesh = kind == QLatin1String("bvh");
        const SweepTruth truth = isMesh ? truthOf(all) : truthOf(sample);
        for (int i = 0; i < 10; ++i) {
            const Sweep sweep = randomSweep(random, truth);
            Touch touch;
            search->sweep(sweep, touch);
            try {
                // copies are written out with rounding, as the simple one looks at them
                const double off = kind == QLatin1String("simple") ? roundingOf(sweep, truth.size()) : 0.0;
                ++(requireFirst(truth, sweep, touch, off) ? touched : missed);
                if (!isMesh) {
                    requireFace(sample.fractal, sample.mesh, picksOf(touch.address, sample.fractal), sweep, touch,
                                truth.size());
                }
            } catch (const std::runtime_error &error) {
                QFAIL(qPrintable(QStringLiteral("round %1, %2: %3").arg(round).arg(i).arg(error.what())));
            }
        }
    }
    QVERIFY2(touched > 3 * rounds && missed > rounds, qPrintable(QStringLiteral("%1 %2").arg(touched).arg(missed)));
}

/// Copies far out in their frames, and spheres beside them that are as small.
void TestSweep::whatIsRoundedMoreIsGrownForByMore()
{
    std::mt19937_64 random(seed(52));
    int touched = 0;
    for (int round = 0; round < 50; ++round) {
        Mesh mesh = randomMesh(random);
        const glm::dvec3 far = randomPoint(random, 1e8);
        for (glm::dvec3 &vertex : mesh.vertices) {
            vertex += far;
        }
        const auto turn = [&] { return randomPoint(random, 180); };
        const glm::dvec3 scale = round % 2 == 0 ? glm::dvec3(1e-8) : glm::dvec3(1e-8, 2e-8, 1e-8);
        naive::Fractal fractal;
        fractal.maps = {mapFromParts(randomPoint(random, 1), turn(), scale),
                        mapFromParts(randomPoint(random, 1), turn(), glm::dvec3(1))};
        fractal.sets = {{{1}, false}, {{0}, false}};
        fractal.items = {{0, 0, {}}, {0, 1, {}}};
        const FractalGraph graph = graphOf(fractal, mesh);
        const BoxBounds boxes(graph, mesh);
        const auto collider = ExactCollider::create(graph, boxes, mesh);
        const auto search = collider->search();
        SweepTruth truth;
        for (const naive::Picks &picks : naive::allPicks(fractal.levels())) {
            truth.add(fractal, mesh, picks);
        }
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 target = narrow(truth.triangles().front()[random() % 3]);
            const glm::dvec3 p = target + randomPoint(random, 3e-8);
            const Sweep sweep{.p = p, .v = target - p, .radius = std::pow(10.0, uniform(random, -11, -8))};
            Touch touch;
            search->sweep(sweep, touch);
            QVERIFY2(touch.lower == 0.0 || truth.leastUntil(sweep, touch.lower * (1 - 1e-15), 1.0) > sweep.radius,
                     qPrintable(words(sweep, touch)));
            touched += touch.isFound() && touch.time > 0.0 ? 1 : 0;
        }
    }
    QVERIFY2(touched > 500, qPrintable(QString::number(touched)));
}

void TestSweep::whatIsVeryFarIsTouched()
{
    std::mt19937_64 random(seed(64));
    const Mesh mesh = randomMesh(random);
    for (const glm::dvec3 &scale : {glm::dvec3(1), glm::dvec3(1e-12), glm::dvec3(1e6), glm::dvec3(1e-12, 1, 0)}) {
        naive::Fractal fractal;
        fractal.maps = {mapFromParts({1, 2, 3}, {0, 30, 0}, scale), mapFromParts({1, 0, 0}, {0, 0, 0}, scale)};
        fractal.sets = {{{0, 1}, false}};
        fractal.items = {{0, 0, {}}};
        const FractalGraph graph = graphOf(fractal, mesh);
        const BoxBounds boxes(graph, mesh);
        const auto collider = ExactCollider::create(graph, boxes, mesh);
        for (const double size : {1e30, 1e100, 1e150}) { // beside which the fractal is a point
            const glm::dvec3 p = randomPoint(random, size);
            for (const double radius : {0.25 * size, 1e-3 * size}) {
                Touch touch;
                collider->search()->sweep({.p = p, .v = -p, .time = 2, .radius = radius}, touch);
                const double expected = 1 - radius / glm::length(p);
                QVERIFY2(std::abs(touch.time - expected) <= 1e-11, qPrintable(QString::number(touch.time - expected)));
                QVERIFY(touch.lower <= expected && expected - touch.lower <= 1e-11);
                QVERIFY(glm::dot(touch.direction, glm::normalize(p)) > 1 - 1e-12);
                collider->search()->sweep({.p = p, .v = p, .radius = radius}, touch);
                QVERIFY(!touch.isFound() && touch.lower == 1.0);
            }
        }
    }
    // and with times and speeds of any size
    const Mesh triangle{{{0, 0, 5}, {4, 0, 5}, {0, 4, 5}}, {{0, 1, 2}}};
    const BvhCollider bvh = BvhCollider::create(triangle).value();
    for (const double speed : {1e-200, 1e-5, 1.0, 1e140}) {
        Touch touch;
        bvh.search()->sweep({.p = {1, 1, 0}, .v = {0, 0, speed}, .time = infinity, .radius = 2}, touch);
        QVERIFY(std::abs(touch.time * speed - 3) < 1e-13 && std::abs(touch.lower * speed - 3) < 1e-13);
        bvh.search()->sweep({.p = {1, 1, 0}, .v = {0, 0, -speed}, .time = infinity, .radius = 2}, touch);
        QVERIFY(!touch.isFound() && touch.lower == infinity);
    }
}

/// A floor that a sphere all but touches, and comes to touch much later than a wall.
void TestSweep::whatIsNearlyGlidedAlongHidesNothing()
{
    for (const int levels : {0, 1, 4}) {
        for (const double stretch : {0.5, 0.499}) {
            naive::Fractal fractal;
            fractal.maps = {mapFromParts({0, 0, 0}, {0, 0, 0}, {0.5, stretch, 0.5})};
            fractal.sets = {{{0}, false}};
            fractal.items.assign(static_cast<std::size_t>(levels), {0, 0, {}});
            Mesh mesh;
            mesh.vertices = {{-20, -20, 0}, {20, -20, 0}, {0, 30, 0}, {5, -20, -5}, {5, 20, -5}, {5, 0, 30}};
            for (glm::dvec3 &vertex : mesh.vertices) {
                vertex *= std::exp2(levels);
            }
            mesh.faces.push_back({0, 1, 2});
            mesh.faces.push_back({3, 4, 5});
            const auto graph = FractalGraph::build(fractal.description(), boundingSphere(mesh));
            const BoxBounds boxes(*graph, mesh);
            const auto exact = ExactCollider::create(*graph, boxes, mesh);
            for (const double gap : {3e-15, 3e-14, 3e-13, 6e-13, 1e-12}) {
                Touch touch;
                exact->search()->sweep({.p = {0, 0, 0.5 + gap}, .v = {1, 0, -gap / 8}, .time = 20, .radius = 0.5},
                                       touch);
                QVERIFY2(touch.time <= 4.5 + 1e-5, qPrintable(QString::number(touch.time)));
                QVERIFY(touch.lower <= 4.5);
            }
        }
    }
}

void TestSweep::stoppingIsHeard()
{
    std::stop_source stop;
    stop.request_stop();
    const Deep deep(QStringLiteral("menger"), 3);
    const GreedyCollider greedy = GreedyCollider::create(deep.fractal.graph, deep.fractal.mesh).value();
    const SimpleCollider simple(deep.fractal.graph, deep.fractal.mesh);
    for (const Collider *collider : std::initializer_list<const Collider *>{&deep.collider, &greedy, &simple}) {
        Touch touch;
        collider->search()->sweep({.p = {3, 0.9, 0.9}, .v = {-9, 0, 0}, .radius = 0.01, .stop = stop.get_token()},
                                  touch);
        QVERIFY(touch.promise == Promise::UpperBound && !touch.isFound() && touch.lower <= 0.3);
    }
}

void TestSweep::greedyTouchesWhatItDescendsTo()
{
    std::mt19937_64 random(seed(70));
    int touched = 0;
    int late = 0;
    for (int round = 0; round < 60; ++round) {
        const RandomFractal sample = randomFractalWithMesh(random, 0.7);
        const auto greedy = GreedyCollider::create(sample.graph, sample.mesh);
        const SimpleCollider simple(sample.graph, sample.mesh);
        const SweepTruth truth = truthOf(sample);
        for (int i = 0; i < 5; ++i) {
            const Sweep sweep = randomSweep(random, truth);
            Touch touch;
            greedy->search()->sweep(sweep, touch);
            QVERIFY(touch.promise == Promise::UpperBound && touch.lower == 0.0 && touch.cost.faceTests > 0);
            const naive::Picks picks = picksOf(touch.address, sample.fractal);
            QVERIFY(naive::allPicks(sample.fractal.levels()).contains(picks));
            Touch first;
            simple.search()->sweep(sweep, first);
            QVERIFY(touch.time >= first.lower * (1 - 1e-9)); // composed in another order
            if (touch.isFound()) {
                ++touched;
                requireFace(sample.fractal, sample.mesh, picks, sweep, touch, truth.size());
                const double distance = glm::distance(sweep.p + touch.time * sweep.v, touch.point);
                QVERIFY(distance <= sweep.radius + roundingOf(sweep, truth.size()));
                SweepTruth alone;
                alone.add(sample.fractal, sample.mesh, picks);
                QVERIFY(touch.time == 0.0
                        || alone.leastUntil(sweep, touch.time, sweep.radius)
                            >= sweep.radius - roundingOf(sweep, truth.size()));
            }
            late += touch.time > first.time ? 1 : 0;
        }
    }
    QVERIFY2(touched > 50 && late > 10, qPrintable(QStringLiteral("%1 %2").arg(touched).arg(late)));
}

void TestSweep::octreesTouchTheirWalls()
{
    const Deep deep(QStringLiteral("menger"), 0); // a cube of side 3, an octant for each of its corners, down to 3/16
    const auto tree = OctreeCollider::create(deep.fractal.graph, deep.fractal.mesh);
    Touch touch;
    tree->search()->sweep({.p = {0.9, 0.8, -5}, .v = {0, 0, 2}, .time = 3, .radius = 1}, touch);
    QVERIFY(touch.promise == Promise::None && touch.lower == 0.0 && touch.face == Mesh::none);
    const glm::dvec3 corner(1.5 - 3.0 / 16, 1.5 - 3.0 / 16, -1.5);
    const glm::dvec2 aside = glm::dvec2(corner) - glm::dvec2(0.9, 0.8);
    QVERIFY(std::abs(touch.time - (5 + corner.z - std::sqrt(1 - glm::dot(aside, aside))) / 2) < 1e-13);
    QVERIFY(glm::distance(touch.point, corner) < 1e-13);
    QCOMPARE(touch.cost.faceTests, 12u * (8 + 3));
    tree->search()->sweep({.p = {0.9, 0.8, -5}, .v = {0, 0, -2}, .time = 3, .radius = 1}, touch);
    QVERIFY(!touch.isFound() && touch.promise == Promise::None);
}

void TestSweep::meshesWithoutFacesAreNotTouched()
{
    const Mesh nothing;
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(nothing));
    const BoxBounds boxes(graph, nothing);
    const ExactCollider exact = ExactCollider::create(graph, boxes, nothing).value();
    const BvhCollider bvh = BvhCollider::create(nothing).value();
    const SimpleCollider simple(graph, nothing);
    for (const Collider *collider : std::initializer_list<const Collider *>{&exact, &bvh, &simple}) {
        Touch touch;
        collider->search()->sweep({.v = {1, 0, 0}, .time = 7, .radius = 1}, touch);
        QVERIFY(!touch.isFound() && touch.lower == 7.0 && touch.promise == Promise::Exact);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestSweep)

#include "testsweep.moc"
