// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/anchor.h"
#include "core/scene/scenesearch.h"
#include "tests/core/scene/longplaces.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr std::uint32_t mapCount = 4;

/// Of four maps at corners, which turn. Where they are uneven no chain of them is a similarity; an open one has its mesh at
/// every level.
std::string deepFractal(std::mt19937_64 &random, bool isUneven, bool isOpen = false)
{
    constexpr glm::dvec3 corners[mapCount]{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    std::string text = "x. \"m.obj\"\n";
    std::string names;
    for (std::uint32_t i = 0; i < mapCount; ++i) {
        const glm::dvec3 p = corners[i] + randomPoint(random, 0.2);
        const glm::dvec3 r = randomPoint(random, 180);
        const double s = uniform(random, 0.3, 0.45);
        text += std::format("p{0} {1} {2} {3}\nr{0} {4} {5} {6}\ns{0} {7} {8} {7}\nm{0}. (p{0}, r{0}, s{0})\n", i, p.x,
                            p.y, p.z, r.x, r.y, r.z, s, isUneven ? 0.8 * s : s);
        names += (i ? ", m" : "m") + std::to_string(i);
    }
    return text + "z<x>. [" + (isOpen ? "#, " : "") + names + "] x\n<$>. z 64\n";
}

/// The scene as it is written, in 700 bits, seen from a place.
class Oracle
{
public:
    Oracle(const Surroundings &place, bool isOpen)
        : m_isOpen(isOpen)
        , m_graph(place.scene->items[0].model->graph)
        , m_mesh(*place.scene->items[0].model->mesh)
        , m_world(OracleMap().then(place.scene->items[0].worldFromModel))
        , m_maps(m_graph.set(0).maps)
        , m_unit(pow(Long(2), Long(place.unitExponent)))
    {
        // of the place's node, whose frame has its origin there
        OracleMap here = m_world;
        for (const Step &step : place.path) {
            here = here.then(m_maps[step.map]);
        }
        m_origin = here.translation;
    }

    /// Of all faces that are within a reach of p, in units of the place.
    [[nodiscard]] double distance(const glm::dvec3 &p, double reach)
    {
        m_best = reach;
        visit(m_world, 0, p);
        return m_best;
    }

private:
    /// From p, in units.
    [[nodiscard]] glm::dvec3 seen(const OracleMap &map, const glm::dvec3 &vertex, const glm::dvec3 &p) const
    {
        OracleVector at = map.turned(vertex);
        glm::dvec3 result;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            result[axis] = static_cast<double>((at[i] + map.translation[i] - m_origin[i]) / m_unit - Long(p[axis]));
        }
        return result;
    }

    void visit(const OracleMap &map, std::uint64_t level, const glm::dvec3 &p)
    {
        // all four maps keep a ball of this radius within itself: 2.1 + 0.45 R <= R
        constexpr double radius = 4.0;
        const double size = static_cast<double>(map.size() / m_unit) * radius;
        const double distance = glm::length(seen(map, glm::dvec3(0.0), p));
        if (distance - size > m_best) {
            return;
        }
        if (size < 1e-14) {
            m_best = std::min(m_best, distance);
            return;
        }
        const bool isEnd = level == m_graph.levels().levelCount();
        if (isEnd || m_isOpen) {
            for (const Mesh::Face &face : m_mesh.faces) {
                std::array<truth::Vector<Wide>, 3> corners;
                for (std::size_t i = 0; i < 3; ++i) {
                    corners[i] = wide(seen(map, m_mesh.vertices[face[i]], p));
                }
                m_best = std::min(m_best, static_cast<double>(truth::distance(corners, wide(glm::dvec3(0.0)))));
            }
        }
        if (isEnd) {
            return;
        }
        std::vector<std::pair<double, OracleMap>> nexts;
        for (const AffineMap &next : m_maps) {
            const OracleMap below = map.then(next);
            nexts.emplace_back(glm::length(seen(below, glm::dvec3(0.0), p)), below);
        }
        std::ranges::sort(nexts, {}, &std::pair<double, OracleMap>::first);
        for (const auto &next : nexts) {
            visit(next.second, level + 1, p);
        }
    }

    bool m_isOpen;
    const FractalGraph &m_graph;
    const Mesh &m_mesh;
    OracleMap m_world;
    const std::vector<AffineMap> &m_maps;
    Long m_unit;
    OracleVector m_origin;
    double m_best = 0.0;
};

}

class TestPlaceCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void deepDownItIsAsExactAsAtTheTop_data();
    void deepDownItIsAsExactAsAtTheTop();
    void itIsThatOfTheWorldWhereBothReach();
    void addressesBeginInTheWorld();
};

void TestPlaceCollider::deepDownItIsAsExactAsAtTheTop_data()
{
    QTest::addColumn<bool>("isUneven");
    QTest::addColumn<bool>("isOpen");
    QTest::addColumn<std::size_t>("levels");
    QTest::newRow("meshes at every level") << false << true << std::size_t{60};
    for (const std::size_t levels : {0, 5, 60}) {
        QTest::addRow("similarities, %zu levels down", levels) << false << false << levels;
        QTest::addRow("uneven maps, %zu levels down", levels) << true << false << levels;
    }
}

