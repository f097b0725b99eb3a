// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <chrono>

#include "core/physics/scenephysics.h"
#include "core/physics/world.h"
#include "falling.h"

namespace romanesco::bench {

namespace {

Laws lawsOf(const Falling::Options &options)
{
    Laws laws;
    laws.timeStep = options.timeStep;
    return laws;
}

class WorldFalling final : public Falling
{
public:
    WorldFalling(const Surface &surface, const std::vector<Ball> &balls, const Options &options)
        : m_world(surface, {.laws = lawsOf(options), .areSolid = options.areSolid, .threads = options.threads})
    {
        for (const Ball &ball : balls) {
            m_world.add(ball);
        }
    }

    void step() override { m_world.step(); }

    void look(std::vector<State> &states) const override
    {
        states.resize(m_world.balls().size());
        for (std::size_t i = 0; i < states.size(); ++i) {
            const BallState &ball = m_world.balls()[i];
            states[i] = {ball.position, !ball.isAsleep, m_world.reports()[i].contacts > 0};
        }
    }

    [[nodiscard]] std::size_t lostSteps() const override { return m_world.lostSteps(); }

private:
    World m_world;
};

class WorldEngine final : public Engine
{
public:
    explicit WorldEngine(const Ground &ground)
        : m_ground(ground)
    {
        const auto begin = std::chrono::steady_clock::now();
        m_surface = surfaceOf(ground.scene, {}).value();
        m_seconds = ground.seconds + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    [[nodiscard]] std::unique_ptr<Falling> fall(const std::vector<Ball> &balls,
                                                const Falling::Options &options) const override
    {
        return std::make_unique<WorldFalling>(m_surface, balls, options);
    }
    [[nodiscard]] double seconds() const override { return m_seconds; }
    [[nodiscard]] std::size_t bytes() const override { return m_ground.bytes + m_surface.collider->memoryUse(); }

private:
    const Ground &m_ground;
    Surface m_surface;
    double m_seconds = 0.0;
};

}

std::unique_ptr<Engine> worldEngine(const Ground &ground)
{
    return std::make_unique<WorldEngine>(ground);
}

}
