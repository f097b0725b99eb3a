// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "levelruns.h"

#include <algorithm>
#include <cassert>

namespace romanesco {

namespace {

using Repeat = LevelSequence::Repeat;

/// A repeat and the position where its passes begin.
struct Round {
    std::uint32_t repeat;
    Position begin;
};

/// The repeats round a position, outermost first.
std::vector<Round> roundsAt(const LevelSequence &levels, Position position)
{
    const std::vector<Repeat> &repeats = levels.repeats();
    std::vector<Round> rounds{{0, 0}};
    while (true) {
        const auto [at, begin] = rounds.back();
        const Position inPass = (position - begin) % repeats[at].passLength;
        const auto after = std::ranges::upper_bound(repeats[at].inner, inPass, {},
                                                    [&](std::uint32_t inner) { return repeats[inner].offset; });
        if (after == repeats[at].inner.begin()) {
            return rounds;
        }
        const std::uint32_t inner = *(after - 1);
        if (inPass >= repeats[inner].offset + repeats[inner].length()) {
            return rounds;
        }
        rounds.push_back({inner, position - inPass + repeats[inner].offset});
    }
}

/// What of one pass of a repeat begins at or after a place in it.
void addRestOfPass(const LevelSequence &levels, const Repeat &repeat, Position inPass, std::vector<LevelRun> &runs)
{
    LevelSequence::Slot slot = repeat.firstSlot;
    Position at = 0;
    const auto addSlotsTo = [&](LevelSequence::Slot endSlot) {
        for (; slot < endSlot; ++slot, ++at) {
            if (at >= inPass) {
                runs.push_back({.slot = slot, .repeat = 0, .passes = 1});
            }
        }
    };
    for (const std::uint32_t index : repeat.inner) {
        const Repeat &inner = levels.repeats()[index];
        addSlotsTo(inner.firstSlot);
        if (at >= inPass) {
            runs.push_back({.slot = 0, .repeat = index, .passes = inner.count});
        }
        at += inner.length();
        slot = inner.endSlot;
    }
    addSlotsTo(repeat.endSlot);
}

/// From the position to the end of the outermost repeat round it, which is returned.
Position addRestOfRepeat(const LevelSequence &levels, Position position, std::vector<LevelRun> &runs)
{
    std::vector<Round> rounds = roundsAt(levels, position);
    assert(rounds.size() > 1 && "there is a repeat round the position");
    for (; rounds.size() > 1; rounds.pop_back()) {
        const auto [index, begin] = rounds.back();
        const Repeat &repeat = levels.repeats()[index];
        const Position inPass = (position - begin) % repeat.passLength;
        if (inPass != 0) {
            addRestOfPass(levels, repeat, inPass, runs);
            position += repeat.passLength - inPass;
        }
        const Position end = begin + repeat.length();
        if (position < end) {
            runs.push_back({.slot = 0, .repeat = index, .passes = (end - position) / repeat.passLength});
        }
        position = end;
    }
    return position;
}

}

std::vector<LevelRun> runsOfPass(const LevelSequence &levels, std::uint32_t repeat)
{
    std::vector<LevelRun> runs;
    addRestOfPass(levels, levels.repeats()[repeat], 0, runs);
    return runs;
}

std::vector<LevelRun> runsBetween(const LevelSequence &levels, Position begin, Position end)
{
    std::vector<LevelRun> runs;
    while (begin < end) {
        const LevelSequence::Location location = levels.locate(begin);
        if (location.repeat == 0) {
            runs.push_back({.slot = location.slot, .repeat = 0, .passes = 1});
            ++begin;
        } else {
            begin = addRestOfRepeat(levels, begin, runs);
        }
    }
    assert(begin == end && "no repeat goes over the end");
    return runs;
}

}
