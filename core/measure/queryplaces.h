// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <memory>
#include <random>

#include <glm/vec3.hpp>

#include "core/collide/collider.h"
#include "core/geometry/box.h"
#include "queryset.h"

namespace romanesco {

/// Gives faces of a surface by chance.
class FaceSource
{
public:
    virtual ~FaceSource() = default;

    /// A corner and the edges from it; both 0 for what is but a point.
    struct Face {
        glm::dvec3 corner{0.0};
        std::array<glm::dvec3, 2> edges{glm::dvec3(0.0), glm::dvec3(0.0)};
    };
    virtual Face draw(std::mt19937_64 &random) = 0;
};

/// Gives places to ask about a surface from, the same ones each time.
class QueryPlaces
{
public:
    /// Of the surface in a box, which is finite. All must outlive it; the collider is exact.
    QueryPlaces(const Box &box, const Collider &exact, FaceSource &faces);

    /// The next place of a set, which is not Balls. Costs a microsecond, and of Pocket some 20 queries.
    [[nodiscard]] glm::dvec3 draw(QuerySet set);

    /// What all queries have taken.
    [[nodiscard]] const SearchCost &cost() const { return m_cost; }

private:
    [[nodiscard]] double uniform(double least, double greatest);
    [[nodiscard]] glm::dvec3 inside(const Box &box);
    [[nodiscard]] glm::dvec3 nearFace();
    [[nodiscard]] glm::dvec3 inPocket();
    [[nodiscard]] double distanceFrom(const glm::dvec3 &p);

    Box m_box;
    double m_diagonal;
    FaceSource &m_faces;
    std::unique_ptr<Search> m_search;
    Hit m_hit;
    SearchCost m_cost;
    std::mt19937_64 m_random{1};
};

}
