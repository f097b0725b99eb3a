// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "polygoncutter.h"

namespace romanesco {

namespace {

using Number = std::uint32_t;

/// What corners are rounded to: differences of them are exact.
constexpr double grain = 0x1p-50;

/// Twice the area of a triangle: positive if it turns left, and 0 only if it is. Of ears that are judged with rounding
/// errors none may be left where corners are nearly in line. Kahan's determinant, whose relative error is below 2^-51
/// (Jeannerod, Louvet and Muller 2013), so that its sign is right.
double area(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c)
{
    const glm::dvec2 u = b - a;
    const glm::dvec2 v = c - a;
    const double product = u.y * v.x;
    const double lost = std::fma(-u.y, v.x, product);
    return std::fma(u.x, v.y, -product) + lost;
}

using Corners = std::array<glm::dvec2, 3>;

/// Points to look for in triangles, which can be taken out. A balanced tree of boxes (Bentley 1975), a node's children
/// behind it as in a heap.
class PointTree
{
public:
    PointTree(std::span<const glm::dvec2> points, std::vector<Number> chosen);

    void remove(Number point);
    /// Whether the function holds for one of those that may lie in the triangle, which turns left, or on its edges.
    template<typename Function>
    [[nodiscard]] bool any(const Corners &triangle, Function function) const;

private:
    static constexpr std::size_t leafSize = 8;
    struct Node {
        glm::dvec2 least;
        glm::dvec2 greatest;
        /// In m_order.
        Number begin;
        Number end;
        /// That have not been taken out.
        Number left;
    };
    [[nodiscard]] static bool isOutside(const Node &node, const Corners &triangle);
    void makeNode(std::size_t index, Number begin, Number end);

    std::span<const glm::dvec2> m_points;
    std::vector<Number> m_order;
    std::vector<Node> m_nodes;
    std::size_t m_innerCount;
    /// By the point.
    std::vector<Number> m_leaves;
};

PointTree::PointTree(std::span<const glm::dvec2> points, std::vector<Number> chosen)
    : m_points(points)
    , m_order(std::move(chosen))
    , m_innerCount(std::bit_ceil(m_order.size() / leafSize + 1) - 1)
    , m_leaves(points.size())
{
    m_nodes.resize(2 * m_innerCount + 1);
    makeNode(0, 0, static_cast<Number>(m_order.size()));
    for (std::size_t i = 0; i < m_innerCount; ++i) {
        const auto &[least, greatest, begin, end, left] = m_nodes[i];
        const int axis = greatest.x - least.x < greatest.y - least.y;
        const Number middle = begin + (end - begin) / 2;
        std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end,
                         [&](Number a, Number b) { return points[a][axis] < points[b][axis]; });
        makeNode(2 * i + 1, begin, middle);
        makeNode(2 * i + 2, middle, end);
    }
    for (std::size_t i = m_innerCount; i < m_nodes.size(); ++i) {
        for (Number k = m_nodes[i].begin; k < m_nodes[i].end; ++k) {
            m_leaves[m_order[k]] = static_cast<Number>(i);
        }
    }
}

void PointTree::makeNode(std::size_t index, Number begin, Number end)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Node node{glm::dvec2(infinity), glm::dvec2(-infinity), begin, end, end - begin};
    for (Number k = begin; k < end; ++k) {
        node.least = glm::min(node.least, m_points[m_order[k]]);
        node.greatest = glm::max(node.greatest, m_points[m_order[k]]);
    }
    m_nodes[index] = node;
}

void PointTree::remove(Number point)
{
    std::size_t node = m_leaves[point];
    --m_nodes[node].left;
    while (node > 0) {
        node = (node - 1) / 2;
        --m_nodes[node].left;
    }
}

