// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/text/spelling.h"

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include <QTest>

#include "tests/testmain.h"

using namespace romanesco;

namespace {

/// All words that one slip makes.
std::set<std::string> slipped(const std::string &word, const std::string &letters)
{
    std::set<std::string> words;
    for (std::size_t i = 0; i <= word.size(); ++i) {
        const std::string before = word.substr(0, i);
        const std::string after = word.substr(i);
        for (const char letter : letters) {
            words.insert(before + letter + after);
            if (!after.empty()) {
                words.insert(before + letter + after.substr(1));
            }
        }
        if (!after.empty()) {
            words.insert(before + after.substr(1));
        }
        if (after.size() > 1) {
            words.insert(before + after[1] + after[0] + after.substr(2));
        }
    }
    return words;
}

}

class TestSpelling : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void slipsAreCounted_data();
    void slipsAreCounted();
    void oneSlipIsWhatOneSlipMakes();
    void directionsDoNotMatter();
};

void TestSpelling::slipsAreCounted_data()
{
    QTest::addColumn<std::string>("one");
    QTest::addColumn<std::string>("other");
    QTest::addColumn<std::size_t>("slips");
    const auto row = [](const char *one, const char *other, std::size_t slips) {
        QTest::addRow("%s %s", one, other) << std::string(one) << std::string(other) << slips;
    };
    row("", "", 0);
    row("", "abc", 3);
    row("lean", "lean", 0);
    row("lean", "xlean", 1);
    row("lean", "laen", 1);
    row("lean", "mean", 1);
    row("lean", "l", 3);
    row("kitten", "sitting", 3);
    row("ca", "abc", 3); // each byte is in one slip: not swapped, and then parted
}

void TestSpelling::slipsAreCounted()
{
    QFETCH(const std::string, one);
    QFETCH(const std::string, other);
    QFETCH(const std::size_t, slips);
    QCOMPARE(slipsBetween(one, other), slips);
}

/// All words of up to four letters out of two.
void TestSpelling::oneSlipIsWhatOneSlipMakes()
{
    std::set<std::string> words{""};
    for (int length = 0; length < 4; ++length) {
        std::set<std::string> longer = words;
        for (const std::string &word : words) {
            longer.insert({word + 'a', word + 'b'});
        }
        words = longer;
    }
    QCOMPARE(words.size(), 31u);
    for (const std::string &one : words) {
        const std::set<std::string> near = slipped(one, "ab");
        for (const std::string &other : words) {
            QCOMPARE(slipsBetween(one, other) == 1, one != other && near.contains(other));
            QCOMPARE(slipsBetween(one, other) == 0, one == other);
        }
    }
}

void TestSpelling::directionsDoNotMatter()
{
    std::mt19937 random(test::seed(5));
    const auto word = [&] {
        std::string letters(random() % 9, 'a');
        for (char &letter : letters) {
            letter = static_cast<char>('a' + random() % 3);
        }
        return letters;
    };
    for (int i = 0; i < 2'000; ++i) {
        const std::string one = word();
        const std::string other = word();
        const std::size_t slips = slipsBetween(one, other);
        QCOMPARE(slipsBetween(other, one), slips);
        QVERIFY(slips <= std::max(one.size(), other.size()));
        QVERIFY(slips >= std::max(one.size(), other.size()) - std::min(one.size(), other.size()));
    }
}

ROMANESCO_TEST(TestSpelling)

#include "testspelling.moc"
