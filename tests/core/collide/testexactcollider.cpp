// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/exactcollider.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/collide/allocations.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Far, near, and on the surface.
glm::dvec3 randomQuery(std::mt19937_64 &random, const RandomFractal &sample)
{
    const double size = sample.graph.bound(0).radius + glm::length(sample.graph.bound(0).centre);
    const auto kind = random() % 4;
    if (kind == 0) {
        return randomPoint(random, 100 * size);
    }
    if (kind == 1) {
        return randomPoint(random, size);
    }
    const auto words = naive::allPicks(sample.fractal.levels());
    const std::vector<naive::Picks> all(words.begin(), words.end());
    const Mesh::Face &face = sample.mesh.faces[random() % sample.mesh.faces.size()];
    const auto vertex =
        placed(all[random() % all.size()], sample.fractal.maps, sample.mesh.vertices[face[random() % 3]]);
    const glm::dvec3 point(static_cast<double>(vertex[0]), static_cast<double>(vertex[1]),
                           static_cast<double>(vertex[2]));
    return kind == 2 ? point : point + randomPoint(random, 0.01 * size);
}

double sizeOf(const RandomFractal &sample, const glm::dvec3 &p)
{
    return sample.graph.bound(0).radius + glm::length(sample.graph.bound(0).centre) + glm::length(p);
}

}

class TestExactCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itFindsTheNearestOfAllFaces_data();
    void itFindsTheNearestOfAllFaces();
    void similaritiesAreSearchedInTheirFrames();
    void bothWaysAgree();
    void whatIsAsNearButForRoundingIsNotFollowed();
    void whatIsVeryFarIsFound();
    void whatIsRoundedMoreIsBoundedByMore();
    void nothingBeyondTheRadiusCounts();
    void aRadiusThatHoldsTheNearestSavesVisits();
    void anExcessIsKept();
    void anExcessEndsTheWayDown();
    void aSpentBudgetIsAdmitted();
    void aSpongeCostsItsDepth();
    void deepFractalsAreSearchedToTheirPoints_data();
    void deepFractalsAreSearchedToTheirPoints();
    void meshesWithoutFacesHaveNoPoint();
    void searchesDoNotAllocateOnceTheyHaveGrown();
};

void TestExactCollider::itFindsTheNearestOfAllFaces_data()
{
    QTest::addColumn<bool>("isSimilar");
    QTest::addColumn<double>("largest");
    QTest::newRow("similarities, contracting") << true << 0.6;
    QTest::newRow("similarities, growing") << true << 1.5;
    QTest::newRow("any maps, contracting") << false << 0.6;
    QTest::newRow("any maps, growing") << false << 1.5;
}

void TestExactCollider::itFindsTheNearestOfAllFaces()
{
    QFETCH(const bool, isSimilar);
    QFETCH(const double, largest);
    std::mt19937_64 random(seed(51));
    for (int round = 0; round < 60; ++round) {
        const RandomFractal sample =
            isSimilar ? randomSimilarFractalWithMesh(random, largest) : randomFractalWithMesh(random, largest);
        const BoxBounds boxes(sample.graph, sample.mesh);
        const auto collider = ExactCollider::create(sample.graph, boxes, sample.mesh);
        QVERIFY(collider->usesLocalFrames() || !isSimilar);
        const auto search = collider->search();
        for (int i = 0; i < 10; ++i) {
            const glm::dvec3 p = randomQuery(random, sample);
            Hit hit;
            search->closest({p}, hit);
            const auto least = static_cast<double>(distanceToAll(sample, p));
            const double rounding = 1e-14 * sizeOf(sample, p);
            const auto words = [&] {
                return qPrintable(QStringLiteral("round %1, %2: %3, but %4, at least %5")
                                      .arg(round)
                                      .arg(i)
                                      .arg(hit.distance, 0, 'g', 17)
                                      .arg(least, 0, 'g', 17)
                                      .arg(hit.lower, 0, 'g', 17));
            };
            QVERIFY2(std::abs(hit.distance - least) <= rounding, words());
            QVERIFY2(hit.lower <= least * (1 + 1e-15), words());
            QVERIFY2(hit.distance - hit.lower <= 100 * rounding, words());
            QVERIFY(hit.promise == Promise::Exact);
            if (hit.face != Mesh::none) {
                const naive::Picks picks = picksOf(hit.address, sample.fractal);
                Mesh alone = sample.mesh;
                alone.faces = {sample.mesh.faces.at(hit.face)};
                const Wide ofFace = distanceToCopy(sample.fractal, alone, picks, p);
                QVERIFY(std::abs(static_cast<double>(ofFace) - hit.distance) <= rounding);
                const Wide toFace = distanceToCopy(sample.fractal, alone, picks, hit.point);
                QVERIFY(static_cast<double>(toFace) <= rounding);
            }
            QVERIFY(std::abs(glm::distance(hit.point, p) - hit.distance) <= rounding);
            QVERIFY(std::abs(glm::length(hit.direction) - 1) < 1e-14);
            if (hit.distance > 1e6 * rounding) {
                QVERIFY(glm::dot(hit.direction, glm::normalize(p - hit.point)) > 1 - 1e-5);
            }
        }
    }
}