/// On the wrong side of an edge with all its box, or beside the triangle.
bool PointTree::isOutside(const Node &node, const Corners &triangle)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 a = triangle[i];
        const glm::dvec2 b = triangle[(i + 1) % 3];
        const glm::dvec2 innermost(b.y > a.y ? node.least.x : node.greatest.x,
                                   b.x > a.x ? node.greatest.y : node.least.y);
        if (area(a, b, innermost) < 0) {
            return true;
        }
    }
    const auto [a, b, c] = triangle;
    return glm::any(glm::greaterThan(glm::min(glm::min(a, b), c), node.greatest))
        || glm::any(glm::lessThan(glm::max(glm::max(a, b), c), node.least));
}

template<typename Function>
bool PointTree::any(const Corners &triangle, Function function) const
{
    std::array<std::size_t, 64> open{0};
    for (std::size_t count = 1; count > 0;) {
        const std::size_t index = open[--count];
        const Node &node = m_nodes[index];
        if (node.left == 0 || isOutside(node, triangle)) {
            continue;
        }
        if (index < m_innerCount) {
            open[count++] = 2 * index + 2;
            open[count++] = 2 * index + 1;
        } else if (std::any_of(m_order.begin() + node.begin, m_order.begin() + node.end, function)) {
            return true;
        }
    }
    return false;
}

std::vector<glm::dvec2> rounded(std::span<const glm::dvec2> corners)
{
    std::vector<glm::dvec2> all;
    for (const glm::dvec2 &corner : corners) {
        assert(std::abs(corner.x) <= 2 && std::abs(corner.y) <= 2 && "further out differences may be rounded");
        all.push_back(grain * glm::round(corner / grain));
    }
    return all;
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
    std::vector<Number> makeRing();
    Number nextEar();
    Number leastBad();
    void remove(Number corner);
    void neighbourWent(Number corner);
    void clearReflex(Number corner);

    /// In whole grains.
    std::vector<glm::dvec2> m_corners;
    /// The ring of those that are left.
    std::vector<Number> m_previous;
    std::vector<Number> m_next;
    /// That do not turn left: only these can lie in the way of an ear.
    std::vector<bool> m_isReflex;
    /// Whether a corner is an ear changes only with its neighbours, so each is tried once and then after these.
    std::deque<Number> m_untried;
    /// The reflex corners.
    PointTree m_reflex;
    /// Tried, and in line with their neighbours.
    std::vector<Number> m_inLine;
    /// One that is left.
    Number m_start = 0;
};

EarCutter::EarCutter(std::span<const glm::dvec2> corners)
    : m_corners(rounded(corners))
    , m_previous(corners.size())
    , m_next(corners.size())
    , m_isReflex(corners.size())
    , m_reflex(m_corners, makeRing())
{
}

/// Returns the reflex corners.
std::vector<Number> EarCutter::makeRing()
{
    const auto count = static_cast<Number>(m_corners.size());
    std::vector<Number> reflex;
    for (Number corner = 0; corner < count; ++corner) {
        m_previous[corner] = (corner > 0 ? corner : count) - 1;
        m_next[corner] = corner + 1 < count ? corner + 1 : 0;
        m_isReflex[corner] = !(turn(corner) > 0);
        if (m_isReflex[corner]) {
            reflex.push_back(corner);
        }
        m_untried.push_back(corner);
    }
    return reflex;
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
    const auto [a, b, c] = Corners{m_corners[ear[0]], m_corners[ear[1]], m_corners[ear[2]]};
    return m_reflex.any({a, b, c}, [&](Number other) {
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
    clearReflex(corner);
    m_start = m_start == corner ? next : m_start;
    neighbourWent(previous);
    neighbourWent(next);
}

void EarCutter::neighbourWent(Number corner)
{
    if (turn(corner) > 0) {
        clearReflex(corner);
    }
    m_untried.push_back(corner);
}

void EarCutter::clearReflex(Number corner)
{
    if (m_isReflex[corner]) {
        m_isReflex[corner] = false;
        m_reflex.remove(corner);
    }
}

}

void cutEars(std::span<const glm::dvec2> corners, std::vector<CornerTriangle> &triangles)
{
    assert(corners.size() >= 3 && "a polygon has at least three corners");
    EarCutter(corners).cut(triangles);
}

}
