// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/formats/sdoreader.h"
#include "core/language/placement.h"
#include "tests/testmain.h"

using namespace romanesco;

/// Lines that place files in a scene.
class TestPlacement : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void linesComeAfterTheLastOfTheirKind_data();
    void linesComeAfterTheLastOfTheirKind();
    void whatIsAddedStandsInTheScene();
    void noPathBreaksItsLine();
};

void TestPlacement::linesComeAfterTheLastOfTheirKind_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char *name, const char *before, const char *after) {
        QTest::newRow(name) << QByteArray(before) << QByteArray(after);
    };
    row("nothing", "", "o \"a.obj\" #\nf \"b.fdo\" #\n");
    row("a comment", "# mine", "# mine\no \"a.obj\" #\nf \"b.fdo\" #\n");
    row("a camera", "c # # 60\n", "c # # 60\no \"a.obj\" #\nf \"b.fdo\" #\n");
    row("objects", "o \"x.obj\" # # first\nf \"y.fdo\" #\n\nl # #\n",
        "o \"x.obj\" # # first\nf \"y.fdo\" #\no \"a.obj\" #\nf \"b.fdo\" #\n\nl # #\n");
    row("a ball, without a line end", "p \"x.obj\" # 0.5", "p \"x.obj\" # 0.5\no \"a.obj\" #\nf \"b.fdo\" #");
    row("lines of Windows", "o \"x.obj\" #\r\nl # #\r\n", "o \"x.obj\" #\no \"a.obj\" #\nf \"b.fdo\" #\r\nl # #\r\n");
}

void TestPlacement::linesComeAfterTheLastOfTheirKind()
{
    QFETCH(const QByteArray, before);
    const FileToPlace files[] = {{"a.obj", false}, {"b.fdo", true}};
    const std::string text = before.toStdString();
    QTEST(QByteArray::fromStdString(applied(text, withPlacedFiles(SdoSyntax(text), files))), "after");
    QVERIFY(withPlacedFiles(SdoSyntax(text), {}).empty());
}

void TestPlacement::whatIsAddedStandsInTheScene()
{
    const FileToPlace files[] = {{"a b.obj", false}, {"../c.fdo", true}};
    const std::string text = "o \"x.obj\" ((1, 2, 3), #, #)\n";
    const SdoResult read = readSdo(applied(text, withPlacedFiles(SdoSyntax(text), files)));
    QVERIFY(read.diagnostics.empty());
    QCOMPARE(read.description->items.size(), std::size_t(3));
    QCOMPARE(read.description->items[1].path, std::string("a b.obj"));
    QVERIFY(read.description->items[1].kind == SceneDescription::Kind::Object);
    QCOMPARE(read.description->items[2].path, std::string("../c.fdo"));
    QVERIFY(read.description->items[2].kind == SceneDescription::Kind::Fractal);
    QVERIFY(read.description->items[2].worldFromModel == AffineMap{});
}

void TestPlacement::noPathBreaksItsLine()
{
    QVERIFY(isWritablePath("a (1) # ünï.obj"));
    for (const char *path : {"", "a\"b.obj", "a\nb.obj", "a\rb.obj"}) {
        QVERIFY(!isWritablePath(path));
    }
}

ROMANESCO_TEST(TestPlacement)
#include "testplacement.moc"
