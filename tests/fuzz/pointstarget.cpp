// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <string>

#include "core/formats/pointline.h"
#include "core/text/unicode.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr double farthest = 1e140;

/// The C library reads the same numbers, and nothing is left.
void requireRead(const glm::dvec3 &point, const std::string &line)
{
    const char *at = line.c_str();
    for (int i = 0; i < 3; ++i) {
        char *end = nullptr;
        require(std::strtod(at, &end) == point[i] && end != at);
        require(std::abs(point[i]) <= farthest);
        at = end;
    }
    require(line.find_first_not_of(blanks, static_cast<std::size_t>(at - line.c_str())) == std::string::npos);
}

/// It is in the line or at its end, and can be shown anywhere.
void requireSound(const PointSlip &slip, std::string_view line)
{
    require(slip.column >= 1 && slip.column <= codePointCount(line) + 1);
    require(!slip.words.empty() && slip.words.size() < 150);
    for (std::string_view left = slip.words; !left.empty();) {
        const CodePoint next = firstCodePoint(left);
        require(next.isValid && next.value >= U' ' && (next.value < 0x7F || next.value > 0x9F));
        left.remove_prefix(next.length);
    }
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    std::string_view left(reinterpret_cast<const char *>(data), size);
    while (!left.empty()) {
        const std::string_view line = left.substr(0, left.find('\n'));
        left.remove_prefix(std::min(line.size() + 1, left.size()));
        const auto point = pointOf(line, farthest);
        if (!point) {
            requireSound(point.error(), line);
        } else if (*point) {
            requireRead(**point, std::string(line));
        } else {
            require(line.find_first_not_of(blanks) == std::string_view::npos);
        }
    }
    return 0;
}
