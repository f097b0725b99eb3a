// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Compiled once for each set of instructions: Highway includes this file again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/collide/lanes.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <limits>

#include <hwy/highway.h>

#include "core/collide/lanes-inl.h"
#include "core/collide/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace romanesco::HWY_NAMESPACE {

void distancesToTurned(std::span<const TurnedBoxes> blocks, const glm::dvec3 &p, double *distances)
{
    const Tag tag;
    const Point point = same(p);
    const auto outside = [&](Vector along, Vector half) {
        return hn::Max(hn::Sub(hn::Abs(along), half), hn::Zero(tag));
    };
    for (const TurnedBoxes &boxes : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Point turned{dot(load(boxes.turned[0], lane), point), dot(load(boxes.turned[1], lane), point),
                               dot(load(boxes.turned[2], lane), point)};
            const Point way = sum(turned, load(boxes.offset, lane));
            const Point half = load(boxes.half, lane);
            const Point least{outside(way.x, half.x), outside(way.y, half.y), outside(way.z, half.z)};
            hn::StoreU(hn::Sqrt(dot(least, least)), tag, distances + lane);
        }
        distances += laneCount;
    }
}

HWY_INLINE Vector distanceToOrigin(const Point &middle, const std::array<Point, 3> &edges)
{
    const Tag tag;
    const Vector zero = hn::Zero(tag);
    const Vector one = hn::Set(tag, 1.0);
    std::array<Vector, 3> perSquare{zero, zero, zero};
    for (std::size_t i = 0; i < 3; ++i) {
        perSquare[i] = inverseOf(dot(edges[i], edges[i]));
    }
    Point nearest = middle;
    std::array<Vector, 3> along{zero, zero, zero};
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector wanted = hn::Sub(along[i], hn::Mul(dot(nearest, edges[i]), perSquare[i]));
            const Vector next = hn::Min(hn::Max(wanted, hn::Neg(one)), one);
            nearest = sum(nearest, times(edges[i], hn::Sub(next, along[i])));
            along[i] = next;
        }
    }
    const Vector length = hn::Sqrt(dot(nearest, nearest));
    Vector reach = dot(nearest, middle);
    for (const Point &edge : edges) {
        reach = hn::Sub(reach, hn::Abs(dot(nearest, edge)));
    }
    const auto isOutside = hn::And(hn::Gt(length, zero), hn::Gt(reach, zero));
    return hn::IfThenElseZero(isOutside, hn::Div(reach, length));
}

void distancesToPlaced(std::span<const Parallelepipeds> blocks, const AffineMap &map, double *distances)
{
    const Tag tag;
    const Map placed(map);
    for (const Parallelepipeds &boxes : blocks) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Point middle = placed(load(boxes.middle, lane));
            const std::array<Point, 3> edges{placed.linear(load(boxes.edges[0], lane)),
                                             placed.linear(load(boxes.edges[1], lane)),
                                             placed.linear(load(boxes.edges[2], lane))};
            hn::StoreU(distanceToOrigin(middle, edges), tag, distances + lane);
        }
        distances += laneCount;
    }
}

std::size_t numberOfLeast(std::span<const double> numbers)
{
    const Tag tag;
    const std::size_t lanes = hn::Lanes(tag);
    const std::size_t whole = numbers.size() - numbers.size() % lanes;
    Vector least = hn::Inf(tag);
    for (std::size_t i = 0; i < whole; i += lanes) {
        least = hn::Min(least, hn::LoadU(tag, numbers.data() + i));
    }
    double leastOfAll = hn::ReduceMin(tag, least);
    for (std::size_t i = whole; i < numbers.size(); ++i) {
        leastOfAll = numbers[i] < leastOfAll ? numbers[i] : leastOfAll;
    }
    const Vector sought = hn::Set(tag, leastOfAll);
    for (std::size_t i = 0; i < whole; i += lanes) {
        const auto found = hn::FindFirstTrue(tag, hn::Eq(hn::LoadU(tag, numbers.data() + i), sought));
        if (found >= 0) {
            return i + static_cast<std::size_t>(found);
        }
    }
    std::size_t i = whole;
    while (numbers[i] != leastOfAll) {
        ++i;
    }
    return i;
}

