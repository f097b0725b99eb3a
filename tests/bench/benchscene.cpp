// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/base/file.h"
#include "core/scene/anchor.h"
#include "core/scene/sceneloader.h"

using namespace romanesco;

namespace {

/// A fractal with a tetrahedron at the origin, and a way down into it.
struct Sample {
    std::shared_ptr<const Scene> scene;
    std::vector<Anchor> places;
};

class OneMesh final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &) const override
    {
        return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
    }
};

std::string fractal(const std::vector<std::string> &places, const std::string &angles, double scale)
{
    std::string text = "x. \"m.obj\"\n";
    std::string names;
    for (const std::string &place : places) {
        text += std::format("v {}\n", place);
    }
    const std::size_t count = places.size();
    text += std::format("r {}\ns {} {} {}\n", angles, scale, scale, scale);
    for (std::size_t i = 1; i <= count; ++i) {
        text += std::format("m{}. ({}, r, s)\n", i, i);
        names += (i > 1 ? ", m" : "m") + std::to_string(i);
    }
    return std::format("{}z<x>. [{}] x\n<$>. z 10000\n", text, names);
}

/// So many levels down, the first by the first map and the others by one map or by any; and a hundred below each other.
Sample sampleOf(const std::string &text, int depth, std::uint32_t map, std::uint32_t choices)
{
    Sample sample{SceneLoader(OneMesh()).load("f.fdo", text).scene, {}};
    std::mt19937_64 random(1);
    Anchor anchor(sample.scene);
    anchor.enter({0, 0});
    anchor.enter({0, 0});
    for (int i = 1; i < depth + 100; ++i) {
        anchor.enter({0, map + static_cast<std::uint32_t>(random() % choices)});
        if (i >= depth) {
            sample.places.push_back(anchor);
        }
    }
    return sample;
}

Sample sampleOf(int kind, int depth)
{
    static const std::vector<std::string> cube{"0 0 0",   "0.5 0 0",   "0 0.5 0",   "0.5 0.5 0",
                                               "0 0 0.5", "0.5 0 0.5", "0 0.5 0.5", "0.5 0.5 0.5"};
    switch (kind) {
    case 0: // a point at which parts touch
        return sampleOf(fractal({"0 0 0", "0.5 0 0", "0 0.5 0", "0 0 0.5"}, "0 0 0", 0.5), depth, 1, 1);
    case 1: // in the middle of a solid cube: all of it is borders
        return sampleOf(fractal(cube, "0 0 0", 0.5), depth, 7, 1);
    case 2: // parts that lie within each other, turned
        return sampleOf(fractal({"0 0 0", "0.2 0 0", "0 0.2 0", "0 0 0.2"}, "10 20 30", 0.8), depth, 0, 4);
    default: // a way at random in dust
        return sampleOf(fractal({"0 0 0", "0.5 0 0", "0 0.5 0", "0 0 0.5"}, "10 20 30", 0.4), depth, 0, 4);
    }
}

const std::vector<std::string> kinds{"point", "solid", "crowd", "apart"};

/// At a place that nothing is known of.
void surroundingsAtOnce(benchmark::State &state)
{
    const Sample sample = sampleOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const auto path = sample.places.front().surroundings()->path;
    for (auto run : state) {
        state.PauseTiming();
        Anchor anchor(sample.scene);
        anchor.enter({0, 0});
        for (const Step &step : path) {
            anchor.enter(step);
        }
        state.ResumeTiming();
        benchmark::DoNotOptimize(anchor.surroundings());
    }
    state.SetLabel(kinds[static_cast<std::size_t>(state.range(0))]);
}

/// A level below the place before, down a hundred levels and up again.
void surroundingsOfTheNext(benchmark::State &state)
{
    const Sample sample = sampleOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    std::size_t i = 0;
    std::size_t nodes = 0;
    for (auto run : state) {
        const std::size_t turn = i++ % (2 * sample.places.size());
        const std::size_t at = turn < sample.places.size() ? turn : 2 * sample.places.size() - 1 - turn;
        nodes = sample.places[at].surroundings()->nodes.size();
    }
    state.counters["nodes"] = static_cast<double>(nodes);
    state.SetLabel(kinds[static_cast<std::size_t>(state.range(0))]);
}

/// As for each movement of the camera, which leads nowhere else here.
void followNowhere(benchmark::State &state)
{
    Sample sample = sampleOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    Anchor &anchor = sample.places.front();
    const Sphere bound = anchor.bound();
    (void)anchor.follow(bound.centre, 0.9 * bound.radius);
    for (auto run : state) {
        benchmark::DoNotOptimize(anchor.follow(bound.centre, 0.9 * bound.radius));
    }
    state.SetLabel(kinds[static_cast<std::size_t>(state.range(0))]);
}

BENCHMARK(followNowhere)->ArgsProduct({{0, 1, 2, 3}, {5, 1000}})->Unit(benchmark::kMicrosecond);
BENCHMARK(surroundingsAtOnce)->ArgsProduct({{0, 1, 2, 3}, {30, 300, 1000, 3000}})->Unit(benchmark::kMicrosecond);
BENCHMARK(surroundingsOfTheNext)->ArgsProduct({{0, 1, 2, 3}, {30, 300, 1000, 3000}})->Unit(benchmark::kMicrosecond);

}
