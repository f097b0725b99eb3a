// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/scene/depthchange.h"

#include <QTest>

#include "core/scene/sceneloader.h"
#include "tablefiles.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

/// Two copies of a triangle at different scales, four times.
std::string fractal(const std::string &scale, const std::string &otherScale = "half 0.5 0.5 0.5")
{
    return "left 0 1 0\n" + scale + "\n" + otherScale
        + "\nto.p.s. (p, #, s)\nx. \"mesh.obj\"\nz<x>. [to.left.2, to.left.3] x\n<$>. z 4\n";
}

}

/// Depths in place of a text's.
class TestDepthChange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyTheDepthIsAnother();
    void textsWithoutADepthStayAsTheyAre_data();
    void textsWithoutADepthStayAsTheyAre();
    void fractalsOfAScenePassThroughIt();
    void otherFilesPassAsTheyAre();
    void allOfASceneMustConverge();
    void shallowFractalsConverge();
    void whatShrinksConverges_data();
    void whatShrinksConverges();
};

void TestDepthChange::onlyTheDepthIsAnother()
{
    const TableFiles files({});
    const DepthChange change(files, "123456");
    QVERIFY(change.isInVain());
    const std::string text = "# z 4\n" + fractal("s 0.5 0.5 0.5") + "# z 4\n";
    std::string expected = text;
    expected.replace(expected.rfind("z 4\n# z 4") + 2, 1, "123456");
    QCOMPARE(change.changed(text), expected);
    QVERIFY(!change.isInVain());
    const DepthChange none(files, {});
    QCOMPARE(none.changed(text), text);
    QVERIFY(!none.isInVain());
}

void TestDepthChange::textsWithoutADepthStayAsTheyAre_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("a mesh") << QByteArray("<$>. \"mesh.obj\"\n");
    QTest::newRow("an error") << QByteArray("v 1 2\nx. \"mesh.obj\"\n<$>. x 4 5\n");
}

void TestDepthChange::textsWithoutADepthStayAsTheyAre()
{
    QFETCH(const QByteArray, text);
    const TableFiles files({});
    const DepthChange change(files, "9");
    QCOMPARE(change.changed(text.toStdString()), text.toStdString());
    QVERIFY(change.isInVain());
}

void TestDepthChange::fractalsOfAScenePassThroughIt()
{
    const TableFiles files({{"mesh.obj", triangleObj}, {"f.fdo", fractal("s 0.5 0.5 0.5")}});
    const DepthChange change(files, DepthChange::endless);
    const SceneResult result = SceneLoader(change).load("s.sdo", "f \"f.fdo\" #\no \"mesh.obj\" #\n");
    QVERIFY(result.scene);
    QCOMPARE(result.scene->items[0].model->graph.levels().levelCount(), Position(1'000'000));
    QVERIFY(isConvergent(*result.scene));
    QVERIFY(!change.isInVain());
    QVERIFY(change.check("mesh.obj") && !change.check("other.obj"));
}

void TestDepthChange::otherFilesPassAsTheyAre()
{
    const std::string text = fractal("s 0.5 0.5 0.5");
    const TableFiles files({{"f.fdo", text}, {"f.txt", text}});
    const DepthChange change(files, "77");
    QVERIFY(change.read("f.txt") == text);
    QVERIFY(change.isInVain());
    QVERIFY(change.read("f.fdo") == change.changed(text) && change.read("f.fdo") != text);
}

void TestDepthChange::allOfASceneMustConverge()
{
    const TableFiles files(
        {{"mesh.obj", triangleObj}, {"good.fdo", fractal("s 0.5 0.5 0.5")}, {"bad.fdo", fractal("s 1 0.5 0.5")}});
    const DepthChange change(files, "100000");
    for (const char *text : {"f \"good.fdo\" #\nf \"bad.fdo\" #\n", "f \"bad.fdo\" #\nf \"good.fdo\" #\n"}) {
        const SceneResult result = SceneLoader(change).load("s.sdo", text);
        QVERIFY(result.scene && result.scene->items.size() == 2);
        QVERIFY(!isConvergent(*result.scene));
    }
}

/// Nothing repeats so often that it would have to.
void TestDepthChange::shallowFractalsConverge()
{
    const TableFiles files({{"mesh.obj", triangleObj}});
    for (const std::string &text : {fractal("s 0.5 0.5 0.5"), std::string("<$>. \"mesh.obj\"\n")}) {
        const SceneResult result = SceneLoader(files).load("f.fdo", text);
        QVERIFY(result.scene && isConvergent(*result.scene));
    }
}

void TestDepthChange::whatShrinksConverges_data()
{
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<bool>("converges");
    const QString half = QStringLiteral("half 0.5 0.5 0.5");
    QTest::newRow("half") << QStringLiteral("s 0.5 0.5 0.5") << half << true;
    QTest::newRow("nearly 1") << QStringLiteral("s 0.99 0.99 0.99") << half << true;
    QTest::newRow("flat") << QStringLiteral("s 0.5 0.5 0") << half << true;
    QTest::newRow("mirrored") << QStringLiteral("s -0.5 0.5 0.5") << half << true;
    QTest::newRow("1") << QStringLiteral("s 1 1 1") << half << false;
    QTest::newRow("1 one way") << QStringLiteral("s 0.5 1 0.5") << half << false;
    QTest::newRow("grows") << QStringLiteral("s 1.0001 0.5 0.5") << half << false;
}

void TestDepthChange::whatShrinksConverges()
{
    QFETCH(const QString, first);
    QFETCH(const QString, second);
    QFETCH(const bool, converges);
    const TableFiles files({{"mesh.obj", triangleObj}});
    const DepthChange change(files, "100000");
    const std::string text = change.changed(fractal(first.toStdString(), second.toStdString()));
    const SceneResult result = SceneLoader(change).load("f.fdo", text);
    // What grows may have no picture at all.
    QVERIFY(result.scene || !converges);
    QVERIFY(!result.scene || isConvergent(*result.scene) == converges);
}

ROMANESCO_TEST(TestDepthChange)

#include "testdepthchange.moc"
