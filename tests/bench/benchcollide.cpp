// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <chrono>
#include <functional>
#include <map>
#include <memory>

#include <benchmark/benchmark.h>

#include "cgalcollider.h"
#include "collideworkloads.h"
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
    Bench(const std::string &name, std::uint64_t depth)
        : m_workload(workload(name, depth))
        , m_boxes(m_workload.graph, m_workload.mesh)
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

    struct Asked {
        std::vector<glm::dvec3> points;
        std::vector<double> distances;
    };
    const Asked &asked(Place place)
    {
        Asked &asked = m_asked[place];
        if (asked.points.empty()) {
            const Collider &exact = *made("bvh").collider;
            asked.points = queries(m_workload, exact, place);
            const auto search = exact.search();
            Hit hit;
            for (const glm::dvec3 &p : asked.points) {
                search->closest({p}, hit);
                asked.distances.push_back(hit.distance);
            }
        }
        return asked;
    }

private:
    std::unique_ptr<Collider> make(const std::string &kind) const
    {
        const auto &[mesh, graph, all, diagonal] = m_workload;
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
            return std::make_unique<ExactCollider>(ExactCollider::create(graph, m_boxes, mesh, excess).value());
        }
        if (kind == "embree") {
            return std::make_unique<EmbreeCollider>(EmbreeCollider::flattened(all));
        }
        if (kind == "cgal") {
            return std::make_unique<CgalCollider>(all);
        }
        return std::make_unique<BvhCollider>(BvhCollider::create(all).value());
    }

    Workload m_workload;
    BoxBounds m_boxes;
    std::map<std::string, Made> m_made;
    std::map<Place, Asked> m_asked;
};

Bench &benchOf(const std::string &name, std::uint64_t depth)
{
    static std::map<std::string, std::unique_ptr<Bench>> benches;
    std::unique_ptr<Bench> &bench = benches[name];
    if (!bench) {
        bench = std::make_unique<Bench>(name, depth);
    }
    return *bench;
}

/// Shares of the answers, in per cent.
void countErrors(benchmark::State &state, Bench &bench, const Collider &collider, Place place, std::size_t most)
{
    const Bench::Asked &asked = bench.asked(place);
    const std::size_t count = std::min(most, asked.points.size());
    const auto search = collider.search();
    const double reach = 0.02 * bench.workloadItself().diagonal;
    double faceTests = 0.0;
    double nodeVisits = 0.0;
    std::array<double, 3> wrong{};
    double missed = 0.0;
    Hit hit;
    for (std::size_t i = 0; i < count; ++i) {
        search->closest({asked.points[i]}, hit);
        const double truth = asked.distances[i];
        faceTests += static_cast<double>(hit.cost.faceTests);
        nodeVisits += static_cast<double>(hit.cost.nodeVisits);
        for (std::size_t k = 0; k < wrong.size(); ++k) {
            const double allowed = std::array{1e-6, 0.01, 0.1}[k] * truth;
            wrong[k] += std::abs(hit.distance - truth) > allowed ? 1.0 : 0.0;
        }
        missed += truth < reach && hit.distance >= reach ? 1.0 : 0.0;
    }
    const auto mean = [&](double sum) { return sum / static_cast<double>(count); };
    state.counters["faces"] = mean(faceTests);
    state.counters["nodes"] = mean(nodeVisits);
    state.counters["wrong_%"] = 100.0 * mean(wrong[0]);
    state.counters["wrong_by_1%"] = 100.0 * mean(wrong[1]);
    state.counters["wrong_by_10%"] = 100.0 * mean(wrong[2]);
    state.counters["missed_%"] = 100.0 * mean(missed);
}

/// most: queries whose errors are counted.
void closest(benchmark::State &state, const std::string &name, std::uint64_t depth, const std::string &kind,
             Place place, std::size_t most)
{
    Bench &bench = benchOf(name, depth);
    const std::vector<glm::dvec3> &points = bench.asked(place).points;
    const Made &made = bench.made(kind);
    const auto search = made.collider->search();
    Hit hit;
    std::size_t next = 0;
    for (auto _ : state) {
        search->closest({points[next++ % points.size()]}, hit);
        benchmark::DoNotOptimize(hit.distance);
    }
    countErrors(state, bench, *made.collider, place, most);
    state.counters["build_ms"] = 1e3 * made.seconds;
    state.counters["KiB"] = static_cast<double>(made.collider->memoryUse()) / 1024.0;
    state.counters["of"] = static_cast<double>(bench.workloadItself().all.faces.size());
}

void registerAll()
{
    // Menger one level less deep than the dissertation's, to be written out
    const std::vector<std::pair<std::string, std::uint64_t>> workloads{
        {"two-sets", 3},      {"tree7", 5},      {"mild-tree", 5},  {"rotated-tree", 7},
        {"uneven-scales", 6}, {"appendix-b", 3}, {"sierpinski", 8}, {"menger", 4}};
    for (const auto &[name, depth] : workloads) {
        for (const Place place : {Place::Uniform, Place::Near, Place::Pocket}) {
            for (const std::string kind :
                 {"simple", "greedy", "octree", "bvh", "exact", "approximate", "embree", "cgal"}) {
                const std::string title = name + "/" + placeNames[static_cast<std::size_t>(place)] + "/" + kind;
                const bool isSlow = kind == "simple";
                auto *run = benchmark::RegisterBenchmark(title, [=](benchmark::State &state) {
                    closest(state, name, depth, kind, place, isSlow ? 3 : 1'500);
                });
                if (isSlow) {
                    run->Iterations(3);
                }
            }
        }
    }
}

}

int main(int argc, char **argv)
{
    registerAll();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    benchmark::RunSpecifiedBenchmarks();
}
