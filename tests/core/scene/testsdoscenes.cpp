// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <memory>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/sceneloader.h"
#include "core/text/linemap.h"
#include "core/text/places.h"
#include "tests/core/scene/tablefiles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// As compilers write them, notes included.
QString remarks(const SceneResult &result, std::string_view text)
{
    const LineMap lines(text);
    Places places(lines);
    QStringList all;
    for (const Diagnostic &diagnostic : result.diagnostics) {
        all.push_back(QString::fromStdString(toLines(diagnostic, "s.sdo", places)));
    }
    return all.join(QLatin1Char('\n'));
}

const std::string fractalText = "v 1 0 0\nhalf 0.5 0.5 0.5\nt. (1, #, half)\nx. \"x.obj\"\nz<x>. [#, t] x\n<$>. z 6\n";

std::map<std::string, std::string> goodFiles()
{
    return {{"x.obj", triangleObj},
            {"y.obj", triangleObj},
            {"a.fdo", fractalText},
            {"dir/b.fdo", fractalText},
            {"dir/x.obj", triangleObj}};
}

const std::string goodScene = "c (1, 2, 3) (0.1, 0.2, 0.3) 50\no \"x.obj\" #\nf \"a.fdo\" ((10, 0, 0), (0, 90, 0), #)\n"
                              "p \"x.obj\" ((0, 9, 0), #, (2, 2, 2)) 0.6 (1, 0, 0)\nl (20, 40, -10) (1, 0.9, 0.8)\n";

/// Asks to stop when it is asked for its second file.
class StoppingFiles final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &) const override
    {
        if (++reads == 2) {
            stop.request_stop();
        }
        return triangleObj;
    }
    mutable int reads = 0;
    mutable std::stop_source stop;
};

}

class TestSdoScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSceneIsWhatItsLinesSay();
    void anEmptyTextIsAnEmptyScene();
    void aFileNamedTwiceIsOneModel();
    void pathsInAFractalAreRelativeToIt();
    void whatIsWrongWithAFileIsSaidWhereItIsNamed_data();
    void whatIsWrongWithAFileIsSaidWhereItIsNamed();
    void onlyTheFirstTenErrorsAreNotes();
    void anFdoTextLeadsIntoItsMesh();
    void aTextThatChangesKeepsItsModels();
    void aFileThatChangesIsMadeAnew();
    void aModelIsMadeAnewWithItsMesh();
    void whatIsNoLongerNamedIsForgotten();
    void stoppingIsHeardBetweenFiles();
    void placesBeyondNumbersAreErrors_data();
    void placesBeyondNumbersAreErrors();
};

void TestSdoScenes::aSceneIsWhatItsLinesSay()
{
    const TableFiles files(goodFiles());
    const SceneResult result = SceneLoader(files).load("s.sdo", goodScene);
    QCOMPARE(remarks(result, goodScene), QString());
    QVERIFY(result.scene);
    const Scene &scene = *result.scene;
    QCOMPARE(scene.items.size(), 3u);
    using Kind = SceneDescription::Kind;
    QVERIFY(scene.items[0].kind == Kind::Object && scene.items[1].kind == Kind::Fractal
            && scene.items[2].kind == Kind::Ball);
    QCOMPARE(scene.items[1].path, std::string("a.fdo"));
    QCOMPARE(scene.items[1].model->meshPath, std::string("x.obj"));
    QCOMPARE(scene.items[1].model->graph.levels().levelCount(), Position(6));
    QVERIFY(scene.items[0].worldFromModel == AffineMap{});
    QVERIFY(scene.items[1].worldFromModel == mapFromParts({10, 0, 0}, {0, 90, 0}, {1, 1, 1}));
    QCOMPARE(scene.items[2].restitution, 0.6);
    QVERIFY(scene.items[2].velocity == glm::dvec3(1, 0, 0));
    QVERIFY(scene.camera && scene.camera->position == glm::dvec3(1, 2, 3) && scene.camera->view == 50.0);
    QVERIFY(scene.lights.size() == 1 && scene.lights[0].colour == glm::dvec3(1, 0.9, 0.8));
    QVERIFY(!scene.depth);
    // The fractal reaches 2 - 1/64 along its x, which a turn of 90 degrees about y leads to z.
    QVERIFY(std::abs(scene.extent.greatest.z - (2 - 1.0 / 64)) < 1e-12);
    QVERIFY(std::abs(scene.extent.greatest.x - 10.0) < 1e-12);
    QVERIFY(std::abs(scene.extent.greatest.y - 11.0) < 1e-12);
}

