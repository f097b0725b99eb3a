// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "boxgrowth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "levelruns.h"

namespace romanesco {

namespace {

using Slot = LevelSequence::Slot;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// 0 times infinity is 0: what is infinite here is only too large.
double product(double a, double b)
{
    return a == 0.0 || b == 0.0 ? 0.0 : a * b;
}

/// A sum of a few numbers, and what it may be off by: nothing where nothing was rounded, since over 10^18 levels any
/// margin counts. What is no number, of infinite ones, is bounded by nothing.
class Sum
{
public:
    void add(double factor, double value)
    {
        const double term = product(factor, value);
        if (term != 0.0) {
            m_value += term;
            m_size += std::abs(term);
            m_roundings += (std::abs(factor) != 1.0 ? 1 : 0) + (m_isEmpty ? 0 : 1);
            m_isEmpty = false;
        }
    }

    [[nodiscard]] double atLeast() const
    {
        const double least = m_value - epsilon * m_roundings * m_size;
        return std::isnan(least) ? -infinity : least;
    }
    [[nodiscard]] double atMost() const
    {
        const double most = m_value + epsilon * m_roundings * m_size;
        return std::isnan(most) ? infinity : most;
    }

private:
    double m_value = 0.0;
    double m_size = 0.0;
    int m_roundings = 0;
    bool m_isEmpty = true;
};

/// Round the image of a box, but for the translation where that is left out.
Box image(const AffineMap &map, const Box &box, bool isMoved)
{
    Box result;
    for (int row = 0; row < 3; ++row) {
        Sum least;
        Sum greatest;
        least.add(1.0, isMoved ? map.translation[row] : 0.0);
        greatest.add(1.0, isMoved ? map.translation[row] : 0.0);
        for (int column = 0; column < 3; ++column) {
            const double factor = map.linear[column][row];
            least.add(factor, factor > 0.0 ? box.least[column] : box.greatest[column]);
            greatest.add(factor, factor > 0.0 ? box.greatest[column] : box.least[column]);
        }
        result.least[row] = least.atLeast();
        result.greatest[row] = greatest.atMost();
    }
    return result;
}

/// A linear map makes at most `factor` times it of a box round the origin.
struct Stretched {
    Box box;
    double factor;
};

Box scaled(const Box &box, double factor)
{
    Box result;
    for (int axis = 0; axis < 3; ++axis) {
        result.least[axis] = product(box.least[axis], factor);
        result.greatest[axis] = product(box.greatest[axis], factor);
    }
    return result;
}

/// 1 + factor + factor² and so on, so many terms, rounded upwards.
double sumOfPowers(double factor, std::uint64_t count)
{
    const auto terms = static_cast<double>(count);
    if (factor == 1.0) {
        return terms * (1.0 + 4.0 * epsilon);
    }
    if (std::isinf(factor)) {
        return factor;
    }
    const double sum = std::expm1(terms * std::log(factor)) / (factor - 1.0);
    return std::min(sum, factor < 1.0 ? 1.0 / (1.0 - factor) : sum) * (1.0 + 1e-6);
}

/// Follows boxes up through levels. The maps of a level act on a box as intervals do; F, what some levels make of boxes,
/// is monotone, and with G, the same maps without their translations, F(X + D) is within F(X) + G(D) for any box D round
/// the origin.
class Growing
{
public:
    enum class Part { Whole, Linear };

    explicit Growing(const FractalGraph &graph)
        : m_graph(graph)
    {
    }

    Box grown(const std::vector<LevelRun> &runs, Box box, Part part = Part::Whole, int nesting = 0) const
    {
        for (const auto &[slot, repeat, passes] : runs | std::views::reverse) {
            if (box.isEmpty()) {
                return box;
            }
            if (repeat == 0) {
                box = level(slot, box, part);
            } else if (nesting == mostNesting) {
                return everything;
            } else {
                const std::vector<LevelRun> pass = runsOfPass(m_graph.levels(), repeat);
                box = part == Part::Whole ? repeated(repeat, pass, passes, box, nesting + 1)
                                          : repeatedLinear(pass, passes, box, nesting + 1);
            }
        }
        return box;
    }

private:
    /// Each doubles the work.
    static constexpr int mostNesting = 6;
    static constexpr Box everything{glm::dvec3(-infinity), glm::dvec3(infinity)};

    Box level(Slot slot, const Box &box, Part part) const
    {
        const TransformSet &set = m_graph.setAt(slot);
        Box result = set.holdsIdentity ? box : Box::ofNothing();
        for (const AffineMap &map : set.maps) {
            result = result.with(image(map, box, part == Part::Whole));
        }
        return result;
    }