void TestPlaceCollider::deepDownItIsAsExactAsAtTheTop()
{
    QFETCH(const bool, isUneven);
    QFETCH(const bool, isOpen);
    QFETCH(const std::size_t, levels);
    std::mt19937_64 random(seed(levels + 1));
    double worst = 0.0;
    int found = 0;
    for (int round = 0; round < 2; ++round) {
        const auto scene = sceneOf({{.model = modelOf(deepFractal(random, isUneven, isOpen)),
                                     .worldFromModel = mapFromParts({3, 1, 2}, {10, 20, 30}, glm::dvec3(1.5))}});
        const SceneCollider whole = SceneCollider::create(scene, {}).value();
        Anchor anchor(scene);
        QVERIFY(anchor.enter({0, 0}));
        for (std::size_t i = 0; i < levels; ++i) {
            QVERIFY(anchor.enter({0, static_cast<std::uint32_t>(random() % mapCount)}));
        }
        const auto place = anchor.surroundings();
        const SceneCollider collider = whole.at(place);
        const auto search = collider.search();
        Oracle oracle(*place, isOpen);
        for (int i = 0; i < 3; ++i) {
            const Sphere near = anchor.bound();
            const glm::dvec3 p = near.centre + randomPoint(random, i % 3 ? near.radius : 0.02 * near.radius);
            Hit hit;
            search->closest({.p = p, .radius = 2.0 * near.radius}, hit);
            const double least = oracle.distance(p, std::min(1.001 * hit.distance, 2.0 * near.radius));
            if (!hit.isFound()) {
                QVERIFY2(least >= 2.0 * near.radius * (1 - 1e-12), "a face was not found");
                continue;
            }
            ++found;
            worst = std::max(worst, std::abs(hit.distance - least));
            QVERIFY2(std::abs(hit.distance - least) < 1e-12,
                     qPrintable(QStringLiteral("%1, but %2").arg(hit.distance, 0, 'g', 17).arg(least, 0, 'g', 17)));
            QVERIFY(hit.lower <= least * (1 + 1e-13) && hit.lower > least - 1e-6);

            // a sphere that goes straight there, and a little beyond
            const double radius = 0.25 * hit.distance;
            Touch touch;
            search->sweep({.p = p, .v = 1.5 * (hit.point - p), .time = 1.0, .radius = radius}, touch);
            QVERIFY(touch.isFound());
            const double there = oracle.distance(p + touch.time * 1.5 * (hit.point - p), 1.001 * radius);
            QVERIFY(std::abs(there - radius) < 2e-5 * radius);
            QVERIFY(touch.lower <= touch.time && touch.lower > touch.time - 1e-4);
        }
    }
    QVERIFY(found > 3);
    qInfo("%d points, off by %.2g units at most", found, worst);
}

/// Among several items, and far out of the place.
void TestPlaceCollider::itIsThatOfTheWorldWhereBothReach()
{
    std::mt19937_64 random(seed(5));
    const auto model = modelOf(deepFractal(random, false));
    std::vector<SceneItem> items = heapOf(model, random);
    items[2].worldFromModel = randomPlace(random);
    items[4].kind = SceneDescription::Kind::Ball;
    const auto scene = sceneOf(items);
    const SceneCollider whole = SceneCollider::create(scene, {}).value();
    Anchor anchor(scene);
    QVERIFY(anchor.enter({0, 1}) && anchor.enter({0, 2}) && anchor.enter({0, 0}));
    const auto place = anchor.surroundings();
    const SceneCollider collider = whole.at(place);
    SceneSearch here(collider);
    SceneSearch there(whole);
    const double unit = std::exp2(place->unitExponent);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = randomPoint(random, i % 2 ? 8 : 800);
        Hit hit;
        Hit inWorld;
        here.closest({.p = p}, hit);
        there.closest({.p = place->worldFromHere(p)}, inWorld);
        QVERIFY(std::abs(hit.distance * unit - inWorld.distance) < 1e-13 * (10 + inWorld.distance));
        QCOMPARE(here.item(), there.item());
        const glm::dvec3 v = randomPoint(random, 20);
        Touch touch;
        Touch touchInWorld;
        here.sweep({.p = p, .v = v, .radius = 0.1}, touch);
        there.sweep({.p = place->worldFromHere(p), .v = unit * v, .radius = 0.1 * unit}, touchInWorld);
        QCOMPARE(touch.isFound(), touchInWorld.isFound());
        QVERIFY(!touch.isFound() || std::abs(touch.time - touchInWorld.time) < 1e-4);
    }
}

void TestPlaceCollider::addressesBeginInTheWorld()
{
    std::mt19937_64 random(seed(9));
    const auto scene = sceneOf({{.model = modelOf(deepFractal(random, true))}});
    const SceneCollider whole = SceneCollider::create(scene, {}).value();
    Anchor anchor(scene);
    QVERIFY(anchor.enter({0, 0}) && anchor.enter({0, 3}) && anchor.enter({0, 1}));
    const auto place = anchor.surroundings();
    const SceneCollider collider = whole.at(place);
    SceneSearch here(collider);
    for (int i = 0; i < 50; ++i) {
        Hit hit;
        here.closest({.p = randomPoint(random, i % 2 ? 2 : 20)}, hit);
        const Address address = here.addressOf(hit);
        // what is smaller than rounding is not told apart
        const AffineMap copy = mapOf(scene->items[0].model->graph, address);
        const double size = operatorNorm(copy.linear) * 4.0;
        QVERIFY(glm::distance(copy.translation, place->worldFromHere(hit.point)) < size + 1e-12);
        QVERIFY(address.size() > 20);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestPlaceCollider)

#include "testplacecollider.moc"
