// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>

#include "facesweep.h"
#include "localframes.h"
#include "sweeping.h"

namespace romanesco {

/// LocalFrames with a sphere that moves: SweepSearch goes down with it. Ways and lengths are in the model's unit.
class LocalSweep
{
public:
    /// A frame, and where the sphere starts and goes in it.
    struct Frame {
        LocalFrames::Frame at;
        glm::dvec3 direction{0.0};

        [[nodiscard]] double error() const { return at.error; }
        [[nodiscard]] double unit() const { return at.unit; }
    };
    using Children = LocalFrames::Children;

    /// All must outlive it; the tree is of the mesh.
    LocalSweep(const FractalGraph &graph, const LocalFrames::Inverses &inverses, const Mesh &mesh, const FaceTree &tree,
               const LeafFaces &faces);

    [[nodiscard]] Children boundsOf(std::span<const DescentStep> children, BoundedStates &states) const
    {
        return m_frames.boundsOf(children, states);
    }

    /// The model is in a box.
    [[nodiscard]] Frame begin(const Path &path, const Box &box);
    /// error: that of the children.
    [[nodiscard]] Frame child(const Frame &frame, const DescentStep &step, double error) const;
    /// By how much the sphere has to grow for what its frame and ways to the children may be off.
    [[nodiscard]] double errorOf(const Frame &frame, const Children &children) const;

    /// How large the numbers are at most that children are placed by.
    [[nodiscard]] static double magnitudeOf(const Frame &frame, const Children &children)
    {
        return LocalFrames::magnitudeOf(frame.at, children);
    }

    /// Whether waysTo() leaves nothing of a box to wayToBox(); there is none then.
    static constexpr bool waysAreToBoxes = true;
    /// Before which the sphere, grown by an error, does not touch the box of each child.
    void waysTo(const Frame &frame, const Children &children, double error, double *ways) const;
    /// Puts in the ways to the coarse hulls of a block of children, where they are longer.
    void raiseToHulls(const Frame &frame, const Children &children, std::size_t block, double error,
                      double *ways) const;
    /// The way to one child's fine hull, of which a shorter one is known.
    [[nodiscard]] double wayToFine(const Frame &frame, const DescentStep &step, const HullBounds::Hulls &hulls,
                                   double error, double from, double until) const;

    /// How far points of a box are apart at most.
    [[nodiscard]] double sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const;

    /// The face of the mesh in the frame that is touched first: see FaceSweep. Nothing of it is touched before `from`.
    void measure(const Frame &frame, double from, double limit, double slack, SweptFace &found);
    /// The same for all points of a box that is smaller than the error: they are taken for its middle.
    void measure(const Frame &frame, const Box &box, double limit, SweptFace &found) const;

    /// Puts what was found in the frame at the end of a path into the model's. The way at which the sphere itself touches,
    /// which is not grown, or at which it is grown where else it passes by.
    double finish(const Frame &frame, const SweptFace &found, std::span<const DescentStep> steps, double slack,
                  Touch &touch) const;

private:
    /// The sphere, grown, in the unit of a frame.
    [[nodiscard]] MovingSphere sphereIn(const Frame &frame, double error) const;

    const FractalGraph &m_graph;
    const LocalFrames::Inverses &m_inverses;
    LocalFrames m_frames;
    FaceSweep m_tree;
    const LeafFaces &m_faces;
    double m_radius = 0.0;
    /// Bounds all numbers that ways are computed from.
    double m_reach = 0.0;
};

}
