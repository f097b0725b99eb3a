// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "simulation.h"

#include <format>

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
    for (const Ball &ball : *balls) {
        simulation.m_world->add(ball);
    }
    simulation.m_collider = collider;
    simulation.m_recording = {.world = world, .collider = collider, .startHash = simulation.m_world->stateHash()};
    return simulation;
}

std::expected<void, std::string> Simulation::apply(const Recording::Input &input, const std::stop_token &stop)
{
    if (const auto *ball = std::get_if<Ball>(&input.what)) {
        m_world->add(*ball);
    } else if (const auto *removal = std::get_if<Recording::Removal>(&input.what)) {
        if (removal->ball >= m_world->balls().size()) {
            return std::unexpected(std::format("there is no ball {}", removal->ball));
        }
        m_world->remove(removal->ball);
    } else if (const auto *rules = std::get_if<World::Options>(&input.what)) {
        m_world->setRules(*rules);
    } else {
        const auto &collider = std::get<SceneCollider::Options>(input.what);
        auto surface = surfaceOf(m_scene, collider, stop);
        if (!surface) {
            return std::unexpected(surface.error());
        }
        m_world->setSurface(std::move(*surface));
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
    m_isRecorded = false;
    return {};
}

Recording Simulation::recording() const
{
    Recording recording = m_recording;
    recording.steps = m_world->stepCount();
    recording.endHash = m_world->stateHash();
    return recording;
}

}