void TestExactCollider::similaritiesAreSearchedInTheirFrames()
{
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 5);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        QVERIFY2(ExactCollider::create(fractal.graph, boxes, fractal.mesh)->usesLocalFrames(), name);
    }
}

/// Similarities too can be searched the other way.
void TestExactCollider::bothWaysAgree()
{
    std::mt19937_64 random(seed(52));
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 4);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
        const auto inFrames = collider->search();
        const auto relative = collider->searchPlaced({});
        const double size = fractal.graph.bound(0).radius;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 p = fractal.graph.bound(0).centre + randomPoint(random, 1.2 * size);
            Hit one;
            Hit other;
            inFrames->closest({p}, one);
            relative->closest({p}, other);
            QVERIFY(std::abs(one.distance - other.distance) <= 1e-13 * size);
            QVERIFY(std::max(one.lower, other.lower) <= std::min(one.distance, other.distance) * (1 + 1e-15));
        }
    }
}

/// An edge is as far from a point as its nearest copy is, over the more of them the smaller they are: ten thousand nodes
/// and more where each is gone down to.
void TestExactCollider::whatIsAsNearButForRoundingIsNotFollowed()
{
    const Sample fractal = sample(QStringLiteral("tree7"), 40, workloads);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    const auto search = collider->search();
    const Box box = boxes.at(fractal.graph, 0);
    std::mt19937_64 random(seed(60));
    std::uint64_t most = 0;
    for (int i = 0; i < 3'000; ++i) {
        Hit hit;
        const glm::dvec3 p = box.centre() + 1.5 * randomPoint(random, 1.0) * 0.5 * box.size();
        search->closest({.p = p, .nodeBudget = 100'000}, hit);
        most = std::max(most, hit.cost.nodeVisits);
    }
    QVERIFY2(most < 1'000, qPrintable(QString::number(most)));
}

/// As far as squares go, also in the frames of very small copies.
void TestExactCollider::whatIsVeryFarIsFound()
{
    std::mt19937_64 random(seed(59));
    const Mesh mesh = randomMesh(random);
    for (const glm::dvec3 &scale : {glm::dvec3(1), glm::dvec3(1e-12), glm::dvec3(1e6), glm::dvec3(1e-12, 1, 0)}) {
        naive::Fractal fractal;
        fractal.maps = {mapFromParts({1, 2, 3}, {0, 30, 0}, scale), mapFromParts({1, 0, 0}, {0, 0, 0}, scale)};
        fractal.sets = {{{0, 1}, false}};
        fractal.items = {{0, 0, {}}};
        const auto graph = FractalGraph::build(fractal.description(), boundingSphere(mesh));
        const BoxBounds boxes(*graph, mesh);
        const auto collider = ExactCollider::create(*graph, boxes, mesh);
        for (const double size : {1e30, 1e100, 1e150}) { // beside which the fractal is a point
            const glm::dvec3 p = randomPoint(random, size);
            Hit hit;
            collider->search()->closest({p}, hit);
            QVERIFY(std::abs(hit.distance - glm::length(p)) <= 1e-14 * size);
            QVERIFY(hit.lower <= hit.distance && hit.distance - hit.lower <= 1e-12 * size);
            QVERIFY(glm::dot(hit.direction, glm::normalize(p)) > 1 - 1e-12);
        }
    }
}

/// Copies far out in their frame are dropped beside others, and are nearer in truth than they are computed to be.
void TestExactCollider::whatIsRoundedMoreIsBoundedByMore()
{
    Mesh mesh;
    mesh.vertices = {{-1e8, -1, -1}, {-1e8, 2, -1}, {-1e8, -1, 2}};
    mesh.faces = {{0, 1, 2}};
    naive::Fractal fractal;
    const glm::dvec3 small(1e-8);
    fractal.maps = {mapFromParts({3 - 4e-9, 0, 0}, {0, 0, 0}, small),
                    mapFromParts({3 - 4e-9, 1e-9, 0}, {0, 0, 0}, small),
                    mapFromParts({1e8, 0, 0}, {0, 0, 0}, glm::dvec3(1))};
    fractal.sets = {{{0, 1}, true}, {{2}, true}};
    fractal.items = {{0, 0, {}}, {0, 1, {}}};
    const auto graph = FractalGraph::build(fractal.description(), boundingSphere(mesh));
    const BoxBounds boxes(*graph, mesh);
    const auto collider = ExactCollider::create(*graph, boxes, mesh);
    // faces across x at 0, seen as one place in 1e8, and at 2 - 4e-9
    const glm::dvec3 p(1 - 3e-9, 0, 0);
    Hit hit;
    collider->search()->closest({p}, hit);
    QVERIFY(std::abs(hit.distance - p.x) < 1e-7);
    QVERIFY2(hit.lower <= p.x, qPrintable(QString::number(hit.lower - p.x)));
}

void TestExactCollider::nothingBeyondTheRadiusCounts()
{
    std::mt19937_64 random(seed(53));
    for (const double excess : {0.0, 0.3}) {
        for (const char *name : {"tree", "two-sets"}) {
            const Sample fractal = sample(QString::fromLatin1(name), 3);
            const BoxBounds boxes(fractal.graph, fractal.mesh);
            const auto exact = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
            const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh, excess);
            const auto search = collider->search();
            std::uint64_t visitsWithin = 0;
            std::uint64_t visits = 0;
            for (int i = 0; i < 100; ++i) {
                const glm::dvec3 p = randomPoint(random, 3);
                Hit hit;
                exact->search()->closest({p}, hit);
                visits += hit.cost.nodeVisits;
                const double least = hit.distance;
                search->closest({p, least * (1 - 1e-9)}, hit);
                visitsWithin += hit.cost.nodeVisits;
                QVERIFY(!hit.isFound());
                QVERIFY(hit.lower > least * (1 - 1e-8) && hit.lower <= least);
                QVERIFY(hit.address.empty());
                search->closest({p, least * (1 + 1e-9)}, hit);
                QVERIFY(hit.isFound() && std::abs(hit.distance - least) <= 1e-9 * least);
                search->closest({p, 0.5 * least}, hit);
                QVERIFY(!hit.isFound() && hit.lower >= 0.5 * least * (1 - 1e-12));
            }
            QVERIFY(visitsWithin < visits);
        }
    }
}

void TestExactCollider::aRadiusThatHoldsTheNearestSavesVisits()
{
    std::mt19937_64 random(seed(62));
    for (const char *name : {"mild-tree", "rotated-tree", "uneven-scales"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 8, workloads);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
        const auto search = collider->search();
        const double size = fractal.graph.bound(0).radius;
        std::uint64_t cold = 0;
        std::uint64_t warm = 0;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 before = fractal.graph.bound(0).centre + randomPoint(random, size);
            const glm::dvec3 p = before + randomPoint(random, 1e-3 * size);
            Hit last;
            Hit hit;
            Hit same;
            search->closest({before}, last);
            search->closest({p}, hit);
            search->closest({p, (last.distance + glm::distance(before, p)) * (1 + 1e-12)}, same);
            QCOMPARE(same.distance, hit.distance);
            cold += hit.cost.nodeVisits;
            warm += same.cost.nodeVisits;
        }
        QVERIFY2(warm < cold, qPrintable(QStringLiteral("%1 of %2").arg(warm).arg(cold)));
    }
}

void TestExactCollider::anExcessIsKept()
{
    std::mt19937_64 random(seed(54));
    for (const char *name : {"tree", "appendix-b", "sierpinski"}) {
        const Sample fractal = sample(QString::fromLatin1(name), 6);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const auto exactCollider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
        const auto exact = exactCollider->search();
        constexpr std::array excesses{0.5, 0.1, 1e-3};
        std::vector<ExactCollider> colliders;
        for (const double excess : excesses) {
            colliders.push_back(ExactCollider::create(fractal.graph, boxes, fractal.mesh, excess).value());
        }
        std::uint64_t exactVisits = 0;
        std::uint64_t visits = 0;
        double worst = 0;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 p = fractal.graph.bound(0).centre + randomPoint(random, fractal.graph.bound(0).radius);
            Hit truth;
            exact->closest({p}, truth);
            exactVisits += truth.cost.nodeVisits;
            for (std::size_t kind = 0; kind < excesses.size(); ++kind) {
                const double excess = excesses[kind];
                Hit hit;
                colliders[kind].search()->closest({p}, hit);
                QVERIFY(hit.distance >= truth.distance * (1 - excess) * (1 - 1e-14));
                QVERIFY(hit.distance <= truth.distance * (1 + excess) * (1 + 1e-14));
                QVERIFY(hit.lower <= truth.distance * (1 + 1e-15)
                        && hit.lower * (1 + 2 * excess) >= hit.distance * (1 - 1e-12));
                QVERIFY(hit.promise == Promise::Within && hit.excess == excess);
                worst = std::max(worst, hit.distance / truth.distance - 1);
                visits += excess == 0.5 ? hit.cost.nodeVisits : 0;
            }
        }
        QVERIFY(visits < exactVisits);
        QVERIFY(worst > 1e-3); // else nothing is traded
    }
}

