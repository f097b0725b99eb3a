// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "core/physics/scenephysics.h"
#include "dropping.h"
#include "physicstables.h"

using namespace romanesco;
using namespace romanesco::bench;

namespace {

constexpr double seconds = 2.0;

/// A ground with both engines, each made when it is first asked for.
class Bench
{
public:
    explicit Bench(Ground made)
        : ground(std::move(made))
        , exact(surfaceOf(ground.scene, {}).value().collider)
    {
    }

    const Engine &engine(const std::string &name)
    {
        std::unique_ptr<Engine> &engine = m_engines[name];
        if (!engine) {
            engine = name == "ours" ? worldEngine(ground) : bulletEngine(ground);
        }
        return *engine;
    }

    const Ground ground;
    const std::shared_ptr<const Collider> exact;

private:
    std::map<std::string, std::unique_ptr<Engine>> m_engines;
};

Bench &benchOf(const Subject &subject)
{
    static std::map<std::string, std::unique_ptr<Bench>> benches;
    std::unique_ptr<Bench> &bench = benches[subject.name];
    if (!bench) {
        bench = std::make_unique<Bench>(groundOf(subject.name, subject.depth, subject.angles));
    }
    return *bench;
}

Bench &trayBench()
{
    static Bench bench(inTray(groundOf(subjects[0].name, subjects[0].depth, subjects[0].angles)));
    return bench;
}

Drop dropAt(double radius, unsigned rate, std::size_t balls)
{
    return {.radius = radius * Ground::size,
            .balls = balls,
            .steps = static_cast<std::size_t>(seconds * rate),
            .options = {.timeStep = 1.0 / rate}};
}

void registerDrop(const Subject &subject, double radius, unsigned rate, const std::string &name)
{
    const bool isLarge = radius >= 0.05;
    const Drop drop = dropAt(radius, rate, isLarge ? 100 : 1'000);
    benchmark::RegisterBenchmark(dropRun(subject, radius, rate, name), [=](benchmark::State &state) {
        Bench &bench = benchOf(subject);
        const Engine &engine = bench.engine(name);
        for (auto _ : state) {
            const Timing timing = timed(engine, bench.ground, drop, isLarge && name != "ours" ? 2 : 3, true);
            const Sinking sinking = sunk(*bench.exact, timing.positions, drop.radius);
            state.counters["rate"] = 1e-6 * static_cast<double>(timing.ballSteps) / timing.cpuSeconds;
            state.counters["steps"] = static_cast<double>(timing.ballSteps);
            state.counters["lost"] = static_cast<double>(timing.lost);
            state.counters["most_%"] = 100.0 * sinking.most;
            state.counters["median_%"] = 100.0 * sinking.median;
            state.counters["through"] = static_cast<double>(sinking.tunnelled);
        }
        state.counters["build_ms"] = 1e3 * engine.seconds();
        state.counters["KiB"] = static_cast<double>(engine.bytes()) / 1024.0;
        state.counters["faces"] = static_cast<double>(bench.ground.all.faces.size());
    })->Iterations(1);
}

/// bench: makes it.
void registerCrowd(const std::string &name, Bench &(*bench)(const Subject &), const Subject &subject, double radius,
                   std::size_t balls, bool areSolid)
{
    Drop drop = dropAt(radius, 240, balls);
    drop.start = name == "tray" ? Start::Rain : Start::Drop;
    drop.options.areSolid = areSolid;
    drop.options.threads = 2;
    benchmark::RegisterBenchmark(crowdRun(name, balls, areSolid), [=](benchmark::State &state) {
        Bench &made = bench(subject);
        for (auto _ : state) {
            const Timing timing = timed(made.engine("ours"), made.ground, drop, 2, false);
            state.counters["real_time"] = seconds / timing.wallSeconds;
            state.counters["slowest"] = 0.25 / timing.slowest;
            state.counters["cpu_time"] = 2.0 * seconds / timing.cpuSeconds;
            const auto steps = static_cast<double>(timing.ballSteps);
            state.counters["awake_%"] = 100.0 * steps / static_cast<double>(drop.balls * drop.steps);
            state.counters["touching_%"] = 100.0 * static_cast<double>(timing.touching) / steps;
            state.counters["lost"] = static_cast<double>(timing.lost);
        }
    })->Iterations(1);
}

void registerShot(const std::string &name)
{
    Drop drop = dropAt(radii[0], 240, 2'000);
    drop.start = Start::Shot;
    drop.steps = 1;
    drop.speed = 1'000.0 * drop.radius / drop.options.timeStep;
    benchmark::RegisterBenchmark(shotRun(name), [=](benchmark::State &state) {
        Bench &bench = benchOf(subjects[0]);
        for (auto _ : state) {
            const Timing timing = timed(bench.engine(name), bench.ground, drop, 5, false);
            state.counters["step_us"] = 1e6 * timing.cpuSeconds / static_cast<double>(drop.balls);
            state.counters["lost"] = static_cast<double>(timing.lost);
        }
    })->Iterations(1);
}

void registerAll()
{
    for (const Subject &subject : subjects) {
        for (const double radius : radii) {
            for (const unsigned rate : rates) {
                for (const std::string &engine : engines) {
                    registerDrop(subject, radius, rate, engine);
                }
            }
        }
    }
    for (const std::string &engine : engines) {
        registerShot(engine);
    }
    for (const Subject &subject : subjects) {
        registerCrowd(subject.name, benchOf, subject, radii[0], crowds.back(), false);
    }
    for (const std::size_t crowd : crowds) {
        for (const bool areSolid : {false, true}) {
            registerCrowd(
                "tray", [](const Subject &) -> Bench & { return trayBench(); }, subjects[0], radii[1], crowd, areSolid);
        }
    }
}

}

/// Beside Google Benchmark's own: --markdown writes docs/physics.md.
int main(int argc, char **argv)
{
    const bool asMarkdown = takeFlag(argc, argv, "--markdown");
    registerAll();
    PhysicsTables tables;
    return run(argc, argv, asMarkdown ? &tables : nullptr, {});
}
