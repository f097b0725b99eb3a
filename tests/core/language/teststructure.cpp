// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>

#include <QTest>

#include "core/language/structure.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const std::string sample = "# Vectors\n"
                           "v 1 2 3\n"
                           "half 0.5, 0.5, 0.5   # a half\n"
                           "v 1 2\n"
                           "\n"
                           "# Maps\n"
                           "# of two kinds\n"
                           "t.a. (a, #, half)\n"
                           "x. \"x.obj\"\n"
                           "z<x>. [t.1] x\n"
                           "\n\n"
                           "y. z 3\n"
                           "wrong\n"
                           "<$>. [t.1] y # z 7\n";

std::string joined(const std::vector<std::string> &parts)
{
    std::string all;
    for (const std::string &part : parts) {
        all += (all.empty() ? "" : ", ") + part;
    }
    return all;
}

}

class TestStructure : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void outlineNamesWhatIsDeclared();
    void sectionsFold_data();
    void sectionsFold();
    void vectorsShowTheirNumbers();
    void inlaysOfSomeLinesAreThoseOfAll();
    void everyDepthIsANumberToSlide();
    void theDepthOfTheResultIsSet();
};

void TestStructure::outlineNamesWhatIsDeclared()
{
    const FdoDocument document(sample);
    std::vector<std::string> found;
    for (const OutlineEntry &entry : outline(document)) {
        QCOMPARE(sample.substr(entry.range.begin, entry.range.length()), entry.name);
        found.push_back(std::format("{}: {} {}", entry.line + 1, described(entry.kind), entry.name));
    }
    QCOMPARE(joined(found),
             std::string("3: a vector half, 8: a transformation t, 9: an object x, 10: a recursive z, "
                         "13: an object y, 14: unknown wrong, 15: an object <$>"));
}

void TestStructure::sectionsFold_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("folds");
    QTest::newRow("sections of the sample") << QByteArray::fromStdString(sample) << QByteArray("1-4 6-15");
    QTest::newRow("nothing") << QByteArray() << QByteArray();
    QTest::newRow("no comment") << QByteArray("x\ny\n\nz\n") << QByteArray();
    QTest::newRow("a comment alone") << QByteArray("# x\n\ny") << QByteArray("1-3");
    QTest::newRow("one line") << QByteArray("# x") << QByteArray();
    QTest::newRow("a comment amid lines starts nothing") << QByteArray("# x\ny\n# z\nw\n") << QByteArray("1-4");
    QTest::newRow("blank lines at the end stay") << QByteArray("# x\ny\n \n\t\n\n# z\nw") << QByteArray("1-2 6-7");
    QTest::newRow("line ends of every kind") << QByteArray("# x\r\ny\r\r# z\nw") << QByteArray("1-2 4-5");
    QTest::newRow("a byte order mark") << QByteArray("\xEF\xBB\xBF# x\ny") << QByteArray("1-2");
    QTest::newRow("indented comments") << QByteArray("  # x\ny") << QByteArray("1-2");
}

void TestStructure::sectionsFold()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, folds);
    const std::string bytes = text.toStdString();
    std::string found;
    for (const FoldingRange &range : foldingRanges(LineMap(bytes))) {
        found += std::format("{}{}-{}", found.empty() ? "" : " ", range.first + 1, range.last + 1);
    }
    QCOMPARE(QByteArray::fromStdString(found), folds);
}

void TestStructure::vectorsShowTheirNumbers()
{
    const FdoDocument document(sample);
    std::string shown = sample;
    const std::vector<Inlay> all = inlays(document, 0, document.syntax.lineCount());
    for (auto inlay = all.rbegin(); inlay != all.rend(); ++inlay) {
        shown.insert(inlay->offset, std::format("·{}", inlay->number));
    }
    QVERIFY(shown.starts_with("# Vectors\nv 1 2 3·1\nhalf 0.5, 0.5, 0.5·2   # a half\nv 1 2·3\n\n"));
    QCOMPARE(all.size(), std::size_t{3});
}

void TestStructure::inlaysOfSomeLinesAreThoseOfAll()
{
    const FdoDocument document(sample);
    QCOMPARE(inlays(document, 2, 3).size(), std::size_t{1});
    QCOMPARE(inlays(document, 2, 3)[0].number, 2u);
    QVERIFY(inlays(document, 5, 100).empty());
    QVERIFY(inlays(document, 100, 3).empty());
}

void TestStructure::everyDepthIsANumberToSlide()
{
    const FdoDocument document("x. \"x.obj\"\nz<x>. [#] x\nw<x>. z 05\ny. w 3 # z 9\n<$>. [#] z 7\n");
    std::vector<std::string> found;
    for (const DepthNumber &number : depthNumbers(document)) {
        found.push_back(std::format("{} {} at {}", number.name, number.value, number.range.begin));
    }
    QCOMPARE(joined(found), std::string("z 5 at 31, w 3 at 39, z 7 at 58"));
}

void TestStructure::theDepthOfTheResultIsSet()
{
    const std::string text = "x. \"x.obj\"\nz<x>. [#] x\ny. [#] z 05 # five\n<$>. [#] y\n";
    QCOMPARE(applied(text, withDepth(FdoDocument(text), 31)),
             std::string("x. \"x.obj\"\nz<x>. [#] x\ny. [#] z 31 # five\n<$>. [#] y\n"));
    QVERIFY(withDepth(FdoDocument("x. \"x.obj\"\n<$>. x\n"), 3).empty());
    QVERIFY(withDepth(FdoDocument(""), 3).empty());
}

}

ROMANESCO_TEST(romanesco::test::TestStructure)

#include "teststructure.moc"
