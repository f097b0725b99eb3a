// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <spanstream>
#include <string>
#include <string_view>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <benchmark/benchmark.h>
#include <tiny_obj_loader.h>

#include "core/formats/objreader.h"
#include "objtexts.h"

using namespace romanesco;

namespace {

[[noreturn]] void fail(const char *what)
{
    std::fprintf(stderr, "%s\n", what);
    std::exit(1);
}

/// Each gives the faces that it read.
std::size_t readOurs(const std::string &text)
{
    const ObjResult result = readObj(text);
    if (hasErrors(result.diagnostics)) {
        fail(result.diagnostics.back().message().c_str());
    }
    return result.mesh.faces.size();
}

std::size_t readTinyObj(const std::string &text)
{
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    std::ispanstream stream(text);
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream)) {
        fail(error.c_str());
    }
    std::size_t faces = 0;
    for (const tinyobj::shape_t &shape : shapes) {
        faces += shape.mesh.num_face_vertices.size();
    }
    return faces;
}

std::size_t readAssimp(const std::string &text)
{
    Assimp::Importer importer;
    const aiScene *scene = importer.ReadFileFromMemory(text.data(), text.size(), 0, "obj");
    if (scene == nullptr) {
        fail(importer.GetErrorString());
    }
    std::size_t faces = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        faces += scene->mMeshes[i]->mNumFaces;
    }
    return faces;
}

/// What no reader can be faster than.
std::size_t copyOnly(const std::string &text)
{
    const auto bytes = std::make_unique_for_overwrite<char[]>(text.size());
    std::memcpy(bytes.get(), text.data(), text.size());
    benchmark::DoNotOptimize(bytes.get());
    return 0;
}

struct Reader {
    const char *name;
    std::size_t (*read)(const std::string &text);
};
constexpr Reader readers[] = {{"romanesco", readOurs},
                              {"tinyobjloader", readTinyObj},
                              {"assimp", readAssimp},
                              {"memcpy", copyOnly}};

void read(benchmark::State &state, const Reader &reader, const std::string &text)
{
    std::size_t faces = 0;
    for (auto _ : state) {
        faces = reader.read(text);
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.counters["faces"] = static_cast<double>(faces);
}

std::string textOf(const char *path)
{
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) {
        fail("cannot read the file");
    }
    return text;
}

void add(const std::string &name, std::string text)
{
    const auto kept = std::make_shared<const std::string>(std::move(text));
    for (const Reader &reader : readers) {
        benchmark::RegisterBenchmark(name + '/' + reader.name, [kept, &reader](benchmark::State &state) {
            read(state, reader, *kept);
        })->Unit(benchmark::kMillisecond);
    }
}

/// The most memory that a program which reads the file and then lets one of the readers have it has used.
int peak(std::string_view name, const char *path)
{
    const std::string text = textOf(path);
    for (const Reader &reader : readers) {
        if (name == reader.name) {
            std::printf("%zu faces of %.1f MB\n", reader.read(text), static_cast<double>(text.size()) * 1e-6);
        }
    }
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM")) {
            std::printf("%s\n", line.c_str());
        }
    }
    return 0;
}

}

/// bench_obj [FILE.obj…] [Google Benchmark's options]   our reader beside others: bytes a second of processor time
/// bench_obj make FACES export|exact                      writes a generated text to stdout
/// bench_obj peak READER FILE.obj                         the most memory that reading takes
int main(int argc, char **argv)
{
    const std::string_view mode = argc > 1 ? argv[1] : "";
    if (mode == "make" && argc == 4) {
        const auto style = std::string_view(argv[3]) == "exact" ? ObjStyle::Exact : ObjStyle::Export;
        const std::string text = objText(std::strtoull(argv[2], nullptr, 10), style);
        return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
    }
    if (mode == "peak" && argc == 4) {
        return peak(argv[2], argv[3]);
    }
    benchmark::Initialize(&argc, argv);
    add("export/237664", objText(237'664, ObjStyle::Export));
    add("export/277654", objText(277'654, ObjStyle::Export));
    add("exact/277654", objText(277'654, ObjStyle::Exact));
    for (int i = 1; i < argc; ++i) {
        add(argv[i], textOf(argv[i]));
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
