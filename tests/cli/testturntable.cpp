// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cstdlib>
#include <limits>

#include <signal.h>

#include <QColor>
#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// A driver may decide otherwise where an edge passes through a sample's place.
constexpr int few = 3;

/// `render --turntable`, by the pictures that it writes.
class TestTurntable : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString path(const char *name) const { return path(QLatin1String(name)); }

    /// Into a folder of its own, which is made; the arguments after FILE and the folder.
    QString folder(const char *name) const
    {
        QDir(m_folder.path()).mkdir(QLatin1String(name));
        return path(name);
    }

    static QStringList small(const QString &file, const QString &output, const QStringList &more = {})
    {
        return QStringList{QStringLiteral("render"),    file,
                           QStringLiteral("--size"),    QStringLiteral("96x64"),
                           QStringLiteral("--samples"), QStringLiteral("4"),
                           QStringLiteral("-o"),        output}
        + more;
    }

    static QStringList files(const QString &folder)
    {
        return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

    /// Pixels that differ by more than rounding.
    static int difference(const QString &a, const QString &b)
    {
        const QImage first(a);
        const QImage second(b);
        if (first.isNull() || first.size() != second.size()) {
            return std::numeric_limits<int>::max();
        }
        int count = 0;
        for (int y = 0; y < first.height(); ++y) {
            for (int x = 0; x < first.width(); ++x) {
                const QColor p = first.pixelColor(x, y);
                const QColor q = second.pixelColor(x, y);
                const int most = std::max(
                    {std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
                count += most > 2 ? 1 : 0;
            }
        }
        return count;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        // nothing is alike from two sides; its box has its middle at the origin
        write(path("odd.obj"), "v 1 -1 -1\nv -1 -1 1\nv -0.5 1 0\nv 0.2 0.1 0.9\nf 1 2 3\nf 1 2 4\nf 2 3 4\n");
        write(path("odd.sdo"), "c (0, 0, -4) # 60\no \"odd.obj\" #\n");
        // as wide as it is deep, twice: the same from the front and from behind, not from its sides
        write(path("bar.obj"),
              "v -2 -1 -1\nv 2 -1 -1\nv 2 1 -1\nv -2 1 -1\nv -2 -1 1\nv 2 -1 1\nv 2 1 1\nv -2 1 1\n"
              "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 4 3 7 8\nf 1 4 8 5\nf 2 6 7 3\n");
    }

    void partsAreTheWhole()
    {
        const QString file = examples + QStringLiteral("sierpinski.fdo");
        const QString whole = folder("whole");
        const QString parts = folder("parts");
        const QString pattern = QStringLiteral("/frame-%04d.png");
        const QStringList eight{QStringLiteral("--turntable"), QStringLiteral("8")};
        QCOMPARE(run(small(file, whole + pattern, eight)).status, 0);
        for (const QString &some : {QStringLiteral("4..7"), QStringLiteral("0..3")}) {
            const Outcome outcome =
                run(small(file, parts + pattern, eight + QStringList{QStringLiteral("--frames"), some}));
            QCOMPARE(outcome.status, 0);
            QCOMPARE(outcome.err, QByteArray());
        }
        const QStringList names = files(whole);
        QCOMPARE(names.size(), 8);
        QCOMPARE(names.constFirst(), QStringLiteral("frame-0000.png"));
        QCOMPARE(names.constLast(), QStringLiteral("frame-0007.png"));
        QCOMPARE(files(parts), names);
        for (const QString &name : names) {
            QCOMPARE(bytesOf(parts + QLatin1Char('/') + name), bytesOf(whole + QLatin1Char('/') + name));
        }
        QVERIFY(bytesOf(whole + QStringLiteral("/frame-0003.png"))
                != bytesOf(whole + QStringLiteral("/frame-0004.png")));
    }

    void theFirstFrameIsThePictureWithout()
    {
        const QString file = examples + QStringLiteral("tree.fdo");
        QCOMPARE(run(small(file, path("one.png"))).status, 0);
        const QStringList first{QStringLiteral("--turntable"), QStringLiteral("7"), QStringLiteral("--frames"),
                                QStringLiteral("0..0")};
        QCOMPARE(run(small(file, path("first%d.png"), first)).status, 0);
        QCOMPARE(bytesOf(path("first0.png")), bytesOf(path("one.png")));
        QCOMPARE(run(small(file, path("single.png"), {QStringLiteral("--turntable"), QStringLiteral("1")})).status, 0);
        QCOMPARE(bytesOf(path("single.png")), bytesOf(path("one.png")));
    }

    /// A camera that is written down where each frame's has to be.
    void theCameraGoesToItsRightRoundWhatItLooksAt_data()
    {
        QTest::addColumn<int>("frame");
        QTest::addColumn<QString>("camera");
        QTest::newRow("a quarter") << 1 << QStringLiteral("c (4, 0, 0) (0, 1.5707963267948966, 0) 60");
        QTest::newRow("behind") << 2 << QStringLiteral("c (0, 0, 4) (0, 3.1415926535897932, 0) 60");
        QTest::newRow("three quarters") << 3 << QStringLiteral("c (-4, 0, 0) (0, -1.5707963267948966, 0) 60");
    }

    void theCameraGoesToItsRightRoundWhatItLooksAt()
    {
        QFETCH(const int, frame);
        QFETCH(const QString, camera);
        const QStringList four{QStringLiteral("--turntable"), QStringLiteral("4"), QStringLiteral("--frames"),
                               QStringLiteral("%1..%1").arg(frame)};
        QCOMPARE(run(small(path("odd.sdo"), path("odd%d.png"), four)).status, 0);
        QCOMPARE(run(small(path("odd.sdo"), path("there.png"), {QStringLiteral("--camera"), camera})).status, 0);
        QVERIFY(difference(path(QStringLiteral("odd%1.png").arg(frame)), path("there.png")) <= few);
        // which is not where the turn began
        QCOMPARE(run(small(path("odd.sdo"), path("start.png"))).status, 0);
        QVERIFY(difference(path("start.png"), path("there.png")) > 100);
    }

    /// From above and aside: only a turn about the upright line through the middle shows the same again half way round.
    void halfATurnShowsASymmetricSceneAsAtFirst_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("at the origin") << path("bar.obj");
        write(path("away.sdo"), "o \"bar.obj\" ((10, 20, -30), #, (2, 2, 2))\n");
        QTest::newRow("away from it") << path("away.sdo");
    }

    void halfATurnShowsASymmetricSceneAsAtFirst()
    {
        QFETCH(const QString, file);
        const QStringList six{QStringLiteral("--turntable"), QStringLiteral("6")};
        QCOMPARE(run(small(file, path("bar%02d.png"), six)).status, 0);
        QVERIFY2(difference(path("bar00.png"), path("bar03.png")) <= few, "half");
        QVERIFY2(difference(path("bar01.png"), path("bar04.png")) <= few, "a sixth and a half");
        QVERIFY(difference(path("bar00.png"), path("bar01.png")) > 100);
    }

    void wrongUsageIsTold_data()
    {
        QTest::addColumn<QString>("output");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("words");
        const auto turn = [](const char *count, const char *frames = nullptr) {
            QStringList options{QStringLiteral("--turntable"), QLatin1String(count)};
            return frames ? options + QStringList{QStringLiteral("--frames"), QLatin1String(frames)} : options;
        };
        const QByteArray pattern("not a pattern: ");
        const auto addPattern = [&](const char *output, const QByteArray &why) {
            QTest::addRow("pattern %s", output) << QString::fromLatin1(output) << turn("2") << pattern + why;
        };
        addPattern("same.png", "it needs a %d");
        addPattern("-", "it needs a %d");
        addPattern("%d-%d.png", "it may have one % only");
        addPattern("%d%%.png", "it may have one % only");
        for (const char *output : {"%s.png", "%4d.png", "%-4d.png", "%00d.png", "%012d.png", "%i.png", "%ld.png",
                                   "%.png", "%0d.png", "%D.png", "a%"}) {
            addPattern(output, "after the % comes d");
        }
        for (const char *count : {"0", "-3", "2.5", "", "x", "1000001", "99999999999", "0x8"}) {
            QTest::addRow("count %s", count)
                << "%d.png" << turn(count) << QByteArray("--turntable takes a whole number");
        }
        for (const char *frames :
             {"", "1", "0..8", "5..4", "-1..2", "0...3", "0..1..2", "a..b", "0-3", "..", "0..", "..3"}) {
            QTest::addRow("frames %s", frames) << "%d.png" << turn("8", frames) << QByteArray("--frames takes A..B");
        }
        QTest::newRow("no turn") << "%d.png" << QStringList{QStringLiteral("--frames"), QStringLiteral("0..1")}
                                 << QByteArray("--frames needs --turntable");
    }

    void wrongUsageIsTold()
    {
        QFETCH(const QString, output);
        QFETCH(const QStringList, options);
        QFETCH(const QByteArray, words);
        const QString empty = folder("empty");
        const Outcome outcome = run(
            small(path("bar.obj"), output == QLatin1String("-") ? output : empty + QLatin1Char('/') + output, options));
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.err.contains(words), outcome.err);
        QCOMPARE(outcome.out, QByteArray());
        QCOMPARE(files(empty), QStringList());
    }

    /// Without a turn a % is nothing but a %.
    void aSinglePictureIsNamedAsItIs()
    {
        QCOMPARE(run(small(path("bar.obj"), path("100%s.png"))).status, 0);
        QVERIFY(!QImage(path("100%s.png")).isNull());
    }

    void aPictureThatCannotBeWrittenEndsTheRun()
    {
        const QString taken = folder("taken");
        QVERIFY(QDir(taken).mkdir(QStringLiteral("1.png")));
        const Outcome outcome = run(small(path("bar.obj"), taken + QStringLiteral("/%d.png"),
                                          {QStringLiteral("--turntable"), QStringLiteral("4")}));
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("cannot write"), outcome.err);
        QCOMPARE(files(taken), QStringList{QStringLiteral("0.png")});
    }

    /// What is there after Ctrl-C is whole, of pictures that take no time too.
    void cancellingLeavesWholePictures()
    {
        const QString cancelled = folder("cancelled");
        QProcess process;
        process.start(QStringLiteral(ROMANESCO_PROGRAM),
                      small(path("bar.obj"), cancelled + QStringLiteral("/%d.png"),
                            {QStringLiteral("--turntable"), QStringLiteral("1000000")}));
        QVERIFY(process.waitForStarted());
        QVERIFY(QTest::qWaitFor([&] { return files(cancelled).size() >= 3; }, 60'000));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        const Outcome outcome = outcomeOf(process);
        QVERIFY(!outcome.isCrash);
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("cancelled"), outcome.err);
        const QStringList left = files(cancelled);
        for (const QString &name : left) {
            QVERIFY2(QImage(cancelled + QLatin1Char('/') + name).size() == QSize(96, 64), qPrintable(name));
        }
        QVERIFY(left.size() < 1'000'000);
    }
};

}

ROMANESCO_TEST(romanesco::test::TestTurntable)

#include "testturntable.moc"
