// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include <glm/vec3.hpp>

#include "collider.h"
#include "core/fractal/boxbounds.h"
#include "core/fractal/fractalgraph.h"
#include "core/fractal/statetable.h"
#include "core/geometry/mesh.h"
#include "core/geometry/raytriangle.h"
#include "facetree.h"
#include "raybounds.h"

namespace romanesco {

/// A half line of some width, along which something is looked for: from origin + t·direction at the least t to that at the
/// greatest.
struct Ray {
    /// Finite, and at most 1e150 along each axis.
    glm::dvec3 origin{0.0};
    /// Finite and not 0; of any length, which is the unit of t.
    glm::dvec3 direction{0.0, 0.0, 1.0};
    /// least ≤ greatest, which may be infinite. Where nothing spreads the least may be negative: what the line meets first
    /// from there on.
    double least = 0.0;
    double greatest = std::numeric_limits<double>::infinity();
    /// Half as wide as it is: width + t·spread, neither negative. What is smaller, seen from the middle of its bound, is one
    /// copy of the base mesh, which the ray meets or misses as if it had no width: so a ray through the middle of a pixel,
    /// as wide as the tolerance of a picture's cut, meets what the picture shows there. 0 goes down to every copy, or to
    /// those that rounding leaves no shape.
    double width = 0.0;
    double spread = 0.0;
    /// The walk ends early once so many nodes were visited, and promises less then: a count, so that answers do not depend
    /// on the machine.
    std::uint64_t nodeBudget = std::numeric_limits<std::uint64_t>::max();
    /// It also ends early when this is asked for.
    std::stop_token stop = {};
};

/// Where a walk begins: what follows a state of the graph, as State describes, at a place. By default the whole fractal in
/// its own coordinates.
struct RayRoot {
    Positions positions{0};
    /// From the state's frame to the ray's: mirrored, sheared, flat.
    AffineMap rayFromState = {};
    /// Only the base mesh in the state's frame, and nothing below it.
    bool isMeshOnly = false;
};

/// What a ray meets first. `point` is in the ray's coordinates; `direction` is the face's normal, against the ray; `address`
/// has the picks below the root. promise: Exact, or UpperBound where the walk ended early.
struct RayHit : SurfacePoint {
    /// Infinite where nothing is met; then only promise, lower and cost mean anything.
    double t = std::numeric_limits<double>::infinity();
    /// Nothing is met before, but for rounding.
    double lower = 0.0;
    /// In the list of roots.
    std::size_t root = 0;
    /// The same picks as the address, each a map of a set.
    std::vector<Step> choices;
    /// Whether the copy stands for all that begins with its address, being smaller than the ray is wide.
    bool isStandIn = false;

    [[nodiscard]] bool isFound() const { return t < std::numeric_limits<double>::infinity(); }
};

/// Makes it say that nothing is met, for nothing.
void clear(RayHit &hit);

/// Finds which face of which copy of a fractal a ray meets first, at any depth: the graph is walked from its roots, nearest
/// bound first, and never written out. Maps are composed from a root on, relative to the ray's origin, in double, so what
/// is near that is exact however far from the origin of coordinates it is.
///
/// Faces are met without gaps between those of a copy that share edges (RayOnTriangles), from both sides; one that the
/// ray runs along is not met. Placing a copy rounds its corners: by some units in the last place, for each level, of the
/// greatest coordinate on the way down, seen from the ray's origin. Copies smaller than some 1e-14 of that stand for all
/// below them, whatever the width.
///
/// With the width of a pixel a ray visits as many nodes however deep the fractal is: 10 to 250 on average on the examples,
/// some thousands past a thicket, at a quarter of a microsecond, or for each of twenty children a thirtieth. It holds 200
/// bytes for each node that it visited, and 40 for each that it kept, until the next ray. One thread uses it.
class RayWalk
{
public:
    /// All must outlive it; boxes and tree are of that graph and mesh.
    RayWalk(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &mesh, const FaceTree &tree);

    /// Of hits that are equally near it is always the same one. Takes no new memory once it has grown, but where sets
    /// share maps.
    void cast(const Ray &ray, std::span<const RayRoot> roots, RayHit &hit);

    [[nodiscard]] std::size_t memoryUse() const;

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// A copy of a state that was reached.
    struct Frame {
        AffineMap map;
        /// At least the operator norm of the map.
        double norm = 0.0;
        /// The greatest coordinate that was rounded on the way down, and in how many maps.
        double magnitude = 0.0;
        std::uint32_t depth = 0;
        /// None for a root.
        std::uint32_t parent = none;
        Step choice = {};
        StateId state = 0;
        bool isMeshOnly = false;
    };
    /// A child of a frame, or a root's own frame, that the ray may meet at a way and not before.
    struct Open {
        double way = 0.0;
        std::uint32_t frame = 0;
        double magnitude = 0.0;
        Step choice = {};
        StateId state = 0;
        bool isRoot = false;
        /// It is narrower than the ray.
        bool isSmall = false;
    };
    /// The nearest face so far.
    struct Best {
        double way = std::numeric_limits<double>::infinity();
        std::uint32_t frame = none;
        std::uint32_t face = 0;
        Triangle triangle{};
        bool isStandIn = false;
    };

    void begin(const Ray &ray, std::span<const RayRoot> roots);
    [[nodiscard]] Frame rootFrame(const RayRoot &root, const glm::dvec3 &origin);
    void openRoot(std::uint32_t number);
    [[nodiscard]] const Sphere &boundOf(const Frame &frame) const;
    [[nodiscard]] static double errorOf(const Frame &frame);
    [[nodiscard]] double smallAt(double way, double magnitude) const;
    [[nodiscard]] double greatestSmall(const Sphere &bound, double magnitude) const;
    void open(Open child, const Sphere &bound, double error);
    [[nodiscard]] bool isReached(const WaySpan &ways) const;
    [[nodiscard]] Open takeNearest();
    [[nodiscard]] std::uint32_t frameOf(const Open &open);
    void visit(const Open &open);
    void openChildren(std::uint32_t number);
    void measure(std::uint32_t frame, const AffineMap &map, bool isStandIn);
    void measureFace(std::uint32_t frame, const AffineMap &map, std::uint32_t face, bool isStandIn);
    [[nodiscard]] const Box &boxOf(StateId state);
    void report(const Ray &ray, RayHit &hit);
    void reportPicks(RayHit &hit);
    [[nodiscard]] std::size_t memoryOfStates() const;

    const FractalGraph &m_graph;
    const BoxBounds &m_boxes;
    const Mesh &m_mesh;
    const FaceTree &m_tree;
    StateTable m_table;
    /// By state; those that were not asked for are nothing.
    std::vector<std::optional<Box>> m_boxOfState;

    /// The ray, in the unit of the walk: where all that it begins with, and the way there, is about 1.
    double m_unit = 1.0;
    glm::dvec3 m_direction{0.0};
    double m_wayOfT = 1.0;
    double m_least = 0.0;
    double m_width = 0.0;
    double m_spread = 0.0;
    std::optional<RayOnTriangles> m_onTriangles;

    /// The roots first.
    std::vector<Frame> m_frames;
    /// A heap, the nearest on top.
    std::vector<Open> m_open;
    struct Waiting {
        double way;
        std::uint32_t node;
    };
    std::array<Waiting, FaceTree::mostDepth> m_waiting;
    Best m_best;
    SearchCost m_cost;
    std::vector<Positions> m_reached;
};

}
