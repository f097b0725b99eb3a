// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "address.h"
#include "statetable.h"

namespace romanesco {

/// Goes through the copies of the base mesh: each canonical word once, a copy before those below it and else in the
/// order of the text.
///
///     CopyWalk copies(graph);
///     while (copies.next()) {
///         use(copies.modelFromBase());
///     }
///
/// Takes some megabytes at most, however many levels and copies there are, unless addresses are kept. Cost: a product of
/// maps for each copy, and a fraction of a microsecond for each state that is met anew; the first copy of a fractal of n levels
/// without `#` is n products away. One thread uses it; the graph must outlive it.
class CopyWalk
{
public:
    enum class Addresses { Drop, Keep };

    /// With Addresses::Keep, address() can be asked; that takes 16 bytes for each level of the deepest copy, and where
    /// sets share maps more, and time for each level of each copy.
    explicit CopyWalk(const FractalGraph &graph, Addresses addresses = Addresses::Drop, std::stop_token stop = {});

    /// On to the next copy, at first to the first. False after the last, and as soon as a stop has been asked for.
    [[nodiscard]] bool next();

    /// Where the copy stands: the product of its picks, outermost on the left.
    [[nodiscard]] const AffineMap &modelFromBase() const { return m_copy.map; }

    /// The picks of the copy, outermost first, until next() is called: one of the ways to place them, always the same.
    /// Only with Addresses::Keep.
    [[nodiscard]] std::span<const Pick> address() const;

    /// Bytes held, for the record.
    [[nodiscard]] std::size_t memoryUse() const;

private:
    /// A state and one of the ways to it.
    struct Place {
        StateId state = 0;
        AffineMap map;
        /// Picks made so far.
        Position length = 0;
    };
    /// A child of a state.
    struct Child {
        std::uint32_t range = 0;
        std::uint32_t map = 0;
        bool operator==(const Child &) const = default;
    };
    /// A place above the copy that has children left. Where the last child was taken, nothing is kept.
    struct Fork {
        Place place;
        Child next;
    };
    /// Forks without their maps: each `gap` picks after the child taken at the one before.
    struct Turn {
        Position gap;
        Child next;
        std::uint32_t repeats;
    };
    /// A run of forks far above the copy, from which they can be made again.
    struct Folded {
        Positions firstState;
        AffineMap firstMap;
        Position firstLength;
        std::vector<Turn> turns;
    };

    [[nodiscard]] Place takeChild();
    void keepPick(const Fork &fork, StateId next);
    [[nodiscard]] bool enter(Place place);
    [[nodiscard]] Place below(const Place &place, const Child &child);
    [[nodiscard]] Child lastChild(StateId state);
    [[nodiscard]] Child childBefore(StateId state, const Child &child);
    void fold();
    [[nodiscard]] bool unfold();
    void limitMemory(Place &current);

    StateTable m_table;
    Addresses m_addresses;
    std::stop_token m_stop;
    Place m_copy;
    bool m_hasBegun = false;
    std::vector<Fork> m_forks;
    std::vector<Folded> m_folded;
    std::vector<Pick> m_picks;
    /// Where sets share maps: beside the picks, the positions that each may lead to.
    std::vector<Positions> m_reached;
    std::size_t m_mostTableBytes;
};

}
