// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/movingsphere.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "core/geometry/hull.h"
#include "tests/core/geometry/triangles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

RealVector at(const Real &way, const glm::dvec3 &direction)
{
    return {way * Real(direction.x), way * Real(direction.y), way * Real(direction.z)};
}

/// Where a convex function is least in [0, end]: golden sections.
template<typename F>
Real leastOf(const F &f, const Real &end)
{
    const Real share = (sqrt(Real(5)) - 1) / 2;
    Real from = 0;
    Real to = end;
    Real left = to - share * (to - from);
    Real right = from + share * (to - from);
    Real fLeft = f(left);
    Real fRight = f(right);
    for (int i = 0; i < 100; ++i) {
        if (fLeft <= fRight) {
            to = right;
            right = left;
            fRight = fLeft;
            left = to - share * (to - from);
            fLeft = f(left);
        } else {
            from = left;
            left = right;
            fLeft = fRight;
            right = from + share * (to - from);
            fRight = f(right);
        }
    }
    return fLeft <= fRight ? left : right;
}

/// A convex function's least value in [0, end], and where it first comes down to a height; infinite where it does not.
struct First {
    Real least;
    Real way;
};
template<typename F>
First firstAt(const F &f, const Real &height, const Real &end)
{
    const Real bottom = leastOf(f, end);
    const Real least = std::min({f(bottom), f(Real(0)), f(end)});
    if (f(Real(0)) <= height) {
        return {least, 0};
    }
    if (least > height) {
        return {least, infinity};
    }
    Real above = 0;
    Real below = f(bottom) <= height ? bottom : end;
    for (int i = 0; i < 110; ++i) {
        const Real middle = (above + below) / 2;
        (f(middle) > height ? above : below) = middle;
    }
    return {least, below};
}

struct Shot {
    Triangle triangle{};
    MovingSphere sphere;
};

double sizeOf(const Shot &shot)
{
    return std::max(largestOffset(shot.triangle, glm::dvec3(0.0)), shot.sphere.radius);
}

Real distanceAt(const Shot &shot, const Real &way)
{
    return truth::distance<Real>({exact(shot.triangle[0]), exact(shot.triangle[1]), exact(shot.triangle[2])},
                                 at(way, shot.sphere.direction));
}

glm::dvec3 pointOf(const Triangle &triangle, Draw &draw)
{
    switch (static_cast<int>(draw.number(0, 3))) {
    case 0:
        return triangle[static_cast<std::size_t>(draw.number(0, 3))];
    case 1: {
        const auto i = static_cast<std::size_t>(draw.number(0, 3));
        return triangle[i] + draw.number(0, 1) * (triangle[(i + 1) % 3] - triangle[i]);
    }
    default: {
        const double s = draw.number(0, 1);
        const double t = draw.number(0, 1 - s);
        return (1 - s - t) * triangle[0] + s * triangle[1] + t * triangle[2];
    }
    }
}

/// At any point, past it, or past it at a distance of about the radius.
Shot randomShot(Shape shape, Draw &draw)
{
    auto [triangle, p] = trianglePoint(shape, draw);
    const double size = largestOffset(triangle, p);
    const double radius = draw.number(0, 1) < 0.1 ? 0.0 : size * draw.size(-9, 1);
    glm::dvec3 direction = glm::normalize(draw.vector());
    const glm::dvec3 target = pointOf(triangle, draw);
    if (draw.number(0, 1) < 0.7) {
        const double amiss =
            draw.number(0, 1) < 0.5 ? draw.number(0, 1.2) : 1.0 + draw.number(-1, 1) * draw.size(-18, -1);
        const glm::dvec3 across = glm::normalize(glm::cross(direction, draw.vector()));
        const double back = std::max(radius, size) * draw.size(-1, 2);
        p = target + amiss * radius * across - back * direction;
    } else if (draw.number(0, 1) < 0.7 && target != p) {
        direction = glm::normalize(target - p);
    }
    if (draw.number(0, 1) < 0.03) {
        direction = glm::dvec3(0.0);
    }
    return {{triangle[0] - p, triangle[1] - p, triangle[2] - p}, {direction, radius}};
}