/// What is smaller than the excess is not looked at: how deep it goes makes no difference.
void TestExactCollider::anExcessEndsTheWayDown()
{
    std::mt19937_64 random(seed(61));
    std::array<std::uint64_t, 2> visits{};
    for (const std::size_t deeper : {0, 1}) {
        const Sample fractal = sample(QStringLiteral("sierpinski"), deeper == 0 ? 20 : 200, workloads);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh, 1e-3);
        for (int i = 0; i < 100; ++i) {
            Hit hit;
            collider->search()->closest({randomPoint(random, 3.0)}, hit);
            visits[deeper] += hit.cost.nodeVisits;
            QVERIFY(hit.isFound() && hit.promise == Promise::Within);
        }
    }
    QVERIFY(2 * visits[1] < 3 * visits[0]);
}

void TestExactCollider::aSpentBudgetIsAdmitted()
{
    std::mt19937_64 random(seed(55));
    const Sample fractal = sample(QStringLiteral("appendix-b"), 6);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    const auto search = collider->search();
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = randomPoint(random, 14);
        Hit truth;
        search->closest({p}, truth);
        for (const std::uint64_t budget : {0u, 1u, 2u, 8u, 10u, 30u, 100u, 100'000u}) {
            Hit hit;
            search->closest({.p = p, .nodeBudget = budget}, hit);
            QVERIFY(hit.cost.nodeVisits <= std::max<std::uint64_t>(budget, 1));
            QVERIFY(hit.distance >= truth.distance * (1 - 1e-14));
            QVERIFY(hit.lower <= truth.distance * (1 + 1e-15));
            if (budget > truth.cost.nodeVisits) {
                QVERIFY(hit.promise == Promise::Exact && hit.distance == truth.distance);
            } else if (budget + 2 < truth.cost.nodeVisits) {
                QVERIFY(hit.promise != Promise::Exact);
            }
            if (hit.promise == Promise::Within) {
                QVERIFY(hit.distance <= truth.distance * (1 + hit.excess) * (1 + 1e-14));
            }
        }
    }
}

