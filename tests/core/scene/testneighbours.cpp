// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/anchor.h"
#include "core/scene/sceneraywalk.h"
#include "tests/core/scene/longplaces.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::string withMaps(const std::vector<std::string> &maps, int depth)
{
    std::string text = "x. \"m.obj\"\n";
    std::string names;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string name = std::to_string(i);
        text += std::format("m{}. {}\n", i, maps[i]);
        names += (i ? ", m" : "m") + name;
    }
    return std::format("{}z<x>. [{}] x\n<$>. z {}\n", text, names, depth);
}

using Cell = std::array<int, 3>;

/// Of 64 cells those on the surface, but for the middles of its sides: their places are exact, as a third's are not.
std::vector<Cell> shellCells()
{
    std::vector<Cell> cells;
    for (int i = 0; i < 64; ++i) {
        const Cell cell{i % 4, i / 4 % 4, i / 16};
        if (std::ranges::count_if(cell, [](int x) { return x == 1 || x == 2; }) < 2) {
            cells.push_back(cell);
        }
    }
    return cells;
}

std::uint32_t shellMap(const Cell &cell)
{
    const std::vector<Cell> cells = shellCells();
    return static_cast<std::uint32_t>(std::ranges::find(cells, cell) - cells.begin());
}

/// A vector is three numbers in a line of its own.
std::string text(const std::vector<std::array<std::string, 3>> &maps, int depth)
{
    std::string vectors;
    std::vector<std::string> parts;
    for (const auto &map : maps) {
        for (const std::string &part : map) {
            vectors += "v " + part + "\n";
        }
        const std::size_t last = 3 * parts.size() + 3;
        parts.push_back(std::format("({}, {}, {})", last - 2, last - 1, last));
    }
    return vectors + withMaps(parts, depth);
}

/// A way down on which another, which parts from it at once, comes as near all the time.
struct Border {
    std::shared_ptr<const Scene> scene;
    std::vector<std::uint32_t> path;
    std::size_t otherItem = 0;
    std::vector<std::uint32_t> other;
};

Border borderOf(const QString &name, std::size_t depth)
{
    const int levels = static_cast<int>(depth) + 5;
    Border border;
    if (name == QLatin1String("point") || name == QLatin1String("items")) {
        const auto model = modelOf(QStringLiteral("sierpinski"), depth + 5);
        border.path.assign(depth, 1);
        border.other.assign(depth, 0);
        border.scene = sceneOf({{.model = model}, {.model = model, .worldFromModel = {glm::dmat3(1.0), {2, 0, 0}}}});
        border.otherItem = 1;
        if (name == QLatin1String("point")) {
            border.scene = sceneOf({{.model = model}});
            border.otherItem = 0;
            std::swap(border.path[0], border.other[0]);
        }
        return border;
    }
    if (name == QLatin1String("turned") || name == QLatin1String("uneven")) {
        // copies of one place, in which the third map stays at the origin
        const bool isTurned = name == QLatin1String("turned");
        border.scene =
            sceneOf({{.model = modelOf(
                          text({{"0.75 0.5 0.5", "10 20 30", "0.25 0.25 0.25"},
                                {"0.75 0.5 0.5", "-100 50 170", isTurned ? "0.25 0.25 0.25" : "0.2 0.3 0.25"},
                                {"0 0 0", isTurned ? "33 71 -12" : "0 0 90", isTurned ? "0.5 0.5 0.5" : "0.5 0.32 0.4"},
                                {"-0.6 0.7 0.1", "60 0 10", "0.3 0.3 0.3"}},
                               levels)),
                      .worldFromModel = mapFromParts({1, 2, 3}, {10, 20, 30}, glm::dvec3(3))}});
        border.path.assign(depth, 2);
        border.other.assign(depth, 2);
        border.path[0] = 0;
        border.other[0] = 1;
        // not quite to where they touch
        std::ranges::fill(std::span(border.path).last(2), 3);
        return border;
    }
    std::vector<std::array<std::string, 3>> maps;
    for (const Cell &cell : shellCells()) {
        maps.push_back(
            {std::format("{} {} {}", 0.75 * cell[0], 0.75 * cell[1], 0.75 * cell[2]), "0 0 0", "0.25 0.25 0.25"});
    }
    border.scene = sceneOf({{.model = modelOf(text(maps, levels))}});
    const bool isEdge = name == QLatin1String("edge");
    border.path.push_back(shellMap({0, 0, 0}));
    border.other.push_back(shellMap({1, 0, 0}));
    std::mt19937_64 random(seed(9));
    while (border.path.size() < depth) {
        const int across = isEdge ? 3 : static_cast<int>(random() % 4);
        const int along = across % 3 ? 0 : static_cast<int>(random() % 4);
        border.path.push_back(shellMap({3, across, along}));
        border.other.push_back(shellMap({0, across, along}));
    }
    return border;
}

