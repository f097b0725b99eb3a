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

#include "core/fractal/statetable.h"
#include "core/geometry/affinemap.h"

namespace romanesco {

/// What is known of an answer's distance d, the least one being m; or of the time of a touch and that of the first.
enum class Promise {
    Exact,      ///< d is m, but for rounding; a time may be late by what Touch tells
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

/// A point of a surface, and what it took to find it. It keeps its memory when it is used again.
struct SurfacePoint {
    glm::dvec3 point{0.0};
    /// Of length 1: from the point to p, or to the centre of the sphere that touches, which is the contact's normal; the
    /// face's own where that lies on it (against the motion), and up on a face without one (or against the motion).
    glm::dvec3 direction{0.0, 1.0, 0.0};
    /// Where the point is: a face of the base mesh, in the copy with this address. Mesh::none where it is of no face, or
    /// where the address ends before the copy does, since all that follows is one point to p.
    std::uint32_t face = 0;
    Address address;

    Promise promise = Promise::Exact;
    SearchCost cost;
};

/// The nearest point of a surface that was found.
struct Hit : SurfacePoint {
    /// At most the radius; infinite where nothing was found within it. Then only promise, lower and cost mean anything.
    double distance = std::numeric_limits<double>::infinity();
    /// Of Promise::Within.
    double excess = 0.0;
    /// No point of the surface is nearer; 0 where nothing is proved.
    double lower = 0.0;

    [[nodiscard]] bool isFound() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// Where a moving sphere touches a surface first.
struct Touch : SurfacePoint {
    /// Infinite where nothing is touched; then only promise, lower and cost mean anything. At most 1e-5·radius/|v| later
    /// than the first touch, but for rounding; the surface is within the radius then, but for rounding. That is as if
    /// the radius were off by some hundreds of u·M for each level of a fractal that was gone down, with u = 2^-53 and M the
    /// greatest coordinate there is, or the radius. A sphere that passes so near may touch or not.
    double time = std::numeric_limits<double>::infinity();
    /// The sphere touches nothing before, which is proved; at most `time` and the sweep's. 0 where nothing is proved.
    double lower = 0.0;

    [[nodiscard]] bool isFound() const { return time < std::numeric_limits<double>::infinity(); }
};

/// Which point of the surface is asked for.
struct Query {
    /// Finite, and at most 1e150 along each axis.
    glm::dvec3 p{0.0};
    /// Only points at most so far from p count, but for rounding: a distance that was found is enough to find it again. What
    /// was nearest a moment ago is no farther than its distance then and the way that p has gone since: with that as the
    /// radius a search is sooner done.
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

/// A sphere that moves: its centre is at p + t·v at each time t from 0 to `time`.
struct Sweep {
    /// Finite, and at most 1e150 along each axis, both.
    glm::dvec3 p{0.0};
    glm::dvec3 v{0.0};
    /// Not negative; may be infinite.
    double time = 1.0;
    /// Not negative, at most 1e150. A point meets faces, but edges and vertices only as rounding has it.
    double radius = 0.0;
    /// As a query's.
    std::uint64_t nodeBudget = std::numeric_limits<std::uint64_t>::max();
    std::stop_token stop = {};
};

/// Finds points of a surface. It holds what a search needs between queries, so that none allocates once it has grown:
/// one for each thread. The collider that made it must outlive it.
class Search
{
public:
    virtual ~Search() = default;

    /// The nearest point of the surface to p, or of what it comes nearer to. Of several that are equally near, but for
    /// rounding, it is always the same one.
    virtual void closest(const Query &query, Hit &hit) = 0;

    /// The first touch of a sphere that moves. One that overlaps the surface from the start touches at once, at one of the
    /// points that it overlaps; a start that is farther than the radius by rounding alone is as good as one. Where it ends
    /// early it promises an UpperBound.
    virtual void sweep(const Sweep &sweep, Touch &touch) = 0;
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

    /// A search of what a state of the graph leads to alone, in the state's frame or as a map places that. Addresses begin
    /// at the state. Null for kinds that do not go down a graph state by state.
    [[nodiscard]] virtual std::unique_ptr<Search> searchBelow(const Positions &, const std::optional<AffineMap> &) const
    {
        return nullptr;
    }

    /// Bytes held beside the mesh and the graph.
    [[nodiscard]] virtual std::size_t memoryUse() const = 0;
};

}
