// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/core/export/exported.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::shared_ptr<const Scene> octahedronFlake(int depth)
{
    const std::string text = "x. \"octahedron.obj\"\na .5 0 0\nb -.5 0 0\nc 0 .5 0\nd 0 -.5 0\ne 0 0 .5\nf 0 0 -.5\n"
                             "half .5 .5 .5\nt.p. (p, #, half)\nz<x>. [t.a, t.b, t.c, t.d, t.e, t.f] x\n<$>. z "
        + std::to_string(depth) + "\n";
    const std::string mesh = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
                             "f 1 3 5\nf 2 5 3\nf 1 5 4\nf 1 6 3\nf 2 4 5\nf 2 3 6\nf 1 4 6\nf 2 6 4\n";
    return loaded(TableFiles({{"octahedron.obj", mesh}, {"a.fdo", text}}), "a.fdo");
}

}

/// Exports as another program reads them, against what mathematics knows of their faces, areas and volumes.
class TestClosedForms : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fractalsHaveTheirFacesAreaAndVolume_data();
    void fractalsHaveTheirFacesAreaAndVolume();
};

void TestClosedForms::fractalsHaveTheirFacesAreaAndVolume_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<QString>("format");
    for (const char *name : {"menger", "sierpinski", "cantor", "octahedron flake"}) {
        for (const int depth : {0, 1, 3}) {
            for (const char *format : {"obj", "ply", "stl"}) {
                QTest::addRow("%s %d %s", name, depth, format)
                    << QString::fromLatin1(name) << depth << QString::fromLatin1(format);
            }
        }
    }
}

void TestClosedForms::fractalsHaveTheirFacesAreaAndVolume()
{
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    QFETCH(const QString, format);
    std::shared_ptr<const Scene> scene;
    Solid truth;
    if (name == QLatin1String("menger")) {
        scene = menger(depth);
        truth = {12 * static_cast<std::size_t>(std::pow(20, depth)), 6 * std::pow(20.0 / 9, depth),
                 std::pow(20.0 / 27, depth)};
    } else if (name == QLatin1String("sierpinski")) {
        // the edge is 2·√2: areas √3·a², volumes a³/(6·√2)
        scene = sierpinski(depth);
        truth = {4 * static_cast<std::size_t>(std::pow(4, depth)), std::numbers::sqrt3 * 8,
                 std::pow(8.0, 1.5) / (6 * std::numbers::sqrt2) / std::pow(2, depth)};
    } else if (name == QLatin1String("octahedron flake")) {
        // edge √2; half as large in each of its six corners
        scene = octahedronFlake(depth);
        truth = {8 * static_cast<std::size_t>(std::pow(6, depth)), 4 * std::numbers::sqrt3 * std::pow(1.5, depth),
                 4.0 / 3 * std::pow(0.75, depth)};
    } else {
        scene = cantorDust(depth);
        truth = {12 * static_cast<std::size_t>(std::pow(8, depth)), 6 * std::pow(8.0 / 9, depth),
                 std::pow(8.0 / 27, depth)};
    }
    QVERIFY(scene);
    const std::string path = "a." + format.toStdString();
    const std::string bytes = exported(*scene, {.format = exportFormat(path).value()});
    const Solid solid = solidOf(importedTriangles(bytes, format.toStdString().c_str()));
    QCOMPARE(solid.faces, truth.faces);
    // assimp has floats
    const auto isNear = [](double found, double expected) { return std::abs(found - expected) < 2e-5 * expected; };
    QVERIFY2(isNear(solid.area, truth.area), qPrintable(QString::number(solid.area, 'g', 9)));
    QVERIFY2(isNear(solid.volume, truth.volume), qPrintable(QString::number(solid.volume, 'g', 9)));
}

}

ROMANESCO_TEST(romanesco::test::TestClosedForms)
#include "testclosedforms.moc"
