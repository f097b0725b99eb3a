// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Points in lanes, for what is compiled once for each set of instructions: it is included as often.
#if defined(ROMANESCO_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ROMANESCO_LANES_INL_H
#undef ROMANESCO_LANES_INL_H
#else
#define ROMANESCO_LANES_INL_H
#endif

#include <array>
#include <cstddef>

#include <hwy/highway.h>

#include "core/collide/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace romanesco::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, laneCount>;
using Vector = hn::Vec<Tag>;

/// Three coordinates.
struct Point {
    Vector x;
    Vector y;
    Vector z;
};

/// From anywhere: vectors of lanes by themselves are not aligned.
HWY_INLINE Point load(const LanesOfPoint &lanes, std::size_t lane)
{
    const Tag tag;
    return {hn::LoadU(tag, lanes[0].data() + lane), hn::LoadU(tag, lanes[1].data() + lane),
            hn::LoadU(tag, lanes[2].data() + lane)};
}

HWY_INLINE void store(const Point &v, LanesOfPoint &lanes, std::size_t lane)
{
    const Tag tag;
    hn::Store(v.x, tag, lanes[0].data() + lane);
    hn::Store(v.y, tag, lanes[1].data() + lane);
    hn::Store(v.z, tag, lanes[2].data() + lane);
}

HWY_INLINE Point same(const glm::dvec3 &v)
{
    const Tag tag;
    return {hn::Set(tag, v.x), hn::Set(tag, v.y), hn::Set(tag, v.z)};
}

/// Multiply, then add: a fused one has other bits.
HWY_INLINE Vector dot(const Point &a, const Point &b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Point cross(const Point &a, const Point &b)
{
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

HWY_INLINE Point sum(const Point &a, const Point &b)
{
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

HWY_INLINE Point difference(const Point &a, const Point &b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Point times(const Point &a, Vector factor)
{
    return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

template<typename Mask>
HWY_INLINE Point choose(Mask isFirst, const Point &first, const Point &second)
{
    return {hn::IfThenElse(isFirst, first.x, second.x), hn::IfThenElse(isFirst, first.y, second.y),
            hn::IfThenElse(isFirst, first.z, second.z)};
}

/// 0 of 0.
HWY_INLINE Vector inverseOf(Vector x)
{
    const Tag tag;
    return hn::IfThenElseZero(hn::Gt(x, hn::Zero(tag)), hn::Div(hn::Set(tag, 1.0), x));
}

/// An affine map, the same for all lanes.
class Map
{
public:
    explicit HWY_INLINE Map(const AffineMap &map)
        : m_columns{same(map.linear[0]), same(map.linear[1]), same(map.linear[2])}
        , m_origin(same(map.translation))
    {
    }

    HWY_INLINE Point operator()(const Point &v) const { return sum(linear(v), m_origin); }

    HWY_INLINE Point linear(const Point &v) const
    {
        return sum(sum(times(m_columns[0], v.x), times(m_columns[1], v.y)), times(m_columns[2], v.z));
    }

private:
    std::array<Point, 3> m_columns;
    Point m_origin;
};

}
HWY_AFTER_NAMESPACE();

#endif
