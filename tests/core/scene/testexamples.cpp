// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>

#include <QTest>

#include "core/scene/sceneloader.h"
#include "core/scene/summary.h"
#include "tests/core/fractal/samples.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// An example at a depth, loaded from the disk as the program does.
std::shared_ptr<const Scene> scene(const QString &name, quint64 depth)
{
    const DiskFiles files;
    SceneLoader loader(files);
    std::string text = exampleText(name + QStringLiteral(".fdo"));
    const std::string path = test::sourcePath("resources/examples/").toStdString() + name.toStdString() + ".fdo";
    const SourceRange digits = loader.load(path, text).scene->depth->range;
    text.replace(digits.begin, digits.length(), std::to_string(depth));
    return loader.load(path, text).scene;
}

}

/// The examples against what another program finds in the same files by writing everything out.
class TestExamples : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsAreThoseOfTheWrittenOutFractal_data();
    void countsAreThoseOfTheWrittenOutFractal();
    void examplesAreFreeOfRemarks_data();
    void examplesAreFreeOfRemarks();
    void summariesOfAppendixB();
    void summariesOfWhatIsNotOneIteration();
    void growingIsTold();
    void theSceneHasSomethingOfEverything();
};

void TestExamples::countsAreThoseOfTheWrittenOutFractal_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("distinct");
    QTest::addColumn<quint64>("facesDistinct");
    const auto row = [](const char *name, quint64 depth, const char *written, const char *distinct, quint64 faces) {
        QTest::addRow("%s %llu", name, depth) << QString::fromLatin1(name) << depth << QString::fromLatin1(written)
                                              << QString::fromLatin1(distinct) << faces;
    };
    row("appendix-b", 1, "25", "25", 350);
    row("appendix-b", 2, "625", "585", 8190);
    row("appendix-b", 3, "15625", "13641", 190974);
    row("appendix-b", 4, "390625", "318025", 4452350);
    row("menger", 1, "20", "20", 240);
    row("menger", 2, "400", "400", 4800);
    row("menger", 3, "8000", "8000", 96000);
    row("menger", 4, "160000", "160000", 1920000);
    row("romanesco", 0, "1", "1", 36);
    row("romanesco", 1, "79228162514264337593543950336", "97", 3492);
    row("romanesco", 2, "6277101735386680763835789423207666416102355444464034512896", "9409", 338724);
    row("sierpinski", 1, "4", "4", 16);
    row("sierpinski", 2, "16", "16", 64);
    row("sierpinski", 3, "64", "64", 256);
    row("sierpinski", 4, "256", "256", 1024);
    row("sierpinski", 5, "1024", "1024", 4096);
    row("sierpinski", 6, "4096", "4096", 16384);
    row("snowflake", 1, "42", "42", 336);
    row("snowflake", 2, "294", "258", 2064);
    row("snowflake", 3, "2058", "1554", 12432);
    row("snowflake", 4, "14406", "9330", 74640);
    row("terrain", 0, "1", "1", 36);
    row("terrain", 1, "11", "11", 396);
    row("terrain", 2, "121", "111", 3996);
    row("terrain", 3, "1331", "1111", 39996);
    row("terrain", 4, "14641", "11111", 399996);
    row("tree", 1, "5", "5", 100);
    row("tree", 2, "25", "21", 420);
    row("tree", 3, "125", "85", 1700);
    row("tree", 4, "625", "341", 6820);
    row("tree", 5, "3125", "1365", 27300);
    row("tree", 6, "15625", "5461", 109220);
    row("tree", 7, "78125", "21845", 436900);
    row("two-sets", 1, "49", "49", 490);
    row("two-sets", 2, "2401", "2317", 23170);
    row("two-sets", 3, "117649", "109453", 1094530);
}

void TestExamples::countsAreThoseOfTheWrittenOutFractal()
{
    QFETCH(QString, name);
    QFETCH(quint64, depth);
    QFETCH(QString, distinct);
    const auto fractal = scene(name, depth);
    QVERIFY(fractal);
    const Summary summary = summarise(*fractal);
    QTEST(QString::fromStdString(summary.instancesAsWritten.toString()), "written");
    QVERIFY(summary.instancesDistinct.has_value());
    QCOMPARE(QString::fromStdString(summary.instancesDistinct->toString()), distinct);
    QTEST(static_cast<quint64>(distinct.toULongLong() * *summary.facesPerBase), "facesDistinct");
}

