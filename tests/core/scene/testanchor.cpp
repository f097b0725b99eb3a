// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <format>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/scene/anchor.h"
#include "tests/core/scene/longplaces.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

double frobenius(const glm::dmat3 &m)
{
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

/// Random contractions: turned and of unequal scales, so that no chain of them degenerates. Where they are close, they
/// are so many times as small, and as near to one another.
std::string randomMaps(std::mt19937_64 &random, int levels, double close)
{
    std::string text = "x. \"m.obj\"\n";
    std::string names;
    for (int i = 0; i < 4; ++i) {
        const auto line = [&](const char *name, double least, double most) {
            text += name + std::to_string(i);
            for (int axis = 0; axis < 3; ++axis) {
                text += std::format(" {}", uniform(random, least, most));
            }
            text += '\n';
        };
        const double scale = uniform(random, 0.3, 0.6) * close;
        line("p", 1 - 2 * close, 1);
        line("r", -180, 180);
        line("s", i == 3 ? 0.9 * scale : scale, scale);
        text += "m" + std::to_string(i) + ". (p" + std::to_string(i) + ", r" + std::to_string(i) + ", s"
            + std::to_string(i) + ")\n";
        names += (i ? ", m" : "m") + std::to_string(i);
    }
    return text + "z<x>. [#, " + names + "] x\n<$>. z " + std::to_string(levels) + "\n";
}

void enterAtRandom(Anchor &anchor, std::mt19937_64 &random, std::size_t levels, std::uint32_t maps)
{
    for (std::size_t i = 0; i < levels; ++i) {
        QVERIFY(anchor.enter({0, static_cast<std::uint32_t>(random() % maps)}));
    }
}

}

class TestAnchor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nodesStandWhereTheirMapsSay_data();
    void nodesStandWhereTheirMapsSay();
    void aMillionLevelsDownNodesStandAsExactly();
    void allThatIsSeenFromTheWorldSurroundsAPlace();
    void placesAreTheSmallestNearby();
    void placesFollowWhatIsLookedAt();
    void goingInAndOutDriftsNowhere();
    void bordersAreNotCrossedBackAndForth();
    void whatHasNoExtentIsNotEntered();
    void whatIsFarKeepsItsDirection();
};

void TestAnchor::nodesStandWhereTheirMapsSay_data()
{
    QTest::addColumn<int>("levels");
    QTest::addColumn<double>("close");
    for (const int levels : {0, 1, 2, 5, 20, 100, 1000}) {
        QTest::addRow("%d", levels) << levels << 1.0;
    }
    QTest::newRow("1, close together") << 1 << 1e-6;
    QTest::newRow("30, close together") << 30 << 1e-6;
}

/// Against products in 700 digits. Seen from here an ancestor's parts are off by rounding, as large as they are.
void TestAnchor::nodesStandWhereTheirMapsSay()
{
    QFETCH(const int, levels);
    QFETCH(const double, close);
    std::mt19937_64 random(seed(7));
    double worst = 0;
    for (int round = 0; round < (levels == 1000 ? 1 : 5); ++round) {
        const auto model = modelOf(randomMaps(random, 1200, close));
        const auto scene =
            sceneOf({{.model = model, .worldFromModel = randomPlace(random)},
                     {.model = model, .worldFromModel = mapFromParts({3, 1, 2}, {10, 20, 30}, {-1, 2, 1.5})},
                     {.model = model, .worldFromModel = randomPlace(random)}});
        Anchor anchor(scene);
        QVERIFY(anchor.enter({0, 1}));
        enterAtRandom(anchor, random, static_cast<std::size_t>(levels), 4);
        QCOMPARE(anchor.depth(), std::size_t(levels));

        const auto seen = anchor.surroundings();
        const auto own = std::ranges::find_if(seen->nodes, [&](const Surroundings::Node &node) {
            return node.sharedSteps == seen->path.size() && node.item == seen->pathItem && node.steps.empty()
                && !node.isMeshOnly;
        });
        QVERIFY(own != seen->nodes.end());
        const WorldNodes worldFrom(*seen);
        const OracleMap here = worldFrom(*own);
        const Long unit = here.size() / frobenius(own->hereFromNode.linear);
        QVERIFY(std::abs(static_cast<double>(log2(unit)) - seen->unitExponent) < 1e-9);
        QVERIFY(levels < 20 || close < 1 || seen->nodes.size() > 40);
        for (const Surroundings::Node &node : seen->nodes) {
            const OracleMap map = worldFrom(node);
            const double size = std::max(1.0, frobenius(node.hereFromNode.linear));
            // a step of the path may be as large as ten of these
            const double rounding = 1e-14 * 10 * size + 1e-15 * glm::length(node.hereFromNode.translation);
            for (std::size_t i = 0; i < 3; ++i) {
                const auto axis = static_cast<glm::length_t>(i);
                const Long offset = (map.translation[i] - here.translation[i]) / unit;
                const double off = std::abs(static_cast<double>(offset - node.hereFromNode.translation[axis]));
                worst = std::max(worst, off / rounding);
                for (std::size_t column = 0; column < 3; ++column) {
                    const double number = node.hereFromNode.linear[static_cast<glm::length_t>(column)][axis];
                    worst = std::max(worst,
                                     std::abs(static_cast<double>(map.columns[column][i] / unit - number)) / rounding);
                }
            }
        }
    }
    QVERIFY2(worst <= 1.0, qPrintable(QString::number(worst)));
}

