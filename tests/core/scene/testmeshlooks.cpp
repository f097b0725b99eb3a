// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include "core/scene/sceneloader.h"
#include "core/text/linemap.h"
#include "core/text/places.h"
#include "tests/core/scene/tablefiles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Files = std::map<std::string, std::string>;

const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string redObj = "mtllib m.mtl\nusemtl red\n" + face + "f 1 2 3\n";
const std::string redMtl = "newmtl red\nKd 1 0 0\n";

/// All that is said of a text, as a compiler would.
QString lines(const SceneResult &result, const std::string &text, const std::string &name)
{
    const LineMap map(text);
    Places places(map);
    QStringList all;
    for (const Diagnostic &diagnostic : result.diagnostics) {
        all.push_back(QString::fromStdString(toLines(diagnostic, name, places)));
    }
    return all.join(QLatin1Char('\n'));
}

const Mesh &meshOf(const SceneResult &result)
{
    return *result.scene->items.at(0).model->mesh;
}

/// "name 1 0 0 texture", a line each.
QString looks(const Mesh &mesh)
{
    QStringList all;
    for (const Material &material : mesh.materials) {
        const auto &[r, g, b] = std::array{material.diffuse.x, material.diffuse.y, material.diffuse.z};
        all.push_back(QStringLiteral("%1 %2 %3 %4 %5")
                          .arg(QString::fromStdString(material.name))
                          .arg(static_cast<double>(r))
                          .arg(static_cast<double>(g))
                          .arg(static_cast<double>(b))
                          .arg(QString::fromStdString(material.diffuseTexture.generic_string()))
                          .trimmed());
    }
    return all.join(QLatin1Char('\n'));
}

}

class TestMeshLooks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void materialsHaveTheLooksOfTheirFiles_data();
    void materialsHaveTheLooksOfTheirFiles();
    void onlyRegularFilesAreRead_data();
    void onlyRegularFilesAreRead();
    void remarksLeadFromTheTextThatNamesTheMesh_data();
    void remarksLeadFromTheTextThatNamesTheMesh();
    void aMeshKeepsItsLooksWhileTheirFilesStay();
    void looksThatChangeAreRenewed();
};

void TestMeshLooks::materialsHaveTheLooksOfTheirFiles_data()
{
    QTest::addColumn<Files>("files");
    QTest::addColumn<std::string>("text");
    QTest::addColumn<QString>("expected");
    QTest::addColumn<QString>("remarks");
    const auto row = [](const char *name, const Files &files, const std::string &text, const char *expected,
                        const char *remarks = "") {
        QTest::newRow(name) << files << text << QString::fromUtf8(expected) << QString::fromUtf8(remarks);
    };
    const std::string use = face + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\n";
    row("no materials", {}, face + "f 1 2 3", "");
    row("one", {{"dir/m.mtl", redMtl}}, redObj, "red 1 0 0");
    row("two in one file", {{"dir/m.mtl", redMtl + "newmtl blue\nKd 0 0 1\n"}}, "mtllib m.mtl\n" + use,
        "red 1 0 0\nblue 0 0 1");
    row("two files", {{"dir/m.mtl", redMtl}, {"dir/n.mtl", "newmtl blue\nKd 0 0 1\n"}}, "mtllib m.mtl n.mtl\n" + use,
        "red 1 0 0\nblue 0 0 1");
    row("the first of a name", {{"dir/m.mtl", redMtl + "newmtl red\nKd 0 1 0"}, {"dir/n.mtl", "newmtl red\nKd 0 0 1"}},
        "mtllib m.mtl n.mtl\nusemtl red\n" + face + "f 1 2 3", "red 1 0 0");
    row("named after the faces", {{"dir/m.mtl", redMtl}}, face + "usemtl red\nf 1 2 3\nmtllib m.mtl\n", "red 1 0 0");
    row("a folder, with the other slash", {{"dir/sub/m.mtl", redMtl}},
        "mtllib sub\\m.mtl\nusemtl red\n" + face + "f 1 2 3", "red 1 0 0");
    row("an absolute path", {{"/top/m.mtl", redMtl}}, "mtllib /top/m.mtl\nusemtl red\n" + face + "f 1 2 3",
        "red 1 0 0");
    row("texture beside its file",
        {{"dir/sub/m.mtl", redMtl + "map_Kd ..\\tex\\a b.png"}, {"dir/sub/../tex/a b.png", "x"}},
        "mtllib sub/m.mtl\nusemtl red\n" + face + "f 1 2 3", "red 1 0 0 dir/sub/../tex/a b.png");
    row("no file", {}, redObj, "red 0.8 0.8 0.8", "x.obj:1:1: warning: no materials from \"m.mtl\": no such file");
    row("one of two files", {{"dir/m.mtl", redMtl}}, "mtllib m.mtl none.mtl\n" + use, "red 1 0 0\nblue 0.8 0.8 0.8",
        "x.obj:1:1: warning: no materials from \"none.mtl\": no such file");
    row("not in the file", {{"dir/m.mtl", redMtl}}, "mtllib m.mtl\n" + use, "red 1 0 0\nblue 0.8 0.8 0.8",
        "x.obj:7:1: warning: material \"blue\" is not described; the default look stands in");
    row("no mtllib", {}, use + "usemtl green\nf 1 2 3\n", "red 0.8 0.8 0.8\nblue 0.8 0.8 0.8\ngreen 0.8 0.8 0.8",
        "x.obj:4:1: warning: material \"red\" and 2 more are not described; the default look stands in");
    row("no texture", {{"dir/m.mtl", redMtl + "map_Kd -s 1 1 none.png"}}, redObj, "red 1 0 0",
        "x.obj:1:1: warning: \"m.mtl\": line 3, column 15: no texture \"none.png\": no such file\n"
        "dir/m.mtl:3:15: note: no texture \"none.png\": no such file");
    row("the texture of a material that nothing uses", {{"dir/m.mtl", redMtl + "newmtl b\nmap_Kd none.png"}}, redObj,
        "red 1 0 0");
    row("what is no number", {{"dir/m.mtl", redMtl + "Ks x\nd y\n"}}, redObj, "red 1 0 0",
        "x.obj:1:1: warning: \"m.mtl\": 2 remarks, the first in line 3, column 4: \"x\" is not a number\n"
        "dir/m.mtl:3:4: note: \"x\" is not a number\ndir/m.mtl:4:3: note: \"y\" is not a number");
    row("no text", {{"dir/m.mtl", "\x1F\x8B"}}, redObj, "red 0.8 0.8 0.8",
        "x.obj:1:1: warning: \"m.mtl\": line 1, column 1: the file is compressed; unpack it first\n"
        "dir/m.mtl:1:1: note: the file is compressed; unpack it first");
    row("itself", {{"dir/x.obj", redObj}}, "mtllib x.obj\nusemtl red\n" + face + "f 1 2 3", "red 0.8 0.8 0.8",
        "x.obj:2:1: warning: material \"red\" is not described; the default look stands in");
}