void requireFirstTouch(const Shot &shot)
{
    const TriangleTouch found = touch(shot.triangle, shot.sphere);
    const double size = sizeOf(shot);
    const auto distance = [&](const Real &way) { return distanceAt(shot, way); };
    const First first = firstAt(distance, Real(shot.sphere.radius), Real(8 * size));
    const Real margin = Real(size) * 128 * 0x1p-53;
    if (!found.isTouch) {
        RC_ASSERT(found.way == infinity);
        RC_ASSERT(first.least > shot.sphere.radius);
        return;
    }
    RC_ASSERT(Real(found.way) <= first.way);
    const Real excess = distanceAt(shot, found.way) - shot.sphere.radius;
    RC_ASSERT(excess <= margin);
    const Contact contact = contactAt(found.way, shot.triangle, shot.sphere);
    const glm::dvec3 centre = found.way * shot.sphere.direction;
    RC_ASSERT(std::abs(glm::length(contact.direction) - 1.0) < 1e-14);
    RC_ASSERT(trueDistance(shot.triangle, contact.point) <= Real(margin));
    const Real length = distanceAt(shot, found.way);
    RC_ASSERT(abs(Real(glm::distance(contact.point, centre)) - length) <= margin);
    if (length > margin) {
        const glm::dvec3 way = (centre - contact.point) / static_cast<double>(length);
        RC_ASSERT(glm::distance(way, contact.direction) <= static_cast<double>(margin / length));
    } else if (shot.sphere.direction != glm::dvec3(0.0)) {
        RC_ASSERT(glm::dot(contact.direction, shot.sphere.direction) <= 1e-15);
    }
}

Real distanceToBox(const Box &box, const RealVector &p)
{
    Real square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Real &x = p[static_cast<std::size_t>(axis)];
        const Real outside = std::max({Real(box.least[axis]) - x, x - Real(box.greatest[axis]), Real(0)});
        square += outside * outside;
    }
    return sqrt(square);
}

std::array<glm::dvec3, 8> cornersOf(const ParallelepipedBody &body)
{
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        corners[i] = body.middle;
        for (unsigned j = 0; j < 3; ++j) {
            corners[i] += (i >> j & 1u) != 0 ? body.halfEdges[j] : -body.halfEdges[j];
        }
    }
    return corners;
}

}

class TestMovingSphere : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstTouchIsFound_data();
    void theFirstTouchIsFound();
    void sizesMayBeExtreme();
    void verticesMayStandInAnyOrder();
    void whatIsBeyondIsNotLookedFor();
    void touchesAreAsReckoned();
    void aPointMeetsFaces();
    void boxesAreMetWhereTheyAre();
    void planesHaveTheBodyBehindThem();
};

void TestMovingSphere::theFirstTouchIsFound_data()
{
    addShapes();
}

void TestMovingSphere::theFirstTouchIsFound()
{
    QFETCH(Shape, shape);
    QVERIFY(rc::check([shape](std::uint32_t seed) {
        Draw draw(seed);
        for (int i = 0; i < 2; ++i) {
            requireFirstTouch(randomShot(shape, draw));
        }
    }));
}

void TestMovingSphere::sizesMayBeExtreme()
{
    QVERIFY(rc::check([](std::uint32_t seed) {
        Draw draw(seed);
        const int exponent = static_cast<int>(draw.number(-490, 490));
        Shot shot = randomShot(Shape::Plain, draw);
        const TriangleTouch plain = touch(shot.triangle, shot.sphere);
        for (glm::dvec3 &vertex : shot.triangle) {
            vertex *= std::ldexp(1.0, exponent);
        }
        shot.sphere.radius *= std::ldexp(1.0, exponent);
        requireFirstTouch(shot);
        RC_ASSERT(touch(shot.triangle, shot.sphere).isTouch == plain.isTouch
                  || distanceAt(shot, shot.sphere.radius) > 0); // grazing
    }));
}

void TestMovingSphere::verticesMayStandInAnyOrder()
{
    QVERIFY(rc::check([](std::uint32_t seed) {
        Draw draw(seed);
        Shot shot = randomShot(Shape::Plain, draw);
        std::ranges::sort(shot.triangle, {}, [](const glm::dvec3 &v) { return v.x; });
        const Triangle triangle = shot.triangle;
        std::array<std::size_t, 3> order{0, 1, 2};
        do {
            shot.triangle = {triangle[order[0]], triangle[order[1]], triangle[order[2]]};
            requireFirstTouch(shot);
        } while (std::ranges::next_permutation(order).found);
    }));
}

