// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/text/linemap.h"
#include "core/text/places.h"

#include <string>

#include <QTest>
#include <rapidcheck.h>

#include "core/text/diagnostic.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestLineMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesEndAtEveryKindOfEnd_data();
    void linesEndAtEveryKindOfEnd();
    void columnsCountCodePoints();
    void everyOffsetHasItsPlace();
    void diagnosticsPrintAsCompilersDo();
    void argumentsMayHoldBraces();
    void argumentsAreShownAsText();
    void everyDiagnosticHasANameOfItsOwn();
    void placesSortAndKeepTheirOrder();
};

void TestLineMap::linesEndAtEveryKindOfEnd_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QList<QByteArray>>("lines");
    QTest::newRow("empty") << QByteArray() << QList<QByteArray>{""};
    QTest::newRow("no end") << QByteArray("ab") << QList<QByteArray>{"ab"};
    QTest::newRow("LF") << QByteArray("a\nb\n") << QList<QByteArray>{"a", "b", ""};
    QTest::newRow("CR LF") << QByteArray("a\r\nb\r\n") << QList<QByteArray>{"a", "b", ""};
    QTest::newRow("CR alone") << QByteArray("a\rb\r") << QList<QByteArray>{"a", "b", ""};
    QTest::newRow("mixed") << QByteArray("a\rb\nc\r\nd") << QList<QByteArray>{"a", "b", "c", "d"};
    QTest::newRow("LF CR is two") << QByteArray("a\n\rb") << QList<QByteArray>{"a", "", "b"};
    QTest::newRow("CR CR LF is two") << QByteArray("a\r\r\nb") << QList<QByteArray>{"a", "", "b"};
    QTest::newRow("only ends") << QByteArray("\n\n") << QList<QByteArray>{"", "", ""};
    QTest::newRow("CR at the end") << QByteArray("\r") << QList<QByteArray>{"", ""};
    QTest::newRow("other separators are none")
        << QByteArray("a\v\f\xE2\x80\xA8z") << QList<QByteArray>{"a\v\f\xE2\x80\xA8z"};
}

void TestLineMap::linesEndAtEveryKindOfEnd()
{
    QFETCH(QByteArray, text);
    const std::string bytes = text.toStdString();
    const LineMap map(bytes);
    QList<QByteArray> found;
    for (std::size_t i = 0; i < map.lineCount(); ++i) {
        const SourceRange range = map.line(i);
        found.push_back(QByteArray::fromStdString(bytes.substr(range.begin, range.length())));
        QCOMPARE(map.position(range.begin), (TextPosition{i + 1, 1}));
    }
    QTEST(found, "lines");
}

void TestLineMap::columnsCountCodePoints()
{
    const std::string text = "x\n\u00E9\u20AC\U0001F600z\xFFw\n";
    const LineMap map(text);
    QCOMPARE(map.position(text.find('z')), (TextPosition{2, 4}));
    QCOMPARE(map.position(text.find('w')), (TextPosition{2, 6}));
    QCOMPARE(map.position(text.size()), (TextPosition{3, 1}));
    QCOMPARE(map.position(text.size() + 100), (TextPosition{3, 1}));
    QCOMPARE(map.offset({2, 4}), text.find('z'));
    QCOMPARE(map.offset({2, 100}), text.size() - 1);
    QCOMPARE(map.offset({100, 1}), text.size());
}

void TestLineMap::everyOffsetHasItsPlace()
{
    // Against counting by hand from the start of the text.
    QVERIFY(rc::check([](std::vector<std::uint8_t> choices) {
        std::string text;
        for (const std::uint8_t choice : choices) {
            text += std::array{"\n", "\r", "\r\n", "a", "bc", "\u20AC"}[choice % 6];
        }
        const LineMap map(text);
        TextPosition place;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const bool isInsideCodePoint = (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
            const bool isInsidePair = text[i] == '\n' && i > 0 && text[i - 1] == '\r';
            if (!isInsideCodePoint && !isInsidePair) {
                RC_ASSERT(map.position(i) == place);
                RC_ASSERT(map.offset(place) == i);
            }
            const bool endsLine = text[i] == '\n' || (text[i] == '\r' && !(i + 1 < text.size() && text[i + 1] == '\n'));
            if (endsLine) {
                place = {place.line + 1, 1};
            } else if (!isInsideCodePoint) {
                ++place.column;
            }
        }
        RC_ASSERT(map.lineCount() == place.line);
    }));
}

