// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "tint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace romanesco {

namespace {

constexpr Tint accent{61, 142, 255, 166};
constexpr Tint second{255, 176, 59, 140};

std::uint8_t asByte(double linear)
{
    const double held = std::clamp(linear, 0.0, 1.0);
    const double srgb = held <= 0.0031308 ? 12.92 * held : 1.055 * std::pow(held, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * srgb));
}

/// Of equal lightness and strength in Oklab (Ottosson 2020), by a hue in turns.
Tint hue(double turns)
{
    constexpr double lightness = 0.74;
    constexpr double chroma = 0.125;
    const double a = chroma * std::cos(2.0 * std::numbers::pi * turns);
    const double b = chroma * std::sin(2.0 * std::numbers::pi * turns);
    const auto cubed = [](double x) { return x * x * x; };
    const double l = cubed(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cubed(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cubed(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {asByte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            asByte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            asByte(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), 255};
}

/// Numbers that follow one another get hues that lie far apart.
Tint distinct(std::uint32_t number)
{
    constexpr double golden = 0.6180339887498949;
    const double turns = 0.16 + golden * number;
    return hue(turns - std::floor(turns));
}

/// Levels that follow one another get hues that do, twelve to a turn.
Tint gradual(std::uint32_t number)
{
    return hue(0.1 + (number % 12) / 12.0);
}

Tint over(const Tint &top, const Tint &below)
{
    if (below[3] == 0) {
        return top;
    }
    Tint mixed{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i) {
        mixed[i] = static_cast<std::uint8_t>((top[i] * top[3] + below[i] * (255 - top[3])) / 255);
    }
    return mixed;
}

}

Tinter::Tinter(const FractalGraph &graph, const CopyColours &colours, std::size_t item, std::span<const Step> path)
    : m_colouring(colours.colouring)
    , m_hasSelection(colours.selection && colours.selection->item == item)
    , m_graph(&graph)
{
    if (m_hasSelection) {
        for (const Step &step : colours.selection->steps) {
            m_selected.push_back(graph.mapClasses(step.set)[step.map]);
        }
    }
    if (colours.map && colours.map->item == item) {
        m_map = colours.map->map;
        m_map->map = graph.mapClasses(m_map->set)[m_map->map];
    }
    if (isNeeded()) {
        m_along.push_back(atRoot());
        for (const Step &step : path) {
            m_along.push_back(marksBelow(m_along.back(), step.set, step.map));
        }
    }
}

Marks Tinter::at(const Surroundings::Node &node) const
{
    if (!isNeeded()) {
        return {};
    }
    Marks marks = m_along[node.sharedSteps];
    for (const Step &step : node.steps) {
        marks = marksBelow(marks, step.set, step.map);
    }
    return marks;
}

Marks Tinter::atRoot() const
{
    Marks marks;
    if (m_colouring == Colouring::Depth) {
        marks.tint = gradual(0);
    }
    return marks;
}

void Tinter::markBranch(Marks &below, const Marks &above, SetId set, std::uint32_t map) const
{
    const bool isFirst = above.picks == 0;
    if (isFirst || above.chain == set) {
        below.tint = distinct(isFirst ? map : above.picks);
        below.chain = m_graph->set(set).maps.size() == 1 ? set : Marks::noChain;
    } else {
        below.chain = Marks::noChain;
    }
}

Marks Tinter::marksBelow(const Marks &marks, SetId set, std::uint32_t map) const
{
    Marks below = marks;
    ++below.picks;
    switch (m_colouring) {
    case Colouring::Materials:
        break;
    case Colouring::Depth:
        below.tint = gradual(below.picks);
        break;
    case Colouring::Branch:
        markBranch(below, marks, set, map);
        break;
    case Colouring::Set:
        below.tint = distinct(set);
        break;
    }
    if (marks.matched < m_selected.size()) {
        const bool isNext = m_graph->mapClasses(set)[map] == m_selected[marks.matched];
        below.matched = isNext ? marks.matched + 1 : Marks::strayed;
    }
    below.hasMap = marks.hasMap || (m_map && m_map->set == set && m_graph->mapClasses(set)[map] == m_map->map);
    return below;
}

Tint Tinter::tint(const Marks &marks) const
{
    const bool isSelected = m_hasSelection && marks.matched == m_selected.size();
    const Tint own = marks.hasMap ? over(second, marks.tint) : marks.tint;
    return isSelected ? over(accent, own) : own;
}

}
