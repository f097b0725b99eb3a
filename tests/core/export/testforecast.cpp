// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/export/forecast.h"

#include <cmath>
#include <random>

#include <QTest>

#include "tests/core/export/exported.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::shared_ptr<const Scene> example(const QString &name, std::uint64_t depth)
{
    Sample made = sample(name, depth);
    const auto mesh = std::make_shared<const Mesh>(std::move(made.mesh));
    return std::make_shared<const Scene>(
        sceneOf(std::make_shared<const Model>(Model{mesh, std::move(made.graph), {}, {}, {}})));
}

/// A ball of triangles with normals, texture coordinates and parts of two materials.
Mesh decoratedBall(int rings)
{
    Mesh mesh;
    const auto at = [&](int ring, int step) { return static_cast<std::uint32_t>(ring * rings + step % rings); };
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < rings; ++step) {
            const double u = 3.1 * (ring + 0.5) / rings;
            const double v = 6.2831853 * step / rings;
            mesh.normals.push_back({std::sin(u) * std::cos(v), std::cos(u), std::sin(u) * std::sin(v)});
            mesh.vertices.push_back(0.3 * mesh.normals.back());
            mesh.textureCoordinates.push_back({u, v});
        }
    }
    for (int ring = 0; ring + 1 < rings; ++ring) {
        mesh.parts.push_back({static_cast<std::uint32_t>(mesh.faces.size()), ring % 2 == 0 ? 0u : 1u, Mesh::none, 1});
        for (int step = 0; step < rings; ++step) {
            mesh.faces.push_back({at(ring, step), at(ring, step + 1), at(ring + 1, step)});
            mesh.faces.push_back({at(ring + 1, step), at(ring, step + 1), at(ring + 1, step + 1)});
        }
    }
    mesh.faceNormals = mesh.faces;
    mesh.faceTextureCoordinates = mesh.faces;
    mesh.materials.resize(2);
    mesh.materials[0].name = "light";
    mesh.materials[1].name = "dark";
    return mesh;
}

std::shared_ptr<const Model> randomModel(std::mt19937_64 &random, Mesh mesh)
{
    const auto shared = std::make_shared<const Mesh>(std::move(mesh));
    FractalGraph graph = FractalGraph::build(randomFractal(random, 0.9).description(), boundingSphere(*shared)).value();
    return std::make_shared<const Model>(Model{shared, std::move(graph), {}, {}, {}});
}

/// How far the forecast is from the truth, as a share of it.
double errorOf(const Scene &scene, const ExportOptions &options)
{
    const double told = static_cast<double>(forecast(scene, options).value().bytes.toInteger().value());
    CountingSink sink;
    const auto report = exportScene(scene, options, sink);
    return report ? std::abs(told / static_cast<double>(sink.count()) - 1.0) : 1.0;
}

}

class TestForecast : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void facesAreExact();
    void bytesAreWithinTwoPerCent_data();
    void bytesAreWithinTwoPerCent();
    void bytesOfAnyFractalAreWithinTwoPerCent();
    void bytesOfSmallFilesAreExact();
    void groupsOfACopyEachAreForecast();
    void numbersAreThoseOfThePlacedItem();
    void manyItemsAreForecastTogether();
    void anySizeIsForecast_data();
    void anySizeIsForecast();
    void whatTheFormatCannotHoldIsAnObstacle();
    void whatTheDiskCannotHoldIsAnObstacle();
};

void TestForecast::facesAreExact()
{
    for (int depth = 0; depth < 5; ++depth) {
        const ExportForecast known = forecast(*menger(depth), {}).value();
        QCOMPARE(known.faces.toInteger().value(), static_cast<std::uint64_t>(12 * std::pow(20, depth)));
        QCOMPARE(known.vertices.toInteger().value(), static_cast<std::uint64_t>(8 * std::pow(20, depth)));
    }
}

void TestForecast::bytesAreWithinTwoPerCent_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<int>("digits");
    QTest::newRow("menger") << "menger" << 4 << 0;
    QTest::newRow("menger, 5 digits") << "menger" << 4 << 5;
    QTest::newRow("tree") << "tree" << 7 << 0;
    QTest::newRow("deeper tree") << "tree" << 8 << 0;
    QTest::newRow("tree, 3 digits") << "tree" << 7 << 3;
    QTest::newRow("sierpinski") << "sierpinski" << 8 << 0;
    QTest::newRow("two sets") << "two-sets" << 3 << 0;
    QTest::newRow("romanesco") << "romanesco" << 2 << 0;
    QTest::newRow("snowflake") << "snowflake" << 4 << 0;
    QTest::newRow("appendix B") << "appendix-b" << 3 << 0;
}

void TestForecast::bytesAreWithinTwoPerCent()
{
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    QFETCH(const int, digits);
    const auto scene = example(name, static_cast<std::uint64_t>(depth));
    for (const ExportFormat format : {ExportFormat::Obj, ExportFormat::Ply, ExportFormat::Stl}) {
        for (const bool isGrouped : {false, true}) {
            ExportOptions options{.format = format, .isGrouped = isGrouped};
            if (digits != 0) {
                options.digits = digits;
            }
            const double error = errorOf(*scene, options);
            QVERIFY2(error < 0.02, qPrintable(QString::number(error)));
        }
    }
}

