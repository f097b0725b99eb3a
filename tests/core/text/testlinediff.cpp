// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/text/linediff.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>
#include <span>
#include <string>

#include <QTest>

#include "tests/testmain.h"

using namespace romanesco;

namespace {

using Lines = std::vector<std::string_view>;

/// Lines that differ, by the table of all longest common subsequences.
std::size_t fewestDifferences(const Lines &a, const Lines &b)
{
    std::vector<std::vector<std::size_t>> common(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            common[i][j] =
                a[i - 1] == b[j - 1] ? common[i - 1][j - 1] + 1 : std::max(common[i - 1][j], common[i][j - 1]);
        }
    }
    return a.size() + b.size() - 2 * common[a.size()][b.size()];
}

std::size_t countOf(const std::vector<LineChange> &changes)
{
    return std::accumulate(changes.begin(), changes.end(), std::size_t{0}, [](std::size_t sum, const LineChange &c) {
        return sum + c.oldEnd - c.oldBegin + c.newEnd - c.newBegin;
    });
}

/// Of few different lines, with characters of one to four bytes.
std::string randomText(std::mt19937_64 &random, std::size_t most)
{
    const std::vector<std::string> lines{"", "a", "b", "ä", "Ä", "ń", "€", "🙂", "🙃", "ab", "aäb"};
    std::string text;
    for (std::size_t i = random() % most; i > 0; --i) {
        text += lines[random() % lines.size()];
        text += random() % 8 ? "\n" : "";
    }
    return text;
}

bool isBoundary(std::string_view text, std::size_t at)
{
    return at == text.size() || (static_cast<unsigned char>(text[at]) & 0xC0) != 0x80;
}

}

class TestLineDiff : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesAreCountedAsByAnEditor()
    {
        QCOMPARE(linesOf("").size(), std::size_t(1));
        QCOMPARE(linesOf("a").size(), std::size_t(1));
        QVERIFY((linesOf("a\n\nb\n") == Lines{"a", "", "b", ""}));
    }

    void theFewestLinesDiffer()
    {
        std::mt19937_64 random(test::seed(1));
        for (int i = 0; i < 3'000; ++i) {
            const std::string before = randomText(random, 14);
            const std::string after = randomText(random, 14);
            const Lines a = linesOf(before);
            const Lines b = linesOf(after);
            const std::vector<LineChange> changes = lineChanges(a, b);
            QCOMPARE(countOf(changes), fewestDifferences(a, b));
            // What lies between them is alike.
            std::size_t x = 0;
            std::size_t y = 0;
            for (const LineChange &change : changes) {
                QVERIFY(x == 0 || change.oldBegin > x);
                QVERIFY(std::ranges::equal(std::span(a).subspan(x, change.oldBegin - x),
                                           std::span(b).subspan(y, change.newBegin - y)));
                x = change.oldEnd;
                y = change.newEnd;
            }
            QVERIFY(std::ranges::equal(std::span(a).subspan(x), std::span(b).subspan(y)));
        }
    }

    void editsMakeTheOneOfTheOther()
    {
        std::mt19937_64 random(test::seed(2));
        for (int i = 0; i < 5'000; ++i) {
            const std::string before = randomText(random, 12);
            const std::string after = randomText(random, 12);
            const TextEdits edits = editsBetween(before, after);
            QCOMPARE(applied(before, edits), after);
            for (const TextEdit &edit : edits) {
                QVERIFY(isBoundary(before, edit.range.begin) && isBoundary(before, edit.range.end));
                QVERIFY(edit.text.empty() || isBoundary(edit.text, 0));
                QVERIFY(edit.range.length() > 0 || !edit.text.empty());
            }
        }
        QVERIFY(editsBetween("a\nb", "a\nb").empty());
    }

    /// Only what differs, so that a cursor beside it stays.
    void editsAreSmall()
    {
        QVERIFY((editsBetween("one\ntwo three\nfour\n", "one\ntwo, three\nfour\n") == TextEdits{{{7, 7}, ","}}));
        QVERIFY((editsBetween("a\nb\nc", "a\nc") == TextEdits{{{2, 4}, ""}}));
        QVERIFY((editsBetween("a\nb", "a\nb\n") == TextEdits{{{3, 3}, "\n"}}));
        // Two places of a long text are two edits.
        std::string text;
        for (int i = 0; i < 10'000; ++i) {
            text += "line " + std::to_string(i) + "\n";
        }
        std::string other = text;
        other.replace(other.find("line 9000"), 4, "LINE");
        other.replace(other.find("line 10\n"), 4, "LINE");
        QCOMPARE(editsBetween(text, other).size(), std::size_t(2));
    }

    /// The cost is bounded: 100,000 lines, all of them others.
    void veryDifferentTextsAreOneChange()
    {
        std::string before = "same\n";
        std::string after = "same\n";
        for (int i = 0; i < 100'000; ++i) {
            before += "before " + std::to_string(i) + "\n";
            after += "after " + std::to_string(i) + "\n";
        }
        const auto start = std::chrono::steady_clock::now();
        const std::vector<LineChange> changes = lineChanges(linesOf(before), linesOf(after));
        QVERIFY((changes == std::vector<LineChange>{{1, 100'001, 1, 100'001}}));
        QCOMPARE(applied(before, editsBetween(before, after)), after);
        // Twice; a search without bounds takes 4e10 steps.
        QVERIFY(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
    }

    void twoThousandDifferencesAreStillFound()
    {
        const auto textOf = [](int differences) {
            std::string text;
            for (int i = 0; i < 4'000; ++i) {
                text += (i % 2 == 0 && i / 2 < differences ? "other " : "line ") + std::to_string(i) + "\n";
            }
            return text;
        };
        const std::string before = textOf(0);
        const std::string few = textOf(1'000);
        const std::string many = textOf(1'001);
        QCOMPARE(lineChanges(linesOf(before), linesOf(few)).size(), std::size_t(1'000));
        QCOMPARE(lineChanges(linesOf(before), linesOf(many)).size(), std::size_t(1));
    }
};

ROMANESCO_TEST(TestLineDiff)

#include "testlinediff.moc"