Anchor anchorAt(const Border &border)
{
    Anchor anchor(border.scene);
    if (!anchor.enter({0, 0})) {
        qFatal("no item");
    }
    for (const std::uint32_t map : border.path) {
        if (!anchor.enter({0, map})) {
            qFatal("no way");
        }
    }
    return anchor;
}

std::vector<Step> stepsOf(const Surroundings &all, const Surroundings::Node &node)
{
    std::vector<Step> steps(all.path.begin(), all.path.begin() + static_cast<std::ptrdiff_t>(node.sharedSteps));
    steps.insert(steps.end(), node.steps.begin(), node.steps.end());
    return steps;
}

bool leadsTo(const Surroundings &all, const Surroundings::Node &node, std::size_t item,
             const std::vector<std::uint32_t> &maps)
{
    const std::vector<Step> steps = stepsOf(all, node);
    return node.item == item && !node.isMeshOnly && steps.size() <= maps.size()
        && std::ranges::equal(steps, std::span(maps).first(steps.size()), {}, &Step::map);
}

OracleMap hereOf(const Border &border)
{
    OracleMap map = OracleMap().then(border.scene->items[0].worldFromModel);
    for (const std::uint32_t i : border.path) {
        map = map.then(border.scene->items[0].model->graph.set(0).maps[i]);
    }
    return map;
}

Long dot(const OracleVector &a, const OracleVector &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

OracleVector cross(const OracleVector &a, const OracleVector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

OracleVector difference(const OracleVector &a, const OracleVector &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// What a map puts at a place, by Cramer's rule.
glm::dvec3 preimage(const OracleMap &map, const OracleVector &place)
{
    const OracleVector to = difference(place, map.translation);
    const OracleVector &a = map.columns[0];
    const OracleVector &b = map.columns[1];
    const OracleVector &c = map.columns[2];
    const Long volume = dot(a, cross(b, c));
    return {static_cast<double>(dot(to, cross(b, c)) / volume), static_cast<double>(dot(a, cross(to, c)) / volume),
            static_cast<double>(dot(a, cross(b, to)) / volume)};
}

/// At a place near what is here, how far a node is from where its maps put it, in units of here.
double offNearHere(const Surroundings::Node &node, const OracleMap &map, const OracleMap &here, const Long &unit)
{
    const glm::dvec3 p = preimage(
        map, {here.translation[0] + 0.3 * unit, here.translation[1] - 0.7 * unit, here.translation[2] + 0.2 * unit});
    const OracleVector exact = map.then({glm::dmat3(1.0), p}).translation;
    OracleVector found;
    for (int i = 0; i < 3; ++i) {
        Long sum = node.hereFromNode.translation[i];
        for (int column = 0; column < 3; ++column) {
            sum += Long(node.hereFromNode.linear[column][i]) * p[column];
        }
        found[static_cast<std::size_t>(i)] = sum;
    }
    double off = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        off = std::max(off, std::abs(static_cast<double>((exact[i] - here.translation[i]) / unit - found[i])));
    }
    return off;
}

}

class TestNeighbours : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theOtherSideOfABorderIsThere_data();
    void theOtherSideOfABorderIsThere();
    void nothingNearIsMissing_data();
    void nothingNearIsMissing();
    void itIsTheSameByAnyWay();
    void picksAcrossNameTheOtherSide_data();
    void picksAcrossNameTheOtherSide();
    void placesCrossBorders_data();
    void placesCrossBorders();
    void crowdsAreCutShort();
};

void TestNeighbours::theOtherSideOfABorderIsThere_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    for (const char *name : {"point", "items", "plane", "edge", "turned", "uneven"}) {
        for (const int depth : {3, 40, 200, 1000}) {
            QTest::addRow("%s, %d", name, depth) << QString::fromLatin1(name) << depth;
        }
    }
}