void TestMovingSphere::whatIsBeyondIsNotLookedFor()
{
    QVERIFY(rc::check([](std::uint32_t seed) {
        Draw draw(seed);
        const Shot shot = randomShot(Shape::Plain, draw);
        const TriangleTouch whole = touch(shot.triangle, shot.sphere);
        if (!whole.isTouch || whole.way == 0.0) {
            return;
        }
        const double margin = 1e-9 * sizeOf(shot) * (1.0 + sizeOf(shot) / shot.sphere.radius);
        const TriangleTouch within = touch(shot.triangle, shot.sphere, 0.0, whole.way + margin);
        RC_ASSERT(within.isTouch && within.way == whole.way);
        const double until = draw.number(0.0, 0.999) * whole.way;
        const TriangleTouch before = touch(shot.triangle, shot.sphere, 0.0, until);
        RC_ASSERT(!before.isTouch && before.way > until);
        const auto distance = [&](const Real &way) { return distanceAt(shot, way); };
        RC_ASSERT(before.way == infinity || distance(before.way) > Real(shot.sphere.radius)
                  || before.way <= whole.way * (1 + 1e-12));
        const TriangleTouch later = touch(shot.triangle, shot.sphere, until);
        RC_ASSERT(later.isTouch && distanceAt(shot, later.way) <= shot.sphere.radius + 1e-13 * sizeOf(shot));
    }));
}

void TestMovingSphere::touchesAreAsReckoned()
{
    const Triangle triangle{glm::dvec3(0, 0, 5), glm::dvec3(4, 0, 5), glm::dvec3(0, 4, 5)};
    const auto from = [&](double x, double y, double z, double radius, const glm::dvec3 &direction) {
        const glm::dvec3 p(x, y, z);
        return touch({triangle[0] - p, triangle[1] - p, triangle[2] - p}, {direction, radius});
    };
    const auto isAt = [](const TriangleTouch &found, double way) {
        return found.isTouch && std::abs(found.way - way) < 1e-13;
    };
    const glm::dvec3 forward(0, 0, 1);
    QVERIFY(isAt(from(1, 1, 0, 2, forward), 3));      // the face
    QVERIFY(isAt(from(1, -3, 0, 5, forward), 1));     // an edge: 5² = 3² + 4²
    QVERIFY(isAt(from(-3, -4, 0, 13, forward), 0));   // a vertex, at 5·√2 already
    QVERIFY(isAt(from(-3, -4, -10, 13, forward), 3)); // 13² = 3² + 4² + 12²
    QVERIFY(isAt(from(1, 1, 6, 0.5, -forward), 0.5)); // from behind
    QVERIFY(!from(1, 1, 6, 0.5, forward).isTouch);    // away
    QVERIFY(!from(-3, 0, 0, 2.999, forward).isTouch); // past it
    QVERIFY(from(-3, 0, 0, 3.001, forward).isTouch);
    QVERIFY(isAt(from(-3, 1, 5, 1, {1, 0, 0}), 2));      // in its plane
    QVERIFY(isAt(from(1, 1, 4, 1.5, forward), 0));       // it overlaps
    QVERIFY(isAt(from(1, 1, 4, 1.5, glm::dvec3(0)), 0)); // and rests
    QVERIFY(!from(1, 1, 4, 0.5, glm::dvec3(0)).isTouch);
}

void TestMovingSphere::aPointMeetsFaces()
{
    Draw draw(1);
    for (int i = 0; i < 10'000; ++i) {
        const Triangle triangle{draw.vector(), draw.vector(), draw.vector()};
        const double s = draw.number(0.01, 0.98);
        const double t = draw.number(0.005, 0.995 - s);
        const glm::dvec3 target = (1 - s - t) * triangle[0] + s * triangle[1] + t * triangle[2];
        const glm::dvec3 p = draw.vector(10);
        const Shot shot{{triangle[0] - p, triangle[1] - p, triangle[2] - p}, {glm::normalize(target - p), 0.0}};
        const TriangleTouch found = touch(shot.triangle, shot.sphere);
        QVERIFY(found.isTouch && distanceAt(shot, found.way) < 1e-13);
        const glm::dvec3 normal = glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
        const glm::dvec3 direction = contactAt(found.way, shot.triangle, shot.sphere).direction;
        QVERIFY(std::abs(std::abs(glm::dot(direction, normal)) - 1) < 1e-6);
        QVERIFY(glm::dot(direction, shot.sphere.direction) < 0);
    }
}

