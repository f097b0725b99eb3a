// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>
#include <vector>

#include "facesweep.h"
#include "relativeframes.h"
#include "sweeping.h"

namespace romanesco {

/// RelativeFrames with a sphere that moves: SweepSearch goes down with it. All is as LocalSweep has it.
class RelativeSweep
{
public:
    struct Frame {
        RelativeFrames::Frame at;

        [[nodiscard]] double error() const { return at.error; }
        [[nodiscard]] static double unit() { return RelativeFrames::Frame::unit; }
    };
    using Children = RelativeFrames::Children;

    /// All must outlive it; tree and faces are of the mesh. The map, of any kind, places all of it.
    RelativeSweep(const FractalGraph &graph, const Mesh &mesh, const FaceTree &tree, const LeafFaces &faces,
                  const AffineMap &worldFromModel = {});

    [[nodiscard]] Children boundsOf(std::span<const DescentStep> children, BoundedStates &states) const
    {
        return m_frames.boundsOf(children, states);
    }

    [[nodiscard]] Frame begin(const Path &path, const Box &box);
    [[nodiscard]] Frame child(const Frame &frame, const DescentStep &step, double error) const;
    [[nodiscard]] double errorOf(const Frame &frame, const Children &children) const;

    /// How large the numbers are at most that children are placed by.
    [[nodiscard]] static double magnitudeOf(const Frame &frame, const Children &children)
    {
        return RelativeFrames::magnitudeOf(frame.at, children);
    }

    static constexpr bool waysAreToBoxes = false;
    void waysTo(const Frame &frame, const Children &children, double error, double *ways) const;
    void raiseToHulls(const Frame &frame, const Children &children, std::size_t block, double error,
                      double *ways) const;
    [[nodiscard]] double wayToBox(const Frame &frame, const DescentStep &step, const Box &box, double error,
                                  double from, double until) const;
    [[nodiscard]] double wayToFine(const Frame &frame, const DescentStep &step, const HullBounds::Hulls &hulls,
                                   double error, double from, double until);

    [[nodiscard]] double sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const;

    void measure(const Frame &frame, double from, double limit, double slack, SweptFace &found);
    void measure(const Frame &frame, const Box &box, double limit, SweptFace &found) const;

    double finish(const Frame &frame, const SweptFace &found, std::span<const DescentStep> steps, double slack,
                  Touch &touch) const;

private:
    [[nodiscard]] MovingSphere grown(double error) const;

    const FractalGraph &m_graph;
    AffineMap m_worldFromModel;
    RelativeFrames m_frames;
    FaceSweep m_tree;
    const LeafFaces &m_faces;
    glm::dvec3 m_start{0.0};
    MovingSphere m_sphere;
    double m_reach = 0.0;
    std::vector<glm::dvec3> m_corners;
};

}
