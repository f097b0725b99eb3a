// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballplaces.h"

#include <algorithm>
#include <cmath>
#include <format>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// A place's coordinates are coarse for what is smaller, in parts of them.
constexpr double coarse = 1e-8;
/// In radii, the node that a ball is counted from.
constexpr double nodeInRadii = 1e3;
/// So many times as large as what is nearby, a place knows what is there.
constexpr double farthest = 1e6;
/// Steps between two looks whether coordinates have become too coarse.
constexpr std::uint64_t stepsBetweenLooks = 16;
constexpr double leastUnit = 1e-300;
constexpr int mostTimes = 100;

/// How far it may come in a step.
double wayOf(const World &world, const BallState &ball)
{
    const Laws &laws = world.laws(ball.place);
    return longestWay(ball.velocity, laws.gravityOn(ball), laws.timeStep);
}

/// An anchor tells only so many levels at a time.
std::vector<Anchor::Move> movesTo(Anchor &anchor, glm::dvec3 point, double radius)
{
    std::vector<Anchor::Move> all;
    for (int i = 0; i < mostTimes; ++i) {
        const auto moves = anchor.follow(point, radius);
        if (moves.empty()) {
            break;
        }
        for (const Anchor::Move &move : moves) {
            point = move(point);
            radius /= move.scale;
            all.push_back(move);
        }
    }
    return all;
}

/// Balls are no places: each has nothing in it. All else keeps its number.
std::shared_ptr<const Scene> withoutBalls(const std::shared_ptr<const Scene> &scene)
{
    const auto isBall = [](const SceneItem &item) { return item.kind == SceneDescription::Kind::Ball; };
    if (std::ranges::none_of(scene->items, isBall)) {
        return scene;
    }
    const auto nothing = std::make_shared<const Mesh>();
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(*nothing));
    const auto model = std::make_shared<const Model>(Model{nothing, graph, BoxBounds(graph, *nothing), {}, {}});
    Scene rest = *scene;
    for (SceneItem &item : rest.items) {
        item.model = isBall(item) ? model : item.model;
    }
    return std::make_shared<const Scene>(std::move(rest));
}

}

Ball inWorld(const Ball &ball, const Surroundings *place)
{
    Ball moved = ball;
    if (place) {
        const double unit = std::exp2(place->unitExponent);
        moved.position = place->worldFromHere(ball.position);
        moved.velocity *= unit;
        moved.radius *= unit;
    }
    return moved;
}

BallPlaces::BallPlaces(const std::shared_ptr<const Scene> &scene)
    : m_scene(withoutBalls(scene))
    , m_anchors(1, Anchor(m_scene))
    , m_surroundings(1)
{
}

bool BallPlaces::isFarOut(const World &world, const BallState &ball) const
{
    return ball.place > 0
        && glm::length(ball.position) + wayOf(world, ball) > farthest * m_surroundings[ball.place]->nearby.radius;
}

bool BallPlaces::isTooCoarse(const World &world, const BallState &ball) const
{
    return ball.radius < coarse * (glm::length(ball.position) + world.surface(ball.place)->size);
}

std::expected<std::uint32_t, std::string> BallPlaces::enter(World &world, const ScenePlace &place,
                                                            const std::stop_token &stop)
{
    auto anchor = Anchor::at(m_scene, place);
    if (!anchor) {
        return std::unexpected(std::format("the scene has no place {}", textOf(place)));
    }
    return placeOf(world, std::move(*anchor), stop);
}

/// The one that is there already, one that no ball is at any more, or one more.
std::expected<std::uint32_t, std::string> BallPlaces::placeOf(World &world, Anchor anchor, const std::stop_token &stop)
{
    const auto node = anchor.place();
    std::uint32_t free = 0;
    for (std::uint32_t i = 0; i < m_anchors.size(); ++i) {
        if (m_anchors[i].place() == node) {
            return i;
        }
        const bool isFree = std::ranges::find(world.balls(), i, &BallState::place) == world.balls().end();
        free = i > 0 && free == 0 && isFree ? i : free;
    }
    return makeWhole(world, stop).transform([&] {
        if (free == 0) {
            free = static_cast<std::uint32_t>(m_anchors.size());
            m_anchors.push_back(std::move(anchor));
            m_surroundings.emplace_back();
        } else {
            m_anchors[free] = std::move(anchor);
        }
        setSurface(world, free);
        return free;
    });
}

std::expected<void, std::string> BallPlaces::makeWhole(const World &world, const std::stop_token &stop)
{
    if (m_whole) {
        return {};
    }
    auto own = std::dynamic_pointer_cast<const SceneCollider>(world.surface()->collider);
    if (own && own->searchesBelow()) {
        m_whole = std::move(own);
        return {};
    }
    return SceneCollider::create(m_scene, {}, stop).transform([&](SceneCollider &&made) {
        m_whole = std::make_shared<const SceneCollider>(std::move(made));
    });
}

void BallPlaces::setSurface(World &world, std::uint32_t place)
{
    m_surroundings[place] = m_anchors[place].surroundings();
    const Surroundings &here = *m_surroundings[place];
    world.setSurface({.collider = std::make_shared<const SceneCollider>(m_whole->at(m_surroundings[place])),
                      .isProved = true,
                      .size = glm::length(here.nearby.centre) + here.nearby.radius,
                      .isExact = m_whole->promise() == Promise::Exact},
                     place, std::max(leastUnit, std::exp2(here.unitExponent)));
}

void BallPlaces::follow(World &world, std::size_t first)
{
    const bool looks = first > 0 || world.stepCount() % stepsBetweenLooks == 0;
    for (std::size_t i = first; i < world.balls().size(); ++i) {
        const BallState &ball = world.balls()[i];
        if (ball.isAsleep || !(isFarOut(world, ball) || (looks && isTooCoarse(world, ball)))) {
            continue;
        }
        Anchor anchor = m_anchors[ball.place];
        const auto moves = movesTo(anchor, ball.position, nodeInRadii * ball.radius + wayOf(world, ball));
        if (moves.empty()) {
            continue;
        }
        if (const auto place = placeOf(world, std::move(anchor), {})) {
            world.recount(i, *place, moves);
        }
    }
}

void BallPlaces::setScene(World &world, const std::shared_ptr<const Scene> &scene)
{
    m_scene = withoutBalls(scene);
    m_whole.reset();
    const bool hasPlaces = m_anchors.size() > 1 && makeWhole(world, {}).has_value();
    for (std::uint32_t place = 0; place < m_anchors.size(); ++place) {
        Anchor &anchor = m_anchors[place];
        const auto moves = hasPlaces ? anchor.moveTo(m_scene) : anchor.leave();
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            if (world.balls()[i].place == place && !moves.empty()) {
                world.recount(i, anchor.isInWorld() ? 0 : place, moves);
            }
        }
        if (!anchor.isInWorld()) {
            setSurface(world, place);
        }
    }
    m_anchors.front() = Anchor(m_scene);
}

}
