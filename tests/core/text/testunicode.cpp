// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/text/unicode.h"

#include <string>

#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

class TestUnicode : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void decodesWellFormedAndRefusesTheRest_data();
    void decodesWellFormedAndRefusesTheRest();
    void everyCodePointSurvivesQtsEncoder();
    void countsIllFormedBytesOneByOne();
    void namesAreMadeOfLettersDigitsAndUnderscores_data();
    void namesAreMadeOfLettersDigitsAndUnderscores();
};

void TestUnicode::decodesWellFormedAndRefusesTheRest_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("value"); // -1: ill-formed
    QTest::newRow("A") << QByteArray("A") << 0x41;
    QTest::newRow("NUL") << QByteArray("\0", 1) << 0;
    QTest::newRow("DEL") << QByteArray("\x7F") << 0x7F;
    QTest::newRow("first of two bytes") << QByteArray("\xC2\x80") << 0x80;
    QTest::newRow("last of two bytes") << QByteArray("\xDF\xBF") << 0x7FF;
    QTest::newRow("first of three bytes") << QByteArray("\xE0\xA0\x80") << 0x800;
    QTest::newRow("before the surrogates") << QByteArray("\xED\x9F\xBF") << 0xD7FF;
    QTest::newRow("after the surrogates") << QByteArray("\xEE\x80\x80") << 0xE000;
    QTest::newRow("last of three bytes") << QByteArray("\xEF\xBF\xBF") << 0xFFFF;
    QTest::newRow("first of four bytes") << QByteArray("\xF0\x90\x80\x80") << 0x10000;
    QTest::newRow("the last code point") << QByteArray("\xF4\x8F\xBF\xBF") << 0x10FFFF;
    QTest::newRow("overlong slash") << QByteArray("\xC0\xAF") << -1;
    QTest::newRow("overlong A") << QByteArray("\xC1\x81") << -1;
    QTest::newRow("overlong three") << QByteArray("\xE0\x9F\xBF") << -1;
    QTest::newRow("overlong four") << QByteArray("\xF0\x8F\xBF\xBF") << -1;
    QTest::newRow("high surrogate") << QByteArray("\xED\xA0\x80") << -1;
    QTest::newRow("low surrogate") << QByteArray("\xED\xBF\xBF") << -1;
    QTest::newRow("past the last") << QByteArray("\xF4\x90\x80\x80") << -1;
    QTest::newRow("F5") << QByteArray("\xF5\x80\x80\x80") << -1;
    QTest::newRow("FF") << QByteArray("\xFF") << -1;
    QTest::newRow("continuation alone") << QByteArray("\x80") << -1;
    QTest::newRow("last continuation alone") << QByteArray("\xBF") << -1;
    QTest::newRow("two cut short") << QByteArray("\xC3") << -1;
    QTest::newRow("three cut short") << QByteArray("\xE2\x82") << -1;
    QTest::newRow("four cut short") << QByteArray("\xF0\x9F\x8C") << -1;
    QTest::newRow("two then ASCII") << QByteArray("\xC3(") << -1;
    QTest::newRow("three then ASCII") << QByteArray("\xE2\x82(") << -1;
    QTest::newRow("four then a lead") << QByteArray("\xF0\x9F\x8C\xC3") << -1;
}

void TestUnicode::decodesWellFormedAndRefusesTheRest()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, value);
    const CodePoint point = firstCodePoint(bytes.toStdString());
    QCOMPARE(point.isValid, value >= 0);
    QCOMPARE(point.length, value >= 0 ? static_cast<std::size_t>(bytes.size()) : 1u);
    if (value >= 0) {
        QCOMPARE(static_cast<int>(point.value), value);
        // What follows does not matter, and one byte less is ill-formed.
        QVERIFY(firstCodePoint(bytes.toStdString() + "\xFFz").isValid);
        QVERIFY(bytes.size() == 1 || !firstCodePoint(bytes.chopped(1).toStdString()).isValid);
    }
}

void TestUnicode::everyCodePointSurvivesQtsEncoder()
{
    for (char32_t value = 0; value <= 0x10FFFF; ++value) {
        if (value >= 0xD800 && value <= 0xDFFF) {
            continue;
        }
        const QString text = QString(QChar::fromUcs4(value));
        const std::string bytes = text.toStdString();
        const CodePoint point = firstCodePoint(bytes);
        if (!point.isValid || point.value != value || point.length != bytes.size()) {
            QFAIL(qPrintable(QString::number(value, 16)));
        }
    }
}

void TestUnicode::countsIllFormedBytesOneByOne()
{
    QCOMPARE(codePointCount(""), 0u);
    QCOMPARE(codePointCount("abc"), 3u);
    QCOMPARE(codePointCount("a\u00E9\u20AC\U0001F600"), 4u);
    QCOMPARE(codePointCount("\xE2\x82"), 2u);
    QCOMPARE(codePointCount("\xFF\xFE\x41"), 3u);
}

void TestUnicode::namesAreMadeOfLettersDigitsAndUnderscores_data()
{
    QTest::addColumn<int>("value");
    QTest::addColumn<bool>("isStart");
    QTest::addColumn<bool>("isPart");
    for (const char c : {'a', 'z', 'A', 'Z', '_'}) {
        QTest::addRow("%c", c) << int(c) << true << true;
    }
    for (const char c : {'0', '9'}) {
        QTest::addRow("%c", c) << int(c) << false << true;
    }
    for (const char c : {'$', '#', '.', ',', '-', '+', '@', '[', '`', '{', '/', ':', ' ', '\t', '\n', '"', '\x7F'}) {
        QTest::addRow("U+%04X", c) << int(c) << false << false;
    }
    const auto letter = [](const char *name, int value) { QTest::newRow(name) << value << true << true; };
    const auto other = [](const char *name, int value) { QTest::newRow(name) << value << false << false; };
    letter("e acute", 0xE9);
    letter("feminine ordinal", 0xAA);
    letter("micro", 0xB5);
    letter("Greek omega", 0x3C9);
    letter("Cyrillic", 0x416);
    letter("Hebrew", 0x5D0);
    letter("hiragana", 0x3042);
    letter("Chinese", 0x6F22);
    letter("Hangul", 0xD55C);
    letter("mathematical bold", 0x1D400);
    letter("last of Latin-1", 0xFF);
    other("no-break space", 0xA0);
    other("multiplication sign", 0xD7);
    other("division sign", 0xF7);
    other("guillemet", 0xAB);
    other("en dash", 0x2013);
    other("left quote", 0x201C);
    other("minus", 0x2212);
    other("ideographic space", 0x3000);
    other("byte order mark", 0xFEFF);
    other("replacement character", 0xFFFD);
    other("zero width space", 0x200B);
    other("private use", 0xE000);
}

void TestUnicode::namesAreMadeOfLettersDigitsAndUnderscores()
{
    QFETCH(int, value);
    QTEST(isNameStart(static_cast<char32_t>(value)), "isStart");
    QTEST(isNamePart(static_cast<char32_t>(value)), "isPart");
}

}

ROMANESCO_TEST(romanesco::test::TestUnicode)

#include "testunicode.moc"
