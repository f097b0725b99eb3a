// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Compiled once for each set of instructions: Highway includes this file again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/collide/waylanes.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "core/collide/lanes-inl.h"
#include "core/collide/waylanes.h"

HWY_BEFORE_NAMESPACE();
namespace romanesco::HWY_NAMESPACE {

/// Above 0, and a number: squares of what is too far are none, and prove nothing.
HWY_INLINE auto isSize(Vector x)
{
    const Tag tag;
    return hn::And(hn::Gt(x, hn::Zero(tag)), hn::Lt(x, hn::Inf(tag)));
}

/// The ways between which a coordinate is within a reach of 0.
struct Between {
    Vector enter;
    Vector leave;
};

HWY_INLINE Between between(Vector start, Vector along, Vector reach)
{
    const Tag tag;
    // what goes along a wall has 1 / 0, and 0 times that is no number
    const Vector least = hn::Set(tag, 1e-290);
    const Vector perWay = hn::Div(hn::Set(tag, 1.0), hn::IfThenElse(hn::Lt(hn::Abs(along), least), least, along));
    const Vector one = hn::Mul(hn::Neg(hn::Add(reach, start)), perWay);
    const Vector other = hn::Mul(hn::Sub(reach, start), perWay);
    return {hn::Min(one, other), hn::Max(one, other)};
}

HWY_INLINE Vector wayToGrown(const Point &start, const Point &along, const Point &half, Vector radius)
{
    const Tag tag;
    const Between x = between(start.x, along.x, hn::Add(half.x, radius));
    const Between y = between(start.y, along.y, hn::Add(half.y, radius));
    const Between z = between(start.z, along.z, hn::Add(half.z, radius));
    const Vector enter = hn::Max(hn::Max(x.enter, y.enter), hn::Max(z.enter, hn::Zero(tag)));
    const Vector leave = hn::Min(hn::Min(x.leave, y.leave), z.leave);
    return hn::IfThenElse(hn::Le(enter, leave), enter, hn::Inf(tag));
}

/// How far outside a box a coordinate is, either way.
HWY_INLINE Vector outside(Vector at, Vector half)
{
    const Tag tag;
    return hn::CopySign(hn::Max(hn::Sub(hn::Abs(at), half), hn::Zero(tag)), at);
}

/// The grown box has corners, where a sphere is round: wayTo() for BoxBody, seen from the box's middle.
HWY_INLINE Vector wayToRound(const Point &start, const Point &along, const Point &half, Vector radius)
{
    constexpr int mostSteps = 24;
    const Tag tag;
    const Vector zero = hn::Zero(tag);
    const Vector closeEnough = hn::Mul(hn::Set(tag, 1e-4), radius);
    Vector way = wayToGrown(start, along, half, radius);
    // each lane stops for itself, so that its neighbours do not change it
    auto goesOn = hn::Lt(way, hn::Inf(tag));
    for (int step = 0; step < mostSteps && !hn::AllFalse(tag, goesOn); ++step) {
        const Point at = sum(start, times(along, hn::IfThenElseZero(goesOn, way)));
        const Point off{outside(at.x, half.x), outside(at.y, half.y), outside(at.z, half.z)};
        const Vector length = hn::Sqrt(dot(off, off));
        const Vector gap = hn::Sub(length, radius);
        const Vector closing = hn::Neg(dot(off, along));
        const Vector more = hn::IfThenElse(hn::Gt(closing, zero), hn::Div(hn::Mul(gap, length), closing), hn::Inf(tag));
        goesOn = hn::And(goesOn, isSize(gap));
        way = hn::Add(way, hn::IfThenElseZero(goesOn, more));
        // as there: where it nearly glides along, steps that are long lead to little
        const auto isFar = hn::Gt(hn::Mul(more, length), hn::Mul(closeEnough, closing));
        goesOn = hn::And(goesOn, hn::And(isFar, hn::Lt(way, hn::Inf(tag))));
    }
    return way;
}

void waysToTurned(std::span<const TurnedBoxes> blocks, const glm::dvec3 &p, const MovingSphere &sphere, double *ways)
{
    const Tag tag;
    const Point point = same(p);
    const Point direction = same(sphere.direction);
    const Vector radius = hn::Set(tag, sphere.radius);
    for (const TurnedBoxes &boxes : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const std::array<Point, 3> turned{load(boxes.turned[0], lane), load(boxes.turned[1], lane),
                                              load(boxes.turned[2], lane)};
            const Point start =
                sum({dot(turned[0], point), dot(turned[1], point), dot(turned[2], point)}, load(boxes.offset, lane));
            const Point along{dot(turned[0], direction), dot(turned[1], direction), dot(turned[2], direction)};
            hn::StoreU(wayToRound(start, along, load(boxes.half, lane), radius), tag, ways + lane);
        }
        ways += laneCount;
    }
}

