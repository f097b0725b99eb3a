// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "copies.h"

#include <algorithm>
#include <cassert>

namespace romanesco {

namespace {

/// So many forks are folded at once, when there are twice as many.
constexpr std::size_t forksFolded = 1'024;
constexpr std::size_t tableBytes = std::size_t(4) << 20;

}

CopyWalk::CopyWalk(const FractalGraph &graph, Addresses addresses, std::stop_token stop)
    : m_table(graph)
    , m_addresses(addresses)
    , m_stop(std::move(stop))
    , m_mostTableBytes(tableBytes)
{
}

bool CopyWalk::next()
{
    bool isAtCopy = false;
    while (!isAtCopy && !m_stop.stop_requested()) {
        if (!m_hasBegun) {
            m_hasBegun = true;
            isAtCopy = enter({m_table.root(), AffineMap{}, 0});
        } else if (!m_forks.empty() || unfold()) {
            isAtCopy = enter(takeChild());
        } else {
            break;
        }
    }
    if (isAtCopy && m_addresses == Addresses::Keep && m_table.graph().setsShareMaps()) {
        placePicks(m_table.graph(), m_reached, m_picks);
    }
    return isAtCopy;
}

std::span<const Pick> CopyWalk::address() const
{
    assert(m_addresses == Addresses::Keep && "addresses are kept only if that was asked for");
    return m_picks;
}

/// The next child of the last fork, which is dropped with its last child.
CopyWalk::Place CopyWalk::takeChild()
{
    Fork &fork = m_forks.back();
    const auto &ranges = m_table.expansion(fork.place.state).ranges;
    const ChildRange &range = ranges[fork.next.range];
    const Place child = below(fork.place, fork.next);
    if (m_addresses == Addresses::Keep) {
        keepPick(fork, range.next);
    }
    if (++fork.next.map == range.endMap) {
        if (++fork.next.range == ranges.size()) {
            m_forks.pop_back();
        } else {
            fork.next.map = ranges[fork.next.range].firstMap;
        }
    }
    return child;
}

void CopyWalk::keepPick(const Fork &fork, StateId next)
{
    const Positions &positions = m_table.state(next).positions;
    m_picks.resize(fork.place.length);
    m_picks.push_back({positions.front() - 1, fork.next.map});
    if (m_table.graph().setsShareMaps()) {
        m_reached.resize(fork.place.length);
        m_reached.push_back(positions);
    }
}

/// Whether a copy stands at the place. Its children come next.
bool CopyWalk::enter(Place place)
{
    limitMemory(place);
    const Expansion &expansion = m_table.expansion(place.state);
    if (!expansion.ranges.empty()) {
        m_forks.push_back({place, {0, expansion.ranges.front().firstMap}});
        if (m_forks.size() == 2 * forksFolded) {
            fold();
        }
    }
    m_copy = place;
    return expansion.hasLeaf;
}

CopyWalk::Place CopyWalk::below(const Place &place, const Child &child)
{
    const ChildRange &range = m_table.expansion(place.state).ranges[child.range];
    return {range.next, place.map * m_table.graph().set(range.set).maps[child.map], place.length + 1};
}

CopyWalk::Child CopyWalk::lastChild(StateId state)
{
    const auto &ranges = m_table.expansion(state).ranges;
    return {static_cast<std::uint32_t>(ranges.size() - 1), ranges.back().endMap - 1};
}

CopyWalk::Child CopyWalk::childBefore(StateId state, const Child &child)
{
    const auto &ranges = m_table.expansion(state).ranges;
    const bool isFirst = child.map == ranges[child.range].firstMap;
    return isFirst ? Child{child.range - 1, ranges[child.range - 1].endMap - 1} : Child{child.range, child.map - 1};
}

/// Puts the outer half of the forks away: in a deep fractal they are not needed before thousands of copies have gone by,
/// and most of them are alike.
void CopyWalk::fold()
{
    const Place &first = m_forks.front().place;
    Folded folded{m_table.state(first.state).positions, first.map, first.length, {}};
    Position expected = first.length;
    for (std::size_t i = 0; i < forksFolded; ++i) {
        const Fork &fork = m_forks[i];
        const Position gap = fork.place.length - expected;
        expected = fork.place.length + 1;
        if (!folded.turns.empty() && folded.turns.back().gap == gap && folded.turns.back().next == fork.next) {
            ++folded.turns.back().repeats;
        } else {
            folded.turns.push_back({gap, fork.next, 1});
        }
    }
    m_folded.push_back(std::move(folded));
    m_forks.erase(m_forks.begin(), m_forks.begin() + forksFolded);
}

/// Makes the forks that were folded last again. False where there are none, or when stopped.
bool CopyWalk::unfold()
{
    if (m_folded.empty()) {
        return false;
    }
    const Folded folded = std::move(m_folded.back());
    m_folded.pop_back();
    Place place{m_table.find(folded.firstState), folded.firstMap, folded.firstLength};
    for (const Turn &turn : folded.turns) {
        for (std::uint32_t i = 0; i < turn.repeats; ++i) {
            for (Position step = 0; step < turn.gap; ++step) {
                if (m_stop.stop_requested()) {
                    return false;
                }
                place = below(place, lastChild(place.state));
                limitMemory(place);
            }
            m_forks.push_back({place, turn.next});
            place = below(place, childBefore(place.state, turn.next));
            limitMemory(place);
        }
    }
    return true;
}

/// Forgets the states that are not needed now, so that a deep fractal does not fill the memory with them.
void CopyWalk::limitMemory(Place &current)
{
    if (m_table.memoryUse() <= m_mostTableBytes) {
        return;
    }
    std::vector<StateId> states{current.state};
    for (const Fork &fork : m_forks) {
        states.push_back(fork.place.state);
    }
    m_table.forgetAllBut(states);
    current.state = states.front();
    for (std::size_t i = 0; i < m_forks.size(); ++i) {
        m_forks[i].place.state = states[i + 1];
    }
    m_mostTableBytes = std::max(tableBytes, 2 * m_table.memoryUse());
}

std::size_t CopyWalk::memoryUse() const
{
    std::size_t bytes = sizeof(*this) + m_table.memoryUse() + m_forks.capacity() * sizeof(Fork)
        + m_picks.capacity() * sizeof(Pick) + m_folded.capacity() * sizeof(Folded);
    for (const Folded &folded : m_folded) {
        bytes += folded.turns.capacity() * sizeof(Turn);
    }
    return bytes;
}

}
