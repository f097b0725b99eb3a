// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include <signal.h>
#include <sys/stat.h>

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestCommands : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        write(path("triangle.obj"), triangle);
        write(path("good.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 3\n");
        write(path("other.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 3\n");
        write(path("plain.fdo"), "<$>. \"triangle.obj\"\n");
        write(path("empty.fdo"), "");
        write(path("syntax.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, # #)\n<$>. x\n");
        write(path("nomesh.fdo"), "x. \"gone.obj\"\n<$>. x\n");
        write(path("huge.obj"), "v 0 0 0\nv 1e200 0 0\nv 0 1e200 0\nf 1 2 3\n");
        write(path("scene.sdo"),
              "c (0, 0, -4) # 60\no \"triangle.obj\" #\nf \"good.fdo\" ((0, 2, 0), #, #)\n"
              "f \"other.fdo\" ((0, -2, 0), #, #)\np \"triangle.obj\" ((9, 0, 0), #, #) 0.5\n");
        write(path("plain.sdo"), "o \"triangle.obj\" #\nf \"plain.fdo\" #\n");
        write(path("one.sdo"), "f \"good.fdo\" ((0, 2, 0), #, #)\n");
        write(path("bad.sdo"), "o \"triangle.obj\" #\nf \"syntax.fdo\" #\n");
        QFile sparse(path("sparse.fdo"));
        QVERIFY(sparse.open(QIODevice::WriteOnly) && sparse.resize(100'000'000'000));
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("folder.fdo")));
        QCOMPARE(::mkfifo(path("pipe").toUtf8().constData(), 0600), 0);
    }

    void infoCountsAppendixB()
    {
        const Outcome outcome = run({QStringLiteral("info"), examples + QStringLiteral("appendix-b.fdo")});
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.out.contains("244140625"));
        QVERIFY(outcome.out.contains("172855881"));
        QCOMPARE(outcome.err, QByteArray());
    }

    void infoSpeaksJson()
    {
        const Outcome outcome =
            run({QStringLiteral("info"), QStringLiteral("--json"), examples + QStringLiteral("appendix-b.fdo")});
        QCOMPARE(outcome.status, 0);
        const QJsonObject object = QJsonDocument::fromJson(outcome.out).object();
        QCOMPARE(object[QStringLiteral("instances_as_written")].toString(), QStringLiteral("244140625"));
        QCOMPARE(object[QStringLiteral("instances_distinct")].toString(), QStringLiteral("172855881"));
        QCOMPARE(object[QStringLiteral("transforms_per_iteration")].toInt(), 25);
        QCOMPARE(object[QStringLiteral("depth")].toInt(), 6);
        QCOMPARE(object[QStringLiteral("levels")].toArray().size(), 12);
        QCOMPARE(object[QStringLiteral("faces_per_base")].toInt(), 14);
        QVERIFY(object[QStringLiteral("contracting")].toBool());
        const QJsonObject storage = object[QStringLiteral("storage")].toObject();
        const qint64 source = QFileInfo(examples + QStringLiteral("appendix-b.fdo")).size()
            + QFileInfo(examples + QStringLiteral("FractalBase.obj")).size();
        QCOMPARE(storage[QStringLiteral("source_bytes")].toString(), QString::number(source));
        // 14 faces and 9 vertices a copy, of some 31 and 58 bytes
        const double flattened = storage[QStringLiteral("flattened_obj_bytes")].toString().toDouble();
        QVERIFY2(flattened > 172855881.0 * 700 && flattened < 172855881.0 * 1300,
                 qPrintable(QString::number(flattened)));
    }

    void infoTellsTheDimension()
    {
        const Outcome text = run({QStringLiteral("info"), examples + QStringLiteral("sierpinski.fdo")});
        QVERIFY2(text.out.contains("\ndimension    2 (similarity)\n"), text.out);

        const Outcome menger =
            run({QStringLiteral("info"), QStringLiteral("--json"), examples + QStringLiteral("menger.fdo")});
        const double dimension = QJsonDocument::fromJson(menger.out)[QStringLiteral("similarity_dimension")].toDouble();
        QVERIFY2(std::abs(dimension - std::log(20) / std::log(3)) < 1e-9, menger.out);
    }

    void whatDoesNotShrinkHasNoDimension()
    {
        const Outcome text = run({QStringLiteral("info"), path("good.fdo")});
        QCOMPARE(text.status, 0);
        QVERIFY2(!text.out.contains("dimension"), text.out);

        const Outcome json = run({QStringLiteral("info"), QStringLiteral("--json"), path("good.fdo")});
        const QJsonObject object = QJsonDocument::fromJson(json.out).object();
        QVERIFY(object.contains(QStringLiteral("similarity_dimension")));
        QVERIFY(object[QStringLiteral("similarity_dimension")].isNull());
    }

    void depthReplacesTheTextsDepth()
    {
        const Outcome outcome =
            run({QStringLiteral("info"), path("good.fdo"), QStringLiteral("--depth"), QStringLiteral("10")});
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.out.contains("1024 as written"));
        QVERIFY(outcome.out.contains("11 distinct"));
    }

    void infoAddsUpAScene()
    {
        const Outcome text = run({QStringLiteral("info"), path("scene.sdo")});
        QCOMPARE(text.status, 0);
        QVERIFY2(text.out.contains("o \"triangle.obj\": instances 1, faces 1\n"), text.out);
        QVERIFY2(text.out.contains("f \"good.fdo\": instances 8, faces 8\n"), text.out);
        QVERIFY2(text.out.contains("p \"triangle.obj\": instances 1, faces 1\n"), text.out);
        QVERIFY2(text.out.contains("18 as written"), text.out);
        QVERIFY(!text.out.contains("base "));

        const Outcome json = run({QStringLiteral("info"), QStringLiteral("--json"), path("scene.sdo")});
        const QJsonObject object = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(object[QStringLiteral("instances_as_written")].toString(), QStringLiteral("18"));
        QCOMPARE(object[QStringLiteral("instances_distinct")].toString(), QStringLiteral("10"));
        QCOMPARE(object[QStringLiteral("faces_as_written")].toString(), QStringLiteral("18"));
        for (const char *key :
             {"base", "faces_per_base", "levels", "depth", "transforms_per_iteration", "similarity_dimension"}) {
            QVERIFY2(object.contains(QLatin1String(key)) && object[QLatin1String(key)].isNull(), key);
        }
        const QJsonObject bounds = object[QStringLiteral("bounds")].toObject();
        QCOMPARE(bounds[QStringLiteral("min")].toArray()[1].toDouble(), -2.0);
        QCOMPARE(bounds[QStringLiteral("max")].toArray()[0].toDouble(), 10.0);
    }

    void infoOfASceneOfOneFractalHasItsBase()
    {
        const Outcome outcome = run({QStringLiteral("info"), QStringLiteral("--json"), path("one.sdo")});
        const QJsonObject object = QJsonDocument::fromJson(outcome.out).object();
        QCOMPARE(object[QStringLiteral("base")].toString(), QStringLiteral("triangle.obj"));
        QCOMPARE(object[QStringLiteral("depth")].toInt(), 3);
    }

    void depthReplacesThatOfEveryFractalInAScene()
    {
        const Outcome outcome =
            run({QStringLiteral("info"), path("scene.sdo"), QStringLiteral("--depth"), QStringLiteral("10")});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.contains("2050 as written"), outcome.out);
        QVERIFY2(outcome.out.contains("24 distinct"), outcome.out);
    }

    void whatASceneNamesIsToldWithItsPlace()
    {
        const Outcome outcome = run({QStringLiteral("info"), path("bad.sdo")});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.err.contains("bad.sdo:2:3: error: cannot use \"syntax.fdo\": line 3, column 12: \",\""),
                 outcome.err);
        QVERIFY2(outcome.err.contains("/syntax.fdo:3:12: note: \",\" expected"), outcome.err);
    }

    void dashReadsStandardInput()
    {
        const Outcome outcome = run({QStringLiteral("info"), QStringLiteral("-")}, "<$>. nothing\n");
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.err.startsWith("<stdin>:1:6: error: "), outcome.err);
    }

    void badInputIsToldAtItsPlace_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("empty file") << "empty.fdo" << QByteArray("empty.fdo:1:1: error: the file has no result");
        QTest::newRow("syntax error") << "syntax.fdo" << QByteArray("syntax.fdo:3:12: error: \",\" expected");
        QTest::newRow("missing mesh") << "nomesh.fdo" << QByteArray("nomesh.fdo:1:4: error: cannot read \"gone.obj\"");
        QTest::newRow("mesh beyond numbers")
            << "huge.obj" << QByteArray("huge.obj:1:1: error: this grows beyond what can be computed with");
        QTest::newRow("file beyond memory") << "sparse.fdo" << QByteArray("larger than 2 GB");
        QTest::newRow("missing file") << "gone.fdo" << QByteArray("gone.fdo: no such file");
        QTest::newRow("folder") << "folder.fdo" << QByteArray("it is a directory");
        QTest::newRow("another kind") << "picture.png" << QByteArray("only .fdo, .sdo and .obj files");
    }

    void badInputIsToldAtItsPlace()
    {
        QFETCH(const QString, file);
        QFETCH(const QByteArray, message);
        const QString input = m_folder.filePath(file);
        const QString output = path("bad.png");
        for (const QStringList &arguments :
             {QStringList{QStringLiteral("info"), input},
              QStringList{QStringLiteral("render"), input, QStringLiteral("-o"), output}}) {
            const Outcome outcome = run(arguments);
            QCOMPARE(outcome.status, 1);
            QVERIFY2(outcome.err.contains(message), outcome.err);
            QCOMPARE(outcome.out, QByteArray());
        }
        QVERIFY(!QFile::exists(output));
    }

    void wrongUsageIsStatus2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString good = path("good.fdo");
        const auto row = [](const char *name, const QStringList &arguments) { QTest::newRow(name) << arguments; };
        row("no file", {"info"});
        row("two files", {"info", good, good});
        row("unknown option", {"info", "--colour", good});
        row("nothing to check", {"check"});
        row("stdin twice", {"check", "-", good, "-"});
        row("nothing to format", {"format"});
        row("a mesh to format", {"format", good, path("triangle.obj")});
        row("a picture to format", {"format", "a.png"});
        row("json of format", {"format", "--json", good});
        row("unknown command", {"exprot"});
        row("unknown global option", {"--colour"});
        row("no output", {"render", good});
        row("bad size", {"render", good, "-o", "a.png", "--size", "12"});
        row("size too large", {"render", good, "-o", "a.png", "--size", "100000x10"});
        row("no samples", {"render", good, "-o", "a.png", "--samples", "0"});
        row("negative tolerance", {"render", good, "-o", "a.png", "--pixel-tolerance", "-1"});
        row("nan tolerance", {"render", good, "-o", "a.png", "--pixel-tolerance", "nan"});
        row("bad colour", {"render", good, "-o", "a.png", "--background", "red"});
        row("bad depth", {"info", good, "--depth", "x"});
        row("negative depth", {"info", good, "--depth=-1"});
        row("depth where there is none", {"info", path("plain.fdo"), "--depth", "3"});
        row("depth of a scene without one", {"info", path("plain.sdo"), "--depth", "3"});
        const auto camera = [&](const QString &line) {
            return QStringList{"render", good, "-o", "a.png", "--camera", line};
        };
        row("camera without a c", camera("(0, 0, -4) # 60"));
        row("camera without a view", camera("c (0, 0, -4) #"));
        row("no camera", camera(""));
        row("camera in a comment", camera("# c (0, 0, -4) # 60"));
        row("camera and more", camera("c (0, 0, -4) # 60\nl # #"));
        row("camera too far away", camera("c (1e200, 0, 0) # 60"));
        row("depth of a mesh", {"info", path("triangle.obj"), "--depth", "3"});
    }

    void wrongUsageIsStatus2()
    {
        QFETCH(const QStringList, arguments);
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.err.startsWith("romanesco: "), outcome.err);
        QCOMPARE(outcome.out, QByteArray());
    }

    void helpAndVersionGoToStandardOutput()
    {
        const Outcome help = run({QStringLiteral("--help")});
        QCOMPARE(help.status, 0);
        QVERIFY(help.out.contains("render"));
        const Outcome version = run({QStringLiteral("--version")});
        QCOMPARE(version.status, 0);
        QVERIFY(version.out.startsWith("romanesco "));
        const Outcome command = run({QStringLiteral("render"), QStringLiteral("--help")});
        QCOMPARE(command.status, 0);
        QVERIFY(command.out.contains("--pixel-tolerance"));
        QCOMPARE(help.err + version.err + command.err, QByteArray());
    }

    void renderWritesAPictureOfTheAskedSize()
    {
        const QString output = path("good.png");
        const Outcome outcome = run({QStringLiteral("render"), path("good.fdo"), QStringLiteral("-o"), output,
                                     QStringLiteral("--size"), QStringLiteral("200x100"), QStringLiteral("--samples"),
                                     QStringLiteral("1"), QStringLiteral("--background"), QStringLiteral("#0000ff")});
        QVERIFY2(outcome.status == 0, outcome.err);
        const QImage image(output);
        QCOMPARE(image.size(), QSize(200, 100));
        int covered = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                covered += image.pixel(x, y) != qRgb(0, 0, 255) ? 1 : 0;
            }
        }
        QVERIFY2(covered > 500 && covered < 15'000, qPrintable(QString::number(covered)));
    }

    /// The scene's camera looks along z at triangles; an option has them in view as a whole, or looks away.
    void renderTakesTheCameraOfTheSceneOrOfTheOption()
    {
        const auto shareOfSurface = [&](const QStringList &more) {
            const QString output = path("camera.png");
            QStringList arguments{"render",  path("scene.sdo"), "-o", output,         "--size",
                                  "400x400", "--samples",       "1",  "--background", "#0000ff"};
            const Outcome outcome = run(arguments + more);
            const QImage image(output);
            int covered = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    covered += image.pixel(x, y) != qRgb(0, 0, 255) ? 1 : 0;
                }
            }
            return outcome.status == 0 ? covered / 160'000.0 : -1.0;
        };
        // A square of 4.6188 units is in view. Of the triangles (0,0), (1,0), (0,1), each half a unit, that holds the one
        // in the middle and parts of two rows of four: cut off at 0.3094 above and to the right.
        const double cut = 0.5 - 0.5 * 0.6906 * 0.6906;
        const double expected = (0.5 + 2 * cut + 0.3094 * 0.3094 + 2 * 0.5 + cut) / (4.6188 * 4.6188);
        const double own = shareOfSurface({});
        QVERIFY2(std::abs(own - expected) < 0.003, qPrintable(QString::number(own)));
        // Nine triangles, without the ball.
        const double wide = shareOfSurface({"--camera", "c (0, 0, -4) # 16 orthographic"});
        QVERIFY2(std::abs(wide - 9 * 0.5 / (16.0 * 16.0)) < 0.001, qPrintable(QString::number(wide)));
        QCOMPARE(shareOfSurface({"--camera", "c (0, 0, -4) (0, 3.14159, 0) 60"}), 0.0);
    }

    void dashWritesThePictureToStandardOutput()
    {
        const Outcome outcome = run({QStringLiteral("render"), path("good.fdo"), QStringLiteral("-o"),
                                     QStringLiteral("-"), QStringLiteral("--size"), QStringLiteral("64x48")});
        QVERIFY2(outcome.status == 0, outcome.err);
        QCOMPARE(QImage::fromData(outcome.out, "PNG").size(), QSize(64, 48));
    }

    void whatCannotBeWrittenIsStatus3_data()
    {
        QTest::addColumn<QString>("output");
        QTest::newRow("folder") << m_folder.path();
        QTest::newRow("pipe") << path("pipe");
        QTest::newRow("missing folder") << path("gone/a.png");
        QTest::newRow("full device on standard output") << QStringLiteral("-");
    }

    void whatCannotBeWrittenIsStatus3()
    {
        QFETCH(const QString, output);
        QProcess process;
        if (output == QLatin1String("-")) {
            process.setStandardOutputFile(QStringLiteral("/dev/full"));
        }
        process.start(QStringLiteral(ROMANESCO_PROGRAM),
                      {QStringLiteral("render"), path("good.fdo"), QStringLiteral("-o"), output,
                       QStringLiteral("--size"), QStringLiteral("64x48")});
        const Outcome outcome = outcomeOf(process);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("cannot write"), outcome.err);
    }

    void cancellingLeavesNoFile()
    {
        const QString output = path("cancelled.png");
        QProcess process;
        process.start(QStringLiteral(ROMANESCO_PROGRAM),
                      {QStringLiteral("render"), examples + QStringLiteral("menger.fdo"), QStringLiteral("-o"), output,
                       QStringLiteral("--samples"), QStringLiteral("4096")});
        QVERIFY(process.waitForStarted());
        // It takes minutes; the default action of the signal is replaced once drawing begins.
        QTest::qWait(3'000);
        QCOMPARE(process.state(), QProcess::Running);
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
        const Outcome outcome = outcomeOf(process);
        QVERIFY(!outcome.isCrash);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("cancelled"), outcome.err);
        const QStringList left = QDir(m_folder.path()).entryList({QStringLiteral("cancelled*")});
        QVERIFY2(left.isEmpty(), qPrintable(left.join(QLatin1Char(' '))));
    }

    void withoutADisplayTheEditorSaysSo_data()
    {
        QTest::addColumn<QString>("display");
        QTest::newRow("none") << QString();
        QTest::newRow("dead") << QStringLiteral(":98765");
    }

    void withoutADisplayTheEditorSaysSo()
    {
        QFETCH(const QString, display);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
            environment.remove(QLatin1String(name));
        }
        if (!display.isEmpty()) {
            environment.insert(QStringLiteral("DISPLAY"), display);
        }
        const Outcome outcome = run({path("good.fdo")}, {}, environment);
        QVERIFY(!outcome.isCrash);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("no display"), outcome.err);
    }

    void withoutOpenGlRenderSaysSo_data()
    {
        QTest::addColumn<QString>("variable");
        QTest::addColumn<QString>("value");
        QTest::newRow("no driver") << "__EGL_VENDOR_LIBRARY_FILENAMES" << "/nonexistent.json";
        QTest::newRow("a driver that is not there") << "GALLIUM_DRIVER" << "nonexistent";
        QTest::newRow("OpenGL 2.1") << "MESA_GL_VERSION_OVERRIDE" << "2.1";
        QTest::newRow("OpenGL 3.3") << "MESA_GL_VERSION_OVERRIDE" << "3.3";
        QTest::newRow("a driver of OpenGL 3.3") << "GALLIUM_DRIVER" << "softpipe";
    }

    void withoutOpenGlRenderSaysSo()
    {
        QFETCH(const QString, variable);
        QFETCH(const QString, value);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(variable, value);
        const QString output = path("nogl.png");
        const Outcome outcome =
            run({QStringLiteral("render"), path("good.fdo"), QStringLiteral("-o"), output}, {}, environment);
        QVERIFY(!outcome.isCrash);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("OpenGL 4.5"), outcome.err);
        QVERIFY(!QFile::exists(output));
    }
};

}

ROMANESCO_TEST(romanesco::test::TestCommands)

#include "testcommands.moc"
