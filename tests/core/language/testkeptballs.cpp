// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/language/keptballs.h"

#include <QTest>

#include "core/formats/sdoreader.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const std::string scene = "c # # 60\n"
                          "p \"a.obj\" ((1, 2, 3), (0, 90, 0), (2, 2, 2)) 0.5 # the first\n"
                          "f \"f.fdo\" #\n"
                          "p \"b.obj\" # 0.25 (1, 0, 0)\n"
                          "l (0, 1, 0) #\n";

SdoResult readWith(const std::string &text, const std::vector<KeptBall> &balls)
{
    return readSdo(applied(text, withBalls(SdoSyntax(text), balls, "ball.obj")));
}

KeptBall asWritten(std::size_t own)
{
    return own == 0 ? KeptBall{0, {1, 2, 3}, {}, 1.0, 0.5} : KeptBall{1, {0, 0, 0}, {1, 0, 0}, 1.0, 0.25};
}

}

class TestKeptBalls : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsAsWrittenStays();
    void ownBallsAreRewritten();
    void ballsThatAreGoneGo();
    void othersFollow_data();
    void othersFollow();
    void digitsSuffice();
};

void TestKeptBalls::whatIsAsWrittenStays()
{
    QCOMPARE(ballCount(SdoSyntax(scene)), 2U);
    const KeptBall balls[] = {asWritten(0), asWritten(1)};
    QVERIFY(withBalls(SdoSyntax(scene), balls, "ball.obj").empty());
}

/// What is not of the ball's stays: path, rotation, scale, comment.
void TestKeptBalls::ownBallsAreRewritten()
{
    KeptBall first = asWritten(0);
    first.position = {-1, 0.5, 1e-7};
    KeptBall second = asWritten(1);
    second.scale = 0.5;
    second.velocity = {};
    const std::vector balls{first, second};
    const std::string text = applied(scene, withBalls(SdoSyntax(scene), balls, "ball.obj"));
    QCOMPARE(QByteArray::fromStdString(text),
             QByteArray("c # # 60\n"
                        "p \"a.obj\" ((-1, 0.5, 1e-07), (0, 90, 0), (2, 2, 2)) 0.5 # the first\n"
                        "f \"f.fdo\" #\n"
                        "p \"b.obj\" ((0, 0, 0), #, (0.5, 0.5, 0.5)) 0.25\n"
                        "l (0, 1, 0) #\n"));
    QVERIFY(readSdo(text).diagnostics.empty());
    // it says now what they are
    KeptBall again = second;
    again.scale = 1.0;
    QVERIFY(withBalls(SdoSyntax(text), std::vector{first, again}, "ball.obj").empty());
}

void TestKeptBalls::ballsThatAreGoneGo()
{
    const auto textWith = [](const std::vector<KeptBall> &balls) {
        return QByteArray::fromStdString(applied(scene, withBalls(SdoSyntax(scene), balls, "ball.obj")));
    };
    QVERIFY(!textWith({asWritten(0)}).contains("b.obj"));
    QVERIFY(textWith({asWritten(0)}).contains("#\nl ("));
    // a comment is not the ball's
    QVERIFY(textWith({asWritten(1)}).contains("60\n # the first\nf"));
    const SdoResult read = readWith(scene, {});
    QVERIFY(read.diagnostics.empty());
    QCOMPARE(read.description->items.size(), 1U);
}

void TestKeptBalls::othersFollow_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::newRow("after its own") << QByteArray::fromStdString(scene);
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("its last line goes") << QByteArray("f \"f.fdo\" #\np \"b.obj\" # 0.25\n# end\n");
    QTest::newRow("its last line goes, open") << QByteArray("f \"f.fdo\" #\np \"b.obj\" # 0.25");
}

void TestKeptBalls::othersFollow()
{
    QFETCH(const QByteArray, before);
    const KeptBall first{{}, {1, 2, 3}, {0, -1, 0}, 0.125, 0.75};
    const KeptBall second{{}, {4, 5, 6}, {}, 0.25, 1.0};
    const SdoResult read = readWith(before.toStdString(), {first, second});
    QVERIFY(read.diagnostics.empty());
    const auto &items = read.description->items;
    QVERIFY(items.size() >= 2U);
    const auto &last = items.back();
    const auto &one = items[items.size() - 2];
    QCOMPARE(one.path, std::string("ball.obj"));
    QVERIFY(one.kind == SceneDescription::Kind::Ball);
    QVERIFY(one.worldFromModel == AffineMap(glm::dmat3(0.125), glm::dvec3(1, 2, 3)));
    QCOMPARE(one.restitution, 0.75);
    QVERIFY(one.velocity == glm::dvec3(0, -1, 0));
    QVERIFY(last.worldFromModel.translation == glm::dvec3(4, 5, 6));
    QVERIFY(last.velocity == glm::dvec3(0.0));
}

void TestKeptBalls::digitsSuffice()
{
    const KeptBall ball{{}, {0.1 + 0.2, 1.0 / 3.0, -1e-300}, {1e100, 5e-17, 2.0 / 3.0}, 1.0 / 7.0, 1.0 / 9.0};
    const SdoResult read = readWith("", {ball});
    QVERIFY(read.diagnostics.empty());
    const auto &item = read.description->items.back();
    QVERIFY(item.worldFromModel.translation == ball.position);
    QVERIFY(item.velocity == ball.velocity);
    QCOMPARE(item.worldFromModel.linear[1][1], 1.0 / 7.0);
    QCOMPARE(item.restitution, 1.0 / 9.0);
}

}

ROMANESCO_TEST(romanesco::test::TestKeptBalls)

#include "testkeptballs.moc"
