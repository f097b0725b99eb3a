// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/compile.h>
#include <fmt/format.h>

#include "core/export/exporter.h"
#include "core/fractal/copies.h"
#include "core/scene/sceneloader.h"

using namespace romanesco;

namespace {

/// Files in memory.
class Texts final : public FileAccess
{
public:
    explicit Texts(std::string mesh)
        : m_mesh(std::move(mesh))
    {
    }
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &) const override
    {
        return m_mesh;
    }

private:
    std::string m_mesh;
};

const std::string cube = "v -1.5 -1.5 -1.5\nv 1.5 -1.5 -1.5\nv -1.5 1.5 -1.5\nv 1.5 1.5 -1.5\n"
                         "v -1.5 -1.5 1.5\nv 1.5 -1.5 1.5\nv -1.5 1.5 1.5\nv 1.5 1.5 1.5\n"
                         "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\n"
                         "f 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";

std::shared_ptr<const Scene> load(const std::string &text)
{
    const Texts files(cube);
    std::shared_ptr<const Scene> scene = SceneLoader(files).load("a.fdo", text).scene;
    if (!scene) {
        std::fprintf(stderr, "there are errors in\n%s", text.c_str());
        std::abort();
    }
    return scene;
}

/// 1,920,000 faces whose coordinates come again and again.
std::shared_ptr<const Scene> menger()
{
    std::string text = "x. \"cube.obj\"\nthird 0.3333333333 0.3333333333 0.3333333333\nbox.p. (p, #, third)\n";
    std::string set;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1;
        const int y = i / 3 % 3 - 1;
        const int z = i / 9 - 1;
        if ((x == 0) + (y == 0) + (z == 0) < 2) {
            const std::string name = "p" + std::to_string(i);
            text += name + " " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
            set += (set.empty() ? "box." : ", box.") + name;
        }
    }
    return load(text + "z<x>. [" + set + "] x\n<$>. z 4\n");
}

/// 1,179,648 faces, each at angles of its own: no coordinate comes again.
std::shared_ptr<const Scene> turnedTree()
{
    return load("x. \"cube.obj\"\na 0 1 0\nb 0 0.8 0.1\nc 0.1 0.7 0\nd 0 0.6 0\ne 10 20 30\nf -40 50 6\ng 7 -80 9\n"
                "h 100 11 12\ns 0.7 0.7 0.7\nt.p.q. (p, q, s)\nz<x>. [t.a.e, t.b.f, t.c.g, t.d.h] x\n<$>. z 8\n");
}

void exportIt(benchmark::State &state, const std::shared_ptr<const Scene> &scene, ExportOptions options)
{
    std::uint64_t bytes = 0;
    for (auto _ : state) {
        CountingSink sink;
        benchmark::DoNotOptimize(exportScene(*scene, options, sink));
        bytes = sink.count();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

void forecastIt(benchmark::State &state, const std::shared_ptr<const Scene> &scene)
{
    for (auto _ : state) {
        benchmark::DoNotOptimize(forecast(*scene, {}));
    }
}

/// The same text as the export's, line by line, by another way to write numbers: line(text, keyword, numbers) appends
/// one. The text is dropped when it is long.
template<typename Line>
void writePlainly(benchmark::State &state, const std::shared_ptr<const Scene> &scene, const Line &line)
{
    const Model &model = *scene->items.front().model;
    std::uint64_t bytes = 0;
    for (auto _ : state) {
        bytes = 0;
        std::string text;
        std::size_t before = 1;
        CopyWalk walk(model.graph);
        while (walk.next()) {
            for (const glm::dvec3 &vertex : model.mesh->vertices) {
                const glm::dvec3 v = walk.modelFromBase()(vertex);
                line(text, 'v', v.x, v.y, v.z);
            }
            for (const Mesh::Face &face : model.mesh->faces) {
                line(text, 'f', before + face[0], before + face[1], before + face[2]);
            }
            before += model.mesh->vertices.size();
            if (text.size() > 200'000) {
                bytes += text.size();
                text.clear();
            }
        }
        bytes += text.size();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

constexpr auto toChars = [](std::string &text, char keyword, auto... numbers) {
    char buffer[128];
    char *to = buffer;
    *to++ = keyword;
    ((*to++ = ' ', to = std::to_chars(to, buffer + sizeof(buffer), numbers).ptr), ...);
    *to++ = '\n';
    text.append(buffer, to);
};

constexpr auto printed = [](std::string &text, char keyword, auto a, auto b, auto c) {
    char buffer[128];
    const int size = std::is_floating_point_v<decltype(a)>
        ? std::snprintf(buffer, sizeof(buffer), "%c %.17g %.17g %.17g\n", keyword, static_cast<double>(a),
                        static_cast<double>(b), static_cast<double>(c))
        : std::snprintf(buffer, sizeof(buffer), "%c %zu %zu %zu\n", keyword, static_cast<std::size_t>(a),
                        static_cast<std::size_t>(b), static_cast<std::size_t>(c));
    text.append(buffer, static_cast<std::size_t>(size));
};

constexpr auto formatted = [](std::string &text, char keyword, auto a, auto b, auto c) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("{} {} {} {}\n"), keyword, a, b, c);
};

constexpr auto streamed = [](std::string &text, char keyword, auto a, auto b, auto c) {
    // one stream for all lines, as for a file
    static std::ostringstream stream;
    stream.precision(17);
    stream.seekp(0);
    stream << keyword << ' ' << a << ' ' << b << ' ' << c << '\n';
    text.append(stream.view().substr(0, static_cast<std::size_t>(stream.tellp())));
};

void add(const char *name, const std::shared_ptr<const Scene> &scene)
{
    const auto named = [&](const char *way) { return std::string(name) + "/" + way; };
    const auto plain = [&](const char *way, const auto &line) {
        benchmark::RegisterBenchmark(named(way), [=](benchmark::State &state) {
            writePlainly(state, scene, line);
        })->Unit(benchmark::kMillisecond);
    };
    const auto exports = [&](const char *way, const ExportOptions &options) {
        benchmark::RegisterBenchmark(named(way), exportIt, scene, options)->Unit(benchmark::kMillisecond);
    };
    exports("obj", {});
    plain("to_chars", toChars);
    plain("libfmt", formatted);
    plain("printf %.17g", printed);
    plain("iostream", streamed);
    exports("obj, 6 digits", {.digits = 6});
    exports("ply", {.format = ExportFormat::Ply});
    exports("stl", {.format = ExportFormat::Stl});
    benchmark::RegisterBenchmark(named("forecast"), forecastIt, scene)->Unit(benchmark::kMillisecond);
}

}

int main(int argc, char **argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    add("menger", menger());
    add("turned tree", turnedTree());
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
