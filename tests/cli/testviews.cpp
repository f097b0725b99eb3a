// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// `render` of views that a text keeps, without end, and as the dissertation zooms.
class TestViews : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    /// The Menger sponge at a depth of 4, with a line before it.
    QString sponge(const QByteArray &line) const
    {
        write(path("sponge.fdo"), line + "\n" + bytesOf(examples + QStringLiteral("menger.fdo")));
        return path("sponge.fdo");
    }

    Outcome render(const QString &file, const QStringList &more) const
    {
        return run(QStringList{QStringLiteral("render"), file, QStringLiteral("--size"), QStringLiteral("96x64"),
                               QStringLiteral("--samples"), QStringLiteral("1"), QStringLiteral("--pixel-tolerance"),
                               QStringLiteral("4"), QStringLiteral("-o"), path("out.png")}
                   + more);
    }

    QImage picture(const QString &file, const QStringList &more = {}) const
    {
        QFile::remove(path("out.png"));
        const Outcome outcome = render(file, more);
        if (outcome.status != 0) {
            qWarning("%s", outcome.err.constData());
        }
        return QImage(path("out.png"));
    }

    static int different(const QImage &a, const QImage &b)
    {
        int count = 0;
        for (int y = 0; y < a.height() && a.size() == b.size(); ++y) {
            for (int x = 0; x < a.width(); ++x) {
                count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
            }
        }
        return a.size() == b.size() ? count : -1;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QVERIFY(QFile::copy(examples + QStringLiteral("cube.obj"), path("cube.obj")));
    }

    void aSavedViewIsTheView()
    {
        const QImage fitted = picture(sponge("#"));
        const QImage saved = picture(sponge("# view: (1, 2, -6) (0.3, -0.2, 0) 40 perspective"));
        const QStringList camera{QStringLiteral("--camera"), QStringLiteral("c (1, 2, -6) (0.3, -0.2, 0) 40")};
        QVERIFY(!saved.isNull() && saved != fitted);
        QCOMPARE(saved, picture(sponge("#"), camera));
        // What is asked for goes first.
        QCOMPARE(picture(sponge("# view: (9, 2, -6) (0.3, -0.2, 0) 40"), camera), saved);
    }

    /// 30 and 300 levels inside a sponge of 4: equal places of equal sponges.
    void anEndlessViewNeedsNoDepth()
    {
        const QByteArray camera = "at (0.7, 0.9, -1.3) (0.45, -0.5, 0) 60 perspective";
        const QImage deep = picture(sponge("# view: endless, in 0: 0.7*30 0.3*30 " + camera));
        QVERIFY(!deep.isNull());
        QCOMPARE(picture(sponge("# view: endless, in 0: 0.3*300 0.7*30 0.3*30 " + camera)), deep);
        const QImage fitted = picture(sponge("#"));
        QVERIFY(deep != fitted);
        // Without the levels there is no such place, and so with a depth that ends before it.
        QCOMPARE(picture(sponge("# view: in 0: 0.7*30 0.3*30 " + camera)), fitted);
        QCOMPARE(picture(sponge("# view: endless, in 0: 0.7*30 0.3*30 " + camera),
                         {QStringLiteral("--depth"), QStringLiteral("4")}),
                 fitted);
    }

    /// Near enough that it tells.
    void endlessAddsDetail()
    {
        const QStringList camera{QStringLiteral("--camera"), QStringLiteral("c (1.2, 1.2, -1.52) # 10")};
        const QString file = sponge("#");
        const QImage plain = picture(file, camera);
        const QImage endless = picture(file, camera + QStringList{QStringLiteral("--endless")});
        const QImage deep = picture(file, camera + QStringList{QStringLiteral("--depth"), QStringLiteral("40")});
        QVERIFY(!endless.isNull() && endless != plain);
        const int off = different(endless, deep);
        QVERIFY2(off >= 0 && off < 60, qPrintable(QString::number(off)));
    }

    /// With a trail as long as the way nothing is moved.
    void trailsAreTheDissertations()
    {
        const QStringList camera{QStringLiteral("--camera"), QStringLiteral("c (1.2, 1.2, -1.2) (0, -0.8, 0) 60")};
        const auto trail = [&](const char *levels) {
            return picture(sponge("#"), camera + QStringList{QStringLiteral("--trail"), QLatin1String(levels)});
        };
        const QImage plain = picture(sponge("#"), camera);
        QVERIFY(!plain.isNull());
        QVERIFY(different(trail("0"), plain) > 1'000);
        QVERIFY(different(trail("1000"), plain) < 30);
    }

    /// Counted from a copy, with a third of the world's unit: the same place told in two ways.
    void aPlaceInsideIsThatOfTheWorld()
    {
        const QString inside = sponge("# view: in 0: 0.7 at (0, 0, -8.4) (0, -0.5, 0) 60 perspective");
        const QStringList quiet{QStringLiteral("--quiet")};
        const QStringList near{QStringLiteral("--trail"), QStringLiteral("0")};
        const QImage seen = picture(inside, quiet);
        const QImage seenNear = picture(inside, near);
        const QStringList camera{QStringLiteral("--camera"), QStringLiteral("c (1, 1, -1.8) (0, -0.5, 0) 60")};
        const QImage plain = picture(sponge("#"), camera);
        QVERIFY(!seen.isNull() && seen != picture(sponge("#")));
        const int off = different(seen, plain);
        QVERIFY2(off >= 0 && off < 60, qPrintable(QString::number(off)));
        const int offNear = different(seenNear, picture(sponge("#"), camera + near));
        QVERIFY2(offNear >= 0 && offNear < 60, qPrintable(QString::number(offNear)));
        QVERIFY(different(seenNear, plain) > 500);
    }

    /// Before the corner (1, 1, -1), nearer than its own corners and farther than those of any copy in it: one step.
    void aTrailOfNoneIsTheNearestCopy()
    {
        const QStringList camera{QStringLiteral("--camera"), QStringLiteral("c (1, 1, -1.8) (0, -0.5, 0) 60")};
        const auto trail = [&](const char *levels) {
            return picture(sponge("#"), camera + QStringList{QStringLiteral("--trail"), QLatin1String(levels)});
        };
        const QImage plain = picture(sponge("#"), camera);
        const QImage none = trail("0");
        QVERIFY(different(none, plain) > 500);
        QVERIFY(different(trail("1"), plain) < 30);
        write(path("near.sdo"),
              "f \"sponge.fdo\" ((1, 1, -1), #, (0.33333333333333333, 0.33333333333333333, "
              "0.33333333333333333))\n");
        const int off = different(none, picture(path("near.sdo"), camera));
        QVERIFY2(off >= 0 && off < 60, qPrintable(QString::number(off)));
    }

    /// Of a text that has no end to show: as the window shows it.
    void anEndlessViewThatCannotBeIsShownAsWritten()
    {
        const QByteArray line = "# view: endless, (1, 2, -6) (0.3, -0.2, 0) 40 perspective\n";
        for (const QByteArray &text :
             {QByteArray("<$>. \"cube.obj\"\n"),
              QByteArray("s 1 0.5 0.5\nt. (#, #, 1)\nx. \"cube.obj\"\nz<x>. [t] x\n<$>. z 4\n")}) {
            write(path("f.fdo"), line + text);
            const QImage saved = picture(path("f.fdo"));
            write(path("g.fdo"), text);
            const QStringList camera{QStringLiteral("--camera"), QStringLiteral("c (1, 2, -6) (0.3, -0.2, 0) 40")};
            QVERIFY(!saved.isNull());
            QCOMPARE(saved, picture(path("g.fdo"), camera));
        }
    }

    void wrongUseIsTold_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("words");
        const auto endless = QStringLiteral("--endless");
        const QByteArray good = "v 0.5 0.5 0.5\nt. (#, #, 1)\nx. \"cube.obj\"\nz<x>. [t] x\n<$>. z 4\n";
        QByteArray growing = good;
        growing.replace("0.5 0.5 0.5", "1 0.5 0.5");
        QTest::newRow("two depths") << QStringList{endless, QStringLiteral("--depth"), QStringLiteral("3")} << good << 2
                                    << QByteArray("exclude each other");
        QTest::newRow("no depth") << QStringList{endless} << QByteArray("<$>. \"cube.obj\"\n") << 2
                                  << QByteArray("--endless needs a depth");
        QTest::newRow("does not shrink") << QStringList{endless} << growing << 1 << QByteArray("shrink");
        QTest::newRow("no trail") << QStringList{QStringLiteral("--trail"), QStringLiteral("-1")} << good << 2
                                  << QByteArray("--trail takes a whole number");
    }

    void wrongUseIsTold()
    {
        QFETCH(const QStringList, options);
        QFETCH(const QByteArray, text);
        QFETCH(const int, status);
        QFETCH(const QByteArray, words);
        write(path("f.fdo"), text);
        QFile::remove(path("out.png"));
        const Outcome outcome = render(path("f.fdo"), options);
        QVERIFY2(outcome.status == status && !outcome.isCrash, outcome.err.constData());
        QVERIFY2(outcome.err.contains(words), outcome.err.constData());
        QVERIFY(!QFile::exists(path("out.png")));
    }
};

}

ROMANESCO_TEST(romanesco::test::TestViews)

#include "testviews.moc"
