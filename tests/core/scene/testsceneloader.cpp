// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/scene/sceneloader.h"

#include <QTemporaryDir>
#include <QTest>

#include "core/text/linemap.h"
#include "tests/core/scene/tablefiles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// "2:5 error cannot-read: …", a line each.
QString remarks(const SceneResult &result, std::string_view text)
{
    QStringList all;
    for (const Diagnostic &diagnostic : result.diagnostics) {
        const TextPosition at = LineMap(text).position(diagnostic.range.begin);
        all.push_back(
            QStringLiteral("%1:%2 %3: %4")
                .arg(at.line)
                .arg(at.column)
                .arg(QLatin1String(name(diagnostic.code).data()), QString::fromStdString(diagnostic.message())));
    }
    return all.join(QLatin1Char('\n'));
}

/// Of a scene of one item.
const Model &modelOf(const std::shared_ptr<const Scene> &scene)
{
    return *scene->items.at(0).model;
}

const std::string good = "v 1 0 0\nhalf 0.5 0.5 0.5\nt. (1, #, half)\nx. \"x.obj\"\nz<x>. [#, t] x\n<$>. z 6\n";

}

class TestSceneLoader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aGoodTextBecomesAScene();
    void whatIsWrongIsSaidAtItsPlace_data();
    void whatIsWrongIsSaidAtItsPlace();
    void pathsAreRelativeToTheirText_data();
    void pathsAreRelativeToTheirText();
    void aDirectoryIsNoMesh();
    void aTextThatChangesKeepsItsMesh();
    void aMeshThatChangesIsReadAnew();
    void errorsLeaveNoScene();
    void objTextsAreScenesToo();
    void stoppingLeavesNoScene();
    void endingsTellTheKind_data();
    void endingsTellTheKind();
};

void TestSceneLoader::aGoodTextBecomesAScene()
{
    const TableFiles files({{"x.obj", triangleObj}});
    SceneLoader loader(files);
    const SceneResult result = loader.load("a.fdo", good);
    QVERIFY(result.diagnostics.empty());
    QVERIFY(result.scene);
    QCOMPARE(modelOf(result.scene).meshPath, "x.obj");
    QCOMPARE(modelOf(result.scene).mesh->faces.size(), 1u);
    QCOMPARE(modelOf(result.scene).graph.levels().levelCount(), Position(6));
    QCOMPARE(result.scene->depth->value, 6u);
    // Six times towards 2: from 0 to 2 - 2/64 + 1/64.
    QVERIFY(std::abs(result.scene->extent.greatest.x - (2 - 1.0 / 64)) < 1e-12);
    QVERIFY(std::abs(result.scene->extent.least.x) < 1e-12);
}

