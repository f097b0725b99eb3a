// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "relativesweep.h"

#include "waylanes.h"

namespace romanesco {

RelativeSweep::RelativeSweep(const FractalGraph &graph, const Mesh &mesh, const FaceTree &tree, const LeafFaces &faces,
                             const AffineMap &worldFromModel)
    : m_graph(graph)
    , m_worldFromModel(worldFromModel)
    , m_frames(graph, mesh, tree, faces, worldFromModel)
    , m_tree(mesh, tree)
    , m_faces(faces)
{
}

RelativeSweep::Frame RelativeSweep::begin(const Path &path, const Box &box)
{
    m_start = path.start;
    m_sphere = path.sphere;
    const AffineMap seen{m_worldFromModel.linear, m_worldFromModel.translation - m_start};
    m_reach = reachFromStart(path, parallelepiped(seen, box).box());
    Frame frame{m_frames.begin({.p = path.start}, box)};
    frame.at.error += errorOfWays * m_reach;
    return frame;
}

RelativeSweep::Frame RelativeSweep::child(const Frame &frame, const DescentStep &step, double error) const
{
    return {m_frames.child(frame.at, step, error)};
}

double RelativeSweep::errorOf(const Frame &frame, const Children &children) const
{
    return m_frames.errorOf(frame.at, children) + errorOfWays * m_reach;
}

void RelativeSweep::waysTo(const Frame &frame, const Children &children, double error, double *ways) const
{
    romanesco::waysTo(children.boxes, frame.at.map, grown(error), ways);
}

void RelativeSweep::raiseToHulls(const Frame &frame, const Children &children, std::size_t block, double error,
                                 double *ways) const
{
    romanesco::raiseToHulls(children.hulls[block], frame.at.map, frame.at.norm, grown(error), ways);
}

double RelativeSweep::wayToBox(const Frame &frame, const DescentStep &step, const Box &box, double error, double from,
                               double until) const
{
    const AffineMap map = step.isToMesh() ? frame.at.map : frame.at.map * m_graph.set(step.set).maps[step.map];
    return wayTo(parallelepiped(map, box), grown(error), from, until);
}

double RelativeSweep::wayToFine(const Frame &frame, const DescentStep &step, const HullBounds::Hulls &hulls,
                                double error, double from, double until)
{
    const AffineMap map = frame.at.map * m_graph.set(step.set).maps[step.map];
    m_corners.clear();
    for (const glm::dvec3 &corner : hulls.fine.corners) {
        m_corners.push_back(map(corner));
    }
    const double outside = frame.at.norm * m_graph.facts(step.set)[step.map].norm * hulls.fine.error;
    return wayTo(HullBody{m_corners, outside}, grown(error), from, until);
}

double RelativeSweep::sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const
{
    return m_frames.sizeOf(frame.at, bounds);
}

void RelativeSweep::measure(const Frame &frame, double from, double limit, double slack, SweptFace &found)
{
    const MovingSphere sphere = grown(frame.at.error);
    if (m_faces.isEmpty()) {
        m_tree.sweep(frame.at.map, sphere, limit, slack, found);
    } else {
        m_faces.sweep(frame.at.map, sphere, from, limit, slack, found);
    }
}

void RelativeSweep::measure(const Frame &frame, const Box &box, double limit, SweptFace &found) const
{
    touchPoint(frame.at.map(box.centre()), grown(2.0 * frame.at.error), limit, found);
}

double RelativeSweep::finish(const Frame &, const SweptFace &found, std::span<const DescentStep>, double slack,
                             Touch &touch) const
{
    const double way = refined(found.way, found.triangle, m_sphere, slack);
    const Contact contact = contactAt(way, found.triangle, m_sphere);
    touch.point = m_start + contact.point;
    touch.direction = contact.direction;
    return way;
}

MovingSphere RelativeSweep::grown(double error) const
{
    return {m_sphere.direction, m_sphere.radius + error};
}

}
