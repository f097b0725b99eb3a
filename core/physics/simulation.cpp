// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "simulation.h"

#include <algorithm>
#include <format>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenephysics.h"

namespace romanesco {

std::expected<Simulation, std::string> Simulation::start(std::shared_ptr<const Scene> scene,
                                                         const World::Options &world,
                                                         const SceneCollider::Options &collider,
                                                         const std::stop_token &stop)
{
    const auto balls = ballsOf(*scene);
    if (!balls) {
        return std::unexpected(balls.error());
    }
    auto surface = surfaceOf(scene, collider, stop);
    if (!surface) {
        return std::unexpected(surface.error());
    }
    Simulation simulation;
    simulation.m_scene = std::move(scene);
    simulation.m_world = std::make_unique<World>(std::move(*surface), world);
    simulation.m_places = std::make_unique<BallPlaces>(simulation.m_scene);
    for (const Ball &ball : *balls) {
        simulation.add(ball, 0);
    }
    simulation.m_collider = collider;
    simulation.m_recording = {.world = world, .collider = collider, .startHash = simulation.m_world->stateHash()};
    return simulation;
}

void Simulation::add(const Ball &ball, std::uint32_t place)
{
    m_world->add(ball, place);
    m_places->follow(*m_world, m_world->balls().size() - 1);
    m_before.push_back(m_world->balls().back().position);
}

void Simulation::step()
{
    m_places->follow(*m_world);
    std::ranges::transform(m_world->balls(), m_before.begin(), &BallState::position);
    m_world->step();
}

std::expected<void, std::string> Simulation::apply(const Recording::Input &input, const std::stop_token &stop)
{
    if (const auto *drop = std::get_if<Recording::Drop>(&input.what)) {
        const auto place = drop->place ? m_places->enter(*m_world, *drop->place, stop) : 0;
        if (!place) {
            return std::unexpected(place.error());
        }
        add(drop->ball, *place);
    } else if (const auto *removal = std::get_if<Recording::Removal>(&input.what)) {
        if (removal->ball >= m_world->balls().size()) {
            return std::unexpected(std::format("there is no ball {}", removal->ball));
        }
        m_world->remove(removal->ball);
        m_before.erase(m_before.begin() + static_cast<std::ptrdiff_t>(removal->ball));
    } else if (const auto *rules = std::get_if<World::Options>(&input.what)) {
        m_world->setRules(*rules);
    } else {
        const auto &collider = std::get<SceneCollider::Options>(input.what);
        auto surface = surfaceOf(m_scene, collider, stop);
        if (!surface) {
            return std::unexpected(surface.error());
        }
        m_world->setSurface(std::move(*surface));
        m_places->setScene(*m_world, m_scene);
        m_collider = collider;
    }
    m_recording.inputs.push_back({m_world->stepCount(), input.what});
    return {};
}

std::expected<void, std::string> Simulation::setScene(std::shared_ptr<const Scene> scene, const std::stop_token &stop)
{
    auto surface = surfaceOf(scene, m_collider, stop);
    if (!surface) {
        return std::unexpected(surface.error());
    }
    m_world->setSurface(std::move(*surface));
    m_scene = std::move(scene);
    m_places->setScene(*m_world, m_scene);
    std::ranges::transform(m_world->balls(), m_before.begin(), &BallState::position);
    m_isRecorded = false;
    return {};
}

double Simulation::energy() const
{
    double energy = 0.0;
    for (const BallState &state : m_world->balls()) {
        const Ball ball = inWorld(state, m_places->surroundings(state.place).get());
        const double mass = 4.0 / 3.0 * std::numbers::pi * ball.radius * ball.radius * ball.radius;
        energy += mass
            * (0.5 * glm::dot(ball.velocity, ball.velocity)
               - glm::dot(m_world->options().laws.gravityOn(ball), ball.position));
    }
    return energy;
}

Recording Simulation::recording() const
{
    Recording recording = m_recording;
    recording.steps = m_world->stepCount();
    recording.endHash = m_world->stateHash();
    return recording;
}

}
