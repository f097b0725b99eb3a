// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/fractal/extent.h"

#include <cmath>
#include <limits>

#include <QTest>
#include <glm/common.hpp>

#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Of every vertex of every copy, written out in long doubles.
Box exactBox(const naive::Levels &levels, const std::vector<AffineMap> &maps, const Mesh &mesh)
{
    std::vector<naive::Affine> copies{{}};
    for (const naive::Level &level : levels) {
        std::vector<naive::Affine> next;
        for (const naive::Affine &copy : copies) {
            if (level.mayPass) {
                next.push_back(copy);
            }
            for (const int map : level.maps) {
                next.push_back(naive::product(copy, naive::fromCore(maps[static_cast<std::size_t>(map)])));
            }
        }
        copies = std::move(next);
    }
    Box box{glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (const naive::Affine &copy : copies) {
        for (const auto &face : mesh.faces) {
            for (const std::uint32_t index : face) {
                const glm::dvec3 &v = mesh.vertices[index];
                const naive::Point point = naive::applied(copy, {v.x, v.y, v.z});
                for (int axis = 0; axis < 3; ++axis) {
                    const auto coordinate = static_cast<double>(point[static_cast<std::size_t>(axis)]);
                    box.least[axis] = std::min(box.least[axis], coordinate);
                    box.greatest[axis] = std::max(box.greatest[axis], coordinate);
                }
            }
        }
    }
    return box;
}

/// Whether found holds truth (but for rounding) and is at most a part of the largest side larger on each side.
bool isBoxOf(const Box &found, const Box &truth, double part)
{
    const glm::dvec3 size = truth.size();
    const double largest = std::max({size.x, size.y, size.z});
    const glm::dvec3 far = glm::max(glm::abs(truth.least), glm::abs(truth.greatest));
    const double rounding = 1e-12 * std::max({far.x, far.y, far.z});
    for (int axis = 0; axis < 3; ++axis) {
        const double below = truth.least[axis] - found.least[axis];
        const double above = found.greatest[axis] - truth.greatest[axis];
        if (std::min(below, above) < -rounding || std::max(below, above) > part * largest + rounding) {
            return false;
        }
    }
    return true;
}

Box extentOf(const FractalGraph &graph, const Mesh &mesh, std::size_t budget = 20'000)
{
    return extent(graph, BoxBounds(graph, mesh), mesh, budget);
}

}

class TestExtent : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theBoxHoldsEveryVertexAndLittleMore();
    void examplesHaveTheirBoxes_data();
    void examplesHaveTheirBoxes();
    void deepFractalsHaveTheBoxOfTheirLimit_data();
    void deepFractalsHaveTheBoxOfTheirLimit();
    void aSmallBudgetStillHoldsAll();
    void aMeshAloneHasItsOwnBox();
    void aLongRowIsMeasuredFromItsEnds();
    void aFarMeshIsHeldAtItsDepth();
};

void TestExtent::theBoxHoldsEveryVertexAndLittleMore()
{
    std::mt19937_64 random(seed(31));
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int round = 0; round < 300; ++round) {
        naive::Fractal fractal;
        for (int i = 0; i < 3; ++i) {
            const double size = 0.35 + 0.3 * unit(random);
            const glm::dvec3 scale(size, round % 2 == 0 ? size : -0.5 * size, round % 5 == 0 ? 0.0 : size);
            fractal.maps.push_back(mapFromParts({unit(random), unit(random), unit(random)},
                                                {180 * unit(random), 180 * unit(random), 180 * unit(random)}, scale));
        }
        fractal.sets = naive::randomSets(random, 3);
        do {
            fractal.items = naive::randomItems(random, fractal.sets.size(), 0, 5);
        } while (naive::wordsAsWritten(fractal.levels()) > 3'000);
        Mesh mesh;
        for (int i = 0; i < 4; ++i) {
            mesh.vertices.emplace_back(unit(random), unit(random), unit(random));
        }
        mesh.faces = {{0, 1, 2}, {1, 2, 3}};
        const FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
        const Box found = extentOf(graph, mesh);
        const Box truth = exactBox(fractal.levels(), fractal.maps, mesh);
        if (!isBoxOf(found, truth, 0.06)) {
            for (int axis = 0; axis < 3; ++axis) {
                qWarning("found %.17g .. %.17g, is %.17g .. %.17g", found.least[axis], found.greatest[axis],
                         truth.least[axis], truth.greatest[axis]);
            }
            QFAIL(qPrintable(QStringLiteral("round %1").arg(round)));
        }
    }
}

