// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdlib>

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const QString thumbnails = examples + QStringLiteral("thumbnails/");

QStringList texts()
{
    return QDir(examples).entryList({QStringLiteral("*.fdo"), QStringLiteral("*.sdo")}, QDir::Files, QDir::Name);
}

/// Of 255, over all pixels and channels.
double meanDifference(const QImage &a, const QImage &b)
{
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
        }
    }
    return sum / (3.0 * a.width() * a.height());
}

}

/// The pictures of the gallery against what the program draws of the examples now. Where they differ, and should,
/// packaging/thumbnails makes them anew.
class TestThumbnails : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachExampleHasOne();
    void theyShowTheExamplesAsTheyAre_data();
    void theyShowTheExamplesAsTheyAre();
};

void TestThumbnails::eachExampleHasOne()
{
    QStringList expected;
    for (const QString &text : texts()) {
        expected << text + QStringLiteral(".png");
    }
    QVERIFY(expected.size() > 5);
    QCOMPARE(QDir(thumbnails).entryList(QDir::Files, QDir::Name), expected);
}

void TestThumbnails::theyShowTheExamplesAsTheyAre_data()
{
    QTest::addColumn<QString>("name");
    for (const QString &text : texts()) {
        QTest::newRow(qPrintable(text)) << text;
    }
}

void TestThumbnails::theyShowTheExamplesAsTheyAre()
{
    QFETCH(const QString, name);
    const QTemporaryDir folder;
    const QString drawn = folder.filePath(QStringLiteral("drawn.png"));
    const Outcome outcome =
        run({QStringLiteral("render"), examples + name, QStringLiteral("-o"), drawn, QStringLiteral("--size"),
             QStringLiteral("192x144"), QStringLiteral("--samples"), QStringLiteral("16"), QStringLiteral("--quiet")});
    QCOMPARE(outcome.status, 0);
    const QImage now(drawn);
    const QImage kept(thumbnails + name + QStringLiteral(".png"));
    QCOMPARE(kept.size(), QSize(192, 144));
    QCOMPARE(now.size(), kept.size());
    // What drivers do differently is at edges; another text shifts whole shapes.
    QVERIFY2(meanDifference(now, kept) < 1.0, qPrintable(QString::number(meanDifference(now, kept))));
}

}

ROMANESCO_TEST(romanesco::test::TestThumbnails)
#include "testthumbnails.moc"
