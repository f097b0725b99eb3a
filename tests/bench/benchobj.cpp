// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <istream>
#include <memory>
#include <spanstream>
#include <string>
#include <string_view>
#include <utility>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <benchmark/benchmark.h>
#include <tiny_obj_loader.h>

#include "core/base/file.h"
#include "core/formats/objreader.h"
#include "objtexts.h"

using namespace romanesco;

namespace {

[[noreturn]] void fail(const char *what)
{
    std::fprintf(stderr, "%s\n", what);
    std::exit(1);
}

/// Readers of a text, and of a file by the reader's own way to open it, give the faces that they read.
std::size_t readOurs(const std::string &text)
{
    const ObjResult result = readObj(text);
    if (hasErrors(result.diagnostics)) {
        fail(result.diagnostics.back().message().c_str());
    }
    return result.mesh.faces.size();
}

std::string textOf(const char *path)
{
    auto text = DiskFiles().read(path);
    if (!text) {
        fail(text.error().c_str());
    }
    return std::move(*text);
}

std::size_t readOursFile(const char *path)
{
    return readOurs(textOf(path));
}

std::size_t readTinyObjStream(std::istream &stream)
{
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream)) {
        fail(error.c_str());
    }
    std::size_t faces = 0;
    for (const tinyobj::shape_t &shape : shapes) {
        faces += shape.mesh.num_face_vertices.size();
    }
    return faces;
}

std::size_t readTinyObj(const std::string &text)
{
    std::ispanstream stream(text);
    return readTinyObjStream(stream);
}

std::size_t readTinyObjFile(const char *path)
{
    std::ifstream stream(path);
    return readTinyObjStream(stream);
}

std::size_t facesOf(const Assimp::Importer &importer)
{
    const aiScene *scene = importer.GetScene();
    if (scene == nullptr) {
        fail(importer.GetErrorString());
    }
    std::size_t faces = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        faces += scene->mMeshes[i]->mNumFaces;
    }
    return faces;
}

std::size_t readAssimp(const std::string &text)
{
    Assimp::Importer importer;
    importer.ReadFileFromMemory(text.data(), text.size(), 0, "obj");
    return facesOf(importer);
}

std::size_t readAssimpFile(const char *path)
{
    Assimp::Importer importer;
    importer.ReadFile(path, 0);
    return facesOf(importer);
}

/// What no reader can be faster than.
std::size_t copyOnly(const std::string &text)
{
    const auto bytes = std::make_unique_for_overwrite<char[]>(text.size());
    std::memcpy(bytes.get(), text.data(), text.size());
    benchmark::DoNotOptimize(bytes.get());
    return 0;
}

/// What this program takes by itself.
std::size_t ignoreFile(const char * /*path*/)
{
    return 0;
}

struct Reader {
    const char *name;
    std::size_t (*read)(const std::string &text);
    std::size_t (*readFile)(const char *path);
};
constexpr Reader readers[] = {{"romanesco", readOurs, readOursFile},
                              {"tinyobjloader", readTinyObj, readTinyObjFile},
                              {"assimp", readAssimp, readAssimpFile},
                              {"memcpy", copyOnly, ignoreFile}};

void read(benchmark::State &state, const Reader &reader, const std::string &text)
{
    std::size_t faces = 0;
    for (auto _ : state) {
        faces = reader.read(text);
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.counters["faces"] = static_cast<double>(faces);
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

/// Each reader in a process of its own: the most memory that it had at once.
int printPeaks(const char *path)
{
    for (const Reader &reader : readers) {
        const pid_t child = ::fork();
        if (child == 0) {
            std::printf("%-14s %8zu faces", reader.name, reader.readFile(path));
            std::fflush(stdout);
            std::_Exit(0);
        }
        int status = 0;
        rusage usage{};
        if (child < 0 || ::wait4(child, &status, 0, &usage) != child || status != 0) {
            fail("no process, or it failed");
        }
        std::printf(" %8.1f MiB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
        std::fflush(stdout); // else the next process prints it again
    }
    return 0;
}

}

/// bench_obj [FILE.obj…] [Google Benchmark's options]   our reader beside others: bytes a second of processor time
/// bench_obj make FACES export|exact                      writes a generated text to stdout
/// bench_obj peak FILE.obj                                the most memory that each takes for a file
int main(int argc, char **argv)
{
    const std::string_view mode = argc > 1 ? argv[1] : "";
    if (mode == "make" && argc == 4) {
        const auto style = std::string_view(argv[3]) == "exact" ? ObjStyle::Exact : ObjStyle::Export;
        const std::string text = objText(std::strtoull(argv[2], nullptr, 10), style);
        return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
    }
    if (mode == "peak" && argc == 3) {
        return printPeaks(argv[2]);
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
