// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/anchor.h"
#include "tests/core/scene/borders.h"
#include "tests/core/scene/longplaces.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

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

/// Surroundings have what is near on the other side of a border.
class TestNeighbours : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theOtherSideOfABorderIsThere_data();
    void theOtherSideOfABorderIsThere();
    void nothingNearIsMissing_data();
    void nothingNearIsMissing();
    void itIsTheSameByAnyWay();
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
