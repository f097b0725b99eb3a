// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <limits>

#include <QTest>

#include "core/language/writtennumber.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestWrittenNumber : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aValueKeepsTheWayOfWriting_data();
    void aValueKeepsTheWayOfWriting();
    void stepsAreOfTheLastDecimal_data();
    void stepsAreOfTheLastDecimal();
    void aThousandStepsAndBackGiveTheSameText();
    void whatIsNoNumberHasNone();
    void whatIsNotFiniteChangesNothing();
};

namespace {

WrittenNumber numberFrom(const QByteArray &text)
{
    return writtenNumber(std::string_view(text.data(), text.size()), {0, static_cast<std::size_t>(text.size())})
        .value();
}

}

void TestWrittenNumber::aValueKeepsTheWayOfWriting_data()
{
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<double>("value");
    QTest::addColumn<QByteArray>("now");
    const auto row = [](const char *written, double value, const char *now) {
        QTest::addRow("%s to %g", written, value) << QByteArray(written) << value << QByteArray(now);
    };
    row("1", 2.0, "2");
    row("1", 0.99999, "1");
    row("1", -0.2, "0");
    row("0.50", 0.51, "0.51");
    row("0.50", 0.30000000000000004, "0.30");
    row("5.", 7.0, "7");
    row(".5", 0.25, "0.2"); // halves to even, as the exact value lies
    row("+1", 2.0, "+2");
    row("+1", -2.0, "-2");
    row("-0.5", 0.5, "0.5");
    row("1e-3", 0.002, "2e-3");
    row("1.5e-3", 0.0025, "2.5e-3");
    row("1.5E+3", 2500.0, "2.5E+3");
    row("1e300", 2e300, "2e300");
    row("123456789.123", -0.0004, "0.000");
}

void TestWrittenNumber::aValueKeepsTheWayOfWriting()
{
    QFETCH(QByteArray, written);
    QFETCH(double, value);
    QFETCH(QByteArray, now);
    const TextEdit edit = withValue(numberFrom(written), value);
    QCOMPARE(QByteArray::fromStdString(edit.text), now);
    QVERIFY((edit.range == SourceRange{0, static_cast<std::size_t>(written.size())}));
}

void TestWrittenNumber::stepsAreOfTheLastDecimal_data()
{
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<int>("steps");
    QTest::addColumn<int>("finer");
    QTest::addColumn<QByteArray>("now");
    const auto row = [](const char *written, int steps, int finer, const char *now) {
        QTest::addRow("%s by %d, %d finer", written, steps, finer)
            << QByteArray(written) << steps << finer << QByteArray(now);
    };
    row("1", 1, 0, "2");
    row("1", -2, 0, "-1");
    row("1", -1, 0, "0");
    row("0.1", 2, 0, "0.3");
    row("0.1", 2, 1, "0.12");
    row("1", 1, 1, "1.1");
    row("9.9", 1, 0, "10.0");
    row("1e-9", 1, 0, "2e-9");
    row("0.123456789012345", 1, 0, "0.123456789012346");
    row("0.123456789012345", 1, 3, "0.123456789012346");
}

void TestWrittenNumber::stepsAreOfTheLastDecimal()
{
    QFETCH(QByteArray, written);
    QFETCH(int, steps);
    QFETCH(int, finer);
    QFETCH(QByteArray, now);
    QCOMPARE(QByteArray::fromStdString(stepped(numberFrom(written), steps, finer).text), now);
}

void TestWrittenNumber::aThousandStepsAndBackGiveTheSameText()
{
    std::string text = "0.10";
    for (int i = 0; i < 2'000; ++i) {
        const WrittenNumber number = writtenNumber(text, {0, text.size()}).value();
        text = stepped(number, i < 1'000 ? 1 : -1).text;
        QCOMPARE(number.decimals, 2);
    }
    QCOMPARE(text, std::string("0.10"));
}

void TestWrittenNumber::whatIsNoNumberHasNone()
{
    for (const std::string text : {"", "x", "nan", "1e400", "0x1", "1,5", "1 ", "1e", "--1", "0.1234567890123456"}) {
        QVERIFY2(!writtenNumber(text, {0, text.size()}), text.c_str());
    }
}

void TestWrittenNumber::whatIsNotFiniteChangesNothing()
{
    QCOMPARE(withValue(numberFrom("0.5"), std::numeric_limits<double>::quiet_NaN()).text, std::string("0.5"));
    QCOMPARE(withValue(numberFrom("0.5"), std::numeric_limits<double>::infinity()).text, std::string("0.5"));
}

}

ROMANESCO_TEST(romanesco::test::TestWrittenNumber)

#include "testwrittennumber.moc"
