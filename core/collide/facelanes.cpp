// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Compiled once for each set of instructions: Highway includes this file again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/collide/facelanes.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "core/collide/facelanes.h"
#include "core/collide/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace romanesco::HWY_NAMESPACE {

/// The longest edge of a plain triangle is at most so many times its height.
constexpr double slimmest = 64.0;

void placed(std::span<const CornerLanes> blocks, const AffineMap &map, FaceLanes *faces)
{
    const Tag tag;
    const Map by(map);
    for (const CornerLanes &block : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Point a = by(load(block.corners[0], lane));
            const Point b = by(load(block.corners[1], lane));
            const Point c = by(load(block.corners[2], lane));
            const std::array<Point, 3> edges{difference(b, a), difference(c, a), difference(c, b)};
            Vector longest = hn::Zero(tag);
            store(a, faces->a, lane);
            for (std::size_t i = 0; i < edges.size(); ++i) {
                const Vector square = dot(edges[i], edges[i]);
                longest = hn::Max(longest, square);
                store(edges[i], faces->edges[i], lane);
                store(times(edges[i], inverseOf(square)), faces->perSquare[i], lane);
            }
            const Point normal = cross(edges[0], edges[1]);
            const Vector square = dot(normal, normal);
            const Vector perSquare = inverseOf(square);
            store(times(cross(edges[1], normal), perSquare), faces->shares[0], lane);
            store(times(cross(normal, edges[0]), perSquare), faces->shares[1], lane);
            store(times(normal, hn::Sqrt(perSquare)), faces->normal, lane);
            // NaN is not plain
            const auto isWide = hn::Ge(hn::Mul(square, hn::Set(tag, slimmest * slimmest)), hn::Mul(longest, longest));
            const auto isSized = hn::And(hn::Ge(longest, hn::Set(tag, 1e-140)), hn::Le(longest, hn::Set(tag, 1e140)));
            hn::Store(hn::IfThenElseZero(hn::And(isWide, isSized), hn::Set(tag, 1.0)), tag,
                      faces->isPlain.data() + lane);
        }
        ++faces;
    }
}

void distancesToFaces(std::span<const FaceLanes> blocks, const glm::dvec3 &p, double *distances)
{
    const Tag tag;
    const Vector zero = hn::Zero(tag);
    const Vector one = hn::Set(tag, 1.0);
    const Point point = same(p);
    for (const FaceLanes &faces : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Point fromA = difference(point, load(faces.a, lane));
            const Point ab = load(faces.edges[0], lane);
            const Point fromB = difference(fromA, ab);
            const auto squareTo = [&](std::size_t edge, const Point &from) {
                const Vector along = hn::Min(hn::Max(dot(load(faces.perSquare[edge], lane), from), zero), one);
                const Point way = difference(from, times(load(faces.edges[edge], lane), along));
                return dot(way, way);
            };
            const Vector toEdges = hn::Min(hn::Min(squareTo(0, fromA), squareTo(1, fromA)), squareTo(2, fromB));
            const Vector shareB = dot(load(faces.shares[0], lane), fromA);
            const Vector shareC = dot(load(faces.shares[1], lane), fromA);
            const auto isInside =
                hn::And(hn::And(hn::Ge(shareB, zero), hn::Ge(shareC, zero)), hn::Le(hn::Add(shareB, shareC), one));
            const Vector height = hn::Abs(dot(load(faces.normal, lane), fromA));
            hn::StoreU(hn::IfThenElse(isInside, height, hn::Sqrt(toEdges)), tag, distances + lane);
        }
        distances += laneCount;
    }
}

/// From the nearest point of each triangle, nearly.
HWY_INLINE Point wayFromFaces(const FaceLanes &faces, std::size_t lane, const Point &fromA, const Point &fromB)
{
    const Tag tag;
    const Vector zero = hn::Zero(tag);
    const Vector one = hn::Set(tag, 1.0);
    const auto fromEdge = [&](std::size_t edge, const Point &from) {
        const Vector along = hn::Min(hn::Max(dot(load(faces.perSquare[edge], lane), from), zero), one);
        return difference(from, times(load(faces.edges[edge], lane), along));
    };
    Point nearest = fromEdge(0, fromA);
    Vector least = dot(nearest, nearest);
    for (std::size_t edge = 1; edge < faces.edges.size(); ++edge) {
        const Point way = fromEdge(edge, edge == 1 ? fromA : fromB);
        const Vector square = dot(way, way);
        nearest = choose(hn::Lt(square, least), way, nearest);
        least = hn::Min(square, least);
    }
    const Vector shareB = dot(load(faces.shares[0], lane), fromA);
    const Vector shareC = dot(load(faces.shares[1], lane), fromA);
    const auto isInside =
        hn::And(hn::And(hn::Ge(shareB, zero), hn::Ge(shareC, zero)), hn::Le(hn::Add(shareB, shareC), one));
    const Point normal = load(faces.normal, lane);
    return choose(isInside, times(normal, dot(normal, fromA)), nearest);
}

