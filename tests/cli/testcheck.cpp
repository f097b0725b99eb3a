// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestCheck : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    /// Runs in the folder, so that names are as they are given.
    Outcome check(const QStringList &arguments, const QByteArray &input = {}) const
    {
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start(QStringLiteral(ROMANESCO_PROGRAM), QStringList{QStringLiteral("check")} + arguments);
        process.write(input);
        process.closeWriteChannel();
        return outcomeOf(process);
    }

    QJsonArray json(const QStringList &files, const QByteArray &input = {}) const
    {
        const Outcome outcome = check(QStringList{QStringLiteral("--json")} + files, input);
        const QJsonDocument document = QJsonDocument::fromJson(outcome.out);
        return document.isArray() && outcome.err.isEmpty() ? document.array()
                                                           : QJsonArray{QString::fromUtf8(outcome.err)};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        write(path("triangle.obj"), triangle);
        write(path("good.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, #, #)\n<$>. [#, t.1] x\n");
        write(path("good.sdo"), "c # # 60\nf \"good.fdo\" #\n");
        write(path("bad.fdo"), "v 1 0 0\nx. \"triangle.obj\"\n\xC3\xA9. [k, [ x\nt.p. (p, # #)\n<$>. x\n");
        write(path("equal.fdo"), "t. (#, #, #)\n<$>. [#, t, #] \"triangle.obj\"\n");
        write(path("unused.fdo"), "k. (#, #, #)\n<$>. \"triangle.obj\"\n");
        write(path("growing.fdo"), "v 2 2 2\nx. \"triangle.obj\"\nt. (#, #, 1)\nz<x>. [t] x\n<$>. z 3\nk. (#, #, #)\n");
        write(path("nomesh.fdo"), "x. \"gone.obj\"\n<$>. x\n");
        write(path("bad.obj"), "v 0 0 0\nf 1 2 3\n");
        write(path("bad.sdo"), "c # # 60\no \"bad.obj\" #\nf \"nomesh.fdo\" #\nl #\n");
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("folder.fdo")));
    }

    void nothingWrongIsStatus0()
    {
        const Outcome outcome = check({"good.fdo", "good.sdo", "triangle.obj"});
        QCOMPARE(outcome.err, QByteArray());
        QCOMPARE(outcome.out, QByteArray("no problems in 3 files\n"));
        QCOMPARE(outcome.status, 0);
        const Outcome machine = check({"--json", "good.fdo"});
        QCOMPARE(QJsonDocument::fromJson(machine.out), QJsonDocument(QJsonArray()));
        QCOMPARE(machine.status, 0);
    }

    void allFilesAreTold()
    {
        const Outcome outcome = check({"bad.fdo", "good.fdo", "unused.fdo", "gone.fdo", "nomesh.fdo"});
        QCOMPARE(outcome.err,
                 QByteArray("bad.fdo:3:8: error: a transformation or # expected, found \"[\"\n"
                            "bad.fdo:4:12: error: \",\" expected, found a comment\n"
                            "unused.fdo:1:1: hint: k is never used\n"
                            "gone.fdo:1:1: error: cannot read \"gone.fdo\": no such file\n"
                            "nomesh.fdo:1:4: error: cannot read \"gone.obj\": no such file\n"));
        QCOMPARE(outcome.out, QByteArray("4 errors, 1 hint in 5 files\n"));
        QCOMPARE(outcome.status, 1);
    }

    void scenesAndMeshesAreTold()
    {
        const Outcome outcome = check({"bad.sdo", "bad.obj"});
        QVERIFY2(outcome.err.contains("bad.sdo:4:4: error: "), outcome.err);
        QVERIFY2(outcome.err.contains("\nbad.obj:2:5: error: no vertex 2"), outcome.err);
        QCOMPARE(outcome.status, 1);
        write(path("bad.sdo"), "c # # 60\no \"bad.obj\" #\nf \"nomesh.fdo\" #\n");
        const Outcome files = check({"bad.sdo"});
        QVERIFY2(files.err.contains("bad.sdo:2:3: error: "), files.err);
        QVERIFY2(files.err.contains("bad.sdo:3:3: error: "), files.err);
    }

    void errorsDoNotHideThatFilesAreMissing()
    {
        write(path("worse.sdo"), "o \"gone.obj\" #\nl #\nf \"good.fdo\" #\nf \"nomesh.fdo\" #\n");
        const Outcome scene = check({"worse.sdo"});
        QVERIFY2(scene.err.contains("worse.sdo:2:4: error: "), scene.err);
        QVERIFY2(scene.err.contains("worse.sdo:1:3: error: "), scene.err);
        QVERIFY2(scene.err.contains("worse.sdo:4:3: error: "), scene.err);
        QVERIFY2(!scene.err.contains("worse.sdo:3:"), scene.err);
        write(path("worse.fdo"), "x. \"gone.obj\"\nv 1 two 3\ny. \"triangle.obj\"\n<$>. [t] y\n");
        const Outcome fractal = check({"worse.fdo"});
        QVERIFY2(fractal.err.contains("worse.fdo:2:5: error: "), fractal.err);
        QVERIFY2(fractal.err.contains("worse.fdo:1:4: error: "), fractal.err);
        QVERIFY2(!fractal.err.contains("worse.fdo:3:"), fractal.err);
    }

    void whatCannotBePrintedIsStatus3()
    {
        QProcess process;
        process.setStandardOutputFile(QStringLiteral("/dev/full"));
        process.start(QStringLiteral(ROMANESCO_PROGRAM), {QStringLiteral("check"), path("good.fdo")});
        const Outcome outcome = outcomeOf(process);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("cannot write the output: No space left on device"), outcome.err);
    }

    void warningsAndHintsAreStatus0()
    {
        const Outcome outcome = check({"equal.fdo", "growing.fdo"});
        QVERIFY2(outcome.err.startsWith("equal.fdo:2:10: warning: "), outcome.err);
        const qsizetype growing = outcome.err.indexOf("\ngrowing.fdo:4:8: warning: ");
        QVERIFY2(growing > 0 && outcome.err.indexOf("\ngrowing.fdo:6:1: hint: ") > growing, outcome.err);
        QCOMPARE(outcome.status, 0);
    }

    void jsonHasThePlaceOfEach()
    {
        const QJsonArray array = json({"bad.fdo"});
        QCOMPARE(array.size(), 2);
        const QJsonObject object = array[1].toObject();
        QCOMPARE(object.keys(),
                 (QStringList{"code", "column", "end_column", "end_line", "file", "line", "message", "severity"}));
        QCOMPARE(object["file"].toString(), QStringLiteral("bad.fdo"));
        QCOMPARE(object["line"].toInt(), 4);
        QCOMPARE(object["column"].toInt(), 12);
        QCOMPARE(object["end_line"].toInt(), 4);
        QCOMPARE(object["end_column"].toInt(), 13);
        QCOMPARE(object["severity"].toString(), QStringLiteral("error"));
        QCOMPARE(object["code"].toString(), QStringLiteral("expected"));
        QCOMPARE(object["message"].toString(), QStringLiteral("\",\" expected, found a comment"));
        QCOMPARE(array[0].toObject()["column"].toInt(), 8);
        const QJsonObject wide = json({"-"}, "\xC3\xA9. \"triangle.obj\"\n<$>. \xC3\xA9\xC3\xA9\n").last().toObject();
        QCOMPARE(wide["column"].toInt(), 6); // in code points
        QCOMPARE(wide["end_column"].toInt(), 8);
    }

    void jsonHasFixesAndNotes()
    {
        const QJsonArray array = json({"equal.fdo"});
        QCOMPARE(array.size(), 1);
        const QJsonObject object = array[0].toObject();
        QCOMPARE(object["severity"].toString(), QStringLiteral("warning"));
        const QJsonObject fix = object["fix"].toObject();
        QCOMPARE(fix["title"].toString(), QStringLiteral("Remove what is repeated"));
        const auto edit = [](int column, int end) {
            return QJsonObject{{"line", 2},
                               {"column", column},
                               {"end_line", 2},
                               {"end_column", end},
                               {"text", QString()}};
        };
        QCOMPARE(fix["edits"].toArray(), (QJsonArray{edit(8, 11), edit(11, 14)}));
        const QJsonObject note = object["notes"].toArray()[0].toObject();
        QCOMPARE(note["file"].toString(), QStringLiteral("equal.fdo"));
        QCOMPARE(note["line"].toInt(), 2);
        QCOMPARE(note["column"].toInt(), 7);
        QCOMPARE(note["message"].toString(), QStringLiteral("the earlier one is here"));
    }

    void whatCannotBeReadIsAnEntry_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("reason");
        QTest::newRow("missing") << "gone.fdo" << "no such file";
        QTest::newRow("folder") << "folder.fdo" << "it is a directory";
        QTest::newRow("another kind") << "a.png" << "only .fdo, .sdo and .obj files can be read";
    }

    void whatCannotBeReadIsAnEntry()
    {
        QFETCH(QString, file);
        QFETCH(QString, reason);
        const QJsonArray array = json({file, "good.fdo"});
        QCOMPARE(array.size(), 1);
        const QJsonObject object = array[0].toObject();
        QCOMPARE(object["file"].toString(), file);
        QCOMPARE(object["code"].toString(), QStringLiteral("cannot-read"));
        QCOMPARE(object["message"].toString(), QStringLiteral("cannot read \"%1\": %2").arg(file, reason));
        QCOMPARE(object["line"].toInt(), 1);
        QCOMPARE(object["column"].toInt(), 1);
        QCOMPARE(check({"--json", file}).status, 1);
    }

    void dashIsStandardInput()
    {
        const QByteArray text = "x. \"triangle.obj\"\n<$> x\n";
        const Outcome outcome = check({"-"}, text);
        QCOMPARE(outcome.err, QByteArray("<stdin>:2:1: error: a dot is missing after <$>\n"));
        QCOMPARE(outcome.out, QByteArray("1 error in 1 file\n"));
        QCOMPARE(outcome.status, 1);
        QCOMPARE(json({"-"}, text)[0].toObject()["file"].toString(), QStringLiteral("<stdin>"));
    }

    void bytesThatAreNoTextAreStillJson()
    {
        const QJsonArray array = json({"-"}, "x \xFF\xC3\n<$>. \"triangle.obj\"\n");
        QCOMPARE(array.size(), 1);
        QVERIFY(array[0].toObject()["message"].toString().contains(QChar(0xFFFD)));
        QCOMPARE(json({"-"}, "\xFF\xFEx")[0].toObject()["code"].toString(), QStringLiteral("not-utf8"));
    }

    /// Counting columns from the start of the line for each would take minutes.
    void aFixOfManyEditsIsWrittenInOnePass()
    {
        QByteArray text = "t. (#, #, #)\n<$>. [t";
        for (int i = 0; i < 200'000; ++i) {
            text += ", #";
        }
        const QJsonArray array = json({"-"}, text + "] \"triangle.obj\"\n");
        QCOMPARE(array.size(), 1);
        const QJsonArray edits = array[0].toObject()["fix"].toObject()["edits"].toArray();
        QCOMPARE(edits.size(), 200'000);
        QCOMPARE(edits.last().toObject()["column"].toInt(), 8 + 199'999 * 3);
    }
};

}

ROMANESCO_TEST(romanesco::test::TestCheck)

#include "testcheck.moc"