void TestMeshLooks::materialsHaveTheLooksOfTheirFiles()
{
    QFETCH(Files, files);
    QFETCH(std::string, text);
    const TableFiles table(files);
    SceneLoader loader(table);
    const SceneResult result = loader.load("dir/x.obj", text);
    QVERIFY(result.scene);
    QTEST(looks(meshOf(result)), "expected");
    QString said = lines(result, text, "dir/x.obj");
    QTEST(said.replace(QLatin1String("dir/x.obj"), QLatin1String("x.obj")), "remarks");
}

void TestMeshLooks::onlyRegularFilesAreRead_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("missing") << "none.mtl" << "no such file";
    QTest::newRow("folder above") << "../.." << "it is a directory";
    QTest::newRow("endless device") << "/dev/zero" << "it is not a regular file";
    QTest::newRow("terminal") << "/dev/tty" << "";
    QTest::newRow("pipe without a writer") << "pipe.mtl" << "it is not a regular file";
    QTest::newRow("link to itself") << "loop.mtl" << "too many symbolic links";
}

void TestMeshLooks::onlyRegularFilesAreRead()
{
    QFETCH(QString, name);
    QFETCH(QString, reason);
    const QTemporaryDir folder;
    QCOMPARE(::mkfifo(folder.filePath(QStringLiteral("pipe.mtl")).toUtf8().constData(), 0600), 0);
    QVERIFY(QFile::link(QStringLiteral("loop.mtl"), folder.filePath(QStringLiteral("loop.mtl"))));
    QFile mtl(folder.filePath(QStringLiteral("good.mtl")));
    QVERIFY(mtl.open(QIODevice::WriteOnly));
    mtl.write(QByteArray::fromStdString(redMtl) + "map_Kd " + name.toUtf8() + '\n');
    mtl.close();
    const DiskFiles disk;
    SceneLoader loader(disk);
    const std::string place = folder.filePath(QStringLiteral("x.obj")).toStdString();

    const std::string text = "mtllib " + name.toStdString() + "\nusemtl red\n" + face + "f 1 2 3\n";
    const SceneResult library = loader.load(place, text);
    QVERIFY(library.scene);
    QCOMPARE(looks(meshOf(library)), QStringLiteral("red 0.8 0.8 0.8"));
    QCOMPARE(library.diagnostics.size(), 1u);
    QCOMPARE(library.diagnostics[0].code, DiagnosticCode::ObjLibraryUnread);

    const SceneResult texture = loader.load(place, "mtllib good.mtl\nusemtl red\n" + face + "f 1 2 3\n");
    QVERIFY(texture.scene);
    QCOMPARE(looks(meshOf(texture)), QStringLiteral("red 1 0 0"));
    QCOMPARE(texture.diagnostics.size(), 1u);
    QCOMPARE(texture.diagnostics[0].code, DiagnosticCode::FileRemarks);
    if (!reason.isEmpty()) { // there may be no terminal
        QCOMPARE(QString::fromStdString(library.diagnostics[0].arguments.at(1)), reason);
        QVERIFY(texture.diagnostics[0].message().ends_with(reason.toStdString()));
    }
}

