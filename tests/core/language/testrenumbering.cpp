// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QFile>
#include <QTest>

#include "core/formats/fdoreader.h"
#include "core/language/renumbering.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::string removedLine(const std::string &text, std::size_t line)
{
    const LineMap lines(text);
    return text.substr(0, lines.start(line)) + text.substr(lines.start(line + 1));
}

std::string insertedLine(const std::string &text, std::size_t line, const std::string &words)
{
    const LineMap lines(text);
    return text.substr(0, lines.start(line)) + words + '\n' + text.substr(lines.start(line));
}

std::string renumbered(const std::string &before, const std::string &after)
{
    return applied(after, renumbering(FdoDocument(before), FdoDocument(after)).edits);
}

bool hasSameMeaning(const std::string &a, const std::string &b)
{
    const FdoResult first = readFdo(a);
    const FdoResult second = readFdo(b);
    if (!first.description || !second.description || hasErrors(second.diagnostics)) {
        return false;
    }
    const auto mapsOf = [](const FractalDescription &description) {
        std::vector<std::vector<AffineMap>> maps;
        for (const TransformSet &set : description.sets) {
            maps.push_back(set.maps);
        }
        return maps;
    };
    return mapsOf(*first.description) == mapsOf(*second.description);
}

std::vector<std::string> examples()
{
    std::vector<std::string> texts{
        "v 1 1 1\nv 2 2 2\nv .5 .5 .5\nt.a. (a, #, 3)\nx. \"x.obj\"\n<$>. [t.1] x\n"}; // 2 is not used
    const QDir folder(test::sourcePath("resources/examples"));
    for (const QFileInfo &info : folder.entryInfoList({QStringLiteral("*.fdo")})) {
        QFile file(info.filePath());
        texts.push_back(file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string());
    }
    return texts;
}

}

class TestRenumbering : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void insertingAVectorAnywhereKeepsTheMeaning();
    void removingAVectorKeepsTheMeaningOrNamesItsUses();
    void editsSay_data();
    void editsSay();
    void otherTextsGetNoEdits();
};

void TestRenumbering::insertingAVectorAnywhereKeepsTheMeaning()
{
    int changed = 0;
    for (const std::string &text : examples()) {
        for (std::size_t line = 0; line <= LineMap(text).lineCount(); ++line) {
            const std::string after = insertedLine(text, line, "v 7 7 7");
            const std::string now = renumbered(text, after);
            QVERIFY2(hasSameMeaning(text, now), now.c_str());
            changed += now != after ? 1 : 0;
        }
    }
    QVERIFY(changed > 20);
}

void TestRenumbering::removingAVectorKeepsTheMeaningOrNamesItsUses()
{
    int used = 0;
    int unused = 0;
    for (const std::string &text : examples()) {
        const FdoDocument before(text);
        for (const VectorEntry &vector : before.model.vectors) {
            const std::string after = removedLine(text, vector.line);
            const Renumbering result = renumbering(before, FdoDocument(after));
            const std::string number =
                std::to_string(&vector - before.model.vectors.data() + 1); // as its uses are written
            for (const SourceRange orphan : result.orphans) {
                QCOMPARE(after.substr(orphan.begin, orphan.length()), number);
            }
            const std::string now = applied(after, result.edits);
            const bool isNamed = text.substr(before.syntax.map().start(vector.line), 2) != "v ";
            if (result.orphans.empty() && !isNamed) {
                QVERIFY2(hasSameMeaning(text, now), now.c_str());
                ++unused;
            } else {
                ++used;
            }
        }
    }
    QVERIFY(used > 20 && unused > 0);
}

void TestRenumbering::editsSay_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QByteArray>("now");
    QTest::addColumn<int>("orphans");
    const QByteArray uses = "t.a. (a, #, 2)\nx. [t.1, t.2.] y\n";
    QTest::newRow("one more before") << "v 1 1 1\nv 2 2 2\n" + uses << "v 0 0 0\nv 1 1 1\nv 2 2 2\n" + uses
                                     << QByteArray("v 0 0 0\nv 1 1 1\nv 2 2 2\nt.a. (a, #, 3)\nx. [t.2, t.3.] y\n")
                                     << 0;
    QTest::newRow("one more after") << "v 1 1 1\nv 2 2 2\n" + uses << "v 1 1 1\nv 2 2 2\nv 3 3 3\n" + uses
                                    << "v 1 1 1\nv 2 2 2\nv 3 3 3\n" + uses << 0;
    QTest::newRow("the first gone") << "v 1 1 1\nv 2 2 2\n" + uses << "v 2 2 2\n" + uses
                                    << QByteArray("v 2 2 2\nt.a. (a, #, 1)\nx. [t.1, t.1.] y\n") << 1;
    QTest::newRow("another value") << "v 1 1 1\nv 2 2 2\n" + uses << "v 9 9 9\nv 2 2 2\n" + uses
                                   << "v 9 9 9\nv 2 2 2\n" + uses << 0;
    const QByteArray missing = "x. [t.2, t.99999999999] y\n";
    QTest::newRow("the missing one is written")
        << "v 1 1 1\n" + missing << "v 1 1 1\nv 2 2 2\n" + missing << "v 1 1 1\nv 2 2 2\n" + missing << 0;
    const QByteArray pair = "v 1 1 1\nv 2 2 2\n";
    QTest::newRow("one of equals is gone") << pair + pair + "x. [t.3, t.4] y\n"
                                           << pair + "x. [t.3, t.4] y\n"
                                           << pair + "x. [t.1, t.2] y\n"
                                           << 0;
    QTest::newRow("a line that was begun is a vector already")
        << "v 1 1 1\nv 2 2 2\n" + uses << "v 1 1 1\nv 1\nv 2 2 2\n" + uses
        << QByteArray("v 1 1 1\nv 1\nv 2 2 2\nt.a. (a, #, 3)\nx. [t.1, t.3.] y\n") << 0;
    QTest::newRow("numbers that are written anew stay")
        << "v 1 1 1\n" + uses << "v 0 0 0\nv 1 1 1\nnew. [t.1] y\n" + uses
        << QByteArray("v 0 0 0\nv 1 1 1\nnew. [t.1] y\nt.a. (a, #, 2)\n"
                      "x. [t.2, t.2.] y\n")
        << 0;
}

void TestRenumbering::editsSay()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QByteArray, now);
    QFETCH(int, orphans);
    const Renumbering result = renumbering(FdoDocument(before.toStdString()), FdoDocument(after.toStdString()));
    QCOMPARE(QByteArray::fromStdString(applied(after.toStdString(), result.edits)), now);
    QCOMPARE(static_cast<int>(result.orphans.size()), orphans);
}

void TestRenumbering::otherTextsGetNoEdits()
{
    for (const std::string &a : examples()) {
        QVERIFY(renumbering(FdoDocument(a), FdoDocument(a)).edits.empty());
        QVERIFY(renumbering(FdoDocument(a), FdoDocument("")).edits.empty());
        QVERIFY(renumbering(FdoDocument(""), FdoDocument(a)).edits.empty());
    }
}

}

ROMANESCO_TEST(romanesco::test::TestRenumbering)

#include "testrenumbering.moc"
