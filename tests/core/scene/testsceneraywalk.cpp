// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/scene/sceneraywalk.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/collide/allocations.h"
#include "tests/core/collide/raytruth.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A face of a scene that is written out.
struct WrittenFace {
    std::size_t item;
    naive::Picks picks;
    std::uint32_t face;
    std::array<truth::Vector<Wide>, 3> corners;
};

std::vector<WrittenFace> facesOf(const Written &scene)
{
    std::vector<WrittenFace> all;
    for (std::size_t item = 0; item < scene.items.size(); ++item) {
        const RandomFractal &sample = scene.fractals[scene.fractalOfItem[item]];
        naive::Fractal moved = sample.fractal;
        moved.maps.push_back(scene.items[item].worldFromModel);
        for (const naive::Picks &picks : naive::allPicks(moved.levels())) {
            naive::Picks whole = picks;
            whole.insert(whole.begin(), static_cast<int>(moved.maps.size()) - 1);
            for (std::uint32_t face = 0; face < sample.mesh.faces.size(); ++face) {
                WrittenFace &written = all.emplace_back(WrittenFace{item, picks, face, {}});
                for (std::size_t i = 0; i < 3; ++i) {
                    written.corners[i] = placed(whole, moved.maps, sample.mesh.vertices[sample.mesh.faces[face][i]]);
                }
            }
        }
    }
    return all;
}

glm::dvec3 narrowed(const truth::Vector<Wide> &v)
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Ray rayTo(std::mt19937_64 &random, const std::vector<WrittenFace> &faces)
{
    const auto &corners = faces[random() % faces.size()].corners;
    const double s = uniform(random, 0, 1);
    const double t = uniform(random, 0, 1 - s);
    Ray ray;
    ray.origin = randomPoint(random, 15);
    ray.direction =
        (1 - s - t) * narrowed(corners[0]) + s * narrowed(corners[1]) + t * narrowed(corners[2]) - ray.origin;
    return ray;
}

/// From the root of the item that was met.
std::vector<Step> stepsTo(const Surroundings &from, const RayHit &hit)
{
    const Surroundings::Node &root = from.nodes.at(hit.root);
    const auto shared = from.path.begin() + static_cast<std::ptrdiff_t>(root.sharedSteps);
    std::vector<Step> steps(from.path.begin(), shared);
    steps.insert(steps.end(), root.steps.begin(), root.steps.end());
    steps.insert(steps.end(), hit.choices.begin(), hit.choices.end());
    return steps;
}

std::vector<AffineMap> mapsOf(const Model &model, const std::vector<Step> &steps)
{
    std::vector<AffineMap> maps;
    for (const Step &step : steps) {
        maps.push_back(model.graph.set(step.set).maps[step.map]);
    }
    return maps;
}

std::vector<AffineMap> mapsOf(const naive::Fractal &fractal, const naive::Picks &picks)
{
    std::vector<AffineMap> maps;
    for (const int pick : picks) {
        maps.push_back(fractal.maps[static_cast<std::size_t>(pick)]);
    }
    return maps;
}

SceneRayWalk walkOf(std::vector<SceneItem> items)
{
    return SceneRayWalk::create(sceneOf(std::move(items))).value();
}

}

class TestSceneRayWalk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itMeetsTheFirstOfAllItems_data();
    void itMeetsTheFirstOfAllItems();
    void deepInASpongeItMeetsWhatTheDigitsSay_data();
    void deepInASpongeItMeetsWhatTheDigitsSay();
    void itemsBehindWhatIsMetAreNotWalked();
    void aBudgetIsForAllItems();
    void whatCannotBeWalkedIsRefused();
    void raysTakeNoMemoryOnceItHasGrown();
};

void TestSceneRayWalk::itMeetsTheFirstOfAllItems_data()
{
    QTest::addColumn<bool>("isFromInside");
    QTest::newRow("from the world") << false;
    QTest::newRow("from a place inside") << true;
}

