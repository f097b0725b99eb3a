// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "plotlayout.h"

#include <algorithm>
#include <cmath>
#include <format>

#include "words.h"

namespace romanesco {

namespace {

using Place = LabelRoom::Place;

bool overlap(const Place &a, const Place &b)
{
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool isIn(const Place &all, const Place &place)
{
    return place.x >= all.x && place.y >= all.y && place.x + place.width <= all.x + all.width
        && place.y + place.height <= all.y + all.height;
}

}

double Decades::shareOf(double value) const
{
    return (std::log10(value) - first) / (last - first);
}

Decades decadesOf(std::vector<double> values)
{
    std::erase(values, 0.0);
    if (values.empty()) {
        return {-1, 0};
    }
    const auto [least, greatest] = std::ranges::minmax(values);
    Decades decades{static_cast<int>(std::floor(std::log10(least))), static_cast<int>(std::ceil(std::log10(greatest)))};
    decades.last = std::max(decades.last, decades.first + 1);
    return decades;
}

std::string decadeText(int exponent)
{
    return exponent >= -3 && exponent <= 4 ? briefly(std::pow(10.0, exponent)) : std::format("1e{}", exponent);
}

/// Right, left, above, below, and by the corners.
std::optional<Place> LabelRoom::besidePoint(double x, double y, double width, double height)
{
    const double right = x + 6.0;
    const double left = x - 6.0 - width;
    const double centred = x - 0.5 * width;
    const double level = y - 0.5 * height + 1.0;
    const double above = y - height - 6.0;
    for (const auto &[fromX, fromY] : {std::pair{right, level},
                                       {left, level},
                                       {centred, above},
                                       {centred, y + 9.0},
                                       {right, above},
                                       {right, y + 8.0},
                                       {left, above},
                                       {left, y + 8.0}}) {
        const Place place{fromX, fromY, width, height};
        if (isIn(m_all, place)
            && std::ranges::none_of(m_taken, [&](const Place &other) { return overlap(place, other); })) {
            m_taken.push_back(place);
            return place;
        }
    }
    return std::nullopt;
}

}