void TestSdoScenes::anEmptyTextIsAnEmptyScene()
{
    const TableFiles files({});
    const SceneResult result = SceneLoader(files).load("s.sdo", "# nothing yet\n");
    QVERIFY(result.diagnostics.empty());
    QVERIFY(result.scene && result.scene->items.empty());
}

void TestSdoScenes::aFileNamedTwiceIsOneModel()
{
    const TableFiles files(goodFiles());
    const std::string text = "o \"x.obj\" #\np \"x.obj\" # 1\nf \"a.fdo\" #\nf \"a.fdo\" ((1, 2, 3), #, #)\n";
    const auto scene = SceneLoader(files).load("s.sdo", text).scene;
    QVERIFY(scene);
    QCOMPARE(scene->items[0].model.get(), scene->items[1].model.get());
    QCOMPARE(scene->items[2].model.get(), scene->items[3].model.get());
    QCOMPARE(scene->items[2].model->mesh.get(), scene->items[0].model->mesh.get());
    QCOMPARE(files.reads(), 2);
}

void TestSdoScenes::pathsInAFractalAreRelativeToIt()
{
    TableFiles files(goodFiles());
    files.put("dir/x.obj", triangleObj + "f 3 2 1\n");
    const auto scene = SceneLoader(files).load("s.sdo", "f \"dir/b.fdo\" #").scene;
    QVERIFY(scene);
    QCOMPARE(scene->items[0].model->mesh->faces.size(), 2u);
}

void TestSdoScenes::whatIsWrongWithAFileIsSaidWhereItIsNamed_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *text, const char *expected) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(expected);
    };
    row("missing mesh", "# one\no \"none.obj\" #\n", "s.sdo:2:3: error: cannot read \"none.obj\": no such file");
    row("missing fractal", "f \"dir/none.fdo\" #", "s.sdo:1:3: error: cannot read \"dir/none.fdo\": no such file");
    row("each of several", "o \"x.obj\" #\no \"none.obj\" #\np \"none.obj\" # 1\nf \"none.fdo\" #",
        "s.sdo:2:3: error: cannot read \"none.obj\": no such file\n"
        "s.sdo:3:3: error: cannot read \"none.obj\": no such file\n"
        "s.sdo:4:3: error: cannot read \"none.fdo\": no such file");
    row("mesh with an error", "o \"bad.obj\" #",
        "s.sdo:1:3: error: cannot use \"bad.obj\": line 2, column 7: no vertex 7: 1 vertex so far\n"
        "bad.obj:2:7: note: no vertex 7: 1 vertex so far");
    row("mesh without faces", "p \"empty.obj\" # 0", "s.sdo:1:3: error: \"empty.obj\" has no faces");
    row("fractal with an error", "f \"bad.fdo\" #",
        "s.sdo:1:3: error: cannot use \"bad.fdo\": line 2, column 6: nothing named y is declared above\n"
        "bad.fdo:2:6: note: nothing named y is declared above");
    row("fractal with three", "f \"worse.fdo\" #",
        "s.sdo:1:3: error: cannot use \"worse.fdo\": 3 errors, the first in line 2, column 6: "
        "nothing named y is declared above\n"
        "worse.fdo:2:6: note: nothing named y is declared above\n"
        "worse.fdo:3:1: note: a name cannot start with a digit: \"1\"\n"
        "worse.fdo:4:6: note: after a name come three numbers, a dot or <, found the end of the line");
    row("fractal without its mesh", "f \"dir/lost.fdo\" #",
        "s.sdo:1:3: error: cannot use \"dir/lost.fdo\": line 1, column 6: cannot read \"../none.obj\": no such file\n"
        "dir/lost.fdo:1:6: note: cannot read \"../none.obj\": no such file");
    row("fractal with a bad mesh", "f \"dir/broken.fdo\" #",
        "s.sdo:1:3: error: cannot use \"dir/broken.fdo\": line 1, column 6: cannot use \"bad.obj\": line 1, column 1: "
        "a vertex has three coordinates, found 1\n"
        "dir/broken.fdo:1:6: note: cannot use \"bad.obj\": line 1, column 1: a vertex has three coordinates, found 1\n"
        "dir/bad.obj:1:1: note: a vertex has three coordinates, found 1");
    row("fractal that only warns", "f \"warns.fdo\" #", "");
    row("fractal that grows", "f \"grows.fdo\" #",
        "s.sdo:1:3: error: cannot use \"grows.fdo\": line 4, column 11: this grows beyond what can be computed "
        "with (1e153)\n"
        "grows.fdo:4:11: note: this grows beyond what can be computed with (1e153)");
    row("mesh that is huge", "o \"huge.obj\" #",
        "s.sdo:1:3: error: this grows beyond what can be computed with (1e153)");
    row("its own error", "o \"x.obj\"\n",
        "s.sdo:1:10: error: a transformation in parentheses or # expected, found the "
        "end of the line");
}

