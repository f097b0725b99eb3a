// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tests/fuzz/target.h"

namespace {

/// Left behind by a crash; two programs may run at once in one folder.
std::string lastInput;

void run(const std::string &text)
{
    std::ofstream(lastInput, std::ios::binary) << text;
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(text.data()), text.size());
}

/// A few small slips, as people and broken disks make them: at random places a byte, a word of the grammar, a piece of
/// the text again, or a piece less.
std::string mutated(std::string text, std::mt19937_64 &random)
{
    static constexpr const char *words[] = {"#",
                                            "[",
                                            "]",
                                            "(",
                                            ")",
                                            "<",
                                            ">",
                                            "<$>",
                                            ".",
                                            ",",
                                            "\"",
                                            " ",
                                            "\n",
                                            "\r",
                                            "v ",
                                            "f ",
                                            "0",
                                            "1",
                                            "-1",
                                            "9223372036854775807",
                                            "18446744073709551616",
                                            "1e308",
                                            "1e-320",
                                            "nan",
                                            "z 6",
                                            "\\\n",
                                            "\xEF\xBB\xBF",
                                            "\xFF",
                                            "/",
                                            "[#] ",
                                            "x. "};
    const std::uint64_t slips = random() % 6 + 1;
    for (std::uint64_t i = 0; i < slips; ++i) {
        const std::size_t at = random() % (text.size() + 1);
        const std::size_t length = random() % 40;
        switch (random() % 5) {
        case 0:
            text.insert(at, words[random() % std::size(words)]);
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(random() % (text.size() + 1), length));
            break;
        case 3:
            text.insert(at, 1, static_cast<char>(random()));
            break;
        default:
            if (at < text.size()) {
                text[at] = static_cast<char>(random());
            }
        }
    }
    return text;
}

}

/// fuzz_NAME MUTATIONS FILE…   each file as it is, then mutated as often; 0 mutations replay a fuzzer's finds.
int main(int argc, char **argv)
{
    const int mutations = argc > 1 ? std::atoi(argv[1]) : 0;
    lastInput = std::string(argv[0]) + ".last";
    run("");
    for (int i = 2; i < argc; ++i) {
        std::ifstream file(argv[i], std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        if (!file) {
            std::fprintf(stderr, "cannot read %s\n", argv[i]);
            return 1;
        }
        run(text);
        std::mt19937_64 random(static_cast<std::uint64_t>(i));
        for (int j = 0; j < mutations; ++j) {
            run(mutated(text, random));
        }
    }
    std::remove(lastInput.c_str());
    return 0;
}
