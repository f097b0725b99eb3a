// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/fractal/statetable.h"
#include "core/geometry/box.h"
#include "descent.h"
#include "equalproducts.h"

namespace romanesco {

/// The branches that a search went down into, to tell where one comes again by other picks. Copies that coincide multiply
/// with each level, and EqualProducts knows only of those that differ in two picks, one after the other. What looks the
/// same from p, by symmetry, is met again too. It has to have been gone down into in all
/// ways that this one would be, though: what EqualProducts leaves out of one is met beside it, where it may have been met
/// before.
///
/// Each has one of a few hundred places, until another takes it: what is forgotten is gone down into again. Constant time;
/// it allocates once. Frames say what is alike: LocalFrames or RelativeFrames.
template<typename Frames>
class MetCopies
{
public:
    using Frame = typename Frames::Frame;

    /// The products must outlive it.
    explicit MetCopies(const EqualProducts &products)
        : m_products(products)
    {
    }

    /// Forgets all.
    void begin() { ++m_search; }

    /// Whether the state that a step leads to was met in a frame that is like this one but for what the frames may be off: how much nearer than
    /// there anything may be here. Keeps it if not. size: that of the box, in the model's unit, more than the frame is off.
    [[nodiscard]] std::optional<double> findOrKeep(const DescentStep &step, const Frame &frame, const Box &box,
                                                   double size)
    {
        m_met.resize(placeCount);
        Met &met = m_met[placeOf(step.state, frame, size)];
        if (met.search == m_search && met.step.state == step.state && m_products.leavesOutNoMore(met.step, step)) {
            if (const double apart = Frames::apart(met.frame, frame, box); apart <= frame.error) {
                // what is kept in mind of what is below allows for what that frame is off
                return apart + std::max(frame.error - met.frame.error, 0.0);
            }
        }
        met = {m_search, step, frame};
        return std::nullopt;
    }

private:
    /// A power of two, of about 100 bytes each.
    static constexpr int bitCount = 8;
    static constexpr std::size_t placeCount = std::size_t{1} << bitCount;
    /// Branches that overlap are mostly farther apart than a cell, which is far larger than what they are off.
    static constexpr double cellsOfSize = 64.0;

    struct Met {
        std::uint64_t search = 0;
        DescentStep step;
        Frame frame;
    };

    [[nodiscard]] static std::size_t placeOf(StateId state, const Frame &frame, double size)
    {
        const double cell = std::trunc(Frames::placeOf(frame) * cellsOfSize / size);
        const std::uint64_t key = std::bit_cast<std::uint64_t>(cell) ^ (std::uint64_t{state} << 24);
        return (key * 0x9e3779b97f4a7c15) >> (64 - bitCount); // Fibonacci hashing (Knuth 1973, 6.4)
    }

    const EqualProducts &m_products;
    std::vector<Met> m_met;
    std::uint64_t m_search = 0;
};

}