void TestSceneLoader::whatIsWrongIsSaidAtItsPlace_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<QString>("expected");
    const QString triangle = QString::fromStdString(triangleObj);
    const auto row = [](const char *name, const QString &text, const QString &mesh, const char *expected) {
        QTest::newRow(name) << text << mesh << QString::fromUtf8(expected);
    };
    row("missing mesh", "# one\nx. \"none.obj\"\n<$>. x", triangle,
        "2:4 cannot-read: cannot read \"none.obj\": no such file");
    row("mesh with an error", "# one\nx. \"x.obj\"\n<$>. x", "v 0 0 0\nf 1 1 7\n",
        "2:4 bad-mesh: cannot use \"x.obj\": line 2, column 7: no vertex 7: 1 vertex so far");
    row("mesh in UTF-16", "x. \"x.obj\"\n<$>. x", QString::fromLatin1("\xFF\xFE"),
        "1:4 mesh-without-faces: \"x.obj\" has no faces"); // the bytes here are UTF-8 of other letters
    row("mesh without faces", "x. \"x.obj\"\n<$>. x", "v 0 0 0\n", "1:4 mesh-without-faces: \"x.obj\" has no faces");
    row("empty mesh", "x. \"x.obj\"\n<$>. x", "", "1:4 mesh-without-faces: \"x.obj\" has no faces");
    row("syntax error", "x. \"x.obj\"\n<$>. [t x", triangle, "2:9 expected: \",\" or \"]\" expected, found \"x\"");
    row("empty text", "", triangle, "1:1 no-result: the file has no result: a line \"<$>. NAME\" is missing");
    row("error beside the result", "x. \"x.obj\"\n<$>. x\nwrong", triangle,
        "3:6 expected-after-name: after a name come three numbers, a dot or <, found the end of the line");
    row("error and missing mesh", "x. \"none.obj\"\n<$>. x\nwrong", triangle,
        "1:4 cannot-read: cannot read \"none.obj\": no such file\n"
        "3:6 expected-after-name: after a name come three numbers, a dot or <, found the end of the line");
    row("a mesh nobody needs is not read", "x. \"x.obj\"\ny. \"none.obj\"\n<$>. x", triangle,
        "2:1 unused: y is never used");
    row("overflow by growth", "big 10 10 10\ns. (#, #, big)\nx. \"x.obj\"\nz<x>. [#, s] x\n<$>. z 1000", triangle,
        "4:11 overflow: this grows beyond what can be computed with (1e153)");
    row("overflow by a move", "far 1e300 0 0\ns. (far, #, #)\nx. \"x.obj\"\n<$>. [#, s] x", triangle,
        "4:10 overflow: this grows beyond what can be computed with (1e153)");
    row("overflow by the mesh", "x. \"x.obj\"\n<$>. x", "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3",
        "1:4 overflow: this grows beyond what can be computed with (1e153)");
    const char *one = "x. \"x.obj\"\n<$>. x";
    row("a mesh just within", one, "v 0 0 0.8e153\nv 1 0 0.8e153\nv 0 1 0.8e153\nf 1 2 3", "");
    row("overflow by the mesh's place", one, "v 0 0 1.1e153\nv 1 0 1.1e153\nv 0 1 1.1e153\nf 1 2 3",
        "1:4 overflow: this grows beyond what can be computed with (1e153)");
    row("overflow with an unused set",
        "big 10 10 10\nmore 20 20 20\ns.a. (#, #, a)\nx. \"x.obj\"\ny. [s.more] x\n"
        "z<x>. [#, s.big] x\n<$>. z 1000",
        triangle, "5:1 unused: y is never used\n6:11 overflow: this grows beyond what can be computed with (1e153)");
}

void TestSceneLoader::whatIsWrongIsSaidAtItsPlace()
{
    QFETCH(QString, text);
    QFETCH(QString, mesh);
    const TableFiles files({{"x.obj", mesh.toStdString()}});
    const std::string bytes = text.toStdString();
    SceneLoader loader(files);
    const SceneResult result = loader.load("a.fdo", bytes);
    QTEST(remarks(result, bytes), "expected");
    QCOMPARE(result.scene != nullptr, !hasErrors(result.diagnostics));
}

void TestSceneLoader::pathsAreRelativeToTheirText_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<QString>("file");
    QTest::newRow("beside") << "a.fdo" << "x.obj" << "x.obj";
    QTest::newRow("in the folder of the text") << "dir/a.fdo" << "x.obj" << "dir/x.obj";
    QTest::newRow("below") << "/top/a.fdo" << "sub/x.obj" << "/top/sub/x.obj";
    QTest::newRow("above") << "/top/a.fdo" << "../x.obj" << "/top/../x.obj";
    QTest::newRow("absolute") << "/top/a.fdo" << "/else/x.obj" << "/else/x.obj";
    QTest::newRow("blanks and other letters") << "/t o p/a.fdo" << "\u00FC b.obj" << "/t o p/\u00FC b.obj";
}

void TestSceneLoader::pathsAreRelativeToTheirText()
{
    QFETCH(QString, text);
    QFETCH(QString, mesh);
    QFETCH(QString, file);
    const TableFiles files({{file.toStdString(), triangleObj}});
    SceneLoader loader(files);
    QVERIFY(loader.load(text.toStdString(), "x. \"" + mesh.toStdString() + "\"\n<$>. x").scene);
}

void TestSceneLoader::aDirectoryIsNoMesh()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("x.obj")));
    const DiskFiles files;
    SceneLoader loader(files);
    const std::string text = "x. \"x.obj\"\n<$>. x";
    const SceneResult result = loader.load(folder.filePath(QStringLiteral("a.fdo")).toStdString(), text);
    QCOMPARE(remarks(result, text), "1:4 cannot-read: cannot read \"x.obj\": it is a directory");
}

