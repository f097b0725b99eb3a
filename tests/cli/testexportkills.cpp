// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <csignal>
#include <random>

#include <signal.h>

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// What kill -9 leaves of an export, whenever it comes.
class TestExportKills : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFileIsTheOldOneOrTheNewOne();
};

void TestExportKills::theFileIsTheOldOneOrTheNewOne()
{
    QTemporaryDir folder;
    QVERIFY(folder.isValid());
    const QString output = folder.filePath("out.obj");
    const QStringList arguments{"export", examples + "menger.fdo", "-o", output};
    const auto names = [&] {
        return QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    };
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(run(arguments).status, 0);
    // The shortest run seen. The machine may be busier now than later, and then most kills would come too late.
    qint64 wholeRun = timer.elapsed();
    const QByteArray whole = bytesOf(output);
    QVERIFY(whole.size() > 100'000'000);

    const int kills = std::max(qEnvironmentVariableIntValue("ROMANESCO_TEST_KILLS"), 25);
    std::mt19937 random(20'250'607);
    int unfinished = 0;
    for (int i = 0; i < kills; ++i) {
        write(output, "old");
        QProcess process;
        process.start(QStringLiteral(ROMANESCO_PROGRAM), arguments);
        QVERIFY(process.waitForStarted());
        timer.restart();
        if (process.waitForFinished(static_cast<int>(random() % static_cast<unsigned>(wholeRun * 3 / 2)))) {
            wholeRun = std::min(wholeRun, timer.elapsed());
        } else {
            process.kill();
            QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished());
        }
        const bool isNew = QFileInfo(output).size() != 3;
        unfinished += isNew ? 0 : 1;
        QVERIFY(isNew ? bytesOf(output) == whole : bytesOf(output) == "old");
        // A file has a hidden name only for the instant before it gets its own, when it is whole.
        for (const QString &name : names()) {
            QVERIFY2(name == QLatin1String("out.obj") || bytesOf(folder.filePath(name)) == whole, qPrintable(name));
            if (name != QLatin1String("out.obj")) {
                qInfo("a whole file is left as %s", qPrintable(name));
                QVERIFY(QFile::remove(folder.filePath(name)));
            }
        }
    }
    qInfo("%d of %d were killed before the end", unfinished, kills);
    QVERIFY(unfinished > kills / 5);
}

}

ROMANESCO_TEST(romanesco::test::TestExportKills)

#include "testexportkills.moc"