void waysOfSphere(std::span<const FaceLanes> blocks, const glm::dvec3 &p, const MovingSphere &sphere, double from,
                  double until, double *ways)
{
    constexpr int mostSteps = 8;
    const Tag tag;
    const Vector zero = hn::Zero(tag);
    const Point start = same(p);
    const Point direction = same(sphere.direction);
    const Vector radius = hn::Set(tag, sphere.radius);
    const Vector closeEnough = hn::Set(tag, 1e-3 * sphere.radius);
    const Vector leastSquare = hn::Set(tag, 1e-280); // below, squares are not as precise
    for (const FaceLanes &faces : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Point startFromA = difference(start, load(faces.a, lane));
            const Point ab = load(faces.edges[0], lane);
            const Point ac = load(faces.edges[1], lane);
            Vector way = hn::Set(tag, from);
            // each lane stops for itself, so that its neighbours do not change it
            auto goesOn = hn::Eq(way, way);
            for (int step = 0; step < mostSteps && !hn::AllFalse(tag, goesOn); ++step) {
                const Point fromA = sum(startFromA, times(direction, hn::IfThenElseZero(goesOn, way)));
                const Point fromB = difference(fromA, ab);
                const Point away = wayFromFaces(faces, lane, fromA, fromB);
                // whatever it is, all corners are beyond the plane across it through the one that is least beyond
                const Point fromC = difference(fromA, ac);
                const Vector beyond = hn::Min(hn::Min(dot(away, fromA), dot(away, fromB)), dot(away, fromC));
                const Vector square = dot(away, away);
                const Vector gap = hn::Sub(beyond, hn::Mul(hn::Sqrt(square), radius));
                const Vector closing = hn::Neg(dot(away, direction));
                const Vector more = hn::IfThenElse(hn::Gt(closing, zero), hn::Div(gap, closing), hn::Inf(tag));
                // all false of NaN
                goesOn = hn::And(goesOn,
                                 hn::And(hn::Ge(square, leastSquare), hn::And(hn::Gt(gap, zero), hn::Gt(more, zero))));
                way = hn::Add(way, hn::IfThenElseZero(goesOn, more));
                goesOn = hn::And(goesOn, hn::And(hn::Gt(more, closeEnough), hn::Lt(way, hn::Set(tag, until))));
            }
            hn::StoreU(way, tag, ways + lane);
        }
        ways += laneCount;
    }
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace romanesco {

HWY_EXPORT(placed);
HWY_EXPORT(distancesToFaces);
HWY_EXPORT(waysOfSphere);

std::vector<CornerLanes> cornersOf(const Mesh &mesh)
{
    const std::size_t count = mesh.faces.size();
    std::vector<CornerLanes> blocks(blocksFor(count));
    for (std::size_t i = 0; i < blocks.size() * laneCount; ++i) {
        const Mesh::Face &face = mesh.faces[i < count ? i : count - 1];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            setLane(blocks[i / laneCount].corners[corner], i % laneCount, mesh.vertices[face[corner]]);
        }
    }
    return blocks;
}

void placeFaces(std::span<const CornerLanes> corners, const AffineMap &map, FaceLanes *faces)
{
    HWY_DYNAMIC_DISPATCH(placed)(corners, map, faces);
}

void faceDistances(std::span<const FaceLanes> faces, const glm::dvec3 &p, double *distances)
{
    HWY_DYNAMIC_DISPATCH(distancesToFaces)(faces, p, distances);
}

void waysToFaces(std::span<const FaceLanes> faces, const glm::dvec3 &p, const MovingSphere &sphere, double from,
                 double until, double *ways)
{
    HWY_DYNAMIC_DISPATCH(waysOfSphere)(faces, p, sphere, from, until, ways);
}

}
#endif