void TestExamples::examplesAreFreeOfRemarks_data()
{
    QTest::addColumn<QString>("path");
    for (const char *name : {"appendix-b.fdo", "menger.fdo", "romanesco.fdo", "sierpinski.fdo", "snowflake.fdo",
                             "terrain.fdo", "terrain.sdo", "tree.fdo", "two-sets.fdo"}) {
        QTest::newRow(name) << test::sourcePath("resources/examples/%1").arg(QLatin1String(name));
    }
}

void TestExamples::examplesAreFreeOfRemarks()
{
    QFETCH(QString, path);
    const DiskFiles files;
    SceneLoader loader(files);
    const SceneResult result = loader.load(path.toStdString(), files.read(path.toStdString()).value());
    QVERIFY(result.scene);
    QVERIFY(result.diagnostics.empty());
}

void TestExamples::summariesOfAppendixB()
{
    const Summary summary = summarise(*scene(QStringLiteral("appendix-b"), 6));
    QCOMPARE(*summary.facesPerBase, 14u);
    QCOMPARE(*summary.levelCount, Position(12));
    QVERIFY(summary.levelSizes == std::vector<std::uint64_t>(12, 5));
    QCOMPARE(summary.iteration->transforms, 25u);
    QCOMPARE(summary.iteration->depth, 6u);
    QCOMPARE(summary.instancesAsWritten.toString(), "244140625");
    QCOMPARE(summary.facesAsWritten.toString(), "3417968750");
    QCOMPARE(summary.instancesDistinct->toString(), "172855881");
    QVERIFY(summary.isContracting);
    QVERIFY(std::abs(summary.contraction->least - 0.1) < 1e-12);
    QVERIFY(std::abs(summary.contraction->greatest - 0.5) < 1e-12);
}

void TestExamples::summariesOfWhatIsNotOneIteration()
{
    const Summary snowflake = summarise(*scene(QStringLiteral("snowflake"), 4));
    QVERIFY(!snowflake.iteration); // sets stand round it
    QVERIFY(snowflake.levelSizes == (std::vector<std::uint64_t>{1, 2, 3, 7, 7, 7, 7}));
    QVERIFY(!snowflake.isContracting); // the turns round it keep sizes

    const Summary romanesco = summarise(*scene(QStringLiteral("romanesco"), 2));
    QVERIFY(!romanesco.iteration); // a recursive stands in it
    QCOMPARE(*romanesco.levelCount, Position(2 * 97));

    const Summary deep = summarise(*scene(QStringLiteral("tree"), 1'000'000));
    QVERIFY(deep.levelSizes.empty());
    QCOMPARE(deep.iteration->depth, 1'000'000u);
    QCOMPARE(*deep.levelCount, Position(1'000'000));
}

void TestExamples::growingIsTold()
{
    const DiskFiles files;
    SceneLoader loader(files);
    const auto summaryOf = [&](const char *scale) {
        const std::string text = std::string("s ") + scale + "\nt. (#, #, s)\n<$>. [t] \"cube.obj\"\n";
        return summarise(*loader.load(test::sourcePath("resources/examples/a.fdo").toStdString(), text).scene);
    };
    QVERIFY(summaryOf("0.999 0.999 0.999").isContracting);
    QVERIFY(!summaryOf("0.5 1 0.5").isContracting);
    QVERIFY(!summaryOf("0.5 0.5 -2").isContracting);
    QVERIFY(summaryOf("0 0 0").isContracting);
    QVERIFY(!summaryOf("0.5 0.5 0.5").iteration);
}

void TestExamples::theSceneHasSomethingOfEverything()
{
    const DiskFiles files;
    const std::string path = test::sourcePath("resources/examples/terrain.sdo").toStdString();
    const auto island = SceneLoader(files).load(path, files.read(path).value()).scene;
    QVERIFY(island && island->camera && !island->lights.empty());
    using Kind = SceneDescription::Kind;
    for (const Kind kind : {Kind::Object, Kind::Fractal, Kind::Ball}) {
        QVERIFY(std::ranges::contains(island->items, kind, &SceneItem::kind));
    }
    const Summary summary = summarise(*island);
    QCOMPARE(summary.instancesAsWritten.toString(), "161056"); // 11^5 and five
    QCOMPARE(summary.instancesDistinct->toString(), "111116"); // the words of 0 to 5 letters out of ten, and five
}

}

ROMANESCO_TEST(romanesco::test::TestExamples)

#include "testexamples.moc"