void TestExtent::examplesHaveTheirBoxes_data()
{
    // Every vertex of every copy, by another program.
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<QList<double>>("box");
    const auto row = [](const char *name, quint64 depth, const QList<double> &box) {
        QTest::addRow("%s %llu", name, depth) << QString::fromLatin1(name) << depth << box;
    };
    row("appendix-b", 1,
        {-11.414213562373096, -11.707106781186548, -10.707106781186548, 11.414213562373096, 11.707106781186548, 2.5});
    row("appendix-b", 2,
        {-11.564213562373096, -11.792462120245876, -10.86317279836453, 11.564213562373096, 11.792462120245876, 2.5});
    row("appendix-b", 3,
        {-11.57878463018496, -11.797158819386977, -10.877011633129362, 11.57878463018496, 11.797158819386977, 2.5});
    row("menger", 1, {-1.49999999995, -1.49999999995, -1.49999999995, 1.49999999995, 1.49999999995, 1.49999999995});
    row("menger", 2,
        {-1.4999999999333333, -1.4999999999333333, -1.4999999999333333, 1.4999999999333333, 1.4999999999333333,
         1.4999999999333333});
    row("menger", 3,
        {-1.4999999999277778, -1.4999999999277778, -1.4999999999277778, 1.4999999999277778, 1.4999999999277778,
         1.4999999999277778});
    row("romanesco", 0, {-0.8, -1.1, -0.69, 0.8, 0.0, 0.69});
    row("romanesco", 1,
        {-1.0461086739140861, -1.5382812563642556, -1.1247559857802276, 1.2, -0.043370994443013434,
         0.9652899340534438});
    row("romanesco", 2,
        {-1.0367354282284076, -1.770429274684528, -1.113284350193464, 1.1867555587005891, -0.0377182379627551,
         0.9578746669054199});
    row("sierpinski", 1, {-1.0, 0.0, -1.1547, 1.0, 1.633, 0.57736});
    row("sierpinski", 2, {-1.0, 0.0, -1.1547, 1.0, 1.633, 0.57736});
    row("sierpinski", 3, {-1.0, 0.0, -1.1547, 1.0, 1.633, 0.5773599999999999});
    row("snowflake", 1, {-0.6634139481689384, -1.0, -0.5566703992264194, 0.6634139481689384, 1.0, 0.5566703992264194});
    row("snowflake", 2, {-0.6634139481689384, -1.0, -0.5566703992264194, 0.6634139481689384, 1.0, 0.5566703992264194});
    row("snowflake", 3, {-0.6634139481689384, -1.0, -0.5566703992264194, 0.6634139481689384, 1.0, 0.5566703992264194});
    row("tree", 1,
        {-0.3081177250164782, 0.0, -0.3939388417180561, 0.4087103610830691, 1.7053683233834018, 0.35596222365886976});
    row("tree", 2,
        {-0.5507254644932166, 0.0, -0.6861615156264607, 0.726676506797074, 2.210892528498878, 0.58627477766296});
    row("tree", 3,
        {-0.7783435005941252, 0.0, -0.9299130790817915, 0.9633802254773879, 2.589776866843564, 0.7295017235514936});
    row("two-sets", 1, {-1.9, -1.9, -1.9, 1.9, 1.9, 1.9});
    row("two-sets", 2,
        {-2.2600000000000002, -2.2600000000000002, -2.2600000000000002, 2.2600000000000002, 2.2600000000000002,
         2.2600000000000002});
    row("two-sets", 3,
        {-2.4040000000000004, -2.4040000000000004, -2.4040000000000004, 2.4040000000000004, 2.4040000000000004,
         2.4040000000000004});
}