/// Against products in 700 digits.
void TestNeighbours::theOtherSideOfABorderIsThere()
{
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    const Border border = borderOf(name, static_cast<std::size_t>(depth));
    const Anchor anchor = anchorAt(border);
    const auto all = anchor.surroundings();
    std::size_t otherCount = 0;
    const OracleMap here = hereOf(border);
    const Surroundings::Node &own = *std::ranges::find_if(all->nodes, [&](const Surroundings::Node &node) {
        return node.sharedSteps == all->path.size() && node.steps.empty() && node.item == 0;
    });
    double squares = 0.0;
    for (int i = 0; i < 3; ++i) {
        squares += glm::dot(own.hereFromNode.linear[i], own.hereFromNode.linear[i]);
    }
    const Long unit = here.size() / std::sqrt(squares);
    const WorldNodes worldFrom(*all);
    double worst = 0.0;
    double largest = 0.0;
    for (const Surroundings::Node &node : all->nodes) {
        otherCount += leadsTo(*all, node, border.otherItem, border.other) ? 1 : 0;
        if (node.steps.size() > 1 || node.item != 0) {
            worst = std::max(worst, offNearHere(node, worldFrom(node), here, unit));
            largest = std::max(largest, glm::length(node.hereFromNode.linear[0]));
        }
    }
    QCOMPARE(otherCount, std::size_t(1));
    QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
    QVERIFY2(largest < 1.6e10, qPrintable(QString::number(largest)));
    QVERIFY(depth < 40 || worst > 0.0);
}

void TestNeighbours::nothingNearIsMissing_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<double>("distance");
    QTest::newRow("point") << "point" << 60 << 30.0;
    QTest::newRow("items") << "items" << 60 << 30.0;
    QTest::newRow("plane") << "plane" << 24 << 3.0;
    QTest::newRow("edge") << "edge" << 24 << 3.0;
    QTest::newRow("turned") << "turned" << 60 << 30.0;
    QTest::newRow("uneven") << "uneven" << 60 << 30.0;
}

/// All nodes of about the size of what is here that are near, found from the world down, are below exactly one.
void TestNeighbours::nothingNearIsMissing()
{
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    QFETCH(const double, distance);
    const Border border = borderOf(name, static_cast<std::size_t>(depth));
    const auto all = anchorAt(border).surroundings();
    const OracleMap here = hereOf(border);
    const Long unit = here.size();
    struct Open {
        std::size_t item;
        std::vector<std::uint32_t> maps;
        OracleMap map;
    };
    std::vector<Open> open;
    for (std::size_t i = 0; i < border.scene->items.size(); ++i) {
        open.push_back({i, {}, OracleMap().then(border.scene->items[i].worldFromModel)});
    }
    // All of these fractals are within 2 of their origins, but for the sponge, which is within 6.
    const double radius = name == QLatin1String("plane") || name == QLatin1String("edge") ? 3.0 * std::sqrt(3.0) : 2.0;
    int nearCount = 0;
    int acrossCount = 0;
    while (!open.empty()) {
        const Open at = std::move(open.back());
        open.pop_back();
        const OracleVector away = difference(at.map.translation, here.translation);
        if (sqrt(dot(away, away)) > distance * unit + radius * at.map.size()) {
            continue;
        }
        if (at.map.size() > 1.01 * unit) {
            const std::vector<AffineMap> &maps = border.scene->items[at.item].model->graph.set(0).maps;
            for (std::uint32_t i = 0; i < maps.size(); ++i) {
                open.push_back({at.item, at.maps, at.map.then(maps[i])});
                open.back().maps.push_back(i);
            }
            continue;
        }
        ++nearCount;
        std::size_t count = 0;
        for (const Surroundings::Node &node : all->nodes) {
            if (leadsTo(*all, node, at.item, at.maps)) {
                ++count;
                acrossCount += node.sharedSteps == 0 ? 1 : 0;
            }
        }
        QCOMPARE(count, std::size_t(1));
    }
    QVERIFY2(nearCount > 100 && acrossCount > 50,
             qPrintable(QStringLiteral("%1 nodes, %2 of them across").arg(nearCount).arg(acrossCount)));
}