std::size_t numberOfLeastAlong(std::span<const LanesOfPoint> points, const glm::dvec3 &direction)
{
    const Tag tag;
    const Point along = same(direction);
    double least = std::numeric_limits<double>::infinity();
    std::size_t number = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
            const Vector products = dot(load(points[i], lane), along);
            const double leastHere = hn::ReduceMin(tag, products);
            if (leastHere < least) {
                least = leastHere;
                const auto found = hn::FindFirstTrue(tag, hn::Eq(products, hn::Set(tag, leastHere)));
                number = i * laneCount + lane + static_cast<std::size_t>(found);
            }
        }
    }
    return number;
}

/// along: the way from the centre, as the corners see it.
HWY_INLINE void raise(const HullsOfFew &hulls, std::size_t lane, Vector length, const Point &along, Vector norm,
                      double *distances)
{
    const Tag tag;
    Vector reach = hn::Neg(hn::Inf(tag));
    for (std::size_t i = 0; i < hulls.cornersUsed; ++i) {
        reach = hn::Max(reach, dot(load(hulls.corners[i], lane), along));
    }
    const Vector error = hn::Mul(hn::Load(tag, hulls.error.data() + lane), norm);
    const Vector distance = hn::Sub(hn::Sub(length, hn::Div(reach, length)), error);
    const Vector before = hn::LoadU(tag, distances + lane);
    // from the centre itself nothing is seen
    const auto isFarther = hn::And(hn::Gt(length, hn::Zero(tag)), hn::Gt(distance, before));
    hn::StoreU(hn::IfThenElse(isFarther, distance, before), tag, distances + lane);
}

void raiseToTurned(const HullsOfFew &hulls, const glm::dvec3 &p, double *distances)
{
    const Tag tag;
    const Point point = same(p);
    for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
        const Point way = difference(point, load(hulls.centre, lane));
        raise(hulls, lane, hn::Sqrt(dot(way, way)), way, hn::Set(tag, 1.0), distances);
    }
}

void raiseToPlaced(const HullsOfFew &hulls, const AffineMap &map, double norm, double *distances)
{
    const Tag tag;
    const Map placed(map);
    const Point x = same(map.linear[0]);
    const Point y = same(map.linear[1]);
    const Point z = same(map.linear[2]);
    for (std::size_t lane = 0; lane < laneCount; lane += hn::Lanes(tag)) {
        const Point centre = placed(load(hulls.centre, lane));
        const Point along{hn::Neg(dot(x, centre)), hn::Neg(dot(y, centre)), hn::Neg(dot(z, centre))};
        raise(hulls, lane, hn::Sqrt(dot(centre, centre)), along, hn::Set(tag, norm), distances);
    }
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace romanesco {

HWY_EXPORT(distancesToTurned);
HWY_EXPORT(distancesToPlaced);
HWY_EXPORT(numberOfLeast);
HWY_EXPORT(numberOfLeastAlong);
HWY_EXPORT(raiseToTurned);
HWY_EXPORT(raiseToPlaced);

void distancesTo(std::span<const TurnedBoxes> boxes, const glm::dvec3 &p, double *distances)
{
    HWY_DYNAMIC_DISPATCH(distancesToTurned)(boxes, p, distances);
}

void distancesTo(std::span<const Parallelepipeds> boxes, const AffineMap &map, double *distances)
{
    HWY_DYNAMIC_DISPATCH(distancesToPlaced)(boxes, map, distances);
}

std::size_t leastOf(std::span<const double> numbers)
{
    return HWY_DYNAMIC_DISPATCH(numberOfLeast)(numbers);
}

std::size_t leastAlong(std::span<const LanesOfPoint> points, const glm::dvec3 &direction)
{
    return HWY_DYNAMIC_DISPATCH(numberOfLeastAlong)(points, direction);
}

void raiseToHulls(const HullsOfFew &hulls, const glm::dvec3 &p, double *distances)
{
    HWY_DYNAMIC_DISPATCH(raiseToTurned)(hulls, p, distances);
}

void raiseToHulls(const HullsOfFew &hulls, const AffineMap &map, double norm, double *distances)
{
    HWY_DYNAMIC_DISPATCH(raiseToPlaced)(hulls, map, norm, distances);
}

}
#endif
