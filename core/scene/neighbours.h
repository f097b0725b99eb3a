// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/longmap.h"
#include "surroundings.h"
#include "waylevel.h"

namespace romanesco {

/// What comes near a way down though it parts from it however far above: the other side of a border between parts of a
/// fractal, down at thousands of levels.
///
/// Each node of the way has neighbours: nodes off the way whose bounds are at most half as large again, and which come as
/// near to the way's end as 1/64 of that node's bound. Those of a node are among the children of those of the node above,
/// and of that node, so they are followed down. What is far is dropped in double; what stays near is kept in fixed point,
/// with as many digits as there are between where it parted and the end of the way. So their maps are exact but for one
/// rounding; nearly everywhere there are none, and nothing long is computed.
///
/// What is dropped. For a node of 1e9 units, what is farther than 1e7 times what is here (in radii of its bound). A border
/// that is flat ends there 1e-7 of the camera's height above it too low, 1e-4 of a pixel. What rises with distance, as parts
/// of the whole do, is seen in the gaps of 23 octaves of nearer parts. So it is with what the anchor drops by itself. Base
/// meshes that stand in nodes larger than that are dropped however near: a card's floats could not place them.
///
/// Limits. At most 32 neighbours are kept, the nearest; at most 128 nodes are divided for a level, and what is still larger is
/// left out. Those that part where the way is more than 2^8,192 times as large as at its end (2^16,384 at times) are
/// forgotten. Where maps grow, a node's neighbours reach only as far as those of any node above. Numbers are those of the
/// text as doubles: parts that touch by a third touch to 1e-17 of the whole, and 40 levels down there is a gap.
///
/// One thread. Cost: half a microsecond for a level of the way that was not there the time before; with neighbours 2 us at
/// a point where two parts touch, 9 us where eight meet, below 300 us where all parts lie within each other. Some tens
/// of microseconds for the answer. Memory: some hundred kilobytes for a border of a thousand levels.
class Neighbours
{
public:
    explicit Neighbours(std::shared_ptr<const Scene> scene);

    /// Those of the last of so many levels of a way, 1 or more, in the coordinates of its end: the axes of the world and the
    /// end's norm as unit.
    [[nodiscard]] std::vector<Surroundings::Node> of(std::span<const WayLevel> way, std::size_t levels);

private:
    /// Steps from the way to a node, the last first.
    struct Trail {
        Step step;
        std::uint32_t above;
    };
    static constexpr std::uint32_t noTrail = 0xffffffff;

    struct Node {
        std::size_t item;
        Positions state;
        std::size_t sharedSteps;
        std::uint32_t trail;
        /// From the origin of the way's node, in units of the node where numbers began to be long.
        LongMap map;
        /// The same in units of the way's node.
        AffineMap seen;
        /// At least so far from what is looked at.
        double gap = 0.0;
        /// Could not be divided in time.
        bool isTooLarge = false;
    };
    /// At a node of the way, the last of so many levels, or in the world.
    struct Station {
        std::size_t levels = 0;
        /// So many levels of the way tell what is here.
        std::size_t lookedAt = 0;
        /// Where numbers began to be long; of as many bits.
        std::size_t base = 0;
        unsigned bits = 0;
        /// The way's node from its own origin; none where there are no neighbours.
        std::optional<LongMap> own = {};
        std::vector<Node> nodes = {};
        std::size_t trailCount = 0;
    };
    struct Child {
        std::size_t item;
        Step step;
        const AffineMap &map;
        const Positions &state;
    };
    /// What is looked at from a node of the way, in its coordinates.
    struct Target {
        glm::dvec3 middle{0.0};
        /// What is farther is dropped, and what is larger divided.
        double reach = 0.0;
        double largest = 0.0;
        std::size_t lookedAt = 0;
    };

    void setWay(std::span<const WayLevel> way, std::size_t levels);
    [[nodiscard]] static Target targetOf(std::span<const WayLevel> way, std::size_t levels);
    void dropLast();
    void advance(std::span<const WayLevel> way);
    [[nodiscard]] std::vector<Node> found(std::span<const WayLevel> way, Station &at, const Target &target);
    void addSiblings(std::span<const WayLevel> way, Station &at, const Target &target, std::vector<Node> &nodes);
    void divide(const Node &node, const Target &target, std::vector<Node> &nodes);
    [[nodiscard]] double gapTo(const Target &target, std::size_t item, const Positions &state, const AffineMap &seen);
    [[nodiscard]] double sizeOf(const Node &node);
    [[nodiscard]] std::vector<Step> stepsTo(const Node &node) const;
    [[nodiscard]] unsigned bitsFrom(std::span<const WayLevel> way, std::size_t levels) const;
    [[nodiscard]] std::size_t firstOf(std::span<const WayLevel> way) const;
    [[nodiscard]] StateTable &tableOf(std::size_t item);
    template<typename Use>
    void forEachChild(std::size_t item, const Positions &state, const AffineMap &seen, const Target &target, Use &&use);

    std::shared_ptr<const Scene> m_scene;
    std::map<const Model *, StateTable> m_tables;
    std::vector<Step> m_way;
    /// The least exponent of the way.
    double m_least = 0.0;
    std::vector<Station> m_stations;
    std::vector<Trail> m_trails;
};

}