void TestMeshLooks::remarksLeadFromTheTextThatNamesTheMesh_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<std::string>("text");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, const char *path, const std::string &text, const char *expected) {
        QTest::newRow(name) << QString::fromUtf8(path) << text << QString::fromUtf8(expected);
    };
    row("an .fdo", "a.fdo", "x. \"sub/x.obj\"\n<$>. x\n",
        "a.fdo:1:4: warning: \"sub/x.obj\": 2 remarks, the first in line 1, column 1: \"m.mtl\": line 2, column 4: "
        "\"x\" is not a number\n"
        "sub/x.obj:1:1: note: \"m.mtl\": line 2, column 4: \"x\" is not a number\n"
        "sub/m.mtl:2:4: note: \"x\" is not a number\n"
        "sub/x.obj:6:1: note: points are passed over (in 1 place)");
    row("an .fdo with an error", "a.fdo", "x. \"sub/x.obj\"\n<$>. [\n",
        "a.fdo:1:4: warning: \"sub/x.obj\": 2 remarks, the first in line 1, column 1: \"m.mtl\": line 2, column 4: "
        "\"x\" is not a number\n"
        "sub/x.obj:1:1: note: \"m.mtl\": line 2, column 4: \"x\" is not a number\n"
        "sub/m.mtl:2:4: note: \"x\" is not a number\n"
        "sub/x.obj:6:1: note: points are passed over (in 1 place)\n"
        "a.fdo:2:7: error: a transformation or # expected, found the end of the line");
    row("a scene, once", "a.sdo", "o \"points.obj\" #\n\np \"points.obj\" # 1\n",
        "a.sdo:1:3: warning: \"points.obj\": line 5, column 1: points are passed over (in 1 place)\n"
        "points.obj:5:1: note: points are passed over (in 1 place)");
    row("a scene with an error", "a.sdo", "x\no \"points.obj\" #\n",
        "a.sdo:1:1: error: a line starts with c (camera), o (object), f (fractal), p (ball) or l (light), found \"x\"\n"
        "a.sdo:2:3: warning: \"points.obj\": line 5, column 1: points are passed over (in 1 place)\n"
        "points.obj:5:1: note: points are passed over (in 1 place)");
}

void TestMeshLooks::remarksLeadFromTheTextThatNamesTheMesh()
{
    QFETCH(QString, path);
    QFETCH(std::string, text);
    const TableFiles table({{"sub/x.obj", redObj.substr(0, redObj.find("f 1")) + "p 1\nf 1 2 3\n"},
                            {"sub/m.mtl", "newmtl red\nKd x\n"},
                            {"points.obj", face + "f 1 2 3\np 1\n"}});
    SceneLoader loader(table);
    for (int i = 0; i < 2; ++i) { // what is known already says the same
        const SceneResult result = loader.load(path.toStdString(), text);
        QTEST(lines(result, text, path.toStdString()), "expected");
        QCOMPARE(result.scene != nullptr, !hasErrors(result.diagnostics));
    }
}

void TestMeshLooks::aMeshKeepsItsLooksWhileTheirFilesStay()
{
    const TableFiles files({{"x.obj", redObj}, {"m.mtl", redMtl + "map_Kd a.png"}, {"a.png", ""}});
    SceneLoader loader(files);
    const SceneResult first = loader.load("a.fdo", "x. \"x.obj\"\n<$>. x");
    const SceneResult second = loader.load("a.fdo", "# now\nx. \"x.obj\"\n<$>. x");
    QCOMPARE(looks(meshOf(first)), QStringLiteral("red 1 0 0 a.png"));
    QCOMPARE(&meshOf(first), &meshOf(second));
}

void TestMeshLooks::looksThatChangeAreRenewed()
{
    TableFiles files({{"x.obj", redObj}, {"y.fdo", "x. \"x.obj\"\n<$>. x"}});
    SceneLoader loader(files);
    for (const std::string text : {"x. \"x.obj\"\n<$>. x", "o \"x.obj\" #", "f \"y.fdo\" #"}) {
        const char *path = text.starts_with('x') ? "a.fdo" : "a.sdo";
        const auto look = [&] { return looks(meshOf(loader.load(path, text))); };
        files.put("m.mtl", redMtl);
        QCOMPARE(look(), QStringLiteral("red 1 0 0"));
        files.put("m.mtl", "newmtl red\nKd 0 1 0\nmap_Kd a.png\n");
        QCOMPARE(look(), QStringLiteral("red 0 1 0"));
        files.put("a.png", "");
        QCOMPARE(look(), QStringLiteral("red 0 1 0 a.png"));
        files.remove("a.png");
        files.remove("m.mtl");
        QCOMPARE(look(), QStringLiteral("red 0.8 0.8 0.8"));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestMeshLooks)

#include "testmeshlooks.moc"
