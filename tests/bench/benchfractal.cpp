// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdint>

#include <benchmark/benchmark.h>

#include "core/fractal/boxbounds.h"
#include "core/fractal/copies.h"
#include "core/geometry/trs.h"

using namespace romanesco;

namespace {

FractalGraph graphOf(const std::vector<AffineMap> &maps, bool holdsIdentity, std::uint64_t depth)
{
    FractalDescription description;
    TransformSet &set = description.sets.emplace_back();
    set.maps = maps;
    set.uses.resize(maps.size());
    set.holdsIdentity = holdsIdentity;
    LevelSequence::Builder builder;
    builder.beginRepeat(depth);
    builder.addLevel(0);
    builder.endRepeat();
    description.levels = std::move(builder).build();
    return FractalGraph::build(description, {{0, 0, 0}, 1}).value();
}

/// The 20 maps of the Menger sponge, or some of them.
std::vector<AffineMap> spongeMaps(std::size_t count)
{
    std::vector<AffineMap> maps;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 place(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (glm::dot(place, place) > 1.5 && maps.size() < count) {
            maps.push_back({glm::dmat3(1.0 / 3.0), place / 1.5});
        }
    }
    return maps;
}

/// Seconds a copy, of so many maps repeated so often; the first `most` copies.
void walk(benchmark::State &state, std::size_t mapCount, bool holdsIdentity, std::uint64_t depth, std::int64_t most)
{
    const FractalGraph graph = graphOf(spongeMaps(mapCount), holdsIdentity, depth);
    std::int64_t copies = 0;
    std::size_t bytes = 0;
    for (auto _ : state) {
        CopyWalk walk(graph);
        for (std::int64_t i = 0; i < most && walk.next(); ++i) {
            const AffineMap *copy = &walk.modelFromBase();
            benchmark::DoNotOptimize(copy);
            ++copies;
        }
        bytes = walk.memoryUse();
    }
    state.counters["copies"] = static_cast<double>(copies) / static_cast<double>(state.iterations());
    state.counters["bytes"] = static_cast<double>(bytes);
    state.counters["per_copy"] =
        benchmark::Counter(static_cast<double>(copies), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// A tree: each smaller and turned another way.
std::vector<AffineMap> turnedMaps(int count, double size)
{
    std::vector<AffineMap> maps;
    for (int i = 0; i < count; ++i) {
        maps.push_back(mapFromParts({0.1 * i, 1, 0.2}, {30.0 + 7 * i, 50.0 * i, 20}, glm::dvec3(size)));
    }
    return maps;
}

/// Makes a graph, or with boxes; a mesh of one face of about the size of the sphere.
void build(benchmark::State &state, const std::vector<AffineMap> &maps, bool holdsIdentity, std::uint64_t depth,
           bool withBoxes)
{
    const Mesh mesh{.vertices = {{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}}, .faces = {{0, 1, 2}}};
    std::size_t bytes = 0;
    for (auto _ : state) {
        const FractalGraph graph = graphOf(maps, holdsIdentity, depth);
        bytes = graph.memoryUse();
        if (withBoxes) {
            const BoxBounds boxes(graph, mesh);
            bytes += boxes.memoryUse();
        }
    }
    state.counters["bytes"] = static_cast<double>(bytes);
}

constexpr std::int64_t all = std::int64_t(1) << 62;

BENCHMARK_CAPTURE(walk, sponge of depth 4, 20, false, 4, all)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walk, tree of depth 6, 6, true, 6, all)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walk, one map a million times, 1, false, 1'000'000, all)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walk, one map or none a million times, 1, true, 1'000'000, all)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walk, two maps a million times, 2, false, 1'000'000, 1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, sponge of depth 5, spongeMaps(20), false, 5, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, sponge of depth 5 with boxes, spongeMaps(20), false, 5, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, sponge of depth 10 ^ 6, spongeMaps(20), false, 1'000'000, false)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, sponge of depth 10 ^ 6 with boxes, spongeMaps(20), false, 1'000'000, true)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, tree of depth 7, turnedMaps(6, 0.6), true, 7, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, tree of depth 7 with boxes, turnedMaps(6, 0.6), true, 7, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, tree of depth 10 ^ 6, turnedMaps(6, 0.6), true, 1'000'000, false)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, tree of depth 10 ^ 6 with boxes, turnedMaps(6, 0.6), true, 1'000'000, true)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, spiral of depth 10 ^ 6, turnedMaps(2, 0.97), false, 1'000'000, false)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build, spiral of depth 10 ^ 6 with boxes, turnedMaps(2, 0.97), false, 1'000'000, true)
    ->Unit(benchmark::kMicrosecond);

void buildRow(benchmark::State &state)
{
    build(state, {{glm::dmat3(1.0), {1, 0, 0}}}, true, 1'000'000'000, true);
}
BENCHMARK(buildRow)->Name("build/row of 10^9 with boxes")->Unit(benchmark::kMicrosecond);

}
