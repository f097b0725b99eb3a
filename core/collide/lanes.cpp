// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Compiled once for each set of instructions: Highway includes this file again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/collide/lanes.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "core/collide/lanes-inl.h"
#include "core/collide/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace romanesco::HWY_NAMESPACE {

using Corners = std::array<std::array<double, cornerCount>, 3>;

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

double greatestAlong(const Corners &points, const glm::dvec3 &direction)
{
    const Tag tag;
    const Point along = same(direction);
    Vector farthest = hn::Neg(hn::Inf(tag));
    for (std::size_t i = 0; i < cornerCount; i += hn::Lanes(tag)) {
        const Point point{hn::LoadU(tag, points[0].data() + i), hn::LoadU(tag, points[1].data() + i),
                          hn::LoadU(tag, points[2].data() + i)};
        farthest = hn::Max(farthest, dot(point, along));
    }
    return hn::ReduceMax(tag, farthest);
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace romanesco {

HWY_EXPORT(distancesToTurned);
HWY_EXPORT(distancesToPlaced);
HWY_EXPORT(numberOfLeast);
HWY_EXPORT(greatestAlong);

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

double farthestAlong(const std::array<std::array<double, cornerCount>, 3> &points, const glm::dvec3 &direction)
{
    return HWY_DYNAMIC_DISPATCH(greatestAlong)(points, direction);
}

}
#endif