/// Level by level, up and down again in any order, from one border to another, and at once.
void TestNeighbours::itIsTheSameByAnyWay()
{
    Border border = borderOf(QStringLiteral("edge"), 400);
    std::vector<Anchor> places{Anchor(border.scene)};
    QVERIFY(places.front().enter({0, 0}));
    const auto goDown = [&](const Border &to, std::size_t from) {
        for (std::size_t i = from; i < to.path.size(); ++i) {
            places.push_back(places.back());
            QVERIFY(places.back().enter({0, to.path[i]}));
            (void)places.back().surroundings();
        }
    };
    goDown(border, 0);
    border.path[150] = shellMap({2, 3, 0});
    places.push_back(places[150]);
    goDown(border, 150);
    std::mt19937_64 random(seed(5));
    for (int i = 0; i < 200; ++i) {
        const Anchor &place = places[random() % places.size()];
        const auto found = place.surroundings();
        Anchor again(border.scene);
        QVERIFY(again.enter({0, 0}));
        for (const Step &step : found->path) {
            QVERIFY(again.enter(step));
        }
        const auto expected = again.surroundings();
        QCOMPARE(found->nodes.size(), expected->nodes.size());
        for (std::size_t k = 0; k < found->nodes.size(); ++k) {
            const Surroundings::Node &a = found->nodes[k];
            const Surroundings::Node &b = expected->nodes[k];
            QVERIFY(stepsOf(*found, a) == stepsOf(*expected, b) && a.state == b.state);
            // numbers may be of other lengths
            const double off = glm::distance(a.hereFromNode.translation, b.hereFromNode.translation)
                + glm::distance(a.hereFromNode.linear[0], b.hereFromNode.linear[0]);
            QVERIFY(off <= 1e-15 * glm::length(a.hereFromNode.linear[0]));
        }
    }
}

void TestNeighbours::picksAcrossNameTheOtherSide_data()
{
    QTest::addColumn<int>("depth");
    for (const int depth : {20, 200, 1000}) {
        QTest::addRow("%d", depth) << depth;
    }
}

/// Rays from near the touching point to the middles of the copies at it: the four of the other side and those of this.
void TestNeighbours::picksAcrossNameTheOtherSide()
{
    QFETCH(const int, depth);
    for (const char *name : {"point", "items"}) {
        const Border border = borderOf(QString::fromLatin1(name), static_cast<std::size_t>(depth));
        const auto all = anchorAt(border).surroundings();
        SceneRayWalk walk = SceneRayWalk::create(border.scene).value();
        const FractalGraph &graph = border.scene->items[0].model->graph;
        // The origin of here is in its ground's middle, below its top; the touching point is at its corner.
        const glm::dvec3 corner =
            (border.path.back() == 1 ? 1.0 : -1.0) * glm::dvec3(1, 0, 0) + glm::dvec3(0, 0, 0.57736);
        for (const bool isAcross : {true, false}) {
            for (std::uint32_t map = 0; map < 4; ++map) {
                // the copy's middle, seen from the corner: from the other side the one beyond it
                const AffineMap &step = graph.set(0).maps[map];
                const glm::dvec3 middle = step(glm::dvec3(0, 0.4, 0));
                const glm::dvec3 shift = isAcross ? 2.0 * glm::dvec3(corner.x, 0, 0) : glm::dvec3(0.0);
                RayHit hit;
                const glm::dvec3 origin = middle + shift + glm::dvec3(0, -8, 0);
                walk.cast({.origin = origin, .direction = {0, 1, 0}, .width = 1e-3}, *all, hit);
                QVERIFY(hit.isFound());
                std::vector<Step> steps = stepsOf(*all, all->nodes[hit.root]);
                steps.insert(steps.end(), hit.choices.begin(), hit.choices.end());
                std::vector<std::uint32_t> maps;
                std::ranges::transform(steps, std::back_inserter(maps), &Step::map);
                QCOMPARE(all->nodes[hit.root].item, isAcross ? border.otherItem : std::size_t(0));
                QVERIFY(maps.size() > border.path.size());
                QVERIFY(std::ranges::equal(std::span(maps).first(border.path.size()),
                                           isAcross ? border.other : border.path));
                QCOMPARE(maps[border.path.size()], map);
                QCOMPARE(walk.item(), all->nodes[hit.root].item);
            }
        }
    }
}

