// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <chrono>
#include <deque>
#include <thread>

#include <benchmark/benchmark.h>

#include "renderbench.h"
#include "renderpictures.h"
#include "rendertables.h"

using namespace romanesco;
using namespace romanesco::bench;

namespace {

constexpr PictureSize fullHd{1920, 1080};

const std::vector<Subject> subjects{
    {.name = "menger", .title = "Menger", .depth = 3},
    {.name = "menger", .title = "Menger", .depth = 4},
    {.name = "menger",
     .title = "Menger",
     .depth = 5,
     .size = fullHd,
     .comparedSize = fullHd,
     .comparedPlaces = {Place::Far, Place::Near, Place::Inside},
     .timedTolerances = {0, 1, 2, 4, 8}},
    {.name = "sierpinski", .title = "Sierpinski", .depth = 8},
    {.name = "sierpinski", .title = "Sierpinski", .depth = 10, .comparedPlaces = {Place::Far}},
    {.name = "tree7", .title = "tree of 7", .depth = 5},
    {.name = "two-sets", .title = "two sets", .depth = 3, .comparedPlaces = {Place::Far}},
    {.name = "tree", .title = "tree", .depth = 7, .comparedPlaces = {Place::Far}},
    {.name = "romanesco", .title = "Romanesco", .depth = 2, .comparedPlaces = {Place::Far}},
    {.name = "appendix-b", .title = "appendix B", .depth = 4},
    {.name = "appendix-b",
     .title = "appendix B",
     .depth = 6,
     .comparedPlaces = {Place::Far},
     .referenceTolerance = 0.25},
};

std::vector<Subject> deeper()
{
    std::vector<Subject> all;
    for (const std::uint64_t depth : {8, 10, 12, 16, 20, 30}) {
        all.push_back({.name = "sierpinski", .title = "Sierpinski", .depth = depth});
    }
    for (const std::uint64_t depth : {5, 6, 8, 10, 15, 25}) {
        all.push_back({.name = "menger", .title = "Menger", .depth = depth});
    }
    return all;
}

void count(benchmark::State &state, const Start &start)
{
    state.counters["load_ms"] = start.load;
    state.counters["first_ms"] = start.first;
    state.counters["start_cpu_ms"] = start.cpu;
}

void count(benchmark::State &state, const PictureError &error, const std::string &kind)
{
    state.counters["error_mean/" + kind] = error.mean;
    state.counters["error_rms/" + kind] = error.rms;
    state.counters["error_%/" + kind] = 100.0 * error.share;
}

void countErrors(benchmark::State &state, RenderBench &bench, Place place, bool isFlattened)
{
    if (isFlattened) {
        count(state, bench.errorAt(place, std::nullopt), "flattened");
    }
    for (const int tolerance : tolerances) {
        if (tolerance >= bench.subject().referenceTolerance) {
            count(state, bench.errorAt(place, tolerance), std::to_string(tolerance));
        }
    }
}

void drawOurs(benchmark::State &state, OurFrames &frames, const View &view)
{
    frames.draw(view); // a steady frame has one before it
    for (auto _ : state) {
        frames.draw(view);
    }
    const DrawStatistics statistics = frames.statistics();
    state.counters["copies"] = static_cast<double>(statistics.instances);
    state.counters["nodes"] = static_cast<double>(statistics.statesVisited);
    state.counters["MB"] = static_cast<double>(statistics.bufferBytes + statistics.graphBytes) / 1e6;
}

void drawFlattened(benchmark::State &state, RenderBench &bench, Place place)
{
    const View view = bench.view(place, 0.0);
    RenderBench::Beside &beside = bench.beside();
    for (auto _ : state) {
        beside.flattened->draw(view);
    }
    state.counters["copies"] = static_cast<double>(beside.copies);
    state.counters["MB"] = static_cast<double>(beside.flattened->bufferBytes()) / 1e6;
    state.counters["unlike_%"] = 100.0 * bench.difference(place).share;
    state.counters["unlike_mean"] = bench.difference(place).mean;
    count(state, beside.start);
}

/// The time of a frame is what goes by; beside it stands the processor time of all threads.
template<typename Function>
void add(const std::string &name, Function function)
{
    benchmark::RegisterBenchmark(name, function)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
}

void addSubject(OurFrames &frames, RenderBench &bench)
{
    const Subject &subject = bench.subject();
    const bool isFlattened = copiesAsWritten(fractalText(subject.name, subject.depth).description()).has_value();
    for (const Place place : places) {
        const auto named = [&](const std::string &kind) { return runName(subject.name, subject.depth, place, kind); };
        if (isFlattened) {
            add(named("flattened"), [&bench, place](benchmark::State &state) { drawFlattened(state, bench, place); });
        }
        for (const int tolerance : subject.timedTolerances) {
            add(named(std::to_string(tolerance)), [=, &frames, &bench](benchmark::State &state) {
                if (place == Place::Far && tolerance == 1) {
                    count(state, bench.ourStart());
                }
                if (bench.isCompared(place) && tolerance == 1) {
                    countErrors(state, bench, place, isFlattened);
                }
                drawOurs(state, frames, bench.view(place, tolerance));
            });
        }
    }
}

void addDeeper(OurFrames &frames, RenderBench &bench)
{
    add(depthRunName(bench.subject().name, bench.subject().depth),
        [&](benchmark::State &state) { drawOurs(state, frames, bench.view(Place::Far, 1.0)); });
}

double secondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string folderOfPictures(int &argc, char **argv)
{
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::string(argv[i]) == "--pictures") {
            const std::string folder = argv[i + 1];
            std::copy(argv + i + 2, argv + argc, argv + i);
            argc -= 2;
            return folder;
        }
    }
    return {};
}

/// With the deepest of each.
std::vector<Subject> eachOnce()
{
    std::vector<Subject> once;
    for (const Subject &subject : subjects) {
        if (!once.empty() && once.back().name == subject.name) {
            once.pop_back();
        }
        once.push_back(subject);
    }
    return once;
}

}

/// Beside Google Benchmark's own: --markdown writes docs/rendering.md, by rounds in random order; --pictures FOLDER writes its
/// pictures.
int main(int argc, char **argv)
{
    const bool asMarkdown = takeFlag(argc, argv, "--markdown");
    const std::string folder = folderOfPictures(argc, argv);

    // Before anything else, since shaders are compiled once.
    const auto begin = std::chrono::steady_clock::now();
    OurFrames frames;
    const auto first = fractalText("appendix-b", 6).scene();
    frames.setScene(first);
    frames.draw(viewOf("appendix-b", *first, Place::Far, {1280, 720}, 1.0));
    const double coldSeconds = secondsSince(begin);

    const GlProgram program = flattenedProgram();
    RenderBench warm(frames, program, {.name = "menger", .title = {}, .depth = 1});
    warm.beside().flattened->draw(warm.view(Place::Far, 0.0));

    std::deque<RenderBench> benches;
    for (const Subject &subject : subjects) {
        addSubject(frames, benches.emplace_back(frames, program, subject));
    }
    for (const Subject &subject : deeper()) {
        addDeeper(frames, benches.emplace_back(frames, program, subject));
    }
    if (!folder.empty()) {
        writePictures(frames, eachOnce(), folder);
    }
    const std::string machine =
        frames.description() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
    RenderTables tables(machine, coldSeconds, subjects, deeper());
    return run(
        argc, argv, asMarkdown ? &tables : nullptr,
        {"--benchmark_min_time=0.05s", "--benchmark_repetitions=3", "--benchmark_enable_random_interleaving=true"});
}