/// Its boxes are its hulls.
void TestExactCollider::aSpongeCostsItsDepth()
{
    std::mt19937_64 random(seed(56));
    for (const std::uint64_t depth : {1u, 5u, 12u}) {
        const Sample fractal = sample(QStringLiteral("menger"), depth);
        const BoxBounds boxes(fractal.graph, fractal.mesh);
        const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
        const auto search = collider->search();
        int cheap = 0;
        for (int i = 0; i < 200; ++i) {
            Hit hit;
            search->closest({randomPoint(random, 2.5)}, hit);
            cheap += hit.cost.nodeVisits == depth + 1 ? 1 : 0;
            QVERIFY(hit.cost.nodeVisits <= 3 * (depth + 1));
        }
        QVERIFY(cheap > 180);
    }
}

void TestExactCollider::deepFractalsAreSearchedToTheirPoints_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    for (const char *name : {"menger", "tree", "appendix-b", "two-sets", "sierpinski", "snowflake"}) {
        for (const quint64 depth : {quint64(1'000), quint64(1'000'000), quint64(1) << 54}) {
            QTest::addRow("%s %llu", name, depth) << QString::fromLatin1(name) << depth;
        }
    }
}

void TestExactCollider::deepFractalsAreSearchedToTheirPoints()
{
    QFETCH(const QString, name);
    QFETCH(const quint64, depth);
    std::mt19937_64 random(seed(57));
    const Sample fractal = sample(name, depth);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    const auto search = collider->search();
    // Two hundred levels are as good as a million: what comes below is smaller than rounding.
    const Sample shallow = sample(name, 200);
    const BoxBounds shallowBoxes(shallow.graph, shallow.mesh);
    const auto shallowCollider = ExactCollider::create(shallow.graph, shallowBoxes, shallow.mesh);
    const auto shallowSearch = shallowCollider->search();
    const double size = fractal.graph.bound(0).radius;
    int exact = 0;
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 p = fractal.graph.bound(0).centre + randomPoint(random, size);
        Hit hit;
        search->closest({.p = p, .nodeBudget = 100'000}, hit);
        Hit other;
        shallowSearch->closest({.p = p, .nodeBudget = 100'000}, other);
        QVERIFY(hit.isFound());
        QVERIFY(hit.lower <= other.distance * (1 + 1e-15) + 1e-13 * size);
        QVERIFY(other.lower <= hit.distance * (1 + 1e-15) + 1e-13 * size);
        if (hit.promise == Promise::Exact && other.promise == Promise::Exact) {
            ++exact;
            QVERIFY(std::abs(hit.distance - other.distance) <= 1e-13 * size);
            QVERIFY(hit.distance - hit.lower <= 1e-11 * size);
        }
    }
    QVERIFY(exact >= 18);
}

void TestExactCollider::meshesWithoutFacesHaveNoPoint()
{
    const Mesh nothing;
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(nothing));
    const BoxBounds boxes(graph, nothing);
    Hit hit;
    const auto collider = ExactCollider::create(graph, boxes, nothing);
    collider->search()->closest({}, hit);
    QVERIFY(!hit.isFound() && hit.lower > 1e300 && hit.promise == Promise::Exact);
}

void TestExactCollider::searchesDoNotAllocateOnceTheyHaveGrown()
{
    std::mt19937_64 random(seed(58));
    const Sample fractal = sample(QStringLiteral("appendix-b"), 6);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    const auto search = collider->search();
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 100; ++i) {
        points.push_back(randomPoint(random, 14));
    }
    Hit hit;
    for (const glm::dvec3 &p : points) {
        search->closest({p}, hit);
    }
    const std::size_t before = allocationCount();
    for (const glm::dvec3 &p : points) {
        search->closest({p}, hit);
    }
    QCOMPARE(allocationCount(), before);
}

}

ROMANESCO_TEST(romanesco::test::TestExactCollider)

#include "testexactcollider.moc"
