// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/fractal/statetable.h"
#include "core/scene/anchor.h"
#include "depthpyramid.h"
#include "projector.h"
#include "tint.h"

namespace romanesco {

/// One copy as the card reads it: the rows of the affine map from the base mesh, within the unit sphere, to the
/// camera's axes, relative to the camera, in units of the view.
struct Instance {
    std::array<std::array<float, 4>, 3> rows;
};
static_assert(sizeof(Instance) == 48);

/// What tells a cut which copies need not be drawn.
struct Depths {
    /// Of this picture, as far as it was looked at: what lies behind is left out.
    DepthPyramid drawn;
    /// Of one much like it: what lies behind is likely to be hidden, and is put off until the rest is drawn.
    DepthPyramid before;
    /// How often this picture was looked at.
    unsigned looks = 0;
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

    /// From now on what is hidden is left out, and what is near comes before what is far; null leaves out nothing. What
    /// is drawn may come nearer between calls of next(), and nothing else may change until the cut is complete.
    void setDepths(const Depths *depths) { m_depths = depths; }

    /// The next copies, about `count` of them: more where one state has more children, fewer or none where much was
    /// walked without finding any, so that each call is short. The reference holds until the next call.
    [[nodiscard]] const std::vector<Instance> &next(std::size_t count);
    /// Beside those; empty where copies have no colours of their own.
    [[nodiscard]] const std::vector<Tint> &tints() const { return m_tints; }

    /// Nothing is left to be found.
    [[nodiscard]] bool isComplete() const { return m_open.empty() && m_handedOut; }

    [[nodiscard]] std::uint64_t instanceCount() const { return m_instances; }
    [[nodiscard]] std::uint64_t statesVisited() const { return m_visited; }
    /// Copies, with all below them, that were left out.
    [[nodiscard]] std::uint64_t hiddenCount() const { return m_hidden; }
    /// Whether much was put off, and it would be good to know what is drawn.
    [[nodiscard]] bool isInDoubt() const { return m_isRestInDoubt || m_doubtful.size() >= mostDoubtful; }
    /// Greatest number of bytes held since begin().
    [[nodiscard]] std::size_t memoryUse() const { return m_memory; }
    /// Bytes held now.
    [[nodiscard]] std::size_t memoryHeld() const;
    /// Gives back what was made; begin() comes next.
    void forget();

private:
    /// More are walked at once.
    static constexpr std::size_t mostDoubtful = 100'000;

    /// A copy of a state that is in view.
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
        /// Stands as one.
        bool isSmall;
        bool mayBePutOff;
    };
    struct Plane {
        glm::dvec3 normal;
        double offset;
    };

    void addRoot(const Surroundings::Node &node);
    void sift();
    void takeUp(std::size_t count);
    [[nodiscard]] bool isToBeSeen(const Node &node);
    [[nodiscard]] const Box &boxOf(StateId state);
    void visit(const Node &node);
    void addChild(const Node &node, const ChildRange &range, std::uint32_t map, const Sphere &bound);
    void place(const AffineMap &map, StateId state, const Marks &marks, bool isWhole);
    [[nodiscard]] bool isOutside(const Sphere &sphere, unsigned &planes) const;
    [[nodiscard]] bool isSmall(const Sphere &sphere) const;
    [[nodiscard]] double distanceTo(const Sphere &sphere) const;
    void sortFrom(std::size_t first);
    void forgetStates();

    const Model &m_model;
    StateTable m_table;
    /// By state; none where nobody asked.
    std::vector<std::optional<Box>> m_boxes;
    std::vector<Node> m_open;
    /// Put off until all else is drawn.
    std::vector<Node> m_doubtful;
    bool m_isRestInDoubt = false;
    /// The look after which those were gone through.
    unsigned m_siftedAt = 0;
    std::vector<Instance> m_ready;
    std::vector<Tint> m_tints;
    Tinter m_tinter;
    std::array<Plane, 5> m_planes;
    Projector m_projector;
    double m_tolerance = 1.0;
    bool m_handedOut = false;
    std::uint64_t m_instances = 0;
    std::uint64_t m_visited = 0;
    std::uint64_t m_hidden = 0;
    const Depths *m_depths = nullptr;
    std::size_t m_memory = 0;
};

}
