// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ask.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

namespace {

double largest(const glm::dvec3 &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}

Answer Asker::operator()(const Ask &ask, const std::stop_token &stop)
{
    if (const Query *query = std::get_if<Query>(&ask.what)) {
        Query stoppable = *query;
        stoppable.stop = stop;
        m_search->closest(stoppable, m_hit);
        return {std::min(m_hit.distance, query->radius), m_hit.isFound() && m_hit.distance < ask.reach,
                m_hit.promise == Promise::Exact, m_hit.cost};
    }
    Sweep stoppable = std::get<Sweep>(ask.what);
    stoppable.stop = stop;
    m_search->sweep(stoppable, m_touch);
    const double way = std::min(m_touch.time, stoppable.time) * glm::length(stoppable.v);
    return {stoppable.radius + way, m_touch.isFound(), m_touch.promise == Promise::Exact, m_touch.cost};
}

double roundingOf(const Ask &ask, double size)
{
    // some units in the last place for each level of a fractal
    constexpr double share = 64.0 * std::numeric_limits<double>::epsilon();
    if (const Query *query = std::get_if<Query>(&ask.what)) {
        return share * (largest(query->p) + size);
    }
    const Sweep &sweep = std::get<Sweep>(ask.what);
    return share * (largest(sweep.p) + size) + 1e-5 * sweep.radius;
}

}