/// Against products in 700 digits from where all ways are one: what is above is the same for all of them.
void TestAnchor::aMillionLevelsDownNodesStandAsExactly()
{
    constexpr std::size_t levels = 999'999; // and the item's root
    const auto model = modelOf(QStringLiteral("menger"), 1'000'100);
    Anchor anchor(sceneOf({{.model = model}}));
    QVERIFY(anchor.enter({0, 0}));
    std::mt19937_64 random(seed(11));
    enterAtRandom(anchor, random, levels, 20);
    QCOMPARE(anchor.depth(), levels);
    QVERIFY(!anchor.enter({0, 0}));

    const auto seen = anchor.surroundings();
    QVERIFY(std::abs(seen->unitExponent + levels * std::log2(3.0)) < 1e-3);
    QVERIFY(seen->nodes.size() > 40);
    const auto first = std::ranges::min(seen->nodes, {}, &Surroundings::Node::sharedSteps).sharedSteps;
    QVERIFY(levels - first < 1'000);
    const auto from = [&](const OracleMap &outer, const Step &step) {
        return outer.then(model->graph.set(step.set).maps[step.map]);
    };
    std::vector<OracleMap> along{{}};
    for (std::size_t i = first; i < levels; ++i) {
        along.push_back(from(along.back(), seen->path[i]));
    }
    const OracleMap &here = along.back();
    const Long unit = here.columns[0][0];
    for (const Surroundings::Node &node : seen->nodes) {
        OracleMap map = along[node.sharedSteps - first];
        for (const Step &step : node.steps) {
            map = from(map, step);
        }
        const double size = std::max(1.0, node.hereFromNode.linear[0].x);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<glm::length_t>(i);
            const Long offset = (map.translation[i] - here.translation[i]) / unit;
            const double off = std::abs(static_cast<double>(offset - node.hereFromNode.translation[axis]));
            QVERIFY2(off <= 1e-13 * size, qPrintable(QString::number(off / size)));
            const Long number = map.columns[i][i] / unit;
            QVERIFY(std::abs(static_cast<double>(number - node.hereFromNode.linear[axis][axis])) <= 1e-13 * size);
        }
    }
}