void TestNeighbours::placesCrossBorders_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    for (const char *name : {"point", "items", "plane"}) {
        for (const int depth : {5, 20, 60, 1000}) {
            QTest::addRow("%s, %d", name, depth) << QString::fromLatin1(name) << depth;
        }
    }
}

/// To the other side and back, with a mark that is counted from the place: it comes back to where it was.
void TestNeighbours::placesCrossBorders()
{
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    const Border border = borderOf(name, static_cast<std::size_t>(depth));
    Anchor anchor = anchorAt(border);
    const auto there = anchor.surroundings();
    const auto other = std::ranges::find_if(there->nodes, [&](const Surroundings::Node &node) {
        return leadsTo(*there, node, border.otherItem, border.other);
    });
    QVERIFY(other != there->nodes.end());
    AffineMap inside = other->hereFromNode;
    for (std::size_t i = stepsOf(*there, *other).size(); i < border.other.size(); ++i) {
        inside = inside * border.scene->items[0].model->graph.set(0).maps[border.other[i]];
    }
    const Sphere own = anchor.bound();
    // far inside a part that does not touch the border
    const std::vector<AffineMap> &parts = border.scene->items[0].model->graph.set(0).maps;
    const auto within = [](AffineMap map, const AffineMap &part) {
        for (int i = 0; i < 4; ++i) {
            map = map * part;
        }
        return map(glm::dvec3(0.1, 0.2, 0.1));
    };
    const glm::dvec3 target = within(inside, parts.back());
    const glm::dvec3 home = within({anchor.surroundings()->nodes.front().hereFromNode.linear, glm::dvec3(0.0)},
                                   name == QLatin1String("plane") ? parts.front() : parts.back());
    glm::dvec3 p = target;
    glm::dvec3 mark = own.centre;
    glm::dvec3 back = home;
    const auto follow = [&] {
        for (const Anchor::Move &move : anchor.follow(p, 0.0)) {
            p = move(p);
            mark = move(mark);
            back = move(back);
        }
    };
    const auto pathNow = [&] {
        std::vector<std::uint32_t> maps;
        const auto now = anchor.surroundings();
        std::ranges::transform(now->path, std::back_inserter(maps), &Step::map);
        return maps;
    };
    follow();
    QCOMPARE(anchor.surroundings()->pathItem, border.otherItem);
    std::vector<std::uint32_t> maps = pathNow();
    QVERIFY(maps.size() >= border.other.size());
    QVERIFY(std::ranges::equal(std::span(maps).first(border.other.size()), border.other));
    p = back;
    follow();
    maps = pathNow();
    QCOMPARE(anchor.surroundings()->pathItem, std::size_t(0));
    QVERIFY(std::ranges::equal(std::span(maps).first(border.path.size()), border.path));
    // up to the node that it was at
    const double unit = std::exp2(there->unitExponent - anchor.surroundings()->unitExponent);
    glm::dvec3 off = (mark - back) / unit - (own.centre - home);
    QVERIFY2(glm::length(off) < 1e-6, qPrintable(QString::number(glm::length(off))));
    QVERIFY(glm::distance(p, anchor.bound().centre) <= 4.0 * anchor.bound().radius);
}

/// Copies that lie within each other are four times as many at each level, and what does not shrink is divided without end.
void TestNeighbours::crowdsAreCutShort()
{
    const auto turned = [](const char *angles) {
        return std::array<std::string, 3>{"0 0 0", angles, "0.25 0.25 0.25"};
    };
    const std::array<std::string, 3> whole{"0.5 0 0", "0 0 0", "1 1 1"};
    const auto crowded = sceneOf(
        {{.model = modelOf(text({turned("0 0 0"), turned("0 0 90"), turned("0 90 0"), turned("90 0 0")}, 300))}});
    const auto shifted = sceneOf({{.model = modelOf(text({turned("0 0 0"), whole}, 300))}});
    for (const auto &scene : {crowded, shifted}) {
        Anchor anchor(scene);
        QVERIFY(anchor.enter({0, 0}));
        for (int i = 0; i < 250; ++i) {
            QVERIFY(anchor.enter({0, 0}));
        }
        const std::size_t count = anchor.surroundings()->nodes.size();
        QVERIFY2(count >= 16 && count < 100, qPrintable(QString::number(count)));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestNeighbours)
#include "testneighbours.moc"
