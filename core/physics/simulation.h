// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <stop_token>
#include <string>

#include "ballplaces.h"
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

    /// Before the next step; its own number of the step does not count. After an error nothing has changed: what a collider
    /// cannot do, cancelled, no such ball.
    [[nodiscard]] std::expected<void, std::string> apply(const Recording::Input &input,
                                                         const std::stop_token &stop = {});
    void step();

    /// The surface of another scene; all balls stay as they are. There is no recording of that. The error is as of start(), and
    /// changes nothing.
    [[nodiscard]] std::expected<void, std::string> setScene(std::shared_ptr<const Scene> scene,
                                                            const std::stop_token &stop = {});

    [[nodiscard]] const World &world() const { return *m_world; }
    /// Where each ball was before the last step, counted from where it is now.
    [[nodiscard]] std::span<const glm::dvec3> before() const { return m_before; }
    /// Kinetic and of height, of all balls, in the world's units: their mass is their volume.
    [[nodiscard]] double energy() const;
    [[nodiscard]] const BallPlaces &places() const { return *m_places; }
    /// Whether all that was done is in the recording.
    [[nodiscard]] bool isRecorded() const { return m_isRecorded; }
    /// Up to here, of the scene that it started with.
    [[nodiscard]] Recording recording() const;

private:
    Simulation() = default;
    void add(const Ball &ball, std::uint32_t place);

    std::shared_ptr<const Scene> m_scene;
    std::unique_ptr<World> m_world;
    std::unique_ptr<BallPlaces> m_places;
    std::vector<glm::dvec3> m_before;
    SceneCollider::Options m_collider;
    Recording m_recording;
    bool m_isRecorded = true;
};

}
