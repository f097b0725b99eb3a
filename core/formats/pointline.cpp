// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "pointline.h"

#include <cmath>
#include <format>

#include "core/text/unicode.h"
#include "numbers.h"

namespace romanesco {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t mostQuoted = 40;

/// A word as it can be shown: its beginning, what is not text replaced.
std::string quoted(std::string_view word)
{
    std::string shown;
    while (!word.empty() && shown.size() < mostQuoted) {
        const CodePoint next = firstCodePoint(word);
        const bool isText = next.isValid && next.value >= U' ' && (next.value < 0x7F || next.value > 0x9F);
        shown += isText ? word.substr(0, next.length) : "?";
        word.remove_prefix(next.length);
    }
    return std::format("\"{}{}\"", shown, word.empty() ? "" : "...");
}

std::expected<double, std::string> coordinateOf(std::string_view word, double farthest)
{
    const ParsedNumber number = numberFromText(word);
    if (number.status == NumberStatus::Malformed) {
        return std::unexpected(std::format("{} is no number; a point is three of them, x y z", quoted(word)));
    }
    if (number.status == NumberStatus::Overflow || std::abs(number.value) > farthest) {
        return std::unexpected(std::format("{} is too far away (at most {:g} in size)", quoted(word), farthest));
    }
    return number.value;
}

}

std::expected<std::optional<glm::dvec3>, PointSlip> pointOf(std::string_view line, double farthest)
{
    glm::dvec3 point(0.0);
    int count = 0;
    std::size_t at = line.find_first_not_of(blanks);
    while (at != std::string_view::npos) {
        const std::string_view word = line.substr(at, line.find_first_of(blanks, at) - at);
        const auto slip = [&](std::string words) {
            return std::unexpected(PointSlip{codePointCount(line.substr(0, at)) + 1, std::move(words)});
        };
        if (count == 3) {
            return slip(std::format("{} is a fourth; a point is three numbers, x y z", quoted(word)));
        }
        const auto coordinate = coordinateOf(word, farthest);
        if (!coordinate) {
            return slip(coordinate.error());
        }
        point[count++] = *coordinate;
        at = line.find_first_not_of(blanks, at + word.size());
    }
    if (count == 1 || count == 2) {
        const std::size_t end = line.find_last_not_of(blanks) + 1;
        return std::unexpected(PointSlip{
            codePointCount(line.substr(0, end)) + 1,
            std::format("a point is three numbers, x y z; here {} missing", count == 1 ? "two are" : "one is")});
    }
    return count == 3 ? std::optional(point) : std::nullopt;
}

}
