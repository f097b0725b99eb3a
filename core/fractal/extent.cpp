// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "extent.h"

#include <algorithm>
#include <limits>
#include <queue>

#include <glm/geometric.hpp>

#include "statetable.h"

namespace romanesco {

namespace {

/// Looking at a copy of a sphere costs about as much as looking at so many faces.
constexpr std::size_t facesPerCopy = 16;

/// A copy of a state or of the base mesh, with the farthest that it can reach; of a leaf that was measured, with what it
/// reaches.
struct Candidate {
    enum class Kind { State, Leaf, MeasuredLeaf };

    double reach;
    StateId state;
    Kind kind;
    AffineMap map;
    double norm;

    bool operator<(const Candidate &other) const { return reach < other.reach; }
};

double reachOfMesh(const AffineMap &map, const Mesh &mesh, const glm::dvec3 &direction)
{
    double reach = -std::numeric_limits<double>::infinity();
    for (const auto &face : mesh.faces) {
        for (const std::uint32_t index : face) {
            reach = std::max(reach, glm::dot(direction, map(mesh.vertices[index])));
        }
    }
    return reach;
}

double reachOfSphere(const Sphere &sphere, const glm::dvec3 &direction)
{
    return glm::dot(direction, sphere.centre) + glm::length(direction) * sphere.radius;
}

double greatestReach(StateTable &table, const Mesh &mesh, const glm::dvec3 &direction, std::size_t budget)
{
    using Kind = Candidate::Kind;
    std::priority_queue<Candidate> open;
    const double whole = reachOfSphere(table.state(table.root()).bound, direction);
    open.push({whole, table.root(), Kind::State, {}, 1.0});
    std::size_t looked = 0;
    while (open.top().kind != Kind::MeasuredLeaf && looked < budget) {
        const Candidate parent = open.top();
        open.pop();
        if (parent.kind == Kind::Leaf) {
            const double reach = std::min(parent.reach, reachOfMesh(parent.map, mesh, direction));
            open.push({reach, parent.state, Kind::MeasuredLeaf, parent.map, parent.norm});
            looked += 1 + mesh.faces.size() / facesPerCopy;
            continue;
        }
        const Expansion &expansion = table.expansion(parent.state);
        if (expansion.hasLeaf) {
            const Sphere bound = transformed(parent.map, parent.norm, table.graph().base());
            open.push({std::min(parent.reach, reachOfSphere(bound, direction)), parent.state, Kind::Leaf, parent.map,
                       parent.norm});
        }
        const std::vector<Sphere> &bounds = table.childBounds(parent.state);
        looked += 1 + bounds.size();
        std::size_t child = 0;
        for (const ChildRange &range : expansion.ranges) {
            for (std::uint32_t i = range.firstMap; i < range.endMap; ++i, ++child) {
                const Sphere bound = transformed(parent.map, parent.norm, bounds[child]);
                open.push({std::min(parent.reach, reachOfSphere(bound, direction)), range.next, Kind::State,
                           parent.map * table.graph().set(range.set).maps[i],
                           parent.norm * table.graph().facts(range.set)[i].norm});
            }
        }
    }
    return open.top().reach;
}

}

double reachAlong(const FractalGraph &graph, const Mesh &base, const glm::dvec3 &direction, std::size_t budget)
{
    StateTable table(graph);
    return graph.base().isEmpty() ? -std::numeric_limits<double>::infinity()
                                  : greatestReach(table, base, direction, budget);
}

Box extent(const FractalGraph &graph, const Mesh &base, std::size_t budget)
{
    if (graph.base().isEmpty()) {
        return {};
    }
    StateTable table(graph);
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0.0);
        direction[axis] = 1.0;
        box.greatest[axis] = greatestReach(table, base, direction, budget);
        box.least[axis] = -greatestReach(table, base, -direction, budget);
    }
    return box;
}

}
