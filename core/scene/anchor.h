// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/fractal/statetable.h"
#include "scene.h"

namespace romanesco {

/// What is seen from a place in a scene, in that place's own coordinates. Immutable; shared between threads.
struct Surroundings {
    /// A node of an item's graph, all below it included.
    struct Node {
        std::size_t item = 0;
        Positions state;
        AffineMap hereFromNode = {};
        /// So many steps of `path` lead there, and this one after them.
        std::size_t sharedSteps = 0;
        std::optional<Step> step = {};
        /// Only the base mesh in the node's frame, and nothing below it.
        bool isMeshOnly = false;
    };

    std::shared_ptr<const Scene> scene;
    /// Nodes of one item follow one another.
    std::vector<Node> nodes;
    /// From the root of an item to the node that the place belongs to; empty in the world.
    std::vector<Step> path;
    std::size_t pathItem = 0;
    /// Round that node, or the whole scene: the size of what is nearby.
    Sphere nearby;
    /// From its middle, how far everything reaches.
    double reach = 0.0;
    /// Where the place's origin stands in the world, as exactly as the world's coordinates can say, and the logarithm to
    /// base 2 of its unit.
    glm::dvec3 origin{0.0};
    double unitExponent = 0.0;

    /// To the coordinates of the place. What is too far away for a double stays in its direction.
    [[nodiscard]] glm::dvec3 hereFromWorld(const glm::dvec3 &inWorld) const;
    /// As exactly as the world's coordinates can say.
    [[nodiscard]] glm::dvec3 worldFromHere(const glm::dvec3 &here) const;

    /// Sets reach, from the nodes and what is nearby.
    void measureReach();
};

/// A place in a scene that coordinates are counted from, so that what is near it keeps its precision however deep it lies
/// (world coordinates end where copies are 1e-16 of the whole). It is the world's origin, or that of a node of an item's
/// graph, with the world's axes and the node's size as unit: for a node of the map (A, t), x stands at (x - t) / |A| in
/// the operator norm. A node is reached down from the world by the maps of the text alone; no product of inverses is
/// made. Any affine map will do but one without any extent.
///
/// One thread. Memory: some hundred bytes a level.
class Anchor
{
public:
    /// At the world's origin.
    explicit Anchor(std::shared_ptr<const Scene> scene);

    /// old coordinates less offset, divided by scale: coordinates as they are after a move.
    struct Move {
        double scale = 1.0;
        glm::dvec3 offset{0.0};
        [[nodiscard]] glm::dvec3 operator()(const glm::dvec3 &old) const { return (old - offset) / scale; }
    };

    /// Goes to the node whose size fits what is looked at: the smallest in twice whose bound a ball round a point lies, as
    /// far as sixteen ways down show it. With hysteresis: out of a node only where the ball leaves four times its bound,
    /// or where a node of at most six tenths of its size is found. The moves, one for each level up or down, in the order
    /// they happened; each is to be applied to all that is counted from here. Cost: the children of the nodes passed.
    [[nodiscard]] std::vector<Move> follow(const glm::dvec3 &point, double radius);

    /// The same place in another scene, or as far along the way there as that scene has it.
    [[nodiscard]] std::vector<Move> moveTo(std::shared_ptr<const Scene> scene);

    /// Goes down from where it is, along one step; false where there is no such child, or it has no extent. From the world
    /// the step's map is the number of an item.
    bool enter(const Step &step);

    [[nodiscard]] bool isInWorld() const { return m_levels.empty(); }
    /// How many maps lead here.
    [[nodiscard]] std::size_t depth() const { return m_levels.empty() ? 0 : m_levels.size() - 1; }
    /// Round the node, in coordinates of here; the whole scene in the world.
    [[nodiscard]] Sphere bound() const;

    /// Everything but what stands on a node more than 1e9 times as large as the one here.
    [[nodiscard]] std::shared_ptr<const Surroundings> surroundings() const;

private:
    struct Level {
        /// From the level above; of a root the map is the item's number.
        Step step;
        AffineMap map;
        Positions state;
        /// The product of all maps down to here, without its norm.
        glm::dmat3 linear;
        /// Of this level's norm to that above.
        double ratio;
    };
    struct Child {
        Step step;
        AffineMap map;
        Positions state;
        /// In coordinates of here.
        Sphere bound;
    };

    template<typename Use>
    void forEachChild(std::size_t levels, Use &&use) const;
    /// On a way down, in the coordinates that it began in.
    struct Place {
        std::size_t from = 0;
        Step step;
        Positions state;
        AffineMap map;
        double norm = 1.0;
        double size = 0.0;
        double share = 0.0;
    };
    struct Way {
        std::vector<Step> steps;
        /// Of the last node's bound.
        double size = 0.0;
    };
    [[nodiscard]] static Way wayDown(StateTable &table, const Place &start, const glm::dvec3 &point, double radius);
    [[nodiscard]] Way wayDown(const glm::dvec3 &point, double radius) const;
    [[nodiscard]] std::optional<Move> enterWith(const Step &step);
    [[nodiscard]] std::vector<Move> goTo(std::span<const Step> path);
    [[nodiscard]] std::optional<Move> descend(const Child &child);
    [[nodiscard]] Move ascend();
    void setModel();
    [[nodiscard]] glm::dmat3 linear() const;
    void addSiblings(std::size_t level, double size, const glm::dvec3 &origin, Surroundings &found) const;

    std::shared_ptr<const Scene> m_scene;
    std::vector<Level> m_levels;
    /// Of the item's graph; null in the world.
    std::shared_ptr<StateTable> m_table;
};

}
