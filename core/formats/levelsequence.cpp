// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "levelsequence.h"

#include <algorithm>
#include <cassert>

namespace romanesco {

namespace {

constexpr std::uint64_t writtenOutLimit = 64;

}

LevelSequence::Location LevelSequence::locate(Position position) const
{
    assert(position < levelCount() && "no level stands at the end of the sequence");
    std::uint32_t at = 0;
    Position start = 0;
    while (true) {
        const Repeat &repeat = m_repeats[at];
        const Position inPass = (position - start) % repeat.passLength;
        const Position passStart = position - inPass;

        // The last inner repeat that starts at or before the position.
        const auto after = std::ranges::upper_bound(repeat.inner, inPass, {},
                                                    [&](std::uint32_t inner) { return m_repeats[inner].offset; });
        if (after == repeat.inner.begin()) {
            return {static_cast<Slot>(repeat.firstSlot + inPass), at, start + repeat.length()};
        }
        const Repeat &inner = m_repeats[*(after - 1)];
        const Position innerEnd = inner.offset + inner.length();
        if (inPass >= innerEnd) {
            return {static_cast<Slot>(inner.endSlot + (inPass - innerEnd)), at, start + repeat.length()};
        }
        at = *(after - 1);
        start = passStart + inner.offset;
    }
}

void LevelSequence::Builder::addLevel(SetId set)
{
    m_sequence.m_slots.push_back(set);
    ++m_sequence.m_repeats[m_current].passLength;
}

void LevelSequence::Builder::beginRepeat(std::uint64_t count)
{
    const bool isPlain = m_current != 0 && count == 1;
    m_begun.push_back(!isPlain);
    if (isPlain) {
        return;
    }
    const auto index = static_cast<std::uint32_t>(m_sequence.m_repeats.size());
    Repeat repeat;
    repeat.firstSlot = m_sequence.slotCount();
    repeat.count = count;
    repeat.offset = m_sequence.m_repeats[m_current].passLength;
    repeat.parent = m_current;
    m_sequence.m_repeats.push_back(repeat);
    m_current = index;
}

void LevelSequence::Builder::endRepeat()
{
    assert(!m_begun.empty() && "a repeat ends that did not begin");
    const bool hasEntry = m_begun.back();
    m_begun.pop_back();
    if (!hasEntry) {
        return;
    }
    const std::uint32_t index = m_current;
    Repeat &repeat = m_sequence.m_repeats[index];
    repeat.endSlot = m_sequence.slotCount();
    m_current = repeat.parent;
    Repeat &parent = m_sequence.m_repeats[m_current];

    const Position length = repeat.length();
    parent.passLength += length;
    const bool isLast = index + 1 == m_sequence.m_repeats.size();
    const bool isWrittenOut = m_current != 0 && repeat.inner.empty() && isLast && length <= writtenOutLimit;
    if (length == 0) {
        // Passes without levels, or none: what was added of them goes again.
        m_sequence.m_slots.resize(repeat.firstSlot);
        m_sequence.m_repeats.resize(index);
    } else if (isWrittenOut) {
        const std::vector<SetId> pass(m_sequence.m_slots.begin() + repeat.firstSlot, m_sequence.m_slots.end());
        for (std::uint64_t i = 1; i < repeat.count; ++i) {
            m_sequence.m_slots.insert(m_sequence.m_slots.end(), pass.begin(), pass.end());
        }
        m_sequence.m_repeats.pop_back();
    } else {
        parent.inner.push_back(index);
    }
}

LevelSequence LevelSequence::Builder::build() &&
{
    assert(m_begun.empty() && "every repeat has ended");
    m_sequence.m_repeats[0].endSlot = m_sequence.slotCount();

    // After a slot comes the next one, and where repeats end there, also the first slot of each of them.
    m_sequence.m_successors.resize(m_sequence.slotCount());
    for (Slot slot = 0; slot < m_sequence.slotCount(); ++slot) {
        m_sequence.m_successors[slot].push_back(slot + 1);
    }
    for (std::size_t i = 1; i < m_sequence.m_repeats.size(); ++i) {
        const Repeat &repeat = m_sequence.m_repeats[i];
        if (repeat.count > 1) {
            m_sequence.m_successors[repeat.endSlot - 1].push_back(repeat.firstSlot);
        }
    }
    return std::move(m_sequence);
}

}
