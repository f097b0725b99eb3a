// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <QTest>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/formats/objreader.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using boost::multiprecision::cpp_int;
using Random = std::mt19937_64;

std::size_t between(Random &random, std::size_t least, std::size_t most)
{
    return least + random() % (most - least + 1);
}

std::string digits(Random &random, std::size_t count)
{
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += static_cast<char>('0' + random() % 10);
    }
    return text;
}

std::string sign(Random &random)
{
    static constexpr const char *signs[] = {"", "", "-", "+"};
    return signs[random() % 4];
}

/// So many digits in all, the point anywhere among them or nowhere.
std::string fixed(Random &random, std::size_t least, std::size_t most)
{
    std::string text = digits(random, between(random, least, most));
    if (random() % 8 != 0) {
        text.insert(random() % (text.size() + 1), 1, '.');
    }
    return sign(random) + text;
}

/// n/2^k, exactly, as n*5^k with k decimals; offset is added to the digit behind the last.
std::string exactly(const cpp_int &n, unsigned k, int offset)
{
    const cpp_int scaled = n * boost::multiprecision::pow(cpp_int(5), k) * 10 + offset;
    std::string text = scaled.str();
    if (text.size() < k + 2) {
        text.insert(0, k + 2 - text.size(), '0');
    }
    text.insert(text.size() - k - 1, 1, '.');
    return text;
}

/// What lies in the middle of two doubles, or next to it.
std::string halfway(Random &random)
{
    const cpp_int odd = ((cpp_int(1) << 52) + (random() >> 12)) * 2 + 1;
    const auto k = static_cast<unsigned>(random() % 300);
    const int offset = static_cast<int>(random() % 3) - 1;
    return random() % 4 == 0 ? exactly(odd << (k % 100), 0, offset) : exactly(odd, k, offset);
}

std::string printed(const char *format, double value)
{
    std::string text(1'200, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, value)));
    return text;
}

struct Kind {
    const char *name;
    std::string (*make)(Random &random);
};
constexpr Kind kinds[] = {
    {"six decimals",
     [](Random &random) { return sign(random) + digits(random, between(random, 1, 4)) + '.' + digits(random, 6); }},
    {"1 to 8 digits", [](Random &random) { return fixed(random, 1, 8); }},
    {"8 to 18 digits", [](Random &random) { return fixed(random, 8, 18); }},
    {"14 to 17 digits", [](Random &random) { return fixed(random, 14, 17); }},
    {"7 to 9 digits on both sides of the point",
     [](Random &random) {
         return digits(random, between(random, 7, 9)) + '.' + digits(random, between(random, 7, 9));
     }},
    {"19 to 40 digits", [](Random &random) { return fixed(random, 19, 40); }},
    {"hundreds of digits",
     [](Random &random) { return digits(random, random() % 300) + '.' + digits(random, between(random, 300, 600)); }},
    {"leading zeros",
     [](Random &random) { return "000000000" + digits(random, 3) + ".00000000000" + digits(random, 8); }},
    {"17 digits of any double",
     [](Random &random) {
         const auto value = std::bit_cast<double>(random());
         return printed("%.17g", std::isfinite(value) ? value : 1.0);
     }},
    {"exponents",
     [](Random &random) {
         return fixed(random, 1, 20) + (random() % 2 == 0 ? "e" : "E") + sign(random) + std::to_string(random() % 280);
     }},
    {"small exponents",
     [](Random &random) { return fixed(random, 1, 17) + "e-" + std::to_string(280 + random() % 80); }},
    {"subnormal",
     [](Random &random) {
         const auto value = std::bit_cast<double>((random() >> 12) >> (random() % 52));
         return printed(random() % 2 == 0 ? "%.17g" : "%.40e", value);
     }},
    {"all digits of a small double",
     [](Random &random) { return printed("%.1100f", std::bit_cast<double>(random() >> (random() % 12 + 2))); }},
    {"halfway between doubles", halfway},
};

}

/// The doubles that the OBJ reader makes, bit by bit against those of the C library, which rounds correctly too.
class TestObjNumbers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anySpellingIsCorrectlyRounded_data();
    void anySpellingIsCorrectlyRounded();
    void anyWhereItEnds();
};

void TestObjNumbers::anySpellingIsCorrectlyRounded_data()
{
    QTest::addColumn<int>("kind");
    for (int i = 0; i < static_cast<int>(std::size(kinds)); ++i) {
        QTest::newRow(kinds[i].name) << i;
    }
}

void TestObjNumbers::anySpellingIsCorrectlyRounded()
{
    QFETCH(int, kind);
    Random random(20250607);
    std::vector<std::string> words;
    std::string text;
    for (int i = 0; i < 30'000; ++i) {
        std::string word = kinds[kind].make(random);
        if (word.find_first_of("0123456789") == word.npos) {
            word = "0";
        }
        text += (i % 3 == 0 ? "v " : " ") + word + (i % 3 == 2 ? "\n" : "");
        words.push_back(std::move(word));
    }
    const Mesh mesh = readObj(text).mesh;
    QCOMPARE(mesh.vertices.size(), words.size() / 3);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const double read = mesh.vertices[i / 3][static_cast<int>(i % 3)];
        const double expected = std::strtod(words[i].c_str(), nullptr);
        if (expected == 0 && read == 0 && words[i].find_first_of("123456789") != words[i].npos) {
            continue; // too small, whatever its sign
        }
        QVERIFY2(std::bit_cast<std::uint64_t>(read) == std::bit_cast<std::uint64_t>(expected), words[i].c_str());
    }
}

/// Eight bytes are looked at at once, but for the last of a text.
void TestObjNumbers::anyWhereItEnds()
{
    Random random(7);
    for (int i = 0; i < 20'000; ++i) {
        const std::string number = "1" + fixed(random, 1, 17);
        if (number.find_first_of("+-") != number.npos) {
            continue;
        }
        static constexpr const char *ends[] = {"", "\n", "\r\n", " ", " 1", " # 1", "\t\t\t\t", "\nv 1 2 3\n"};
        const std::string text = "v 0 0 " + number + ends[random() % std::size(ends)];
        // so that a sanitizer sees what is read behind it
        const std::vector<char> bytes(text.begin(), text.end());
        const Mesh mesh = readObj({bytes.data(), bytes.size()}).mesh;
        QVERIFY2(!mesh.vertices.empty(), text.c_str());
        QVERIFY2(mesh.vertices[0].z == std::strtod(number.c_str(), nullptr), text.c_str());
    }
}

}

ROMANESCO_TEST(romanesco::test::TestObjNumbers)

#include "testobjnumbers.moc"
