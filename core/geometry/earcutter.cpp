// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>

#include <glm/common.hpp>

#include "polygoncutter.h"

namespace romanesco {

namespace {

using Number = std::uint32_t;

/// Twice the area of a triangle: positive if it turns left.
double area(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Points by the cells of a grid of about as many cells as points.
class PointGrid
{
public:
    PointGrid() = default;
    PointGrid(std::span<const glm::dvec2> points, std::span<const Number> chosen);

    /// Whether the function holds for one of the points that may lie in the box.
    template<typename Function>
    bool any(const glm::dvec2 &least, const glm::dvec2 &greatest, Function function) const
    {
        const auto [left, bottom] = cellOf(least);
        const auto [right, top] = cellOf(greatest);
        for (std::size_t row = bottom; row <= top; ++row) {
            // the cells of a row lie one behind another
            const Number end = m_starts[row * m_width + right + 1];
            for (Number i = m_starts[row * m_width + left]; i < end; ++i) {
                if (function(m_points[i])) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    struct Cell {
        std::size_t column;
        std::size_t row;
    };
    [[nodiscard]] Cell cellOf(const glm::dvec2 &point) const
    {
        const auto most = static_cast<double>(m_width - 1);
        const glm::dvec2 place = glm::clamp((point - m_least) * m_cellsPerUnit, 0.0, most);
        return {static_cast<std::size_t>(place.x), static_cast<std::size_t>(place.y)};
    }

    glm::dvec2 m_least{0.0};
    glm::dvec2 m_cellsPerUnit{0.0};
    std::size_t m_width = 1;
    /// Of each cell, in m_points; and the end.
    std::vector<Number> m_starts{0, 0};
    std::vector<Number> m_points;
};

PointGrid::PointGrid(std::span<const glm::dvec2> points, std::span<const Number> chosen)
{
    if (!chosen.empty()) {
        m_least = points[chosen[0]];
        glm::dvec2 greatest = m_least;
        for (const Number point : chosen) {
            m_least = glm::min(m_least, points[point]);
            greatest = glm::max(greatest, points[point]);
        }
        m_width = static_cast<std::size_t>(std::sqrt(static_cast<double>(chosen.size()))) + 1;
        const glm::dvec2 size = greatest - m_least;
        for (int axis = 0; axis < 2; ++axis) {
            m_cellsPerUnit[axis] = size[axis] > 0 ? static_cast<double>(m_width) / size[axis] : 0.0;
        }
    }
    const auto cellIndex = [&](Number point) {
        const Cell cell = cellOf(points[point]);
        return cell.row * m_width + cell.column;
    };
    // a counting sort
    m_starts.assign(m_width * m_width + 1, 0);
    for (const Number point : chosen) {
        ++m_starts[cellIndex(point) + 1];
    }
    for (std::size_t i = 1; i < m_starts.size(); ++i) {
        m_starts[i] += m_starts[i - 1];
    }
    std::vector<Number> ends(m_starts.begin(), m_starts.end() - 1);
    m_points.resize(chosen.size());
    for (const Number point : chosen) {
        m_points[ends[cellIndex(point)]++] = point;
    }
}

class EarCutter
{
public:
    explicit EarCutter(std::span<const glm::dvec2> corners);

    void cut(std::vector<CornerTriangle> &triangles)
    {
        for (std::size_t left = m_corners.size(); left > 3; --left) {
            const Number corner = nextEar();
            triangles.push_back(triangleAt(corner));
            remove(corner);
        }
        triangles.push_back(triangleAt(m_start));
    }

private:
    [[nodiscard]] CornerTriangle triangleAt(Number corner) const
    {
        return {m_previous[corner], corner, m_next[corner]};
    }
    [[nodiscard]] double turn(Number corner) const
    {
        return area(m_corners[m_previous[corner]], m_corners[corner], m_corners[m_next[corner]]);
    }
    [[nodiscard]] bool isGone(Number corner) const { return m_next[corner] == corner; }
    [[nodiscard]] bool isEar(Number corner) const;
    [[nodiscard]] bool isBlocked(const CornerTriangle &ear) const;
    Number nextEar();
    Number leastBad();
    void remove(Number corner);
    void neighbourWent(Number corner);

    std::span<const glm::dvec2> m_corners;
    /// The ring of those that are left.
    std::vector<Number> m_previous;
    std::vector<Number> m_next;
    /// That do not turn left: only these can lie in the way of an ear.
    std::vector<bool> m_isReflex;
    PointGrid m_reflex;
    /// Whether a corner is an ear changes only with its neighbours, so each is tried once and then after these.
    std::deque<Number> m_untried;
    /// Tried, and in line with their neighbours.
    std::vector<Number> m_inLine;
    /// One that is left.
    Number m_start = 0;
};

EarCutter::EarCutter(std::span<const glm::dvec2> corners)
    : m_corners(corners)
    , m_previous(corners.size())
    , m_next(corners.size())
    , m_isReflex(corners.size())
{
    const auto count = static_cast<Number>(corners.size());
    std::vector<Number> reflex;
    for (Number corner = 0; corner < count; ++corner) {
        m_previous[corner] = (corner > 0 ? corner : count) - 1;
        m_next[corner] = corner + 1 < count ? corner + 1 : 0;
        if (!(turn(corner) > 0)) {
            m_isReflex[corner] = true;
            reflex.push_back(corner);
        }
        m_untried.push_back(corner);
    }
    m_reflex = PointGrid(corners, reflex);
}

Number EarCutter::nextEar()
{
    while (!m_untried.empty()) {
        const Number corner = m_untried.front();
        m_untried.pop_front();
        if (isGone(corner)) {
            continue;
        }
        if (isEar(corner)) {
            return corner;
        }
        if (turn(corner) == 0) {
            m_inLine.push_back(corner);
        }
    }
    return leastBad();
}

/// Of a polygon that is not simple, or only just: a corner without area does no harm; else one that turns left, if there
/// is one near by.
Number EarCutter::leastBad()
{
    while (!m_inLine.empty()) {
        const Number corner = m_inLine.back();
        m_inLine.pop_back();
        if (!isGone(corner) && turn(corner) == 0) {
            return corner;
        }
    }
    constexpr int farthest = 100; // all of them each time would take hours
    for (int i = 0; i < farthest && !(turn(m_start) > 0); ++i) {
        m_start = m_next[m_start];
    }
    return m_start;
}

bool EarCutter::isEar(Number corner) const
{
    return turn(corner) > 0 && !isBlocked(triangleAt(corner));
}

/// Whether another corner lies in the triangle or on its edges. At a corner of the triangle it does not count: there
/// edges touch.
bool EarCutter::isBlocked(const CornerTriangle &ear) const
{
    const glm::dvec2 a = m_corners[ear[0]];
    const glm::dvec2 b = m_corners[ear[1]];
    const glm::dvec2 c = m_corners[ear[2]];
    return m_reflex.any(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), [&](Number other) {
        const glm::dvec2 p = m_corners[other];
        return m_isReflex[other] && p != a && p != b && p != c && area(a, b, p) >= 0 && area(b, c, p) >= 0
            && area(c, a, p) >= 0;
    });
}

void EarCutter::remove(Number corner)
{
    const Number previous = m_previous[corner];
    const Number next = m_next[corner];
    m_next[previous] = next;
    m_previous[next] = previous;
    m_next[corner] = corner;
    m_isReflex[corner] = false;
    m_start = m_start == corner ? next : m_start;
    neighbourWent(previous);
    neighbourWent(next);
}

void EarCutter::neighbourWent(Number corner)
{
    if (turn(corner) > 0) {
        m_isReflex[corner] = false;
    }
    m_untried.push_back(corner);
}

}

void cutEars(std::span<const glm::dvec2> corners, std::vector<CornerTriangle> &triangles)
{
    assert(corners.size() >= 3 && "a polygon has at least three corners");
    EarCutter(corners).cut(triangles);
}

}