void TestExtent::examplesHaveTheirBoxes()
{
    QFETCH(QString, name);
    QFETCH(quint64, depth);
    QFETCH(QList<double>, box);
    const Sample fractal = sample(name, depth);
    const Box truth{{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
    QVERIFY(isBoxOf(extentOf(fractal.graph, fractal.mesh), truth, 1.0 / 256));
}

void TestExtent::deepFractalsHaveTheBoxOfTheirLimit_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    for (const char *name : {"sierpinski", "menger", "tree", "appendix-b", "two-sets", "snowflake", "romanesco"}) {
        for (const quint64 depth : {quint64(1'000), quint64(1'000'000), quint64(1) << 55}) {
            QTest::addRow("%s %llu", name, depth) << QString::fromLatin1(name) << depth;
        }
    }
}

void TestExtent::deepFractalsHaveTheBoxOfTheirLimit()
{
    QFETCH(QString, name);
    QFETCH(quint64, depth);
    const Sample shallow = sample(name, 14);
    const Sample deep = sample(name, depth);
    const Box limit = extentOf(shallow.graph, shallow.mesh);
    QVERIFY(isBoxOf(extentOf(deep.graph, deep.mesh),
                    {limit.least + 0.03 * limit.size(), limit.greatest - 0.03 * limit.size()}, 0.08));
}

void TestExtent::aSmallBudgetStillHoldsAll()
{
    const Sample tree = sample(QStringLiteral("tree"), 6);
    const Box truth = extentOf(tree.graph, tree.mesh);
    for (const std::size_t budget : {0u, 1u, 10u, 100u}) {
        const Box rough = extentOf(tree.graph, tree.mesh, budget);
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(rough.least[axis] <= truth.least[axis] + 1e-12);
            QVERIFY(rough.greatest[axis] >= truth.greatest[axis] - 1e-12);
        }
    }
}

void TestExtent::aMeshAloneHasItsOwnBox()
{
    Mesh mesh;
    mesh.vertices = {{9, 9, 9}, {1, 2, 3}, {-1, 5, 3}, {0, 0, 4}};
    mesh.faces = {{1, 2, 3}};
    const Box box = extentOf(FractalGraph::ofMesh(boundingSphere(mesh)), mesh);
    QVERIFY(box.least == glm::dvec3(-1, 0, 3));
    QVERIFY(box.greatest == glm::dvec3(1, 5, 4));
    const Box none = extentOf(FractalGraph::ofMesh(Sphere{}), Mesh{});
    QVERIFY(none.least == glm::dvec3(0) && none.greatest == glm::dvec3(0));
}

/// A row of 10^6 steps that do not contract, each taken or all of them.
void TestExtent::aLongRowIsMeasuredFromItsEnds()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces.push_back({0, 1, 2});
    for (const bool mayPass : {false, true}) {
        naive::Fractal fractal;
        fractal.maps = {mapFromParts({0.5, 0, 0}, {0, 0, 0}, glm::dvec3(1))};
        fractal.sets = {{{0}, mayPass}};
        fractal.items = {{1'000'000, 0, {{0, 0, {}}}}};
        const FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
        const Box truth{{mayPass ? 0 : 500'000, 0, 0}, {500'001, 1, 0}};
        const Box found = extentOf(graph, mesh);
        QVERIFY(isBoxOf(found, truth, 1e-9));
    }
}

/// The innermost level throws the mesh far away, and each level round it brings it nearer.
void TestExtent::aFarMeshIsHeldAtItsDepth()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}};
    mesh.faces.push_back({0, 1, 2});
    naive::Fractal fractal;
    fractal.maps = {mapFromParts({1'000, 0, 0}, {0, 0, 0}, glm::dvec3(1)),
                    mapFromParts({0.5, 0, 0}, {0, 0, 0}, glm::dvec3(0.5)),
                    mapFromParts({-0.5, 0, 0}, {0, 0, 0}, glm::dvec3(0.5))};
    fractal.sets = {{{0}, false}, {{1, 2}, false}};
    fractal.items = {{4, 0, {{0, 1, {}}}}, {0, 0, {}}};
    const FractalGraph graph = FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
    QVERIFY(isBoxOf(extentOf(graph, mesh), exactBox(fractal.levels(), fractal.maps, mesh), 1e-9));
}
}

ROMANESCO_TEST(romanesco::test::TestExtent)

#include "testextent.moc"