    /// Some passes one by one, while what one makes may still settle. Those left each move sides out by G of what the one
    /// before did.
    Box repeated(std::uint32_t repeat, const std::vector<LevelRun> &pass, std::uint64_t passes, Box box,
                 int nesting) const
    {
        if (onlyMoves(repeat)) {
            const Box moved = grown(pass, {}, Part::Whole, nesting);
            return moved.isEmpty() ? moved : sum(box, static_cast<double>(passes), moved);
        }
        constexpr std::uint64_t mostAlone = 32;
        const std::uint64_t alone = isSimple(pass) ? std::min(passes, mostAlone) : 0;
        for (std::uint64_t i = 0; i < alone; ++i) {
            box = grown(pass, box, Part::Whole, nesting);
        }
        if (alone == passes) {
            return box;
        }
        const Box next = grown(pass, box, Part::Whole, nesting);
        if (next.isEmpty()) {
            return next;
        }
        const Box out = movedOut(box, next);
        const Stretched most = stretched(pass, out, nesting);
        const Box all = scaled(most.box, sumOfPowers(most.factor, passes - alone));
        return sum(box, 1.0, all);
    }

    /// How far the sides of the second box are outside those of the first.
    static Box movedOut(const Box &box, const Box &next)
    {
        Box out;
        for (int axis = 0; axis < 3; ++axis) { // infinite sides are not compared: their difference is no number
            out.least[axis] = next.least[axis] < box.least[axis] ? next.least[axis] - box.least[axis] : 0.0;
            out.greatest[axis] =
                next.greatest[axis] > box.greatest[axis] ? next.greatest[axis] - box.greatest[axis] : 0.0;
        }
        return out;
    }

    /// Round all sums of a point of one box and so many times a point of the other.
    static Box sum(const Box &box, double times, const Box &other)
    {
        Box result;
        for (int axis = 0; axis < 3; ++axis) {
            Sum least;
            least.add(1.0, box.least[axis]);
            least.add(times, other.least[axis]);
            result.least[axis] = least.atLeast();
            Sum greatest;
            greatest.add(1.0, box.greatest[axis]);
            greatest.add(times, other.greatest[axis]);
            result.greatest[axis] = greatest.atMost();
        }
        return result;
    }

    /// What it makes of a box then is the sum with what it makes of the origin.
    [[nodiscard]] bool onlyMoves(std::uint32_t repeat) const
    {
        const LevelSequence::Repeat &slots = m_graph.levels().repeats()[repeat];
        return std::ranges::all_of(std::views::iota(slots.firstSlot, slots.endSlot), [&](Slot slot) {
            return std::ranges::all_of(m_graph.setAt(slot).maps,
                                       [](const AffineMap &map) { return map.linear == glm::dmat3(1.0); });
        });
    }

    Box repeatedLinear(const std::vector<LevelRun> &pass, std::uint64_t passes, const Box &box, int nesting) const
    {
        const Stretched most = stretched(pass, box, nesting);
        return scaled(most.box,
                      most.factor == 1.0 ? 1.0 : std::pow(most.factor, static_cast<double>(passes)) * (1.0 + 1e-6));
    }

    /// Widens a box round the origin until G of it is no more than it, if that comes soon.
    Stretched stretched(const std::vector<LevelRun> &pass, Box box, int nesting) const
    {
        const int rounds = isSimple(pass) ? 8 : 1;
        double factor = 1.0;
        for (int round = 0; round <= rounds; ++round) {
            const Box next = grown(pass, box, Part::Linear, nesting);
            factor = 0.0;
            for (int axis = 0; axis < 3; ++axis) {
                factor = std::max({factor, ratio(-next.least[axis], -box.least[axis]),
                                   ratio(next.greatest[axis], box.greatest[axis])});
            }
            if (factor <= 1.0 || round == rounds) {
                break;
            }
            box = box.with(next);
        }
        // What begins to move may move others that stay.
        return {std::isinf(factor) ? everything : box, factor};
    }

    /// Of lengths; a zero may have any sign.
    static double ratio(double a, double b)
    {
        return a == 0.0 ? 0.0 : a == b ? 1.0 : b == 0.0 ? infinity : a / b * (1.0 + 2.0 * epsilon);
    }

    static bool isSimple(const std::vector<LevelRun> &pass)
    {
        return std::ranges::all_of(pass, [](const LevelRun &run) { return run.repeat == 0; });
    }

    const FractalGraph &m_graph;
};

}

Box grownBox(const FractalGraph &graph, Position begin, Position end, const Box &box)
{
    if (box.isEmpty()) {
        return box;
    }
    const Box grown = Growing(graph).grown(runsBetween(graph.levels(), begin, end), box);
    const Sphere sphere = graph.bound(begin);
    return grown.within({sphere.centre - sphere.radius, sphere.centre + sphere.radius});
}

}
