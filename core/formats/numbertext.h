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
/// significant ones as wanted. The coordinates of a fractal often come again and again, so the last texts are kept.
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
        // Where numbers do not come again, looking for them would be in vain.
        if (++m_count % period == trial) {
            m_isLooking = m_found > trial / 2;
        } else if (m_count % period == 0) {
            m_found = 0;
            m_isLooking = true;
        }
        return m_isLooking ? writeKnown(to, value) : writeNew(to, value);
    }

private:
    static constexpr int knownBits = 8;
    /// Of so many numbers the first ones tell whether the rest are looked for.
    static constexpr unsigned period = 4'096;
    static constexpr unsigned trial = 256;

    struct Known {
        std::uint64_t bits = 0;
        std::uint64_t size = 0;
        std::array<char, mostBytes> text{};
    };

    char *writeKnown(char *to, double value)
    {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        // Fibonacci hashing: of many coordinates the low bits are alike, and the high bits too.
        Known &known = m_known[(bits * 0x9E3779B97F4A7C15u) >> (64 - knownBits)];
        if (known.bits == bits && known.size != 0) {
            ++m_found;
        } else {
            known.bits = bits;
            known.size = static_cast<std::uint64_t>(writeNew(known.text.data(), value) - known.text.data());
        }
        std::memcpy(to, known.text.data(), mostBytes);
        return to + known.size;
    }

    char *writeNew(char *to, double value) const
    {
        return m_digits ? std::to_chars(to, to + mostBytes, value, std::chars_format::general, *m_digits).ptr
                        : std::to_chars(to, to + mostBytes, value).ptr;
    }

    std::optional<int> m_digits;
    unsigned m_count = 0;
    unsigned m_found = 0;
    bool m_isLooking = true;
    std::array<Known, std::size_t{1} << knownBits> m_known{};
};

}