/// Balls too.
void TestSceneRayWalk::itMeetsTheFirstOfAllItems()
{
    QFETCH(const bool, isFromInside);
    std::mt19937_64 random(seed(331));
    int metCount = 0;
    int ballCount = 0;
    int insideCount = 0;
    for (int round = 0; round < 80; ++round) {
        const Written scene = randomScene(random);
        const std::vector<WrittenFace> faces = facesOf(scene);
        if (faces.empty()) {
            continue;
        }
        SceneRayWalk walk = walkOf(scene.items);
        for (int i = 0; i < 10; ++i) {
            const Ray ray = rayTo(random, faces);
            const double length = glm::length(ray.direction);
            const double rounding = 1e-13 * (40 + glm::length(ray.origin));
            RayHit hit;
            std::vector<Step> steps;
            if (isFromInside) {
                Anchor anchor(walk.scene());
                const auto moves = anchor.follow(narrowed(faces[random() % faces.size()].corners[0]), 0.0);
                insideCount += anchor.depth() > 0 ? 1 : 0;
                const auto from = anchor.surroundings();
                const double unit = std::exp2(from->unitExponent);
                walk.cast({.origin = (ray.origin - from->origin) / unit, .direction = ray.direction / unit}, *from,
                          hit);
                hit.point = from->origin + unit * hit.point;
                if (hit.isFound()) {
                    QCOMPARE(from->nodes.at(hit.root).item, walk.item());
                    steps = stepsTo(*from, hit);
                }
            } else {
                walk.cast(ray, hit);
                steps = hit.choices;
            }
            const auto words = [&] {
                return qPrintable(QStringLiteral("round %1, %2: %3").arg(round).arg(i).arg(hit.t));
            };
            QVERIFY(hit.promise == Promise::Exact);
            bool isOneOfThem = !hit.isFound();
            for (const WrittenFace &face : faces) {
                const auto met = truth::meeting<Wide>(face.corners, wide(ray.origin), wide(ray.direction));
                if (met && met->inside > rounding) {
                    const double slack = rounding / static_cast<double>(met->cosine) / length;
                    QVERIFY2(met->t < 0 || hit.t <= static_cast<double>(met->t) + slack, words());
                }
                if (hit.isFound() && face.item == walk.item() && face.face == hit.face) {
                    const RandomFractal &sample = scene.fractals[scene.fractalOfItem[face.item]];
                    if (mapsOf(*scene.items[face.item].model, steps) == mapsOf(sample.fractal, face.picks)) {
                        isOneOfThem = true;
                        const auto off = static_cast<double>(truth::distance<Wide>(face.corners, wide(hit.point)));
                        const double thinness = met ? static_cast<double>(met->thinness) : HUGE_VAL;
                        QVERIFY2(off <= rounding * (1 + 0.1 * thinness), words());
                        metCount += thinness < 100 ? 1 : 0;
                        ballCount += scene.items[face.item].kind == SceneDescription::Kind::Ball ? 1 : 0;
                    }
                }
            }
            QVERIFY2(isOneOfThem, words());
        }
    }
    QVERIFY2(metCount > 200 && ballCount > 10, qPrintable(QStringLiteral("%1 %2").arg(metCount).arg(ballCount)));
    QVERIFY(!isFromInside || insideCount > 200);
}

namespace {

/// Of a cell among 27, each from 0 to 2.
using Digits = std::array<int, 3>;

bool isHole(const Digits &cell)
{
    return std::ranges::count(cell, 1) > 1;
}

Digits randomCell(std::mt19937_64 &random)
{
    return {static_cast<int>(random() % 3), static_cast<int>(random() % 3), static_cast<int>(random() % 3)};
}

/// The way of a ray along z in a sponge: from a hole to the cell behind it, whose parts before the ray are those with the
/// least z, down to the last level; unless at some level the ray is in the middle in x and in y, which is a hole all along.
struct WayIn {
    /// Of all levels.
    std::vector<Digits> cells;
    /// What has the hole before it.
    std::size_t behind;
};

WayIn randomWayIn(std::mt19937_64 &random, std::size_t levels, std::size_t below)
{
    WayIn way{{}, levels - random() % 6};
    while (way.cells.size() < levels + below) {
        Digits cell = randomCell(random);
        const std::size_t level = way.cells.size() + 1;
        cell[2] = level < way.behind ? cell[2] : level == way.behind ? 2 : 0;
        cell[0] = level == way.behind ? 1 : cell[0];
        if (!isHole(cell)) {
            way.cells.push_back(cell);
        }
    }
    return way;
}

}

