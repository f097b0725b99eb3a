// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace romanesco {

/// Writes numbers as text, whatever the locale: the shortest digits that read back as the same number, or as many
/// significant ones as wanted. The coordinates of a fractal come again and again, so the last texts are kept.
class NumberText
{
public:
    /// What write() may touch.
    static constexpr std::size_t mostBytes = 24;
    /// No more digits than these differ.
    static constexpr int mostDigits = 17;

    /// digits: from 1 to mostDigits; none for the shortest.
    explicit NumberText(std::optional<int> digits = std::nullopt)
        : m_digits(digits)
    {
    }

    /// A finite number; gives the end of its text.
    char *write(char *to, double value)
    {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        // Of Fibonacci hashing; the low bits of many coordinates are alike, the high bits too.
        Known &known = m_known[(bits * 0x9E3779B97F4A7C15u) >> (64 - knownBits)];
        if (known.bits != bits || known.size == 0) {
            known.bits = bits;
            known.size = static_cast<std::uint64_t>(newText(known.text.data(), value) - known.text.data());
        }
        std::memcpy(to, known.text.data(), mostBytes);
        return to + known.size;
    }

private:
    static constexpr int knownBits = 8;

    struct Known {
        std::uint64_t bits = 0;
        std::uint64_t size = 0;
        std::array<char, mostBytes> text{};
    };

    char *newText(char *to, double value) const
    {
        return m_digits ? std::to_chars(to, to + mostBytes, value, std::chars_format::general, *m_digits).ptr
                        : std::to_chars(to, to + mostBytes, value).ptr;
    }

    std::optional<int> m_digits;
    std::array<Known, std::size_t{1} << knownBits> m_known{};
};

}
