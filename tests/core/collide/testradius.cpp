// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <glm/geometric.hpp>

#include "core/collide/bvhcollider.h"
#include "core/collide/colliderkind.h"
#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/octreecollider.h"
#include "core/collide/simplecollider.h"
#include "core/collide/writtenout.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Kind = ColliderKind;

const AffineMap sheared{glm::dmat3(1, 0.3, 0, 0, 2, 0, -0.5, 0, 0.7), {3, 4, 5}};

/// Says where what was found without a radius is not found with its distance as the radius.
QString missedAgain(Search &search, const glm::dvec3 &p, const std::optional<glm::dvec3> &motion)
{
    Hit hit;
    search.closest({.p = p, .motion = motion}, hit);
    if (!hit.isFound()) {
        return {};
    }
    Hit again;
    search.closest({.p = p, .radius = hit.distance, .motion = motion}, again);
    const double rounding = 1e-12 * (glm::length(p) + glm::length(hit.point));
    const bool isAgain = again.isFound() && again.distance <= hit.distance
        && (hit.promise != Promise::Exact || again.distance >= hit.distance - rounding) && again.promise == hit.promise
        && again.lower <= hit.distance && std::abs(glm::distance(again.point, p) - again.distance) <= rounding;
    return isAgain ? QString()
                   : QStringLiteral("%1, then %2").arg(hit.distance, 0, 'g', 17).arg(again.distance, 0, 'g', 17);
}

std::optional<glm::dvec3> motionNowAndThen(std::mt19937_64 &random)
{
    return random() % 4 == 0 ? std::optional(randomPoint(random, 1)) : std::nullopt;
}

/// Far, near, and on the surface.
glm::dvec3 randomQuery(std::mt19937_64 &random, const Sphere &around, const Mesh &all)
{
    const double size = around.radius + glm::length(around.centre);
    switch (random() % 4) {
    case 0:
        return randomPoint(random, 100 * size);
    case 1:
        return randomPoint(random, size);
    case 2:
        return randomVertex(random, all);
    default:
        return randomVertex(random, all) + randomPoint(random, 0.01 * size);
    }
}

/// Of any maps, or of similarities; small meshes and others are searched in their own ways.
RandomFractal randomSample(std::mt19937_64 &random, bool isSimilar, quint32 faces)
{
    RandomFractal sample = isSimilar ? randomSimilarFractalWithMesh(random, 0.8) : randomFractalWithMesh(random, 0.8);
    sample.mesh = soup(random, faces, 0.3);
    sample.graph = graphOf(sample.fractal, sample.mesh);
    return sample;
}

std::unique_ptr<Collider> colliderOf(Kind kind, const RandomFractal &sample, const BoxBounds &boxes, const Mesh &all)
{
    const auto &[fractal, mesh, graph] = sample;
    switch (kind) {
    case Kind::Exact:
        return std::make_unique<ExactCollider>(ExactCollider::create(graph, boxes, mesh).value());
    case Kind::Approximate:
        return std::make_unique<ExactCollider>(ExactCollider::create(graph, boxes, mesh, 0.05).value());
    case Kind::Bvh:
        return std::make_unique<BvhCollider>(BvhCollider::create(all).value());
    case Kind::Simple:
        return std::make_unique<SimpleCollider>(graph, mesh);
    case Kind::Greedy:
        return std::make_unique<GreedyCollider>(GreedyCollider::create(graph, mesh).value());
    case Kind::Octree:
        break;
    }
    return std::make_unique<OctreeCollider>(OctreeCollider::create(graph, mesh).value());
}

}

class TestRadius : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatWasFoundIsFoundAgainWithin_data();
    void whatWasFoundIsFoundAgainWithin();
    void pointsOfDeepFractalsAreFoundAgain_data();
    void pointsOfDeepFractalsAreFoundAgain();
};

void TestRadius::whatWasFoundIsFoundAgainWithin_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<bool>("isSimilar");
    QTest::addColumn<bool>("isPlaced");
    QTest::addColumn<quint32>("faces");
    const std::pair<const char *, Kind> kinds[]{{"exact", Kind::Exact},   {"approximate", Kind::Approximate},
                                                {"bvh", Kind::Bvh},       {"simple", Kind::Simple},
                                                {"greedy", Kind::Greedy}, {"octree", Kind::Octree}};
    for (const auto &[name, kind] : kinds) {
        for (const quint32 faces : {2u, 50u}) {
            QTest::addRow("%s, similarities, %u faces", name, faces) << kind << true << false << faces;
            QTest::addRow("%s, any maps, %u faces", name, faces) << kind << false << false << faces;
            if (kind != Kind::Bvh && kind != Kind::Octree) {
                QTest::addRow("%s, placed, %u faces", name, faces) << kind << true << true << faces;
            }
        }
    }
}

void TestRadius::whatWasFoundIsFoundAgainWithin()
{
    QFETCH(const Kind, kind);
    QFETCH(const bool, isSimilar);
    QFETCH(const bool, isPlaced);
    QFETCH(const quint32, faces);
    std::mt19937_64 random(seed(91));
    const bool isQuick = kind != Kind::Simple && kind != Kind::Greedy;
    for (int round = 0; round < (isQuick ? 40 : 8); ++round) {
        const RandomFractal sample = randomSample(random, isSimilar, faces);
        const AffineMap place = isPlaced ? sheared : AffineMap{};
        const BoxBounds boxes(sample.graph, sample.mesh);
        const Mesh all = writtenOut(sample.graph, sample.mesh, place, 1'000'000).value();
        const auto collider = colliderOf(kind, sample, boxes, all);
        const auto search = isPlaced ? collider->searchPlaced(place) : collider->search();
        const Sphere around = boundingSphere(all);
        for (int i = 0; i < 15; ++i) {
            const glm::dvec3 p = randomQuery(random, around, all);
            const QString words = missedAgain(*search, p, motionNowAndThen(random));
            QVERIFY2(words.isEmpty(), qPrintable(QStringLiteral("round %1, %2: %3").arg(round).arg(i).arg(words)));
        }
    }
}

void TestRadius::pointsOfDeepFractalsAreFoundAgain_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("excess");
    QTest::addColumn<bool>("isPlaced");
    for (const char *name : {"menger", "tree", "two-sets"}) {
        for (const double excess : {0.0, 0.05}) {
            QTest::addRow("%s %g", name, excess) << QString::fromLatin1(name) << excess << false;
        }
    }
    QTest::newRow("tree, placed") << QStringLiteral("tree") << 0.0 << true;
}

void TestRadius::pointsOfDeepFractalsAreFoundAgain()
{
    QFETCH(const QString, name);
    QFETCH(const double, excess);
    QFETCH(const bool, isPlaced);
    std::mt19937_64 random(seed(92));
    const Sample fractal = sample(name, 200);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh, excess);
    const auto search = isPlaced ? collider->searchPlaced(sheared) : collider->search();
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 p = fractal.graph.bound(0).centre + randomPoint(random, 1.5 * fractal.graph.bound(0).radius);
        const QString words = missedAgain(*search, isPlaced ? sheared(p) : p, motionNowAndThen(random));
        QVERIFY2(words.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(i).arg(words)));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestRadius)

#include "testradius.moc"