void TestSceneRayWalk::deepInASpongeItMeetsWhatTheDigitsSay_data()
{
    QTest::addColumn<int>("levels");
    for (const int levels : {7, 30, 300, 1500}) {
        QTest::addRow("%d levels", levels) << levels;
    }
}

/// The sponge has a side of 3 and parts of a third around the whole numbers.
void TestSceneRayWalk::deepInASpongeItMeetsWhatTheDigitsSay()
{
    QFETCH(const int, levels);
    constexpr std::size_t below = 10;
    const auto depth = static_cast<std::size_t>(levels);
    std::mt19937_64 random(seed(334));
    const AffineMap place = mapFromParts({1, 2, 3}, {10, 20, 30}, glm::dvec3(2));
    SceneRayWalk walk =
        walkOf({{.model = modelOf(QStringLiteral("sierpinski"), 3), .worldFromModel = {glm::dmat3(1.0), {99, 0, 0}}},
                {.model = modelOf(QStringLiteral("menger"), depth + below), .worldFromModel = place}});
    const std::vector<AffineMap> &maps = walk.scene()->items[1].model->graph.set(0).maps;
    const auto mapOf = [&](const Digits &cell) {
        const glm::dvec3 middle(cell[0] - 1, cell[1] - 1, cell[2] - 1);
        return static_cast<std::uint32_t>(std::ranges::find(maps, middle, &AffineMap::translation) - maps.begin());
    };
    for (int round = 0; round < 20; ++round) {
        WayIn way = randomWayIn(random, depth, below);
        const bool isMissed = round % 4 == 3;
        if (isMissed) {
            way.cells[depth + random() % 4] = {1, 1, 0};
        }
        Anchor anchor(walk.scene());
        QVERIFY(anchor.enter({0, 1}));
        glm::dvec3 at(0.0);
        for (std::size_t i = 0; i < way.cells.size(); ++i) {
            if (i < depth) {
                QVERIFY(anchor.enter({0, mapOf(way.cells[i])}));
            } else {
                at +=
                    std::pow(3.0, double(depth) - double(i)) * glm::dvec3(way.cells[i][0] - 1, way.cells[i][1] - 1, 0);
            }
        }
        // the hole is as deep as the cell behind it
        const double distance = uniform(random, 0.1, 0.9) * std::pow(3.0, 1.0 + double(depth - way.behind));
        const double speed = uniform(random, 0.5, 3);
        const glm::dmat3 turned = 0.5 * place.linear;
        at.z = -1.5 - distance;
        RayHit hit;
        const auto from = anchor.surroundings();
        // a hole that goes on is followed only within the cell: beyond, it has 3^18 walls
        const double greatest = isMissed ? (distance + 2.9) / speed : std::numeric_limits<double>::infinity();
        walk.cast({.origin = turned * at, .direction = speed * turned[2], .greatest = greatest}, *from, hit);
        QCOMPARE(hit.isFound(), !isMissed);
        if (isMissed) {
            continue;
        }
        QVERIFY2(std::abs(hit.t * speed - distance) < 1e-12 * (10 + distance),
                 qPrintable(QString::number(hit.t * speed - distance)));
        QCOMPARE(walk.item(), std::size_t(1));
        const std::vector<Step> steps = stepsTo(*from, hit);
        QCOMPARE(steps.size(), way.cells.size());
        for (std::size_t i = 0; i < steps.size(); ++i) {
            QCOMPARE(steps[i].map, mapOf(way.cells[i]));
        }
    }
}