void TestMovingSphere::boxesAreMetWhereTheyAre()
{
    Draw draw(2);
    int met = 0;
    for (int i = 0; i < 2'000; ++i) {
        const glm::dvec3 middle = draw.vector(10);
        const glm::dvec3 half = glm::abs(draw.vector()) * (i % 7 == 0 ? glm::dvec3(1, 0, 1) : glm::dvec3(1));
        const Box box{middle - half, middle + half};
        const double radius = i % 5 == 0 ? 0.0 : draw.size(-3, 1);
        glm::dvec3 direction = glm::normalize(i % 3 == 0 ? draw.vector() : middle + draw.vector(radius + 2));
        if (i % 11 == 0) {
            direction = {0, i % 2 == 0 ? 1 : -1, 0};
        }
        const MovingSphere sphere{direction, radius};
        const First first =
            firstAt([&](const Real &way) { return distanceToBox(box, at(way, direction)); }, Real(radius), Real(100));
        const double slab = wayToBox(box, sphere);
        QVERIFY(slab <= first.way + 1e-13 * (1 + radius));
        QVERIFY(slab == infinity || first.least <= 1.733 * radius + 1e-13); // corners of the grown box stick out
        if (slab == infinity) {
            QVERIFY(first.least > radius - 1e-13);
            continue;
        }
        const double way = wayTo(BoxBody{box}, sphere, slab, infinity);
        QVERIFY(way >= slab && way <= first.way + 1e-12 * (1 + radius));
        const ParallelepipedBody slanted{middle, {glm::dvec3(half.x, 0, 0), {0, half.y, 0}, {0, 0, half.z}}};
        QVERIFY(wayTo(slanted, sphere, 0.0, infinity) <= first.way + 1e-12 * (1 + radius));
        QVERIFY(glm::distance(slanted.box().least, box.least) < 1e-14);
        if (first.least < radius * 0.999) {
            ++met;
            QVERIFY(first.way - way <= 1e-4 * radius + 1e-12);
        } else if (first.least > radius * 1.001 + 1e-9) {
            QVERIFY(way == infinity);
        }
    }
    QVERIFY2(met > 200, qPrintable(QString::number(met)));
}

void TestMovingSphere::planesHaveTheBodyBehindThem()
{
    Draw draw(3);
    int outside = 0;
    for (int i = 0; i < 3'000; ++i) {
        ParallelepipedBody body{draw.vector(3), {draw.vector(), draw.vector(), draw.vector(i % 4 == 0 ? 0.0 : 1.0)}};
        const auto corners = cornersOf(body);
        const glm::dvec3 point = draw.vector(draw.size(-1, 2));
        const double error = i % 2 == 0 ? 0.0 : 0.01;
        const HullDistance distance = distanceToHull(corners, point);
        const SupportPlane ofEdges = body.planeFrom(point);
        const SupportPlane ofCorners = HullBody{corners, error}.planeFrom(point);
        if (distance.least == 0.0) {
            QVERIFY(distance.greatest > 1e-9 || ofCorners.normal == glm::dvec3(0.0));
            continue;
        }
        ++outside;
        for (const glm::dvec3 &corner : corners) {
            QVERIFY(glm::dot(ofEdges.normal, corner) >= ofEdges.offset - 1e-14);
            QVERIFY(glm::dot(ofCorners.normal, corner) >= ofCorners.offset + error - 1e-14);
        }
        // and is as far as it can be, or nearly
        const double reach = glm::dot(ofCorners.normal, point);
        QVERIFY(std::abs(distance.least - std::max(ofCorners.offset + error - reach, 0.0))
                <= 1e-9 * (1 + distance.least));
        QVERIFY(ofEdges.offset - glm::dot(ofEdges.normal, point) <= distance.least + 1e-12);
    }
    QVERIFY(outside > 2'000);
}

}

ROMANESCO_TEST(romanesco::test::TestMovingSphere)

#include "testmovingsphere.moc"
