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
#include "lanes.h"
#include "leaffaces.h"
#include "treesearch.h"

namespace romanesco {

/// Goes down a graph whose maps are similarities by taking the point p along into the frame of each state, where boxes
/// and mesh stand still. A frame has its own unit of length, so that nothing is lost however deep it is.
class LocalFrames
{
public:
    /// What is kept of a map.
    struct Inverse {
        AffineMap childFromParent;
        /// The same in the parent's units.
        AffineMap turned;
        double scale = 1.0;
    };
    /// By set and map; nothing where a map is not what similarityOf() takes for one.
    using Inverses = std::vector<std::vector<Inverse>>;
    [[nodiscard]] static std::optional<Inverses> inverses(const FractalGraph &graph);

    /// A frame, and p in it.
    struct Frame {
        glm::dvec3 p{0.0};
        /// In the model's.
        double unit = 1.0;
        /// p may be off by so much, in the model's unit.
        double error = 0.0;
        /// The query's, turned.
        std::optional<glm::dvec3> motion = {};
    };

    /// All must outlive it; tree and faces are of the mesh.
    LocalFrames(const FractalGraph &graph, const Inverses &inverses, const Mesh &mesh, const FaceTree &tree,
                const LeafFaces &faces);

    /// What bounds the children of a state, in the state's frame.
    struct Children {
        std::vector<TurnedBoxes> boxes;
        /// Beside the boxes; nothing where no child has one.
        std::vector<HullsOfFew> hulls;
        /// Bounds the numbers that they are computed from: for the rounding.
        double reach = 0.0;
    };
    [[nodiscard]] Children boundsOf(std::span<const DescentStep> children, BoundedStates &states) const;

    [[nodiscard]] Frame begin(const Query &query, const Box &) const { return {.p = query.p, .motion = query.motion}; }
    /// error: that of the children.
    [[nodiscard]] Frame child(const Frame &frame, const DescentStep &step, double error) const;
    /// How far off, in the model's unit, distances may be in children and to them.
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
    /// In the model's unit, how large the numbers are at most that children are placed by.
    [[nodiscard]] static double magnitudeOf(const Frame &frame, const Children &children)
    {
        return frame.unit * children.reach;
    }
    /// How far, in the model's unit, what is in a box is from itself in another frame at most, seen from p; infinite where
    /// p moves another way there.
    [[nodiscard]] static double apart(const Frame &one, const Frame &other, const Box &box);
    /// A number, in the model's unit, by which frames differ that are not alike.
    [[nodiscard]] static double placeOf(const Frame &frame) { return frame.unit * romanesco::placeOf(frame.p); }
    /// How far points of a box are apart at most.
    [[nodiscard]] double sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const;

    /// Looks at the faces of the mesh in the frame that are within a limit.
    void measure(const Frame &frame, double limit, LeafHit &hit);

    /// Puts what was found in the frame at the end of a path into the model's.
    void finish(const Frame &frame, const LeafHit &leaf, std::span<const DescentStep> path, Hit &hit) const;
    /// The same, of any point of a box that is too small to tell its points apart.
    void finish(const Frame &frame, const Box &box, std::span<const DescentStep> path, Hit &hit) const;

private:
    void takeOut(const Frame &frame, std::span<const DescentStep> path, Hit &hit) const;

    const FractalGraph &m_graph;
    const Inverses &m_inverses;
    const Mesh &m_mesh;
    TreeSearch m_leaf;
    const LeafFaces &m_faces;
};

}