/// Each copy of a small fractal is below exactly one node.
void TestAnchor::allThatIsSeenFromTheWorldSurroundsAPlace()
{
    std::mt19937_64 random(seed(3));
    for (int round = 0; round < 50; ++round) {
        const Written written = randomScene(random);
        const auto scene = sceneOf(written.items);
        const auto copiesBelow = [&](const std::shared_ptr<const Surroundings> &seen) {
            std::vector<glm::dvec3> places;
            for (const Surroundings::Node &node : seen->nodes) {
                const Model &model = *scene->items[node.item].model;
                StateTable table(model.graph);
                std::vector<std::pair<StateId, AffineMap>> open{{table.find(node.state), node.hereFromNode}};
                while (!open.empty()) {
                    const auto [state, map] = open.back();
                    open.pop_back();
                    const Expansion expansion = table.expansion(state);
                    if (expansion.hasLeaf || node.isMeshOnly) {
                        places.push_back(map(model.mesh->vertices.front()));
                    }
                    for (const ChildRange &range : expansion.ranges) {
                        for (std::uint32_t i = range.firstMap; i < range.endMap && !node.isMeshOnly; ++i) {
                            open.emplace_back(range.next, map * table.graph().set(range.set).maps[i]);
                        }
                    }
                }
            }
            return places;
        };
        Anchor anchor(scene);
        const auto fromWorld = copiesBelow(anchor.surroundings());
        const std::vector<Anchor::Move> moves = anchor.follow(randomPoint(random, 4), 0.0);
        const auto seen = anchor.surroundings();
        auto fromHere = copiesBelow(seen);
        QCOMPARE(fromHere.size(), fromWorld.size());
        for (const glm::dvec3 &place : fromHere) {
            QVERIFY(glm::distance(place, seen->nearby.centre) <= seen->reach * (1 + 1e-12));
        }
        // Back to the world, each has its place.
        for (glm::dvec3 &place : fromHere) {
            for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
                place = place * move->scale + move->offset;
            }
        }
        for (const glm::dvec3 &place : fromWorld) {
            const auto near =
                std::ranges::min_element(fromHere, {}, [&](const glm::dvec3 &q) { return glm::distance(q, place); });
            QVERIFY(glm::distance(*near, place) < 1e-11);
            fromHere.erase(near);
        }
    }
}

namespace {

/// A node in twice whose bound a ball lies, and so in all above it.
struct Holding {
    std::vector<Step> path;
    /// Of its bound, in the world.
    double size;
};

/// All of them below the root of a scene's only item.
std::vector<Holding> allHolding(const Scene &scene, const glm::dvec3 &point, double radius)
{
    struct Open {
        StateId state;
        AffineMap map;
        Holding node;
    };
    const SceneItem &item = scene.items.front();
    StateTable table(item.model->graph);
    const auto holds = [&](const Sphere &bound) {
        return glm::distance(bound.centre, point) + radius <= 2.0 * bound.radius;
    };
    const Sphere whole = boundingSphere(item);
    std::vector<Open> open{{table.find(Positions{0}), item.worldFromModel, {{}, whole.radius}}};
    open.resize(holds(whole) ? 1 : 0, open.front());
    std::vector<Holding> found;
    while (!open.empty()) {
        const Open at = open.back();
        open.pop_back();
        found.push_back(at.node);
        const std::vector<Sphere> bounds = table.childBounds(at.state);
        std::size_t number = 0;
        for (const ChildRange &range : Expansion(table.expansion(at.state)).ranges) {
            for (std::uint32_t map = range.firstMap; map < range.endMap; ++map, ++number) {
                const double size = operatorNorm(at.map.linear) * bounds[number].radius;
                if (holds({at.map(bounds[number].centre), size})) {
                    open.push_back({range.next, at.map * table.graph().set(range.set).maps[map], {at.node.path, size}});
                    open.back().node.path.push_back({range.set, map});
                }
            }
        }
    }
    return found;
}

/// Coordinates of a place, in the world.
glm::dvec3 inWorld(const Anchor &anchor, const glm::dvec3 &here)
{
    const auto all = anchor.surroundings();
    return all->origin + std::exp2(all->unitExponent) * here;
}

}

