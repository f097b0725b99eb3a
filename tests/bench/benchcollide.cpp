// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <memory>

#include <benchmark/benchmark.h>

#include "cgalcollider.h"
#include "collidesurvey.h"
#include "collidetables.h"
#include "collideworkloads.h"
#include "core/collide/bvhcollider.h"
#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/octreecollider.h"
#include "core/collide/simplecollider.h"
#include "embreecollider.h"

using namespace romanesco;
using namespace romanesco::bench;

namespace {

struct Made {
    std::unique_ptr<Collider> collider;
    double seconds;
};

/// A workload with what is made of it, each when it is first asked for.
class Bench
{
public:
    explicit Bench(Workload workload)
        : m_workload(std::move(workload))
    {
    }

    const Workload &workloadItself() const { return m_workload; }

    const Made &made(const std::string &kind)
    {
        Made &made = m_made[kind];
        if (!made.collider) {
            const auto begin = std::chrono::steady_clock::now();
            made.collider = make(kind);
            made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        }
        return made;
    }

    /// With answers where the workload is written out.
    const Answered &asked(Place place)
    {
        Answered &asked = m_asked[place];
        if (asked.points.empty()) {
            const bool isWrittenOut = !m_workload.all.faces.empty();
            const Collider &exact = *made(isWrittenOut ? "bvh" : "exact").collider;
            asked.points = queries(m_workload, exact, place);
            if (isWrittenOut) {
                asked = answered(exact, std::move(asked.points));
            }
        }
        return asked;
    }

    /// Made once, since counts are the same in every repetition.
    const Survey &surveyed(const std::string &kind, Place place, std::size_t most)
    {
        const auto [known, isNew] = m_surveys.try_emplace({kind, place});
        if (isNew) {
            const double reach = 0.02 * m_workload.diagonal;
            known->second = survey(*made(kind).collider, asked(place), reach, most);
        }
        return known->second;
    }

private:
    std::unique_ptr<Collider> make(const std::string &kind) const
    {
        const Mesh &mesh = m_workload.mesh;
        const Mesh &all = m_workload.all;
        const FractalGraph &graph = m_workload.graph;
        if (kind == "simple") {
            return std::make_unique<SimpleCollider>(graph, mesh);
        }
        if (kind == "greedy") {
            return std::make_unique<GreedyCollider>(GreedyCollider::create(graph, mesh).value());
        }
        if (kind == "octree") {
            return std::make_unique<OctreeCollider>(OctreeCollider::create(graph, mesh).value());
        }
        if (kind == "exact" || kind == "approximate") {
            const double excess = kind == "exact" ? 0.0 : 1e-3;
            return std::make_unique<ExactCollider>(
                ExactCollider::create(graph, m_workload.boxes, mesh, excess).value());
        }
        if (kind == "embree") {
            return std::make_unique<EmbreeCollider>(EmbreeCollider::flattened(all));
        }
        if (kind == "embree-instanced") {
            return std::make_unique<EmbreeCollider>(EmbreeCollider::instanced(graph, mesh));
        }
        if (kind == "cgal") {
            return std::make_unique<CgalCollider>(all);
        }
        return std::make_unique<BvhCollider>(BvhCollider::create(all).value());
    }

