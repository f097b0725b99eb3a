// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <iterator>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/anchor.h"
#include "core/scene/sceneraywalk.h"
#include "tests/core/scene/borders.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// Rays and places go across borders, and name what is there.
class TestAcrossBorders : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picksAcrossNameTheOtherSide_data();
    void picksAcrossNameTheOtherSide();
    void placesCrossBorders_data();
    void placesCrossBorders();
};

void TestAcrossBorders::picksAcrossNameTheOtherSide_data()
{
    QTest::addColumn<int>("depth");
    for (const int depth : {20, 200, 1000}) {
        QTest::addRow("%d", depth) << depth;
    }
}

/// Rays from near the touching point to the middles of the copies at it: the four of the other side and those of this.
void TestAcrossBorders::picksAcrossNameTheOtherSide()
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

void TestAcrossBorders::placesCrossBorders_data()
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
void TestAcrossBorders::placesCrossBorders()
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

}

ROMANESCO_TEST(romanesco::test::TestAcrossBorders)
#include "testacrossborders.moc"