void TestSdoScenes::whatIsWrongWithAFileIsSaidWhereItIsNamed()
{
    QFETCH(const QString, text);
    TableFiles files(goodFiles());
    files.put("bad.obj", "v 0 0 0\nf 1 1 7\n");
    files.put("empty.obj", "");
    files.put("bad.fdo", "x. \"x.obj\"\n<$>. y\n");
    files.put("worse.fdo", "x. \"x.obj\"\n<$>. y\n1 2 3\nwrong\n");
    files.put("dir/lost.fdo", "<$>. \"../none.obj\"\n");
    files.put("dir/broken.fdo", "<$>. \"bad.obj\"\n");
    files.put("dir/bad.obj", "v 1\n");
    files.put("warns.fdo", "v 1 2 1e-999\nx. \"x.obj\"\n<$>. x\n");
    files.put("grows.fdo", "big 10 10 10\ns. (#, #, big)\nx. \"x.obj\"\nz<x>. [#, s] x\n<$>. z 1000");
    files.put("huge.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3");
    const std::string bytes = text.toStdString();
    const SceneResult result = SceneLoader(files).load("s.sdo", bytes);
    QTEST(remarks(result, bytes), "expected");
    QCOMPARE(result.scene != nullptr, !hasErrors(result.diagnostics));
    for (const Diagnostic &diagnostic : result.diagnostics) {
        const std::string marked = bytes.substr(diagnostic.range.begin, diagnostic.range.length());
        QVERIFY(marked.empty() || (marked.starts_with('"') && marked.ends_with('"')));
    }
}

void TestSdoScenes::onlyTheFirstTenErrorsAreNotes()
{
    TableFiles files(goodFiles());
    std::string bad;
    for (int i = 0; i < 25; ++i) {
        bad += "wrong\n";
    }
    files.put("bad.fdo", bad);
    const SceneResult result = SceneLoader(files).load("s.sdo", "f \"bad.fdo\" #");
    QCOMPARE(result.diagnostics.size(), 1u);
    QCOMPARE(result.diagnostics[0].notes.size(), 10u);
    QVERIFY(result.diagnostics[0].message().contains("26 errors")); // and no result
}

void TestSdoScenes::anFdoTextLeadsIntoItsMesh()
{
    TableFiles files({{"sub/bad.obj", "v 0 0 0\nf 1 1 7\n"}});
    const std::string text = "x. \"sub/bad.obj\"\n<$>. x\n";
    const SceneResult result = SceneLoader(files).load("s.fdo", text);
    QCOMPARE(remarks(result, text),
             QStringLiteral("s.sdo:1:4: error: cannot use \"sub/bad.obj\": line 2, column 7: no vertex 7: 1 vertex so "
                            "far\nsub/bad.obj:2:7: note: no vertex 7: 1 vertex so far"));
}

void TestSdoScenes::aTextThatChangesKeepsItsModels()
{
    const TableFiles files(goodFiles());
    SceneLoader loader(files);
    const auto first = loader.load("s.sdo", goodScene).scene;
    QVERIFY(!loader.load("s.sdo", goodScene + "o [").scene);
    const auto second = loader.load("s.sdo", "# another comment\n" + goodScene).scene;
    QVERIFY(first && second && first != second);
    for (std::size_t i = 0; i < first->items.size(); ++i) {
        QCOMPARE(first->items[i].model.get(), second->items[i].model.get());
    }
    // A missing file costs the others nothing.
    QVERIFY(!loader.load("s.sdo", goodScene + "o \"none.obj\" #").scene);
    QCOMPARE(loader.load("s.sdo", goodScene).scene->items[1].model.get(), first->items[1].model.get());
}

void TestSdoScenes::aFileThatChangesIsMadeAnew()
{
    TableFiles files(goodFiles());
    SceneLoader loader(files);
    const auto first = loader.load("s.sdo", goodScene).scene;
    files.put("a.fdo", fractalText + "# a comment\n");
    const auto second = loader.load("s.sdo", goodScene).scene;
    QVERIFY(first->items[1].model != second->items[1].model);
    QCOMPARE(first->items[1].model->mesh.get(), second->items[1].model->mesh.get());
    QCOMPARE(first->items[0].model.get(), second->items[0].model.get());
    files.put("a.fdo", "");
    QVERIFY(!loader.load("s.sdo", goodScene).scene);
    files.put("a.fdo", fractalText);
    QVERIFY(loader.load("s.sdo", goodScene).scene);
}