    Workload m_workload;
    std::map<std::string, Made> m_made;
    std::map<Place, Answered> m_asked;
    std::map<std::pair<std::string, Place>, Survey> m_surveys;
};

Bench &benchOf(const std::string &name, std::uint64_t depth, bool isWrittenOut)
{
    static std::map<std::pair<std::string, std::uint64_t>, std::unique_ptr<Bench>> written;
    static std::map<std::pair<std::string, std::uint64_t>, std::unique_ptr<Bench>> deep;
    std::unique_ptr<Bench> &bench = (isWrittenOut ? written : deep)[{name, depth}];
    if (!bench) {
        bench = std::make_unique<Bench>(isWrittenOut ? workload(name, depth) : deepWorkload(name, depth));
    }
    return *bench;
}

void count(benchmark::State &state, const std::string &what, const Survey::Cost &cost)
{
    state.counters[what] = cost.mean;
    state.counters[what + "_p99"] = cost.p99;
}

void count(benchmark::State &state, const Bench &bench, const Made &made, const Survey &survey)
{
    // what a collider does not tell is left out
    const bool tellsNodes = survey.nodeVisits.mean > 0.0;
    if (tellsNodes) {
        count(state, "nodes", survey.nodeVisits);
    }
    if (tellsNodes || survey.faceTests.mean > 0.0) {
        count(state, "faces", survey.faceTests);
    }
    const Workload &workload = bench.workloadItself();
    if (workload.all.faces.empty()) {
        state.counters["cut_off_%"] = 100.0 * survey.cutOff;
    } else {
        const std::size_t faces = workload.all.faces.size();
        state.counters["of"] = static_cast<double>(faces);
        state.counters["wrong_%"] = 100.0 * survey.wrong[0];
        state.counters["wrong_by_1%"] = 100.0 * survey.wrong[1];
        state.counters["wrong_by_10%"] = 100.0 * survey.wrong[2];
        state.counters["missed_%"] = 100.0 * survey.missed;
        state.counters["turned_%"] = 100.0 * survey.turned;
    }
    state.counters["build_ms"] = 1e3 * made.seconds;
    state.counters["graph_ms"] = 1e3 * workload.seconds;
    state.counters["build_KiB"] = static_cast<double>(made.collider->memoryUse()) / 1024.0;
    state.counters["graph_KiB"] = static_cast<double>(workload.graph.memoryUse() + workload.boxes.memoryUse()) / 1024.0;
    state.counters["search_KiB"] = static_cast<double>(survey.searchBytes) / 1024.0;
    if (const auto *embree = dynamic_cast<const EmbreeCollider *>(made.collider.get())) {
        state.counters["peak_KiB"] = static_cast<double>(embree->peakMemory()) / 1024.0;
    }
}

/// most: queries whose errors are counted.
void closest(benchmark::State &state, Bench &bench, const std::string &kind, Place place, std::size_t most)
{
    const std::vector<glm::dvec3> &points = bench.asked(place).points;
    const Made &made = bench.made(kind);
    const Survey &survey = bench.surveyed(kind, place, most);
    const auto search = made.collider->search();
    Hit hit;
    for (std::size_t i = 0; i < most / 15; ++i) {
        search->closest({.p = points[i], .nodeBudget = nodeBudget}, hit); // a search grows at first
    }
    std::size_t next = 0;
    for (auto _ : state) {
        search->closest({.p = points[next], .nodeBudget = nodeBudget}, hit);
        benchmark::DoNotOptimize(hit.distance);
        next = next + 1 < points.size() ? next + 1 : 0;
    }
    count(state, bench, made, survey);
}

std::string titled(const std::string &prefix, Place place, const std::string &kind)
{
    return prefix + "/" + placeNames[static_cast<std::size_t>(place)] + "/" + kind;
}

void registerWrittenOut(const Subject &subject, const std::vector<std::string> &kinds)
{
    const auto &[name, title, depth, goal] = subject;
    for (const Place place : {Place::Uniform, Place::Near, Place::Pocket}) {
        for (const std::string &kind : kinds) {
            const bool isSlow = kind == "simple";
            const std::string run = titled(name + "-" + std::to_string(depth), place, kind);
            auto *registered = benchmark::RegisterBenchmark(run, [=](benchmark::State &state) {
                closest(state, benchOf(name, depth, true), kind, place, isSlow ? 20 : 1'500);
            });
            if (isSlow) {
                registered->Iterations(3)->Repetitions(1);
            }
        }
    }
}

/// Graphs alone.
void registerDeep(const std::string &name, std::uint64_t depth)
{
    for (const Place place : {Place::Uniform, Place::Near}) {
        for (const std::string kind : {"exact", "approximate"}) {
            const std::string title = titled("depth/" + name + "-" + std::to_string(depth), place, kind);
            benchmark::RegisterBenchmark(title, [=](benchmark::State &state) {
                closest(state, benchOf(name, depth, false), kind, place, 1'500);
            });
        }
    }
}

/// Menger one level less deep than the dissertation's, for all to hold it.
const std::vector<Subject> subjects{{"two-sets", "two sets of 7", 3, 150}, {"tree7", "tree of 7", 5, 120},
                                    {"mild-tree", "mild tree", 5, 25},     {"rotated-tree", "rotated tree", 7, 200},
                                    {"uneven-scales", "uneven scales", 6}, {"appendix-b", "appendix B", 3, 60},
                                    {"sierpinski", "Sierpinski", 8, 45},   {"menger", "Menger", 4}};
const Subject huge{"menger", "Menger", 5};

void registerAll(bool withHuge)
{
    for (const Subject &subject : subjects) {
        registerWrittenOut(
            subject,
            {"exact", "approximate", "bvh", "greedy", "octree", "simple", "embree", "embree-instanced", "cgal"});
    }
    if (withHuge) {
        registerWrittenOut(huge, {"exact", "approximate", "bvh", "greedy", "embree", "embree-instanced"});
    }
    for (const Subject &subject : subjects) {
        for (const std::uint64_t depth : depths) {
            registerDeep(subject.name, depth);
        }
    }
}

}

/// Beside Google Benchmark's own: --markdown writes docs/colliders.md, by rounds in random order; --huge adds what takes
/// 10 GB.
int main(int argc, char **argv)
{
    const bool withHuge = takeFlag(argc, argv, "--huge");
    const bool asMarkdown = takeFlag(argc, argv, "--markdown");
    registerAll(withHuge);
    std::vector<Subject> all = subjects;
    all.push_back(huge);
    CollideTables tables(std::move(all));
    return run(
        argc, argv, asMarkdown ? &tables : nullptr,
        {"--benchmark_min_time=0.05s", "--benchmark_repetitions=5", "--benchmark_enable_random_interleaving=true"});
}
