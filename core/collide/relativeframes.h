// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boundedstates.h"
#include "collider.h"
#include "core/fractal/fractalgraph.h"
#include "core/fractal/hullbounds.h"
#include "core/geometry/box.h"
#include "descent.h"
#include "facetree.h"
#include "lanes.h"
#include "leaffaces.h"

namespace romanesco {

/// Goes down any graph, of maps that shear, flatten or send all to a point, by taking frames along to the point p: what
/// stands in them is measured in the model's unit, with p as the origin. Nothing is inverted.
class RelativeFrames
{
public:
    /// A frame's axes and origin, seen from p.
    struct Frame {
        AffineMap map;
        /// Bounds how much the axes lengthen, and counts the maps: for the rounding.
        double norm = 1.0;
        int depth = 0;
        /// What stands in the frame may be off by so much.
        double error = 0.0;

        static constexpr double unit = 1.0;
    };

    /// All must outlive it; tree and faces are of the mesh. The map, of any kind, places all of it.
    RelativeFrames(const FractalGraph &graph, const Mesh &mesh, const FaceTree &tree, const LeafFaces &faces,
                   const AffineMap &worldFromModel = {});

    /// What bounds the children of a state, in the state's frame.
    struct Children {
        std::vector<Parallelepipeds> boxes;
        /// Beside the boxes; nothing where no child has one.
        std::vector<HullsOfFew> hulls;
        /// How far maps move, and how large the boxes are: for the rounding.
        double farthest = 0.0;
        double reach = 0.0;
    };
    [[nodiscard]] Children boundsOf(std::span<const DescentStep> children, BoundedStates &states) const;

    /// All is in a box, which is not empty.
    [[nodiscard]] Frame begin(const Query &query, const Box &all);
    /// error: that of the children.
    [[nodiscard]] Frame child(const Frame &frame, const DescentStep &step, double error) const;
    /// How far off distances may be in children and to them.
    [[nodiscard]] double errorOf(const Frame &frame, const Children &children) const;

    /// From p to the box of each child; never more than it is, but for rounding.
    void distancesTo(const Frame &frame, const Children &children, double *distances) const;
    /// Puts in the distances to the coarse hulls of a block of children, where they are farther.
    void raiseToHulls(const Frame &frame, const Children &children, std::size_t block, double *distances) const;
    /// From p to a fine hull in the frame of a child; not looked at more closely where it is above `enough`.
    [[nodiscard]] double fineDistanceTo(const Frame &frame, const DescentStep &step,
                                        const BoundedStates::Bounds &bounds, double enough) const;

    /// Whether no point of a box is ahead of p.
    [[nodiscard]] bool isBehind(const Frame &frame, const Box &box) const;
    /// How large the numbers are at most that children are placed by.
    [[nodiscard]] static double magnitudeOf(const Frame &frame, const Children &children)
    {
        return frame.norm * (children.farthest + children.reach);
    }
    /// How far, in the model's unit, what is in a box is from itself in another frame at most, seen from p.
    [[nodiscard]] static double apart(const Frame &one, const Frame &other, const Box &box);
    /// A number, in the model's unit, by which frames differ that are not alike.
    [[nodiscard]] static double placeOf(const Frame &frame) { return romanesco::placeOf(frame.map.translation); }
    /// How far points of a box are apart at most.
    [[nodiscard]] double sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const;

    /// Looks at the faces of the mesh in the frame that are within a limit.
    void measure(const Frame &frame, double limit, LeafHit &hit);

    /// Puts what was found in the frame at the end of a path into the model's.
    void finish(const Frame &frame, const LeafHit &leaf, std::span<const DescentStep> path, Hit &hit) const;
    /// The same, of any point of a box that is too small to tell its points apart.
    void finish(const Frame &frame, const Box &box, std::span<const DescentStep> path, Hit &hit) const;

private:
    struct Waiting {
        double distance;
        std::uint32_t node;
    };
    void measureFaces(const Frame &frame, const FaceTree::Node &node, double &limit, LeafHit &hit) const;

    const FractalGraph &m_graph;
    const Mesh &m_mesh;
    const FaceTree &m_tree;
    const LeafFaces &m_faces;
    AffineMap m_worldFromModel;
    double m_norm = 1.0;
    glm::dvec3 m_p{0.0};
    std::optional<glm::dvec3> m_motion;
    std::vector<Waiting> m_waiting;
};

}