/// Against all nodes there are, from the world and from any other place; the moves tell where it was.
void TestAnchor::placesAreTheSmallestNearby()
{
    std::mt19937_64 random(seed(11));
    int heldCount = 0;
    int smallestCount = 0;
    for (int round = 0; round < 60; ++round) {
        const std::string maps = randomMaps(random, 4, 1);
        const auto scene = sceneOf(
            {{.model = modelOf(maps), .worldFromModel = mapFromParts({1, 2, 3}, {10, 20, 30}, glm::dvec3(1.5))}});
        for (int i = 0; i < 10; ++i) {
            Anchor anchor(scene);
            if (i % 2) {
                QVERIFY(anchor.enter({0, 0}));
                enterAtRandom(anchor, random, random() % 4, 4);
            }
            // near a copy, or far from all
            Anchor other(scene);
            QVERIFY(other.enter({0, 0}));
            enterAtRandom(other, random, random() % 5, 4);
            const glm::dvec3 point = inWorld(other, other.bound().centre + randomPoint(random, i % 5 ? 2 : 50));
            const double radius = i % 3 ? 0.0 : 0.3 * std::exp2(other.surroundings()->unitExponent);

            const double unit = std::exp2(anchor.surroundings()->unitExponent);
            glm::dvec3 p = (point - anchor.surroundings()->origin) / unit;
            for (const Anchor::Move &move : anchor.follow(p, radius / unit)) {
                p = move(p);
            }
            QVERIFY(glm::distance(inWorld(anchor, p), point) < 1e-12 * (10 + glm::length(point)));

            const std::vector<Holding> holding = allHolding(*scene, point, radius);
            const auto own = std::ranges::find(holding, anchor.surroundings()->path, &Holding::path);
            if (i % 2 == 0) {
                QCOMPARE(anchor.isInWorld(), holding.empty());
                QVERIFY(holding.empty() || own != holding.end());
            }
            if (!holding.empty()) {
                const double least = std::ranges::min(holding, {}, &Holding::size).size;
                ++heldCount;
                smallestCount += own != holding.end() && 0.6 * own->size <= least ? 1 : 0;
            }
            // less deep, as far as it goes
            const auto shallow = sceneOf({{.model = modelOf(maps.substr(0, maps.rfind(' ')) + " 1\n"),
                                           .worldFromModel = scene->items[0].worldFromModel}});
            for (const Anchor::Move &move : anchor.moveTo(shallow)) {
                p = move(p);
            }
            QVERIFY(anchor.depth() <= 1);
            QVERIFY(glm::distance(inWorld(anchor, p), point) < 1e-12 * (10 + glm::length(point)));
        }
    }
    // Sixteen ways down show nine in ten and more of them, one way 432.
    QVERIFY2(heldCount > 500 && 10 * smallestCount > 9 * heldCount,
             qPrintable(QStringLiteral("%1 of %2").arg(smallestCount).arg(heldCount)));
}

/// Down to the last level of a sponge of a thousand, and up again.
void TestAnchor::placesFollowWhatIsLookedAt()
{
    const auto scene = std::make_shared<const Scene>(romanesco::sceneOf(modelOf(QStringLiteral("menger"), 1000)));
    Anchor anchor(scene);
    glm::dvec3 p(5.0, 4.0, -6.0);
    std::size_t frames = 0;
    std::size_t rebased = 0;
    const auto follow = [&] {
        for (const Anchor::Move &move : anchor.follow(p, 0.0)) {
            p = move(p);
            ++rebased;
        }
        ++frames;
    };
    while (anchor.depth() < 1000 && frames < 5000) {
        // towards a corner of what is here
        const Sphere bound = anchor.bound();
        const glm::dvec3 target = bound.centre + bound.radius / std::sqrt(3.0) * glm::dvec3(1, 1, -1);
        p = target + 0.8 * (p - target);
        follow();
        QVERIFY(glm::distance(p, anchor.bound().centre) <= 4.0 * anchor.bound().radius || anchor.isInWorld());
        QVERIFY(std::abs(glm::length(anchor.surroundings()->nodes.front().hereFromNode.linear[0]) - 1) < 1e-9
                || frames > 100);
    }
    QCOMPARE(anchor.depth(), 1000u);
    QCOMPARE(rebased, 1001u);
    const double expected = 1000 * std::log(3.0) / -std::log(0.8);
    QVERIFY(std::abs(double(frames) - expected) < 20);
    while (!anchor.isInWorld() && frames < 10'000) {
        p = anchor.bound().centre + (p - anchor.bound().centre) / 0.8 + glm::dvec3(0, 1e-3, 0);
        follow();
    }
    QVERIFY(anchor.isInWorld());
    QVERIFY2(glm::distance(p, anchor.bound().centre) < 10 * anchor.bound().radius, "not lost");
}

