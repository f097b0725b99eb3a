// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <vector>

namespace romanesco {

using SetId = std::uint32_t;

/// Counts levels and names places between them: position p is the place before level p. Below 2^64 - 1.
using Position = std::uint64_t;

/// The levels of a fractal, outermost first, as the text gives them: a run of slots, some of it in repeats. `z 6`
/// round two sets is two slots and one repeat, not twelve levels; a depth of 10^18 takes no more. Repeats nest as
/// recursives do. Nested repeats of one pass, or of up to 64 levels, are written out; each of those left at least doubles
/// the levels, so that repeats nest at most 64 deep.
///
/// A *slot* is a place in that structure, with its set; a *position* is a place in the written-out sequence.
/// Immutable once built; thread-safe.
class LevelSequence
{
public:
    using Slot = std::uint32_t;

    /// Slots [firstSlot, endSlot) of one pass, passed through count times. Repeat 0 is the whole sequence, once.
    struct Repeat {
        Slot firstSlot = 0;
        Slot endSlot = 0;
        std::uint64_t count = 1;
        /// Levels of one pass.
        Position passLength = 0;
        /// Where it starts in a pass of its parent.
        Position offset = 0;
        std::uint32_t parent = 0;
        /// Inner repeats in order.
        std::vector<std::uint32_t> inner;

        [[nodiscard]] Position length() const { return passLength * count; }
    };

    class Builder;

    [[nodiscard]] Position levelCount() const { return m_repeats[0].passLength; }
    [[nodiscard]] std::uint32_t slotCount() const { return static_cast<std::uint32_t>(m_slots.size()); }
    [[nodiscard]] SetId set(Slot slot) const { return m_slots[slot]; }
    [[nodiscard]] const std::vector<Repeat> &repeats() const { return m_repeats; }

    struct Location {
        Slot slot;
        /// The innermost repeat round it, and where the whole run of that repeat ends.
        std::uint32_t repeat;
        Position end;
    };

    /// What stands at a position below levelCount(). Costs a binary search for each repeat round it.
    [[nodiscard]] Location locate(Position position) const;

    /// The slots that can follow a slot, over all passes; slotCount() stands for the end of the sequence.
    [[nodiscard]] const std::vector<Slot> &successors(Slot slot) const { return m_successors[slot]; }

private:
    std::vector<SetId> m_slots;
    std::vector<Repeat> m_repeats{Repeat{}};
    std::vector<std::vector<Slot>> m_successors;
};

/// Makes a sequence from the outermost level inwards.
class LevelSequence::Builder
{
public:
    void addLevel(SetId set);
    void beginRepeat(std::uint64_t count);
    void endRepeat();

    /// Precondition: every repeat has ended, and the levels are fewer than 2^64 - 1.
    [[nodiscard]] LevelSequence build() &&;

private:
    LevelSequence m_sequence;
    std::uint32_t m_current = 0;
    /// For each repeat that has begun, whether it has an entry of its own.
    std::vector<bool> m_begun;
};

}
