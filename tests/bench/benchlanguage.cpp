// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

#include "core/formats/fdoreader.h"
#include "core/language/fdodocument.h"
#include "texts.h"

using namespace romanesco;

namespace {

/// Reading a text of one shape: seconds a line, bytes a second.
void read(benchmark::State &state, const TextShape &shape)
{
    const std::string text = shape.make(static_cast<std::size_t>(state.range(0)));
    const auto lines = static_cast<double>(std::ranges::count(text, '\n'));
    for (auto _ : state) {
        benchmark::DoNotOptimize(readFdo(text));
    }
    const auto passes = static_cast<double>(state.iterations());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.counters["lines"] = lines;
    state.counters["per_line"] =
        benchmark::Counter(lines * passes, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// What an editor waits for at each key: a line more or less in the middle of a person's text, read and resolved.
void keystroke(benchmark::State &state)
{
    const std::string without = findTextShape("person")->make(static_cast<std::size_t>(state.range(0)));
    std::string with = without;
    with.insert(with.find('\n', with.size() / 2) + 1, "v 1 2 3\n");
    FdoDocument document(without);
    bool isWith = false;
    for (auto _ : state) {
        isWith = !isWith;
        document.setText(isWith ? with : without);
        benchmark::DoNotOptimize(document.model.diagnostics.size());
    }
    state.counters["lines"] = static_cast<double>(document.syntax.lineCount());
}

void add(std::string_view name, std::initializer_list<std::int64_t> sizes)
{
    const TextShape *shape = findTextShape(name);
    if (shape == nullptr) {
        std::fprintf(stderr, "there are no texts named %s\n", std::string(name).c_str());
        std::abort();
    }
    auto *made = benchmark::RegisterBenchmark("readFdo/" + std::string(name), read, *shape);
    made->Unit(benchmark::kMillisecond);
    for (const std::int64_t size : sizes) {
        made->Arg(size);
    }
}

}

int main(int argc, char **argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    add("person", {1'000, 10'000, 100'000});
    add("chained", {10'000, 20'000});
    add("one-set", {100'000, 200'000});
    add("long-comment", {50'000'000});
    add("errors", {100'000});
    benchmark::RegisterBenchmark("keystroke/person", keystroke)
        ->Unit(benchmark::kMillisecond)
        ->Arg(10'000)
        ->Arg(100'000);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
