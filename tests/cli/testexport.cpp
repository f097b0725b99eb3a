// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <csignal>

#include <linux/capability.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QDir>
#include <QElapsedTimer>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Bytes that a process has given to the system so far.
qint64 writtenBy(qint64 process)
{
    QFile file(QStringLiteral("/proc/%1/io").arg(process));
    if (!file.open(QIODevice::ReadOnly)) {
        return 0;
    }
    const QByteArray text = file.readAll();
    const qsizetype begin = text.indexOf("wchar:") + 6;
    return text.mid(begin, text.indexOf('\n', begin) - begin).trimmed().toLongLong();
}

}

class TestExport : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QStringList names(const QString &pattern = QStringLiteral("*")) const
    {
        return QDir(m_folder->path())
            .entryList({pattern}, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
    static Outcome exportTo(const QString &input, const QString &output, const QStringList &more = {})
    {
        return run(QStringList{"export", input, "-o", output} + more);
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        write(path("triangle.obj"), triangle);
        write(path("a.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 3\n");
        write(path("bad.fdo"), "v 1 0 0\n<$>. nothing\n");
        write(path("a.sdo"),
              "f \"a.fdo\" ((0, 5, 0), #, #)\no \"triangle.obj\" #\np \"triangle.obj\" ((9, 0, 0), #, #) 0.5\n");
        write(path("wordy.obj"), '#' + QByteArray(400, '.') + '\n' + triangle);
        write(path("paint.mtl"), "newmtl red\nKd 1 0 0\n");
        write(path("painted.obj"), "mtllib paint.mtl\n" + triangle.chopped(8) + "usemtl red\nf 1 2 3\n");
        write(path("painted.fdo"), "<$>. \"painted.obj\"\n");
        QVERIFY(QDir(m_folder->path()).mkdir("folder.obj"));
        QCOMPARE(::mkfifo(path("pipe.obj").toUtf8().constData(), 0600), 0);
    }

    void aFractalBecomesAMesh()
    {
        const Outcome outcome = exportTo(path("a.fdo"), path("out.obj"));
        QVERIFY2(outcome.status == 0, outcome.err);
        QCOMPARE(outcome.err, QByteArray());
        // as written [#, t.1] is eight copies; distinct are those moved by 0, 1, 2 and 3
        QCOMPARE(bytesOf(path("out.obj")),
                 QByteArray("# Romanesco: a.fdo, depth 3, 4 faces\n"
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 1 0 0\nv 2 0 0\nv 1 1 0\nf 4 5 6\n"
                            "v 2 0 0\nv 3 0 0\nv 2 1 0\nf 7 8 9\nv 3 0 0\nv 4 0 0\nv 3 1 0\nf 10 11 12\n"));
        const qsizetype source = bytesOf(path("a.fdo")).size() + triangle.size();
        const QRegularExpression report(
            QStringLiteral("^faces +4\nbytes +%1\nseconds +[0-9.]+\nsource +%2 bytes, .*\n$")
                .arg(bytesOf(path("out.obj")).size())
                .arg(source));
        QVERIFY2(report.match(QString::fromUtf8(outcome.out)).hasMatch(), outcome.out);
    }

    void theSourceIsSoManyTimesLess_data()
    {
        QTest::addColumn<QString>("input");
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QString>("form");
        QTest::newRow("more") << "wordy.obj" << QStringList() << "[1-9]\\.[0-9]{2}";
        QTest::newRow("ones") << "a.fdo" << QStringList{"--depth", "9"} << "[1-9]\\.[0-9]{2}";
        QTest::newRow("tens") << "a.fdo" << QStringList{"--depth", "50"} << "[1-9][0-9]\\.[0-9]";
        QTest::newRow("hundreds") << "a.fdo" << QStringList{"--depth", "800"} << "[1-9][0-9]{2}";
        QTest::newRow("thousands") << "a.fdo" << QStringList{"--depth", "8000"} << "[1-9],[0-9]{2}0";
        QTest::newRow("hundred thousands") << "a.fdo" << QStringList{"--depth", "300000"} << "[1-9][0-9]{2},000";
    }

    /// In three digits and as people write them.
    void theSourceIsSoManyTimesLess()
    {
        QFETCH(const QString, input);
        QFETCH(const QStringList, more);
        QFETCH(const QString, form);
        const Outcome outcome = exportTo(m_folder->filePath(input), path("out.obj"), more);
        const QRegularExpression line(QStringLiteral("\nsource +([0-9]+) bytes, (%1) times (less|more)\n").arg(form));
        const QRegularExpressionMatch match = line.match(QString::fromUtf8(outcome.out));
        QVERIFY2(match.hasMatch(), outcome.out);
        const double ratio = static_cast<double>(bytesOf(path("out.obj")).size()) / match.captured(1).toDouble();
        const double told = match.captured(2).remove(u',').toDouble();
        QCOMPARE(match.captured(3), ratio < 1 ? QStringLiteral("more") : QStringLiteral("less"));
        QVERIFY2(std::abs(told / std::max(ratio, 1 / ratio) - 1) < 0.005, outcome.out);
    }

    void aSceneIsWrittenWithAllItsItems()
    {
        QCOMPARE(exportTo(path("a.sdo"), path("out.obj"), {"--groups", "--depth", "1"}).status, 0);
        QCOMPARE(bytesOf(path("out.obj")),
                 QByteArray("# Romanesco: a.sdo, 4 faces\n"
                            "v 0 5 0\nv 1 5 0\nv 0 6 0\ng a\nf 1 2 3\nv 1 5 0\nv 2 5 0\nv 1 6 0\ng a.1.1\nf 4 5 6\n"
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\ng triangle\nf 7 8 9\n"
                            "v 9 0 0\nv 10 0 0\nv 9 1 0\ng triangle-2\nf 10 11 12\n"));
    }

    void aMeshStaysAsItIs()
    {
        QCOMPARE(exportTo(path("triangle.obj"), path("out.obj")).status, 0);
        QCOMPARE(bytesOf(path("out.obj")), "# Romanesco: triangle.obj, 1 face\n" + triangle);
    }

    void materialsGoAlong()
    {
        const Outcome outcome = exportTo(path("painted.fdo"), path("out.obj"));
        QVERIFY2(outcome.status == 0, outcome.err);
        QVERIFY(bytesOf(path("out.obj")).contains("mtllib out.mtl\n"));
        QVERIFY(bytesOf(path("out.mtl")).startsWith("newmtl red\nKd 1 0 0\n"));
        // on standard output there is no file beside
        QVERIFY(!exportTo(path("painted.fdo"), "-").out.contains("mtl"));
    }

    void otherFormatsGoByTheEnding()
    {
        QCOMPARE(exportTo(path("painted.fdo"), path("paint.ply")).status, 0);
        QCOMPARE(exportTo(path("a.fdo"), path("out.glb")).status, 0);
        QVERIFY(bytesOf(path("out.glb")).startsWith("glTF"));
        QCOMPARE(exportTo(path("a.fdo"), path("out.PLY")).status, 0);
        QVERIFY(bytesOf(path("out.PLY")).startsWith("ply\nformat binary_little_endian 1.0\n"));
        QCOMPARE(exportTo(path("a.fdo"), path("out.stl")).status, 0);
        QCOMPARE(bytesOf(path("out.stl")).size(), 84 + 4 * 50);
    }

    void digitsAreCut()
    {
        write(path("third.obj"), "v 0.123456789 1 2\nv 0 1 2\nv 1 1 2\nf 1 2 3\n");
        QCOMPARE(exportTo(path("third.obj"), path("out.obj"), {"--digits", "3"}).status, 0);
        QVERIFY(bytesOf(path("out.obj")).contains("\nv 0.123 1 2\n"));
    }

    void dashWritesToStandardOutput()
    {
        const Outcome file = exportTo(path("a.fdo"), path("out.obj"));
        const Outcome streamed = exportTo(path("a.fdo"), "-");
        QCOMPARE(streamed.status, 0);
        QCOMPARE(streamed.out, bytesOf(path("out.obj")));
        QVERIFY2(streamed.err.startsWith("faces        4\n"), streamed.err);
        QCOMPARE(file.status, 0);
    }

    void wrongUsageIsStatus2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char *name, const QStringList &arguments, const char *message) {
            QTest::newRow(name) << arguments << QByteArray(message);
        };
        row("no output", {"a.fdo"}, "export needs -o OUT.obj");
        row("no file", {"-o", "out.obj"}, "takes one FILE");
        row("unknown ending", {"a.fdo", "-o", "out.dae"}, "only .obj, .ply");
        row("no ending", {"a.fdo", "-o", "out"}, "only .obj, .ply");
        row("no digits", {"a.fdo", "-o", "out.obj", "--digits", "0"}, "from 1 to 17, not \"0\"");
        row("too many digits", {"a.fdo", "-o", "out.obj", "--digits", "18"}, "from 1 to 17, not \"18\"");
        row("digits in words", {"a.fdo", "-o", "out.obj", "--digits", "six"}, "from 1 to 17, not \"six\"");
        row("digits of a binary file", {"a.fdo", "-o", "out.stl", "--digits", "3"}, "only an .obj file has digits");
        row("groups of a binary file", {"a.fdo", "-o", "out.ply", "--groups"},
            "only an .obj file has digits and groups");
        row("over its own mesh", {"a.fdo", "-o", "triangle.obj"}, "a file that it is made from");
        row("over its own mesh by another path", {"a.fdo", "-o", "./folder.obj/../triangle.obj"},
            "a file that it is made from");
        row("over its own materials", {"painted.fdo", "-o", "paint.obj"}, "a file that it is made from");
        row("over the mesh itself", {"triangle.obj", "-o", "triangle.obj"}, "a file that it is made from");
        row("depth of a mesh", {"triangle.obj", "-o", "out.obj", "--depth", "3"}, "--depth needs");
    }

    void wrongUsageIsStatus2()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, message);
        const QStringList before = names();
        QProcess process;
        process.setWorkingDirectory(m_folder->path());
        process.start(QStringLiteral(ROMANESCO_PROGRAM), QStringList{"export"} + arguments);
        const Outcome outcome = outcomeOf(process);
        QVERIFY2(outcome.err.contains(message), outcome.err);
        QCOMPARE(outcome.status, 2);
        QCOMPARE(outcome.out, QByteArray());
        QCOMPARE(names(), before);
        QCOMPARE(bytesOf(path("triangle.obj")), triangle);
    }

    void badInputIsStatus1()
    {
        const Outcome outcome = exportTo(path("bad.fdo"), path("out.obj"));
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.err.contains("bad.fdo:2:6: error: "), outcome.err);
        QVERIFY(!QFile::exists(path("out.obj")));
    }

    void whatIsTooMuchIsRefusedWithAForecast_data()
    {
        QTest::addColumn<QString>("output");
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("past 10^9 faces") << "out.obj" << QStringList{"--depth", "7"}
                                         << QByteArray("15360000000 faces, about 1.15 TB; --force");
        QTest::newRow("10^40 faces") << "out.obj" << QStringList{"--depth", "30"}
                                     << QByteArray("1.29e40 faces, about 2.1e42 bytes; --force");
        QTest::newRow("any depth") << "out.obj" << QStringList{"--depth", "1000000000000"} << QByteArray("; --force");
        QTest::newRow("past the disk") << "out.obj" << QStringList{"--depth", "15", "--force"}
                                       << QByteArray("bytes free on the disk");
        QTest::newRow("10^40 bytes on standard output")
            << "-" << QStringList{"--depth", "30"} << QByteArray("1.29e40 faces, about 2.1e42 bytes; --force");
        QTest::newRow("past the format") << "out.stl" << QStringList{"--depth", "8", "--force"}
                                         << QByteArray("an STL file holds at most 4294967295 faces");
        QTest::newRow("past the indices") << "out.ply" << QStringList{"--depth", "8", "--force"}
                                          << QByteArray("a PLY file holds at most 4294967296 vertices");
    }

    void whatIsTooMuchIsRefusedWithAForecast()
    {
        QFETCH(const QString, output);
        QFETCH(const QStringList, more);
        QFETCH(const QByteArray, message);
        const Outcome outcome =
            exportTo(examples + "menger.fdo", output == QLatin1String("-") ? output : m_folder->filePath(output), more);
        QVERIFY2(outcome.err.contains(message), outcome.err);
        QCOMPARE(outcome.status, 3);
        QCOMPARE(outcome.out, QByteArray());
        QVERIFY(names("*out*").isEmpty());
    }

    void whatCannotBeWrittenIsStatus3_data()
    {
        QTest::addColumn<QString>("output");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("folder") << "folder.obj" << QByteArray("it is a directory");
        QTest::newRow("pipe") << "pipe.obj" << QByteArray("it is not a regular file");
        QTest::newRow("missing folder") << "gone/out.obj" << QByteArray("no such folder");
        QTest::newRow("full device on standard output") << "-" << QByteArray("disk full");
    }

    void whatCannotBeWrittenIsStatus3()
    {
        QFETCH(const QString, output);
        QFETCH(const QByteArray, reason);
        const bool isStreamed = output == QLatin1String("-");
        QProcess process;
        if (isStreamed) {
            process.setStandardOutputFile(QStringLiteral("/dev/full"));
        }
        process.start(QStringLiteral(ROMANESCO_PROGRAM),
                      {"export", path("a.fdo"), "-o", isStreamed ? output : m_folder->filePath(output)});
        const Outcome outcome = outcomeOf(process);
        QVERIFY2(outcome.err.contains(": " + reason + "\n"), outcome.err);
        QVERIFY2(outcome.err.startsWith("romanesco: cannot write "), outcome.err);
        QCOMPARE(outcome.status, 3);
    }

    void oldFilesOutliveWhatFails_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("read-only folder") << false;
        QTest::newRow("no space in the middle") << true;
    }

    void oldFilesOutliveWhatFails()
    {
        QFETCH(const bool, isFull);
        write(path("out.obj"), "old");
        const QStringList before = names();
        if (!isFull) {
            QVERIFY(QFile::setPermissions(m_folder->path(), QFileDevice::ReadOwner | QFileDevice::ExeOwner));
        }
        QProcess process;
        process.setChildProcessModifier([isFull] {
            if (isFull) { // a file may not grow beyond; unless the program knows better, trying ends it
                const rlimit limit{1'000'000, 1'000'000};
                ::setrlimit(RLIMIT_FSIZE, &limit);
            } else { // permissions are for root as well, then
                ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
            }
        });
        process.start(QStringLiteral(ROMANESCO_PROGRAM),
                      {"export", examples + "menger.fdo", "--depth", "3", "-o", path("out.obj")});
        const Outcome outcome = outcomeOf(process);
        QFile::setPermissions(m_folder->path(),
                              QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
        QVERIFY(!outcome.isCrash);
        QVERIFY2(outcome.err.contains(isFull ? "larger than a file may be here" : "permission denied"), outcome.err);
        QCOMPARE(outcome.status, 3);
        QCOMPARE(bytesOf(path("out.obj")), QByteArray("old"));
        QCOMPARE(names(), before);
    }

    void cancellingLeavesTheOldFile_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGTERM") << SIGTERM;
    }

    void cancellingLeavesTheOldFile()
    {
        QFETCH(const int, signal);
        write(path("out.obj"), "old");
        const QStringList before = names();
        QProcess process;
        process.start(QStringLiteral(ROMANESCO_PROGRAM),
                      {"export", examples + "menger.fdo", "--depth", "5", "-o", path("out.obj")});
        QVERIFY(process.waitForStarted());
        // gigabytes follow
        QVERIFY(QTest::qWaitFor([&] { return writtenBy(process.processId()) > 1'000'000; }, 30'000));
        QCOMPARE(process.state(), QProcess::Running);
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
        const Outcome outcome = outcomeOf(process);
        qInfo("ended after %lld ms", static_cast<long long>(timer.elapsed()));
        QVERIFY(!outcome.isCrash);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("cancelled"), outcome.err);
        QCOMPARE(bytesOf(path("out.obj")), QByteArray("old"));
        QCOMPARE(names(), before);
    }
};

}

ROMANESCO_TEST(romanesco::test::TestExport)

#include "testexport.moc"