void TestLineMap::diagnosticsPrintAsCompilersDo()
{
    const std::string text = "first\n  \u00E9 wrong\n";
    const LineMap map(text);
    Places places(map);
    const std::size_t at = text.find("wrong");
    const Diagnostic diagnostic{DiagnosticCode::UnknownName, {at, at + 5}, {"wrong"}};
    QCOMPARE(toLines(diagnostic, "tree.fdo", places), "tree.fdo:2:5: error: nothing named wrong is declared above");
    QCOMPARE(toLines({DiagnosticCode::Unused, {0, 5}, {"first"}}, "a.fdo", places),
             "a.fdo:1:1: hint: first is never used");
    QCOMPARE(toLines({DiagnosticCode::EmptyIteration, {0, 5}, {"z"}}, "a.fdo", places),
             "a.fdo:1:1: warning: an iteration of z adds nothing");
}

void TestLineMap::argumentsMayHoldBraces()
{
    const Diagnostic diagnostic{DiagnosticCode::NotAnObject, {}, {"{1}{0}", "{"}};
    QCOMPARE(diagnostic.message(), "{1}{0} is {, not an object");
}

void TestLineMap::argumentsAreShownAsText()
{
    const auto shown = [](std::string argument) {
        return QString::fromStdString(Diagnostic{DiagnosticCode::BadNumber, {}, {std::move(argument)}}.message());
    };
    QCOMPARE(shown("\u00E9\U0001F600"), QString::fromUtf8("\"\u00E9\U0001F600\" is not a number"));
    QCOMPARE(shown("2\xFF"), QString::fromUtf8("\"2\uFFFD\" is not a number"));
    QCOMPARE(shown(std::string("a\0\x1B\x7F", 4)), QString::fromUtf8("\"a\uFFFD\uFFFD\uFFFD\" is not a number"));
    QCOMPARE(shown(std::string(200, 'x')), "\"" + QString(200, QLatin1Char('x')) + "\" is not a number");
    QCOMPARE(shown(std::string(1'000'000, 'x')),
             QString::fromUtf8("\"") + QString(200, QLatin1Char('x')) + QString::fromUtf8("\u2026\" is not a number"));
}

void TestLineMap::everyDiagnosticHasANameOfItsOwn()
{
    const std::vector<std::string_view> names = {
#define DIAGNOSTIC(code, name, severity, words) name,
#include "core/text/diagnostics.def"
#undef DIAGNOSTIC
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        QVERIFY(name(static_cast<DiagnosticCode>(i)) == names[i]);
        QVERIFY(names[i].find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos);
        for (std::size_t j = 0; j < i; ++j) {
            QVERIFY(names[i] != names[j]);
        }
    }
}

void TestLineMap::placesSortAndKeepTheirOrder()
{
    Diagnostics diagnostics{{DiagnosticCode::UnknownName, {9, 10}, {"a"}},
                            {DiagnosticCode::EmptySet, {3, 9}, {}},
                            {DiagnosticCode::EmptyIteration, {3, 4}, {"b"}}};
    QVERIFY(hasErrors(diagnostics));
    sortByPlace(diagnostics);
    QVERIFY(diagnostics[0].code == DiagnosticCode::EmptySet);
    QVERIFY(diagnostics[1].code == DiagnosticCode::EmptyIteration);
    QVERIFY(diagnostics[2].code == DiagnosticCode::UnknownName);
    QVERIFY(!hasErrors({{DiagnosticCode::Unused, {}, {"a"}}, {DiagnosticCode::EmptyIteration, {}, {"b"}}}));
}

}

ROMANESCO_TEST(romanesco::test::TestLineMap)

#include "testlinemap.moc"
