// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/text/lexer.h"

#include <string>

#include <QTest>
#include <rapidcheck.h>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// One letter for each kind, in the order of the enumeration.
constexpr std::string_view letters = "$NDIsu.,()[]<>S#?";

QString tokens(std::string_view line, LexMode mode)
{
    LineLexer lexer(line, 0);
    QString text;
    for (Token token = lexer.take(mode); !token.is(TokenKind::EndOfLine); token = lexer.take(mode)) {
        const char letter = letters[static_cast<std::size_t>(token.kind)];
        text += (text.isEmpty() ? "" : " ") + QString(QLatin1Char(letter)) + ':'
            + QString::fromUtf8(token.text.data(), static_cast<qsizetype>(token.text.size()));
    }
    return text;
}

}

class TestLexer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesBecomeTokens_data();
    void linesBecomeTokens();
    void rangesCountFromTheOffset();
    void blanksBeforeTheNextToken();
    void alwaysMovesOnToTheEnd();
};

void TestLexer::linesBecomeTokens_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("asValue");
    QTest::addColumn<QString>("asIndex");
    const auto row = [](const char *line, const char *asValue, const char *asIndex) {
        QTest::newRow(line) << QString::fromUtf8(line) << QString::fromUtf8(asValue) << QString::fromUtf8(asIndex);
    };
    const auto both = [&](const char *line, const char *expected) { row(line, expected, expected); };
    both("", "");
    both(" \t\v\f ", "");
    both("abc_1 _x9 Z", "N:abc_1 N:_x9 N:Z");
    both("\u00E9t\u00E9", "N:\u00E9t\u00E9");
    both("a\u2013b", "N:a ?:\u2013 N:b");
    both(".,()[]<>$#", ".:. ,:, (:( ):) [:[ ]:] <:< >:> S:$ #:#");
    both("\"a b\"c", "s:\"a b\" N:c");
    both("\"\"", "s:\"\"");
    both("\"open # [", "u:\"open # [");
    both("@ \x01", "?:@ ?:\x01");
    row("t.1.2", "N:t D:.1.2", "N:t .:. I:1 .:. I:2");
    row("t.1a", "N:t D:.1a", "N:t .:. D:1a");
    row("t.a.1", "N:t .:. N:a D:.1", "N:t .:. N:a .:. I:1");
    row("t.1 .2", "N:t D:.1 D:.2", "N:t .:. I:1 .:. I:2");
    row("1 2.5 -3 +.5 5. 1e5 1E-5 1e+5", "D:1 D:2.5 D:-3 D:+.5 D:5. D:1e5 D:1E-5 D:1e+5",
        "I:1 I:2 .:. I:5 ?:- I:3 ?:+ .:. I:5 I:5 .:. D:1e5 D:1E ?:- I:5 D:1e ?:+ I:5");
    row("1,2)3]4#5", "D:1 ,:, D:2 ):) D:3 ]:] D:4 #:# D:5", "I:1 ,:, I:2 ):) I:3 ]:] I:4 #:# I:5");
    row("0x1F 1e 1.2.3 1a", "D:0x1F D:1e D:1.2.3 D:1a", "D:0x1F D:1e I:1 .:. I:2 .:. I:3 D:1a");
    row("-x +. .x", "?:- N:x ?:+ .:. .:. N:x", "?:- N:x ?:+ .:. .:. N:x");
    row("1(2[3\"4\"5<6>7$8", "D:1 (:( D:2 [:[ D:3 s:\"4\" D:5 <:< D:6 >:> D:7 S:$ D:8",
        "I:1 (:( I:2 [:[ I:3 s:\"4\" I:5 <:< I:6 >:> I:7 S:$ I:8");
    row("nan inf infinity", "N:nan N:inf N:infinity", "N:nan N:inf N:infinity");
}

void TestLexer::linesBecomeTokens()
{
    QFETCH(QString, line);
    const std::string bytes = line.toStdString();
    QTEST(tokens(bytes, LexMode::Value), "asValue");
    QTEST(tokens(bytes, LexMode::Index), "asIndex");
}

void TestLexer::rangesCountFromTheOffset()
{
    LineLexer lexer("  ab  12 ", 100);
    QCOMPARE(lexer.peek().range, (SourceRange{102, 104}));
    QCOMPARE(lexer.take().range, (SourceRange{102, 104}));
    QCOMPARE(lexer.take().range, (SourceRange{106, 108}));
    QCOMPARE(lexer.take().range, (SourceRange{109, 109}));
    QCOMPARE(lexer.take().range, (SourceRange{109, 109}));
}

void TestLexer::blanksBeforeTheNextToken()
{
    LineLexer lexer("a.5 b", 0);
    QVERIFY(lexer.isBlankBeforeNext());
    (void)lexer.take();
    QVERIFY(!lexer.isBlankBeforeNext());
    (void)lexer.take();
    QVERIFY(lexer.isBlankBeforeNext());
}

void TestLexer::alwaysMovesOnToTheEnd()
{
    QVERIFY(rc::check([](const std::string &line, bool isIndex) {
        const LexMode mode = isIndex ? LexMode::Index : LexMode::Value;
        LineLexer lexer(line, 0);
        std::size_t end = 0;
        for (Token token = lexer.take(mode); !token.is(TokenKind::EndOfLine); token = lexer.take(mode)) {
            RC_ASSERT(token.range.begin >= end);
            RC_ASSERT(token.range.end > token.range.begin);
            RC_ASSERT(line.substr(token.range.begin, token.range.length()) == token.text);
            end = token.range.end;
        }
        RC_ASSERT(line.find_first_not_of(" \t\v\f", end) == std::string::npos);
    }));
}

}

ROMANESCO_TEST(romanesco::test::TestLexer)

#include "testlexer.moc"
