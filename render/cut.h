// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "camera.h"
#include "core/fractal/statetable.h"
#include "core/scene/anchor.h"
#include "depthpyramid.h"
#include "tint.h"

namespace romanesco {

/// One copy as the card reads it: the rows of the affine map from the base mesh, within the unit sphere, to the
/// camera's axes, relative to the camera, in units of the view.
struct Instance {
    std::array<std::array<float, 4>, 3> rows;
};
static_assert(sizeof(Instance) == 48);

/// How a camera maps what it sees to the screen, in units in which the scene and its distance are about 1, so that a
/// scene of any size fits the card's floats.
struct Projector {
    Projector() = default;
    /// nearby: round what is looked at, in the camera's coordinates; from its middle nothing is farther than reach.
    Projector(const Camera &camera, const Sphere &nearby, double reach, int viewWidth, int viewHeight);

    /// A node's own coordinates to the camera's, in units of the view. What is near the camera keeps its precision
    /// however far from the origin both are.
    [[nodiscard]] AffineMap cameraFrom(const AffineMap &hereFromNode) const;

    Projection projection = Projection::Perspective;
    /// The camera's place, and the world's axes to the camera's in units of the view.
    glm::dvec3 position{0.0};
    glm::dmat3 cameraFromHere{1.0};
    double unit = 1.0;
    /// Clip x and y for each unit sideways: at distance 1 for perspective.
    double scaleX = 1.0;
    double scaleY = 1.0;
    /// Perspective: nothing nearer is drawn. A hundred-thousandth of the scene's size and distance.
    double near = 1e-5;
    /// Orthographic: depth runs over ±range, in logarithms where that is long.
    double range = 1.0;
    [[nodiscard]] bool isDeep() const { return projection == Projection::Orthographic && range > longRange; }
    /// Pixels for each unit sideways, at distance 1 for perspective.
    double pixels = 1.0;
    /// Of the picture, in pixels; and how far its pixels are shifted, in clip coordinates.
    int width = 0;
    int height = 0;
    glm::dvec2 jitter{0.0};

    /// Whether a sphere in the camera's axes lies wholly behind what is drawn.
    [[nodiscard]] bool isHidden(const Sphere &sphere, const DepthPyramid &drawn) const;

private:
    static constexpr double longRange = 100.0;

    [[nodiscard]] double depthOf(double z) const;
};

/// The copies of a model to draw for a view: the graph walked from some nodes, its root or what surrounds a place deep
/// inside, with camera-relative maps in double; what is outside the view is dropped, and where a bound is smaller on the screen than the tolerance, one base mesh stands for all
/// below. Where maps contract, its cost follows what is seen, about (pixels / tolerance)^dimension, whatever the number
/// of instances. (Copies of one size, or many at one place, are all drawn that are in view.)
///
/// Works in slices and holds the way down, not the result. One thread.
class Cut
{
public:
    /// model must outlive the cut.
    explicit Cut(const Model &model);

    /// Starts over, with all that is below these nodes of the model. A tolerance of 0 gives every instance that is in view
    /// and larger than a millionth of a pixel.
    void begin(const Projector &projector, std::span<const Surroundings::Node> nodes, double pixelTolerance);

    /// From the next begin() on: how copies are coloured.
    void setTinter(Tinter tinter) { m_tinter = std::move(tinter); }

    /// From now on what lies behind all that is drawn is left out, and what is near comes before what is far; null leaves
    /// out nothing. The pyramid may become another between calls of next(), but only nearer.
    void setDrawn(const DepthPyramid *drawn) { m_drawn = drawn; }

    /// The next copies, about `count` of them: more where one state has more children, fewer or none where much was
    /// walked without finding any, so that each call is short. The reference holds until the next call.
    [[nodiscard]] const std::vector<Instance> &next(std::size_t count);
    /// Beside those; empty where copies have no colours of their own.
    [[nodiscard]] const std::vector<Tint> &tints() const { return m_tints; }

    /// Nothing is left to be found.
    [[nodiscard]] bool isComplete() const { return m_open.empty() && m_handedOut; }

    [[nodiscard]] std::uint64_t instanceCount() const { return m_instances; }
    [[nodiscard]] std::uint64_t statesVisited() const { return m_visited; }
    /// Greatest number of bytes held since begin().
    [[nodiscard]] std::size_t memoryUse() const { return m_memory; }
    /// Bytes held now.
    [[nodiscard]] std::size_t memoryHeld() const;
    /// Gives back what was made; begin() comes next.
    void forget();

private:
    /// A copy of a state that is in view and too large to stand as one.
    struct Node {
        StateId state;
        /// Planes that its bound may cross.
        unsigned planes;
        AffineMap map;
        /// At least the operator norm of the map.
        double norm;
        Marks marks;
        /// From the camera to the middle of its bound.
        double distance;
    };
    struct Plane {
        glm::dvec3 normal;
        double offset;
    };

    void addRoot(const Surroundings::Node &node);
    void visit(const Node &node);
    void addChild(const Node &node, const ChildRange &range, std::uint32_t map, const Sphere &bound);
    void place(const AffineMap &map, StateId state, const Marks &marks, bool isWhole);
    [[nodiscard]] bool isOutside(const Sphere &sphere, unsigned &planes) const;
    [[nodiscard]] bool isSmall(const Sphere &sphere) const;
    [[nodiscard]] bool isBehind(const Sphere &sphere) const;
    [[nodiscard]] double distanceTo(const Sphere &sphere) const;
    void sortFrom(std::size_t first);
    void forgetStates();

    const Model &m_model;
    StateTable m_table;
    std::vector<Node> m_open;
    std::vector<Instance> m_ready;
    std::vector<Tint> m_tints;
    Tinter m_tinter;
    std::array<Plane, 5> m_planes;
    Projector m_projector;
    double m_tolerance = 1.0;
    bool m_handedOut = false;
    std::uint64_t m_instances = 0;
    std::uint64_t m_visited = 0;
    const DepthPyramid *m_drawn = nullptr;
    std::size_t m_memory = 0;
};

}
