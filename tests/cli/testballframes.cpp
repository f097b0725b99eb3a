// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A view 8 high, and a ball of radius 0.5 that falls from its middle.
constexpr auto falling = "c (0, 0, -20) # 8 orthographic\n"
                         "o \"cube.obj\" ((0, -3.5, 0), #, #)\n"
                         "p \"ball.obj\" ((0, 0.5, 0), #, (0.5, 0.5, 0.5)) 0\n";

struct Folder {
    QTemporaryDir folder;

    Folder()
    {
        QFile::copy(examples + "cube.obj", path("cube.obj"));
        QFile::copy(examples + "ball.obj", path("ball.obj"));
        write(path("s.sdo"), falling);
    }
    [[nodiscard]] QString path(const char *name) const { return folder.filePath(QLatin1String(name)); }
};

/// The height of the ball's middle, in the scene: it is orange.
double heightIn(const QString &picture)
{
    const QImage image(picture);
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (c.red() > 60 && c.red() > 5 * c.blue()) {
                sum += y + 0.5;
                ++count;
            }
        }
    }
    // of a disc of radius 0.5 in a view that is 8 high
    const double expected = 3.14159 * std::pow(0.5 / 8.0 * image.height(), 2);
    return std::abs(count - expected) < 0.1 * expected ? 4.0 - 8.0 * sum / count / image.height() : std::nan("");
}

}

class TestBallFrames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picturesFollowTheBalls();
    void picturesChangeNothing();
    void whatMakesNoSense_data();
    void whatMakesNoSense();
    void aFolderThatIsNotThereIsTold();
};

void TestBallFrames::picturesFollowTheBalls()
{
    const Folder folder;
    const Outcome result = run({"simulate", folder.path("s.sdo"), "--seconds", "1", "--render",
                                folder.path("f%02d.png"), "--size", "160x160", "--fps", "9", "--dt", "0.05"});
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.isEmpty());
    QCOMPARE(QDir(folder.folder.path()).entryList({"f*.png"}).size(), 10);
    for (int i = 0; i < 10; ++i) {
        const double time = i / 9.0;
        // from 0.5 down to the cube's top at -2, which it reaches with its lower end
        const double height = std::max(0.5 - 4.9 * time * time, -1.5);
        const double seen =
            heightIn(folder.path(qPrintable(QStringLiteral("f%1.png").arg(i, 2, 10, QLatin1Char('0')))));
        QVERIFY2(std::abs(seen - height) < 0.03,
                 qPrintable(QStringLiteral("%1: %2 for %3").arg(i).arg(seen).arg(height)));
    }
}

void TestBallFrames::picturesChangeNothing()
{
    const Folder folder;
    const QStringList plain{"simulate", folder.path("s.sdo"), "--seconds", "0.2"};
    const Outcome rows = run(plain);
    const Outcome pictures =
        run(plain + QStringList{"--render", folder.path("f%d.png"), "--size", "16x16", "--fps", "1000"});
    QCOMPARE(rows.status, 0);
    QVERIFY(rows.err.contains("state "));
    QCOMPARE(pictures.err, rows.err);
    // more pictures than steps
    QCOMPARE(QDir(folder.folder.path()).entryList({"f*.png"}).size(), 201);
}

void TestBallFrames::whatMakesNoSense_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("no pattern") << QStringList{"--render", "f.png"} << QByteArray("--render f.png is not a pattern");
    QTest::newRow("no size") << QStringList{"--render", "f%d.png", "--size", "0x5"} << QByteArray("--size takes");
    QTest::newRow("no time") << QStringList{"--render", "f%d.png", "--fps", "0"} << QByteArray("--fps takes");
    QTest::newRow("nonsense") << QStringList{"--render", "f%d.png", "--fps", "x"} << QByteArray("--fps takes");
}

void TestBallFrames::whatMakesNoSense()
{
    QFETCH(const QStringList, options);
    QFETCH(const QByteArray, words);
    const Folder folder;
    const Outcome result = run(QStringList{"simulate", folder.path("s.sdo"), "--seconds", "1"} + options);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(words), result.err.constData());
}

void TestBallFrames::aFolderThatIsNotThereIsTold()
{
    const Folder folder;
    const Outcome result =
        run({"simulate", folder.path("s.sdo"), "--seconds", "1", "--render", folder.path("nowhere/f%d.png")});
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("nowhere"), result.err.constData());
    QVERIFY(!result.err.contains("state "));
}

}

ROMANESCO_TEST(romanesco::test::TestBallFrames)

#include "testballframes.moc"
