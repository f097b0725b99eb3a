// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <stop_token>
#include <string>

#include "core/scene/scene.h"
#include "recording.h"
#include "world.h"

namespace romanesco {

/// A scene whose balls move, and a recording of all that is done to them.
class Simulation
{
public:
    /// With the balls of the scene. The error is a sentence: a ball without extent, what the collider cannot do, cancelled.
    [[nodiscard]] static std::expected<Simulation, std::string> start(std::shared_ptr<const Scene> scene,
                                                                      const World::Options &world,
                                                                      const SceneCollider::Options &collider,
                                                                      const std::stop_token &stop = {});

    /// Drops a ball, or searches the surface another way, before the next step. Its own number of the step does not count.
    /// After an error nothing has changed.
    [[nodiscard]] std::expected<void, std::string> apply(const Recording::Input &input,
                                                         const std::stop_token &stop = {});
    void step() { m_world->step(); }

    [[nodiscard]] const World &world() const { return *m_world; }
    /// Up to here.
    [[nodiscard]] Recording recording() const;

private:
    Simulation() = default;

    std::shared_ptr<const Scene> m_scene;
    std::unique_ptr<World> m_world;
    Recording m_recording;
};

}
