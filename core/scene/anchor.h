// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sceneplace.h"
#include "surroundings.h"
#include "waylevel.h"

namespace romanesco {

class Neighbours;

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
    /// or where a node of at most six tenths of its size is found. So it crosses borders to what is among its surroundings,
    /// however far up the ways part. The moves, one for each level up or down and one for such a border, in the order they
    /// happened; each is to be applied to all that is counted from here. Cost: the children of the nodes passed, and that of
    /// surroundings().
    [[nodiscard]] std::vector<Move> follow(const glm::dvec3 &point, double radius);

    /// The same place in another scene, or as far along the way there as that scene has it.
    [[nodiscard]] std::vector<Move> moveTo(std::shared_ptr<const Scene> scene);

    /// At a node; nothing where there is none, or it has no extent.
    [[nodiscard]] static std::optional<Anchor> at(std::shared_ptr<const Scene> scene, const ScenePlace &place);

    /// Goes down from where it is, along one step; false where there is no such child, or it has no extent. From the world
    /// the step's map is the number of an item.
    bool enter(const Step &step);

    /// Up to the world.
    [[nodiscard]] std::vector<Move> leave() { return goTo(std::span<const Step>()); }

    /// To a node, up to where the ways part and down from there, as far as there is one. What is small is lost only where that is
    /// far above both.
    [[nodiscard]] std::vector<Move> goTo(const ScenePlace &place);

    [[nodiscard]] bool isInWorld() const { return m_levels.empty(); }
    /// How many maps lead here.
    [[nodiscard]] std::size_t depth() const { return m_levels.empty() ? 0 : m_levels.size() - 1; }
    /// Nothing in the world.
    [[nodiscard]] std::optional<ScenePlace> place() const;
    /// Round the node, in coordinates of here; the whole scene in the world.
    [[nodiscard]] Sphere bound() const;

    /// Everything that stands on a node at most 1e9 times as large as the one here; and of all else what comes near the
    /// largest of those, or the next above it (see Neighbours).
    [[nodiscard]] std::shared_ptr<const Surroundings> surroundings() const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

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
        std::size_t from = none;
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
        AffineMap map = {};
        /// The number of the place that it begins at, which that has for a step.
        std::size_t start = 0;
    };
    [[nodiscard]] static Way wayDown(StateTable &table, std::vector<Place> places, const glm::dvec3 &point,
                                     double radius);
    [[nodiscard]] Way wayDown(const glm::dvec3 &point, double radius) const;
    [[nodiscard]] static std::vector<Place> placesAcross(const Surroundings &all,
                                                         std::span<const Surroundings::Node> nodes,
                                                         const glm::dvec3 &point, double radius, std::size_t levels);
    [[nodiscard]] std::optional<Move> goAcross(const glm::dvec3 &point, double radius, std::size_t levels, double size);
    [[nodiscard]] std::optional<Move> enterWith(const Step &step);
    [[nodiscard]] std::vector<Move> goTo(std::span<const Step> path);
    [[nodiscard]] std::optional<Move> descend(const Child &child);
    [[nodiscard]] Move ascend();
    void setModel();
    [[nodiscard]] glm::dmat3 linear() const;
    void addSiblings(std::size_t level, double size, const glm::dvec3 &origin, Surroundings &found) const;

    std::shared_ptr<const Scene> m_scene;
    std::vector<WayLevel> m_levels;
    /// Of the item's graph; null in the world.
    std::shared_ptr<StateTable> m_table;
    /// Those of copies of an anchor are the same.
    std::shared_ptr<Neighbours> m_neighbours;
};

}
