// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <limits>
#include <vector>

#include "collider.h"
#include "core/geometry/affinemap.h"
#include "core/geometry/mesh.h"
#include "core/geometry/movingsphere.h"
#include "facesweep.h"

/// What the ways to answer a Sweep have in common. They reckon in ways: lengths from where the centre starts.
namespace romanesco {

/// A sweep, its speed and its time taken apart.
struct Path {
    explicit Path(const Sweep &sweep);

    glm::dvec3 start{0.0};
    MovingSphere sphere;
    double speed = 0.0;
    double length = 0.0;
    /// What is touched later by less is passed over: Touch::time tells.
    double slack = 0.0;

    /// Infinite ways stay so.
    [[nodiscard]] double timeOf(double way) const;
};

/// The first of the faces that were looked at so far, one by one, of copies of a mesh.
class FirstTouch
{
public:
    FirstTouch(const Mesh &mesh, const Path &path)
        : m_mesh(mesh)
        , m_path(path)
        , m_best(path.length)
    {
    }

    /// Looks at all faces of a copy. Whether the first so far is one of them.
    bool consider(const AffineMap &modelFromBase, std::vector<glm::dvec3> &scratch);

    /// Forgets all but the number of tests.
    void restart();

    [[nodiscard]] bool isFound() const { return m_face != Mesh::none; }

    /// What it comes to, but for promise and address. lower is that of the faces.
    void report(const Sweep &sweep, Touch &touch) const;

private:
    const Mesh &m_mesh;
    const Path &m_path;
    double m_best;
    double m_lower = std::numeric_limits<double>::infinity();
    /// Seen from the start.
    Triangle m_triangle{};
    std::uint32_t m_face = Mesh::none;
    std::uint64_t m_faceTests = 0;
};

/// What ways and a step of a descent may be off by, of reachOf(): a dozen roundings, with a margin.
constexpr double errorOfWays = 16.0 * std::numeric_limits<double>::epsilon();

/// Bounds the coordinates that count while a path may touch what is in a box, seen from anywhere there: the start, the
/// box, the radius, and the way.
[[nodiscard]] double reachOf(const Path &path, const Box &box);
/// The same where all is seen from the start, the box too.
[[nodiscard]] double reachFromStart(const Path &path, const Box &seen);

/// Of what is no more than a point, seen from the start: no face.
void touchPoint(const glm::dvec3 &point, const MovingSphere &sphere, double limit, SweptFace &found);

/// A way at which a sphere that had grown by a little touched a triangle, or that of the sphere itself where that is no
/// more than the slack later: what lies beyond was passed over.
[[nodiscard]] double refined(double way, const Triangle &triangle, const MovingSphere &sphere, double slack);

/// Puts in where a path touches a triangle, seen from its start, and when.
void place(Touch &touch, const Path &path, double way, const Triangle &triangle);

/// Puts in what is proved of the whole: nothing is touched before a way.
void prove(Touch &touch, const Path &path, double lower, const Sweep &sweep);

}
