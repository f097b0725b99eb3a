// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "appearance.h"
#include "core/scene/anchor.h"

namespace romanesco {

/// A colour that lies over a copy's own: red, green, blue in sRGB, and how much of it there is.
using Tint = std::array<std::uint8_t, 4>;

/// What a node of the walk knows of the way to it.
struct Marks {
    /// By the colouring.
    Tint tint{};
    std::uint32_t picks = 0;
    /// All picks so far are of this set, which has but one map; or `noChain`.
    SetId chain = noChain;
    /// As many of the selected steps lead here, or `strayed`.
    std::uint32_t matched = 0;
    /// The map that stands out is among the picks.
    bool hasMap = false;

    static constexpr std::uint32_t strayed = 0xffffffff;
    static constexpr SetId noChain = 0xffffffff;
};

/// Colours the copies of a graph.
class Tinter
{
public:
    Tinter() = default;
    /// What stands out of an item. graph must outlive it. path: what nodes share (see Surroundings).
    Tinter(const FractalGraph &graph, const CopyColours &colours, std::size_t item, std::span<const Step> path);

    /// Whether any copy has a tint.
    [[nodiscard]] bool isNeeded() const { return m_colouring != Colouring::Materials || m_hasSelection || m_map; }

    [[nodiscard]] Marks at(const Surroundings::Node &node) const;
    /// Of the child that a map of a set leads to.
    [[nodiscard]] Marks below(const Marks &marks, SetId set, std::uint32_t map) const
    {
        return isNeeded() ? marksBelow(marks, set, map) : marks;
    }
    [[nodiscard]] Tint tint(const Marks &marks) const;

private:
    void markBranch(Marks &below, const Marks &above, SetId set, std::uint32_t map) const;
    [[nodiscard]] Marks atRoot() const;
    [[nodiscard]] Marks marksBelow(const Marks &marks, SetId set, std::uint32_t map) const;

    Colouring m_colouring = Colouring::Materials;
    bool m_hasSelection = false;
    const FractalGraph *m_graph = nullptr;
    /// The classes of the maps: from a state, equal maps lead to equal copies.
    std::vector<std::uint32_t> m_selected;
    /// Its set, and its class.
    std::optional<Step> m_map;
    /// After each step of the path.
    std::vector<Marks> m_along;
};

}
