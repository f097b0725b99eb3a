// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What a plot looks like, whoever draws it.
namespace romanesco {

/// Of groups. Told apart by those who do not see all colours, too (Okabe and Ito 2008).
inline constexpr std::array plotColours{"#0072b2", "#56b4e9", "#d55e00", "#cc79a7", "#009e73", "#e69f00"};

/// From one power of ten to another, of which an axis by logarithms is made.
struct Decades {
    int first = 0;
    int last = 1;

    /// From 0 to 1. Of a value above 0.
    [[nodiscard]] double shareOf(double value) const;
    /// From one that has a number to the next, where so many have room.
    [[nodiscard]] int step(int most) const { return (last - first) / most + 1; }
};

/// Those round all values above 0.
[[nodiscard]] Decades decadesOf(std::vector<double> values);

/// "0.01", "100", "1e-6".
[[nodiscard]] std::string decadeText(int exponent);

/// Finds room for labels beside points. In pixels, down from above.
class LabelRoom
{
public:
    struct Place {
        double x = 0.0;
        double y = 0.0;
        double width = 0.0;
        double height = 0.0;
    };

    /// Where labels may be.
    explicit LabelRoom(const Place &all)
        : m_all(all)
    {
    }

    /// What labels keep off.
    void take(const Place &place) { m_taken.push_back(place); }
    /// For a label so large, which is taken; nothing where none is free.
    [[nodiscard]] std::optional<Place> besidePoint(double x, double y, double width, double height);

private:
    Place m_all;
    std::vector<Place> m_taken;
};

}
