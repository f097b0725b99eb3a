// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Balls that fall while everything is done to them at once, from two threads: scenes come, balls come and go, rules and
// colliders change, and frames are looked at all the while.

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "core/physics/livesimulation.h"
#include "core/scene/sceneloader.h"

namespace {

using namespace romanesco;

class OneMesh final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &) const override
    {
        return "v -3 0 -3\nv 3 0 -3\nv 3 0 3\nv -3 0 3\nf 1 2 3\nf 1 3 4\n";
    }
};

std::string textOfDepth(int depth)
{
    return "v 0.5 -0.25 0\nv -0.5 0 0.5\nhalf 0.5 0.5 0.5\nx. \"x.obj\"\nt.p. (p, #, half)\nz<x>. [#, t.1, t.2] "
           "x\n<$>. z "
        + std::to_string(depth) + '\n';
}

std::shared_ptr<const Scene> sceneOfDepth(int depth)
{
    const OneMesh files;
    SceneLoader loader(files);
    return loader.load("a.fdo", textOfDepth(depth)).scene;
}

Ball ballAt(double x, double z)
{
    Ball ball;
    ball.position = {x, 1.0, z};
    ball.radius = 0.05;
    ball.restitution = 0.5;
    return ball;
}

void require(bool condition, const char *words)
{
    if (!condition) {
        std::fprintf(stderr, "failed: %s\n", words);
        std::abort();
    }
}

/// What a user does, one after another, as fast as it goes.
void play(LiveSimulation &live, int rounds, unsigned seed)
{
    constexpr ColliderKind kinds[] = {ColliderKind::Exact, ColliderKind::Bvh, ColliderKind::Approximate};
    for (int i = 0; i < rounds; ++i) {
        const unsigned chance = (seed = seed * 1'664'525U + 1'013'904'223U) >> 24U;
        switch (chance % 8U) {
        case 0:
            live.setScene(sceneOfDepth(static_cast<int>(chance % 5U)));
            break;
        case 1:
            live.setCollider({kinds[chance / 8U % 3U], 1e-3});
            break;
        case 2: {
            World::Options rules;
            rules.shrinkRate = chance % 16U == 2U ? 0.1 : 0.0;
            live.setRules(rules);
            break;
        }
        case 3:
            live.remove(chance % 32U);
            break;
        case 4:
            live.step();
            break;
        case 5:
            live.setSpeed(1.0 + chance);
            break;
        default:
            live.drop({ballAt(0.01 * chance - 1.0, 0.02 * chance - 2.0)});
            live.play();
        }
        std::this_thread::sleep_for(std::chrono::microseconds(10U * chance));
    }
}

}

int main()
{
    std::atomic<int> told = 0;
    {
        LiveSimulation live([&] { ++told; });
        live.startScene(sceneOfDepth(3));
        std::atomic<bool> isOver = false;
        std::jthread looking([&] {
            while (!isOver) {
                const auto frame = live.newest();
                require(frame->isStarted || frame->balls.empty(), "no balls before the start");
                for (const LiveSimulation::BallFrame &ball : frame->balls) {
                    require(ball.radius > 0.0 && ball.after.y > -1e9, "a ball is somewhere");
                }
                std::this_thread::yield();
            }
        });
        std::jthread other([&] { play(live, 150, 7); });
        play(live, 150, 1);
        other.join();
        std::atomic<int> recordings = 0;
        live.reset();
        live.step();
        live.record([&](const std::expected<Recording, std::string> &recording) {
            require(recording.has_value() && recording->steps == 1, "a recording of one step");
            live.replay(*recording);
            ++recordings;
        });
        while (recordings == 0 || live.newest()->remark.find("same state") == std::string::npos) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        live.play();
        isOver = true;
    }
    require(told > 10, "frames are told");
    return 0;
}