void TestSdoScenes::aModelIsMadeAnewWithItsMesh()
{
    TableFiles files(goodFiles());
    SceneLoader loader(files);
    const std::string text = "f \"a.fdo\" #\n";
    const auto first = loader.load("s.sdo", text).scene;
    files.put("x.obj", triangleObj + "f 3 2 1\n");
    QCOMPARE(loader.load("s.sdo", text).scene->items[0].model->mesh->faces.size(), 2u);
    files.put("x.obj", "");
    QVERIFY(!loader.load("s.sdo", text).scene);
    files.put("x.obj", triangleObj);
    QCOMPARE(loader.load("s.sdo", text).scene->items[0].model->mesh->faces.size(), 1u);
    QCOMPARE(first->items[0].model->mesh->faces.size(), 1u);
}

void TestSdoScenes::whatIsNoLongerNamedIsForgotten()
{
    const TableFiles files(goodFiles());
    SceneLoader loader(files);
    const std::weak_ptr<const Model> fractal =
        loader.load("s.sdo", "o \"y.obj\" #\nf \"a.fdo\" #").scene->items[1].model;
    QVERIFY(!fractal.expired());
    QVERIFY(!loader.load("s.sdo", "o \"y.obj\" #\nwrong").scene); // nobody knows what such a text needs
    QVERIFY(!fractal.expired());
    QVERIFY(loader.load("s.sdo", "o \"y.obj\" #\n").scene);
    QVERIFY(fractal.expired());

    const std::weak_ptr<const Mesh> mesh = loader.load("s.sdo", "o \"y.obj\" #\n").scene->items[0].model->mesh;
    QVERIFY(!mesh.expired());
    QVERIFY(loader.load("a.fdo", fractalText).scene);
    QVERIFY(mesh.expired());
}

void TestSdoScenes::stoppingIsHeardBetweenFiles()
{
    const StoppingFiles files;
    const std::string text = "o \"a.obj\" #\no \"b.obj\" #\no \"c.obj\" #\no \"d.obj\" #\n";
    const SceneResult result = SceneLoader(files).load("s.sdo", text, files.stop.get_token());
    QVERIFY(!result.scene);
    QCOMPARE(files.reads, 2);
}

void TestSdoScenes::placesBeyondNumbersAreErrors_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("isGood");
    const auto row = [](const char *line, bool isGood) { QTest::newRow(line) << QString::fromLatin1(line) << isGood; };
    row("f \"a.fdo\" ((1e300, 0, 0), #, #)", false);
    row("f \"a.fdo\" ((0, 1.1e153, 0), #, #)", false);
    row("f \"a.fdo\" ((0.9e153, 0, 0), #, #)", true);
    row("f \"a.fdo\" (#, #, (1e300, 1, 1))", false);
    row("f \"a.fdo\" (#, #, (1.7e308, 1.7e308, 1.7e308))", false);
    row("f \"a.fdo\" (#, (10, 20, 30), (1e308, 1e308, 1e308))", false);
    row("f \"a.fdo\" ((1e308, -1e308, 1e308), (10, 20, 30), (-1e308, 1e308, 1e308))", false);
    row("o \"x.obj\" (#, (1e300, 1e300, 1e300), (1e152, 1e152, 1e152))", true);
    row("o \"x.obj\" (#, #, (1e-300, 0, 1e-300))", true);
    row("p \"x.obj\" ((-1e155, 0, 0), #, #) 1", false);
    row("c (1e200, 0, 0) # 60", false);
    row("c (1e152, 0, 0) (1e300, 0, 0) 60", true);
}

void TestSdoScenes::placesBeyondNumbersAreErrors()
{
    QFETCH(const QString, line);
    QFETCH(const bool, isGood);
    const TableFiles files(goodFiles());
    const std::string text = "o \"x.obj\" #\n" + line.toStdString() + '\n';
    const SceneResult result = SceneLoader(files).load("s.sdo", text);
    QCOMPARE(result.scene != nullptr, isGood);
    if (isGood) {
        QVERIFY(std::isfinite(glm::length(result.scene->extent.size())));
        return;
    }
    QCOMPARE(result.diagnostics.size(), 1u);
    QVERIFY(result.diagnostics[0].code == DiagnosticCode::Overflow);
    QCOMPARE(LineMap(text).position(result.diagnostics[0].range.begin).line, 2u);
}

}

ROMANESCO_TEST(romanesco::test::TestSdoScenes)

#include "testsdoscenes.moc"