void TestSceneLoader::aTextThatChangesKeepsItsMesh()
{
    const TableFiles files({{"x.obj", triangleObj}});
    SceneLoader loader(files);
    const auto first = loader.load("a.fdo", good).scene;
    const auto second = loader.load("a.fdo", "# another comment\n" + good).scene;
    QVERIFY(first && second && first != second);
    QCOMPARE(modelOf(first).mesh.get(), modelOf(second).mesh.get());

    // Even after a text that has no scene.
    QVERIFY(!loader.load("a.fdo", "x. \"x.obj\"\n<$>. [").scene);
    QCOMPARE(modelOf(loader.load("a.fdo", good).scene).mesh.get(), modelOf(first).mesh.get());
}

void TestSceneLoader::aMeshThatChangesIsReadAnew()
{
    TableFiles files({{"x.obj", triangleObj}});
    SceneLoader loader(files);
    const auto first = loader.load("a.fdo", good).scene;
    files.put("x.obj", triangleObj + "f 3 2 1\n");
    const auto second = loader.load("a.fdo", good).scene;
    QCOMPARE(modelOf(first).mesh->faces.size(), 1u); // the old scene is as it was
    QCOMPARE(modelOf(second).mesh->faces.size(), 2u);
    files.put("x.obj", "f 1 2 3");
    QVERIFY(!loader.load("a.fdo", good).scene);
    files.put("x.obj", triangleObj);
    QCOMPARE(modelOf(loader.load("a.fdo", good).scene).mesh->faces.size(), 1u);
}

void TestSceneLoader::errorsLeaveNoScene()
{
    const TableFiles files({{"x.obj", triangleObj}});
    SceneLoader loader(files);
    QVERIFY(!loader.load("a.fdo", good + "v 1 1\n").scene);
    QVERIFY(loader.load("a.fdo", good + "v 1 1 1\n").scene);
    QVERIFY(loader.load("a.fdo", good + "unused. x\n").scene); // a hint is no error
}

void TestSceneLoader::objTextsAreScenesToo()
{
    const TableFiles files({});
    SceneLoader loader(files);
    const SceneResult mesh = loader.load("dir/X.OBJ", triangleObj);
    QVERIFY(mesh.scene);
    QCOMPARE(modelOf(mesh.scene).graph.levels().levelCount(), Position(0));
    QVERIFY(mesh.scene->extent.greatest == glm::dvec3(1, 1, 0));
    QVERIFY(!mesh.scene->depth);
    QCOMPARE(files.reads(), 0);
    QCOMPARE(remarks(loader.load("x.obj", "v 1 2"), "v 1 2"),
             "1:1 obj-too-few-coordinates: a vertex has three coordinates, found 2");
    QCOMPARE(remarks(loader.load("x.obj", "v 1 2 3"), "v 1 2 3"), "1:1 mesh-without-faces: the mesh has no faces");
}

void TestSceneLoader::stoppingLeavesNoScene()
{
    const TableFiles files({{"x.obj", triangleObj}});
    SceneLoader loader(files);
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!loader.load("a.fdo", good, stop.get_token()).scene);
    QVERIFY(loader.load("a.fdo", good).scene);
}

void TestSceneLoader::endingsTellTheKind_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("kind");
    QTest::newRow("fdo") << "a/b.fdo" << int(FileKind::Fdo);
    QTest::newRow("FDO") << "B.FDO" << int(FileKind::Fdo);
    QTest::newRow("obj") << "b.Obj" << int(FileKind::Obj);
    QTest::newRow("sdo") << "a.b/c.Sdo" << int(FileKind::Sdo);
    QTest::newRow("two endings") << "b.fdo.obj" << int(FileKind::Obj);
    QTest::newRow("none") << "fdo" << int(FileKind::Other);
    QTest::newRow("hidden") << ".fdo" << int(FileKind::Other);
    QTest::newRow("folder with an ending") << "a.fdo/b" << int(FileKind::Other);
    QTest::newRow("other") << "b.fdox" << int(FileKind::Other);
}

void TestSceneLoader::endingsTellTheKind()
{
    QFETCH(QString, path);
    QFETCH(int, kind);
    QCOMPARE(int(fileKind(path.toStdString())), kind);
}

}

ROMANESCO_TEST(romanesco::test::TestSceneLoader)

#include "testsceneloader.moc"