void TestForecast::bytesOfAnyFractalAreWithinTwoPerCent()
{
    std::mt19937_64 random(seed(11));
    for (int round = 0; round < 60; ++round) {
        const Scene scene = sceneOf(randomModel(random, decoratedBall(4 + round % 20)));
        for (const bool isGrouped : {false, true}) {
            const double error = errorOf(scene, {.isGrouped = isGrouped});
            QVERIFY2(error < 0.02, qPrintable(QStringLiteral("%1: %2").arg(round).arg(error)));
        }
    }
}

void TestForecast::bytesOfSmallFilesAreExact()
{
    for (const ExportFormat format : {ExportFormat::Obj, ExportFormat::Ply, ExportFormat::Stl}) {
        QCOMPARE(errorOf(*menger(2), {.format = format, .source = "a.fdo"}), 0.0);
    }
}

/// Short numbers: whole ones.
std::shared_ptr<const Scene> rowOf(int count, const std::string &line)
{
    std::string text = "x. \"cube.obj\"\nt.p. (p, #, #)\n";
    std::string set;
    for (int i = 1; i <= count; ++i) {
        text += "v " + std::to_string(i % 7) + " " + std::to_string(i / 7) + " 1\n";
        set += (i == 1 ? "t." : ", t.") + std::to_string(i);
    }
    return loaded(TableFiles({{"cube.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"},
                              {"a.fdo", text + "<$>. [" + set + "] x\n"},
                              {"a.sdo", line}}),
                  "a.sdo");
}

void TestForecast::groupsOfACopyEachAreForecast()
{
    const auto scene = rowOf(40'000, "f \"a.fdo\" #\n");
    QVERIFY(scene);
    QVERIFY(errorOf(*scene, {.isGrouped = true}) < 0.02);
}

void TestForecast::numbersAreThoseOfThePlacedItem()
{
    const auto scene = rowOf(40'000, "f \"a.fdo\" (#, (10, 20, 30), #)\n");
    QVERIFY(scene);
    QVERIFY(errorOf(*scene, {}) < 0.02);
}

void TestForecast::manyItemsAreForecastTogether()
{
    std::mt19937_64 random(seed(12));
    const auto model = randomModel(random, decoratedBall(8));
    Scene scene;
    for (int i = 0; i < 300; ++i) {
        scene.items.push_back({.model = model, .worldFromModel = randomMap(random, 100.0)});
    }
    const double error = errorOf(scene, {});
    QVERIFY2(error < 0.02, qPrintable(QString::number(error)));
}

void TestForecast::anySizeIsForecast_data()
{
    QTest::addColumn<QByteArray>("depth");
    QTest::addColumn<double>("logarithm");
    // 20^n cubes
    QTest::newRow("10^40") << QByteArray("30") << 30 * std::log10(20.0);
    QTest::newRow("10^1300") << QByteArray("1000") << 1000 * std::log10(20.0);
    QTest::newRow("10^130103") << QByteArray("100000") << 100000 * std::log10(20.0);
    QTest::newRow("a depth of 2^31") << QByteArray("2147483647") << 2147483647 * std::log10(20.0);
    QTest::newRow("the greatest depth") << QByteArray("9223372036854775807") << 9.223372036854776e18 * std::log10(20.0);
}

void TestForecast::anySizeIsForecast()
{
    QFETCH(const QByteArray, depth);
    QFETCH(const double, logarithm);
    QString text = QString::fromStdString(exampleText("menger.fdo"));
    text.replace("sponge 4", "sponge " + QString::fromLatin1(depth));
    const auto scene = loaded(TableFiles({{"cube.obj", unitCubeObj}, {"a.fdo", text.toStdString()}}), "a.fdo");
    QVERIFY(scene);
    const ExportForecast known = forecast(*scene, {}).value();
    const double relative = std::max(logarithm * 1e-12, 1e-9);
    QVERIFY(std::abs(known.faces.log10() - std::log10(12.0) - logarithm) < relative);
    // 36 indices of so many digits with a blank each, 24 coordinates of 19 bytes or so, and the letters
    const double perCopy = 36 * (logarithm + 1) + 24 * 19 + 40;
    const double difference = known.bytes.log10() - logarithm - std::log10(perCopy);
    QVERIFY2(std::abs(difference) < 0.05 + relative, qPrintable(QString::number(difference)));
}

void TestForecast::whatTheFormatCannotHoldIsAnObstacle()
{
    const ExportForecast much{Count(std::uint64_t{1} << 33), Count(std::uint64_t{1} << 33), Count(1)};
    const ExportForecast fits{Count(1'000), Count(1'000), Count(1)};
    for (const ExportFormat format : {ExportFormat::Ply, ExportFormat::Stl}) {
        QVERIFY(obstacle(much, {.format = format}, "/tmp/out").contains("holds at most 42949672"));
        QCOMPARE(obstacle(fits, {.format = format}, "/tmp/out"), std::string());
    }
    QCOMPARE(obstacle(much, {.format = ExportFormat::Obj}, "/tmp/out"), std::string());
}

void TestForecast::whatTheDiskCannotHoldIsAnObstacle()
{
    for (const Count &bytes : {power(Count(10), 17), power(Count(10), 40), power(Count(10), 100'000)}) {
        const ExportForecast much{Count(1), Count(1), bytes};
        QVERIFY(obstacle(much, {}, "/tmp/out.obj").contains("bytes free"));
        QVERIFY(obstacle(much, {}, "out.obj").contains("bytes free"));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestForecast)
#include "testforecast.moc"