void TestAnchor::goingInAndOutDriftsNowhere()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("menger"), 2000)}});
    Anchor anchor(scene);
    QVERIFY(anchor.enter({0, 0}));
    std::mt19937_64 random(seed(4));
    const std::uint32_t maps = 20;
    enterAtRandom(anchor, random, 1000, maps);
    glm::dvec3 p = anchor.bound().centre + glm::dvec3(0.2, 0.1, -0.3);
    glm::dvec3 target = p + glm::dvec3(0.05, 0.02, 0.1);
    std::size_t rebased = 0;
    const auto follow = [&] {
        for (const Anchor::Move &move : anchor.follow(p, 0.0)) {
            p = move(p);
            target = move(target);
            ++rebased;
        }
    };
    const auto goOutAndIn = [&] {
        for (int frame = 0; frame < 20; ++frame) {
            p = target + (frame < 10 ? 1.5 : 1.0 / 1.5) * (p - target);
            follow();
        }
    };
    goOutAndIn();
    const std::vector<Step> path = anchor.surroundings()->path;
    const glm::dvec3 start = p;
    const glm::dvec3 first = target;
    for (int cycle = 0; cycle < 50; ++cycle) {
        goOutAndIn();
    }
    QVERIFY(rebased > 100);
    // In units of what is looked at, which is a thousand pixels large: 1e-6 of a pixel.
    QVERIFY(anchor.depth() > 990);
    QVERIFY(anchor.surroundings()->path == path);
    QVERIFY2(glm::distance(p, start) < 1e-9 && glm::distance(target, first) < 1e-9,
             qPrintable(QString::number(glm::distance(p, start))));
}

void TestAnchor::bordersAreNotCrossedBackAndForth()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("menger"), 30)}});
    Anchor anchor(scene);
    QVERIFY(anchor.enter({0, 0}));
    std::mt19937_64 random(seed(4));
    enterAtRandom(anchor, random, 10, 20);
    const Sphere bound = anchor.bound();
    glm::dvec3 p = bound.centre + glm::dvec3(0, 0, -2.0001) * bound.radius;
    int rebased = 0;
    for (int frame = 0; frame < 100; ++frame) {
        glm::dvec3 step(0, 0, (frame % 2 ? 1.0 : -1.0) * 2e-4 * bound.radius);
        for (const Anchor::Move &move : anchor.follow(p, 0.4 * bound.radius)) {
            p = move(p);
            ++rebased;
        }
        p += step;
    }
    QVERIFY2(rebased <= 6, qPrintable(QString::number(rebased)));
}

void TestAnchor::whatHasNoExtentIsNotEntered()
{
    const auto model = modelOf(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    const auto scene = sceneOf({{.model = model, .worldFromModel = {glm::dmat3(0.0), {1, 2, 3}}}, {.model = model}});
    Anchor anchor(scene);
    QVERIFY(!anchor.enter({0, 0}));
    QVERIFY(!anchor.enter({0, 2}));
    QVERIFY(anchor.isInWorld());
    QVERIFY(anchor.follow({1, 2, 3}, 0.0).empty());
    QVERIFY(anchor.enter({0, 1}));
    QVERIFY2(!anchor.enter({0, 0}), "a mesh has no parts");
}

void TestAnchor::whatIsFarKeepsItsDirection()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("menger"), 2000)}});
    Anchor anchor(scene);
    QVERIFY(anchor.enter({0, 0}));
    const glm::dvec3 light(20, 40, -10);
    for (int level = 0; level < 2000;) {
        const glm::dvec3 here = anchor.surroundings()->hereFromWorld(light);
        const glm::dvec3 direction = glm::normalize(here);
        QVERIFY(std::isfinite(glm::length(here)));
        QVERIFY(glm::distance(direction, glm::normalize(light - anchor.surroundings()->origin)) < 1e-12);
        do {
            QVERIFY(anchor.enter({0, 0}));
        } while (++level % 100);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestAnchor)
#include "testanchor.moc"
