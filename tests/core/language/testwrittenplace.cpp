// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/formats/sdoreader.h"
#include "core/language/writtenplace.h"
#include "tests/testmain.h"

using namespace romanesco;

namespace {

constexpr auto tree = "up  0 1.50 0 # a comment\nturn -5, +30.0, 1e2\nsmall 0.6 0.6 0.6\nx. \"x.obj\"\n"
                      "t.p.r. (p, r, small)\nfixed. (up, #, #)\n"
                      "y. [t.up.turn, fixed, #] x\nz<x>. [t.1.turn] x\n<$>. [fixed] z 3\n";

std::optional<WrittenPlace> placeAt(const std::string &text, const std::string &use)
{
    return placeOfUse(FdoDocument(text), text.find(use));
}

std::string changed(const std::string &text, const WrittenVector &vector, const glm::dvec3 &value, int decimals = 0)
{
    return applied(text, {{vector.range, vector.with(value, decimals)}});
}

}

/// Where something is placed, as the text says it.
class TestWrittenPlace : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aUseLeadsToItsVectors();
    void usesAreCounted();
    void numbersKeepTheirWords();
    void whatIsNoUseHasNoPlace();
    void anObjectOfASceneHasVectors_data();
    void anObjectOfASceneHasVectors();
    void itemsAreCounted();
};

void TestWrittenPlace::aUseLeadsToItsVectors()
{
    const auto place = placeAt(tree, "t.up.turn");
    QVERIFY(place && place->vectors[0] && place->vectors[1] && place->vectors[2]);
    QVERIFY(place->parts.position == glm::dvec3(0, 1.5, 0));
    QVERIFY(place->parts.rotation == glm::dvec3(-5, 30, 100));
    for (int part = 0; part < 3; ++part) {
        const glm::dvec3 expected = part == 0 ? place->parts.position
            : part == 1                       ? place->parts.rotation
                                              : place->parts.scale;
        QVERIFY(place->vectors[static_cast<std::size_t>(part)]->value() == expected);
    }
    // by its number, and from the declaration
    QVERIFY(placeAt(tree, "t.1.turn")->vectors[0]->range == place->vectors[0]->range);
    const auto fixed = placeAt(tree, "fixed, #");
    QVERIFY(fixed && fixed->vectors[0]->range == place->vectors[0]->range);
    QVERIFY(!fixed->vectors[1] && !fixed->vectors[2]);
}

void TestWrittenPlace::usesAreCounted()
{
    const auto place = placeAt(tree, "t.up.turn");
    // t.up, t.1, and two uses of fixed
    QCOMPARE(place->vectors[0]->uses, std::size_t(4));
    QCOMPARE(place->vectors[1]->uses, std::size_t(2));
    QCOMPARE(place->vectors[2]->uses, std::size_t(2)); // of t, which has it from its declaration
}

void TestWrittenPlace::numbersKeepTheirWords()
{
    const auto place = placeAt(tree, "t.up.turn");
    const std::string moved = changed(tree, *place->vectors[0], {0, 1.256, 0});
    QVERIFY(moved.starts_with("up  0 1.26 0 # a comment\n"));
    QVERIFY(changed(tree, *place->vectors[0], {0.4, 1.5, 0}, 2).starts_with("up  0.40 1.50 0 # a comment\n"));
    const std::string turned = changed(tree, *place->vectors[1], {-5, 31.26, 100});
    QVERIFY(turned.find("\nturn -5, +31.3, 1e2\n") != turned.npos);
}

void TestWrittenPlace::whatIsNoUseHasNoPlace()
{
    const std::string text = tree;
    QVERIFY(!placeOfUse(FdoDocument(text), text.find("#] x")));
    QVERIFY(!placeOfUse(FdoDocument(text), 0));
    QVERIFY(!placeOfUse(FdoDocument(text), text.size()));
    QVERIFY(!placeOfUse(FdoDocument(std::string()), 0));
    QVERIFY(!placeAt("x. \"x.obj\"\nt.p. (p, #, #)\n<$>. [t.9] x\n", "t.9"));
}

void TestWrittenPlace::anObjectOfASceneHasVectors_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("part");
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char *line, int part, const char *after) {
        QTest::addRow("%s, part %d", line, part) << QByteArray(line) << part << QByteArray(after);
    };
    row("o \"x.obj\" ((1, 2.0,3), #, #) # c", 0, "o \"x.obj\" ((2, 2.0,3), #, #) # c");
    row("o \"x.obj\" ((1, 2.0,3), #, #)", 1, "o \"x.obj\" ((1, 2.0,3), (1, 0, 0), #)");
    row("f \"x.fdo\" #", 0, "f \"x.fdo\" ((1, 0, 0), #, #)");
    row("f \"x.fdo\" #", 1, "f \"x.fdo\" (#, (1, 0, 0), #)");
    row("f \"x.fdo\" #", 2, "f \"x.fdo\" (#, #, (2, 1, 1))");
    row("p \"x.obj\" (#, #, (2, 2, 2)) 0.5 (1, 0, 0)", 2, "p \"x.obj\" (#, #, (3, 2, 2)) 0.5 (1, 0, 0)");
}

void TestWrittenPlace::anObjectOfASceneHasVectors()
{
    QFETCH(const QByteArray, line);
    QFETCH(const int, part);
    const std::string text = line.toStdString();
    const auto place = placeOfItem(SdoSyntax(text), 0);
    QVERIFY(place && place->vectors[static_cast<std::size_t>(part)]);
    const WrittenVector &vector = *place->vectors[static_cast<std::size_t>(part)];
    const std::string after = changed(text, vector, vector.value() + glm::dvec3(1, 0, 0));
    QTEST(QByteArray::fromStdString(after), "after");
    QVERIFY(readSdo(after).diagnostics.empty());
}

void TestWrittenPlace::itemsAreCounted()
{
    const SdoSyntax scene("l # #\no \"a.obj\" ((1, 0, 0), #, #)\n\nc # # 60\nf \"b.fdo\" ((2, 0, 0), #, #)\n");
    QVERIFY(placeOfItem(scene, 0)->parts.position.x == 1.0);
    QVERIFY(placeOfItem(scene, 1)->parts.position.x == 2.0);
    QVERIFY(!placeOfItem(scene, 2));
}

ROMANESCO_TEST(TestWrittenPlace)
#include "testwrittenplace.moc"
