// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "localsweep.h"

#include <algorithm>
#include <ranges>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "waylanes.h"

namespace romanesco {

namespace {

/// A hull in the frame of a child, with lengths in the parent's unit, seen from where the sphere starts.
struct ScaledHull {
    const HullBody &hull;
    double scale;
    glm::dvec3 start;

    [[nodiscard]] SupportPlane planeFrom(const glm::dvec3 &point) const
    {
        const auto [normal, offset] = hull.planeFrom((start + point) / scale);
        return {normal, offset * scale - glm::dot(normal, start)};
    }
};

void scale(SweptFace &found, double unit)
{
    found.way *= unit;
    found.lower *= unit;
}

}

LocalSweep::LocalSweep(const FractalGraph &graph, const LocalFrames::Inverses &inverses, const Mesh &mesh,
                       const FaceTree &tree, const LeafFaces &faces)
    : m_graph(graph)
    , m_inverses(inverses)
    , m_frames(graph, inverses, mesh, tree, faces)
    , m_tree(mesh, tree)
    , m_faces(faces)
{
}

LocalSweep::Frame LocalSweep::begin(const Path &path, const Box &box)
{
    m_radius = path.sphere.radius;
    m_reach = reachOf(path, box);
    return {{.p = path.start, .error = errorOfWays * m_reach}, path.sphere.direction};
}

LocalSweep::Frame LocalSweep::child(const Frame &frame, const DescentStep &step, double error) const
{
    return {m_frames.child(frame.at, step, error), m_inverses[step.set][step.map].turned.linear * frame.direction};
}

double LocalSweep::errorOf(const Frame &frame, const Children &children) const
{
    return m_frames.errorOf(frame.at, children) + errorOfWays * m_reach;
}

void LocalSweep::waysTo(const Frame &frame, const Children &children, double error, double *ways) const
{
    romanesco::waysTo(children.boxes, frame.at.p, sphereIn(frame, error), ways);
    for (double &way : std::span(ways, children.boxes.size() * laneCount)) {
        way *= frame.at.unit;
    }
}

void LocalSweep::raiseToHulls(const Frame &frame, const Children &children, std::size_t block, double error,
                              double *ways) const
{
    Lanes inFrame;
    for (std::size_t lane = 0; lane < laneCount; ++lane) {
        inFrame[lane] = ways[lane] / frame.at.unit;
    }
    romanesco::raiseToHulls(children.hulls[block], frame.at.p, sphereIn(frame, error), inFrame.data());
    for (std::size_t lane = 0; lane < laneCount; ++lane) {
        ways[lane] = std::max(ways[lane], inFrame[lane] * frame.at.unit);
    }
}

double LocalSweep::wayToFine(const Frame &frame, const DescentStep &step, const HullBounds::Hulls &hulls, double error,
                             double from, double until) const
{
    const LocalFrames::Inverse &inverse = m_inverses[step.set][step.map];
    MovingSphere sphere = sphereIn(frame, error);
    sphere.direction = inverse.turned.linear * sphere.direction;
    const HullBody hull{hulls.fine.corners, hulls.fine.error};
    return wayTo(ScaledHull{hull, inverse.scale, inverse.turned(frame.at.p)}, sphere, from / frame.at.unit,
                 until / frame.at.unit)
        * frame.at.unit;
}

double LocalSweep::sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const
{
    return m_frames.sizeOf(frame.at, bounds) * frame.at.unit;
}

void LocalSweep::measure(const Frame &frame, double from, double limit, double slack, SweptFace &found)
{
    const double unit = frame.at.unit;
    const MovingSphere sphere = sphereIn(frame, frame.at.error);
    if (m_faces.isEmpty()) {
        m_tree.sweep(frame.at.p, sphere, limit / unit, slack / unit, found);
    } else {
        m_faces.sweep(frame.at.p, sphere, from / unit, limit / unit, slack / unit, found);
    }
    scale(found, unit);
}

void LocalSweep::measure(const Frame &frame, const Box &box, double limit, SweptFace &found) const
{
    const double unit = frame.at.unit;
    touchPoint(box.centre() - frame.at.p, sphereIn(frame, 2.0 * frame.at.error), limit / unit, found);
    scale(found, unit);
}

double LocalSweep::finish(const Frame &frame, const SweptFace &found, std::span<const DescentStep> steps, double slack,
                          Touch &touch) const
{
    const MovingSphere sphere = sphereIn(frame, 0.0);
    const double way = refined(found.way / frame.at.unit, found.triangle, sphere, slack / frame.at.unit);
    const Contact contact = contactAt(way, found.triangle, sphere);
    touch.point = frame.at.p + contact.point;
    touch.direction = contact.direction;
    for (const DescentStep &step : steps | std::views::reverse) {
        const AffineMap &map = m_graph.set(step.set).maps[step.map];
        touch.point = map(touch.point);
        touch.direction = glm::normalize(map.linear * touch.direction / m_inverses[step.set][step.map].scale);
    }
    return way * frame.at.unit;
}

MovingSphere LocalSweep::sphereIn(const Frame &frame, double error) const
{
    return {frame.direction, (m_radius + error) / frame.at.unit};
}

}
