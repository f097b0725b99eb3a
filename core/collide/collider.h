// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>

#include <glm/vec3.hpp>

#include "core/fractal/address.h"
#include "core/geometry/affinemap.h"

namespace romanesco {

/// What is known of an answer's distance d, the least one being m.
enum class Promise {
    Exact,      ///< d is m, but for rounding
    Within,     ///< d is at most (1 + excess)·m
    UpperBound, ///< d is that of a point of the surface, or infinite; a nearer one may have been missed
    None,       ///< may err both ways
};

/// What an answer took. Counts, so that they are the same on every machine.
struct SearchCost {
    /// Faces of which the distance to p was found.
    std::uint64_t faceTests = 0;
    /// States of the fractal (or nodes of a tree) that were entered.
    std::uint64_t nodeVisits = 0;
};

/// The nearest point of a surface that was found. It keeps its memory when it is used again.
struct Hit {
    /// Infinite where nothing was found within the radius; then only promise, lower and cost mean anything.
    double distance = std::numeric_limits<double>::infinity();
    glm::dvec3 point{0.0};
    /// Of length 1: from the point to p, which is the contact's normal; the face's own where p lies on it (against the
    /// query's motion), and up on a face without one (or against the motion).
    glm::dvec3 direction{0.0, 1.0, 0.0};
    /// Where the point is: a face of the base mesh, in the copy with this address. Mesh::none where it is of no face, or
    /// where the address ends before the copy does, since all that follows is one point to p.
    std::uint32_t face = 0;
    Address address;

    Promise promise = Promise::Exact;
    /// Of Promise::Within.
    double excess = 0.0;
    /// No point of the surface is nearer; 0 where nothing is proved.
    double lower = 0.0;
    SearchCost cost;

    [[nodiscard]] bool isFound() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// Which point of the surface is asked for.
struct Query {
    /// Finite, and at most 1e150 along each axis.
    glm::dvec3 p{0.0};
    /// Only points at most so far from p count.
    double radius = std::numeric_limits<double>::infinity();
    /// The search ends early once so many nodes were visited, and promises less then. Of the colliders of fractals that
    /// promise anything; a count, so that answers do not depend on the machine.
    std::uint64_t nodeBudget = std::numeric_limits<std::uint64_t>::max();
    /// The search also ends early when this is asked for, and promises less then.
    std::stop_token stop = {};
    /// Where p is moving: only what it comes nearer to counts then, the faces whose own nearest point q to p is ahead,
    /// (p − q)·motion < 0 but for rounding; where p is on a face, those that motion is not along. Nothing is said of
    /// others. At most 1e150, not 0.
    std::optional<glm::dvec3> motion = {};
};

/// Finds points of a surface. It holds what a search needs between queries, so that none allocates once it has grown:
/// one for each thread. The collider that made it must outlive it.
class Search
{
public:
    virtual ~Search() = default;

    /// The nearest point of the surface to p, or of what it comes nearer to. Of several that are equally near, but for rounding, it is
    /// always the same one.
    virtual void closest(const Query &query, Hit &hit) = 0;
};

/// A surface that can be touched: of a fractal or a mesh, in its model's own coordinates. Immutable; any number of threads
/// may search it, each with a Search of its own.
class Collider
{
public:
    virtual ~Collider() = default;

    [[nodiscard]] virtual std::unique_ptr<Search> search() const = 0;

    /// A search of the surface as an affine map places it, in the world's coordinates; mirrored, sheared, flat or all at
    /// a point. Null where the kind would have to be built anew for that.
    [[nodiscard]] virtual std::unique_ptr<Search> searchPlaced(const AffineMap &) const { return nullptr; }

    /// Bytes held beside the mesh and the graph.
    [[nodiscard]] virtual std::size_t memoryUse() const = 0;
};

}