/// A row of cubes, met from one end: as many nodes as of one alone.
void TestSceneRayWalk::itemsBehindWhatIsMetAreNotWalked()
{
    const auto model = modelOf(QStringLiteral("menger"), 3);
    std::vector<SceneItem> items;
    for (int i = 0; i < 20; ++i) {
        items.push_back({.model = model, .worldFromModel = {glm::dmat3(1.0), {0, 0, 10.0 * ((i * 7) % 20)}}});
    }
    SceneRayWalk walk = walkOf(items);
    SceneRayWalk alone = walkOf({items[0]});
    const Ray ray{.origin = {0.6, 0.65, -20}, .direction = {0.001, 0.002, 3}};
    RayHit hit;
    RayHit ofOne;
    walk.cast(ray, hit);
    alone.cast(ray, ofOne);
    QVERIFY(hit.isFound() && hit.t == ofOne.t && walk.item() == 0);
    QCOMPARE(hit.cost.nodeVisits, ofOne.cost.nodeVisits);
    walk.cast({.origin = {0.6, 0.65, 400}, .direction = {0, 0, -1}}, hit);
    QCOMPARE(walk.item(), std::size_t(17)); // 17 · 7 mod 20 is 19
}

void TestSceneRayWalk::aBudgetIsForAllItems()
{
    std::mt19937_64 random(seed(332));
    const auto model = modelOf(QStringLiteral("tree"), 6);
    std::vector<SceneItem> items;
    for (int i = 0; i < 12; ++i) {
        items.push_back(
            {.model = model, .worldFromModel = mapFromParts(randomPoint(random, 2), {0, 30.0 * i, 0}, glm::dvec3(1))});
    }
    SceneRayWalk walk = walkOf(items);
    int cutCount = 0;
    for (int i = 0; i < 60; ++i) {
        const Ray ray{.origin = {0, 1, -12}, .direction = glm::dvec3(0, 0, 12) + randomPoint(random, 2)};
        RayHit truth;
        walk.cast(ray, truth);
        QVERIFY(truth.promise == Promise::Exact && truth.lower == truth.t);
        for (const std::uint64_t budget : {0u, 1u, 7u, 40u, 100'000u}) {
            Ray cheap = ray;
            cheap.nodeBudget = budget;
            RayHit hit;
            walk.cast(cheap, hit);
            QVERIFY(hit.cost.nodeVisits <= budget && hit.t >= truth.t && hit.lower <= truth.t);
            QVERIFY(hit.promise == Promise::UpperBound || (hit.t == truth.t && hit.lower == truth.lower));
            cutCount += hit.promise == Promise::UpperBound ? 1 : 0;
        }
        std::stop_source stop;
        stop.request_stop();
        Ray stopped = ray;
        stopped.stop = stop.get_token();
        RayHit hit;
        walk.cast(stopped, hit);
        QVERIFY(hit.cost.nodeVisits == 0 && (truth.cost.nodeVisits == 0 || hit.promise == Promise::UpperBound));
    }
    QVERIFY(cutCount > 50);
}

void TestSceneRayWalk::whatCannotBeWalkedIsRefused()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    std::stop_source stop;
    stop.request_stop();
    const auto refused = SceneRayWalk::create(sceneOf({{.model = modelOf(mesh), .path = "one.obj"}}), stop.get_token());
    QCOMPARE(refused.error(), std::string("one.obj: cancelled"));
    RayHit hit;
    walkOf({}).cast({}, hit);
    QVERIFY(!hit.isFound() && hit.promise == Promise::Exact);
}

void TestSceneRayWalk::raysTakeNoMemoryOnceItHasGrown()
{
    std::mt19937_64 random(seed(333));
    std::vector<SceneItem> items;
    for (const char *name : {"tree", "menger", "sierpinski"}) {
        items.push_back({.model = modelOf(QString::fromLatin1(name), 4), .worldFromModel = randomPlace(random)});
    }
    SceneRayWalk walk = walkOf(items);
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 origin = randomPoint(random, 12);
        rays.push_back({.origin = origin, .direction = items[i % 3].worldFromModel(randomPoint(random, 1)) - origin});
    }
    RayHit hit;
    const auto castAll = [&] {
        for (const Ray &ray : rays) {
            walk.cast(ray, hit);
        }
    };
    castAll();
    castAll();
    const std::size_t before = allocationCount();
    castAll();
    QCOMPARE(allocationCount(), before);
}

ROMANESCO_TEST(TestSceneRayWalk)

}

#include "testsceneraywalk.moc"
