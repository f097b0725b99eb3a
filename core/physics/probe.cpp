// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace romanesco {

Probe::Probe(const Surface &surface)
    : m_surface(surface)
    , m_search(surface.collider->search())
{
}

void Probe::begin(const ProbeBudget &budget)
{
    m_left = budget;
    m_cost = {};
    m_queries = 0;
}

double Probe::roundingAt(const glm::dvec3 &p) const
{
    // some units in the last place for each level of a fractal
    constexpr double share = 32.0 * std::numeric_limits<double>::epsilon();
    return share * (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) + m_surface.size);
}

void Probe::count(const SearchCost &cost)
{
    m_cost.faceTests += cost.faceTests;
    m_cost.nodeVisits += cost.nodeVisits;
    m_left.nodes -= std::min(m_left.nodes, cost.nodeVisits);
    m_left.queries -= std::min(m_left.queries, 1u);
    ++m_queries;
}

Probe::Nearest Probe::nearest(const glm::dvec3 &p, double radius, const std::optional<glm::dvec3> &motion)
{
    Query query;
    query.p = p;
    query.radius = radius;
    query.nodeBudget = m_left.nodes;
    query.motion = motion;
    m_search->closest(query, m_hit);
    count(m_hit.cost);
    const double seen = std::min(m_hit.distance, radius);
    return {m_hit.isFound(), m_surface.isProved ? std::min(m_hit.lower, seen) : seen, m_hit.distance, m_hit.direction};
}

double Probe::freeShare(const glm::dvec3 &from, const glm::dvec3 &way, double radius)
{
    Sweep sweep;
    sweep.p = from;
    sweep.v = way;
    sweep.time = 1.0;
    sweep.radius = radius;
    sweep.nodeBudget = m_left.nodes;
    m_search->sweep(sweep, m_touch);
    count(m_touch.cost);
    if (m_surface.isProved) {
        return std::min(m_touch.lower, 1.0);
    }
    return m_touch.isFound() ? std::min(m_touch.time, 1.0) : 1.0;
}

}