HWY_INLINE Point sizes(const Point &v)
{
    return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}

void waysToPlaced(std::span<const Parallelepipeds> blocks, const AffineMap &map, const MovingSphere &sphere,
                  double *ways)
{
    const Tag tag;
    const Map placed(map);
    const Point direction = same(sphere.direction);
    const Vector radius = hn::Set(tag, sphere.radius);
    for (const Parallelepipeds &boxes : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Point middle = placed(load(boxes.middle, lane));
            const Point half = sum(
                sum(sizes(placed.linear(load(boxes.edges[0], lane))), sizes(placed.linear(load(boxes.edges[1], lane)))),
                sizes(placed.linear(load(boxes.edges[2], lane))));
            const Point start = difference(same(glm::dvec3(0.0)), middle);
            hn::StoreU(wayToGrown(start, direction, half, radius), tag, ways + lane);
        }
        ways += laneCount;
    }
}

/// towards: the way from where the sphere is to the centre; inHull: the same, as the corners see it.
HWY_INLINE Vector wayToHull(const HullsOfFew &hulls, std::size_t lane, const Point &towards, const Point &inHull,
                            const Point &along, Vector norm, Vector radius, Vector way)
{
    const Tag tag;
    const Vector zero = hn::Zero(tag);
    Vector least = hn::Inf(tag);
    for (std::size_t i = 0; i < hulls.cornersUsed; ++i) {
        const LanesOfPoint &corner = hulls.corners[i];
        least = hn::Min(least, dot(load(corner, lane), inHull));
    }
    const Vector length = hn::Sqrt(dot(towards, towards));
    const Vector error = hn::Mul(hn::Load(tag, hulls.error.data() + lane), norm);
    // in units of the length
    const Vector gap = hn::Sub(hn::Add(hn::Mul(length, length), least), hn::Mul(length, hn::Add(error, radius)));
    const Vector closing = dot(towards, along);
    const Vector more = hn::IfThenElse(hn::Gt(closing, zero), hn::Div(gap, closing), hn::Inf(tag));
    return hn::Add(way, hn::IfThenElseZero(isSize(gap), more));
}

void raiseToTurned(const HullsOfFew &hulls, const glm::dvec3 &p, const MovingSphere &sphere, double *ways)
{
    const Tag tag;
    const Point point = same(p);
    const Point along = same(sphere.direction);
    for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
        const Vector way = hn::LoadU(tag, ways + lane);
        const Point at = sum(point, times(along, hn::IfThenZeroElse(hn::IsInf(way), way)));
        const Point towards = difference(load(hulls.centre, lane), at);
        hn::StoreU(wayToHull(hulls, lane, towards, towards, along, hn::Set(tag, 1.0), hn::Set(tag, sphere.radius), way),
                   tag, ways + lane);
    }
}

void raiseToPlaced(const HullsOfFew &hulls, const AffineMap &map, double norm, const MovingSphere &sphere, double *ways)
{
    const Tag tag;
    const Map placed(map);
    const std::array<Point, 3> columns{same(map.linear[0]), same(map.linear[1]), same(map.linear[2])};
    const Point along = same(sphere.direction);
    for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
        const Vector way = hn::LoadU(tag, ways + lane);
        const Point at = times(along, hn::IfThenZeroElse(hn::IsInf(way), way));
        const Point towards = difference(placed(load(hulls.centre, lane)), at);
        const Point inHull{dot(columns[0], towards), dot(columns[1], towards), dot(columns[2], towards)};
        hn::StoreU(wayToHull(hulls, lane, towards, inHull, along, hn::Set(tag, norm), hn::Set(tag, sphere.radius), way),
                   tag, ways + lane);
    }
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace romanesco {

HWY_EXPORT(waysToTurned);
HWY_EXPORT(waysToPlaced);
HWY_EXPORT(raiseToTurned);
HWY_EXPORT(raiseToPlaced);

void waysTo(std::span<const TurnedBoxes> boxes, const glm::dvec3 &p, const MovingSphere &sphere, double *ways)
{
    HWY_DYNAMIC_DISPATCH(waysToTurned)(boxes, p, sphere, ways);
}

void waysTo(std::span<const Parallelepipeds> boxes, const AffineMap &map, const MovingSphere &sphere, double *ways)
{
    HWY_DYNAMIC_DISPATCH(waysToPlaced)(boxes, map, sphere, ways);
}

void raiseToHulls(const HullsOfFew &hulls, const glm::dvec3 &p, const MovingSphere &sphere, double *ways)
{
    HWY_DYNAMIC_DISPATCH(raiseToTurned)(hulls, p, sphere, ways);
}

void raiseToHulls(const HullsOfFew &hulls, const AffineMap &map, double norm, const MovingSphere &sphere, double *ways)
{
    HWY_DYNAMIC_DISPATCH(raiseToPlaced)(hulls, map, norm, sphere, ways);
}

}
#endif
