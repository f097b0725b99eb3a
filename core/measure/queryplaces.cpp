// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "queryplaces.h"

#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ask.h"

namespace romanesco {

namespace {

Box scaled(const Box &box, double factor)
{
    const glm::dvec3 half = 0.5 * factor * box.size();
    return {box.centre() - half, box.centre() + half};
}

}

QueryPlaces::QueryPlaces(const Box &box, const Collider &exact, FaceSource &faces)
    : m_box(box)
    , m_diagonal(glm::length(box.size()))
    , m_faces(faces)
    , m_search(exact.search())
{
    assert(std::isfinite(m_diagonal) && "places are drawn from a box");
}

glm::dvec3 QueryPlaces::draw(QuerySet set)
{
    assert(set != QuerySet::Balls && "what balls ask is recorded");
    return set == QuerySet::Uniform ? inside(scaled(m_box, 1.5)) : set == QuerySet::Near ? nearFace() : inPocket();
}

double QueryPlaces::uniform(double least, double greatest)
{
    return std::uniform_real_distribution<double>(least, greatest)(m_random);
}

glm::dvec3 QueryPlaces::inside(const Box &box)
{
    const double z = uniform(0, 1);
    const double y = uniform(0, 1);
    const double x = uniform(0, 1);
    return box.least + glm::dvec3(x, y, z) * box.size();
}

glm::dvec3 QueryPlaces::nearFace()
{
    const FaceSource::Face face = m_faces.draw(m_random);
    const double s = std::sqrt(uniform(0, 1));
    const double t = uniform(0, 1);
    const glm::dvec3 on = face.corner + s * (1 - t) * face.edges[0] + s * t * face.edges[1];
    const glm::dvec3 across = glm::cross(face.edges[0], face.edges[1]);
    const double length = glm::length(across);
    const bool hasNormal = length > 0.0 && std::isfinite(length);
    const glm::dvec3 normal = hasNormal ? across / length : glm::dvec3(0.0, 1.0, 0.0);
    const double away = m_diagonal * std::pow(10.0, uniform(-3, -1.3));
    return on + (m_random() % 2 == 0 ? away : -away) * normal;
}

glm::dvec3 QueryPlaces::inPocket()
{
    const Box around = scaled(m_box, 0.9);
    glm::dvec3 best = inside(scaled(m_box, 0.8));
    double distance = distanceFrom(best);
    for (int i = 0; i < 12; ++i) {
        const glm::dvec3 move = inside({glm::dvec3(-1.0), glm::dvec3(1.0)});
        const glm::dvec3 next = glm::clamp(best + 0.1 * m_diagonal * move, around.least, around.greatest);
        if (const double there = distanceFrom(next); there > distance) {
            best = next;
            distance = there;
        }
    }
    return best;
}

double QueryPlaces::distanceFrom(const glm::dvec3 &p)
{
    m_search->closest({.p = p, .nodeBudget = askBudget}, m_hit);
    m_cost.faceTests += m_hit.cost.faceTests;
    m_cost.nodeVisits += m_hit.cost.nodeVisits;
    return m_hit.distance;
}

}
