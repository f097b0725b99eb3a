// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <pthread.h>

#include "core/formats/fdoreader.h"
#include "core/formats/objreader.h"
#include "core/formats/sdoreader.h"
#include "core/text/linemap.h"
#include "core/text/places.h"
#include "tests/bench/texts.h"

using namespace romanesco;

namespace {

struct Reading {
    Diagnostics diagnostics;
    bool hasMeaning = false;
};

/// In the language that the shape's name says.
Reading readText(std::string_view shape, std::string_view text)
{
    if (shape.starts_with("obj")) {
        ObjResult result = readObj(text);
        return {std::move(result.diagnostics), !result.mesh.faces.empty()};
    }
    if (shape.starts_with("scene")) {
        SdoResult result = readSdo(text);
        const SdoResult copy = result; // copying and destroying may recurse too
        return {copy.diagnostics, copy.description.has_value()};
    }
    const FdoResult result = readFdo(text);
    const FdoResult copy = result;
    return {copy.diagnostics, copy.description.has_value()};
}

/// As `check` does: a line for each remark.
std::size_t lengthOfRemarks(const Reading &reading, std::string_view text)
{
    const LineMap lines(text);
    Places places(lines);
    std::size_t length = 0;
    for (const Diagnostic &diagnostic : reading.diagnostics) {
        length += toLines(diagnostic, "FILE", places).size();
    }
    return length;
}

/// Reads a text of the shape on a stack of some kilobytes: what a file says must not decide how deep calls go. A stack
/// that is used up is a crash.
int readOnSmallStack(const TextShape &shape, std::size_t kilobytes)
{
    struct Job {
        std::string_view shape;
        std::string text;
        Reading result;
    } job{shape.name, shape.make(shape.largeSize), {}};
    const auto read = [](void *argument) -> void * {
        auto &work = *static_cast<Job *>(argument);
        work.result = readText(work.shape, work.text);
        return nullptr;
    };
    pthread_attr_t attributes;
    pthread_t thread;
    pthread_attr_init(&attributes);
    if (pthread_attr_setstacksize(&attributes, kilobytes * 1024) != 0
        || pthread_create(&thread, &attributes, read, &job) != 0) {
        std::fprintf(stderr, "no thread with a stack of %zu KB\n", kilobytes);
        return 1;
    }
    pthread_join(thread, nullptr);
    if (shape.isRight && (!job.result.hasMeaning || !job.result.diagnostics.empty())) {
        std::fprintf(stderr, "%s is meant to be right: %s\n", std::string(shape.name).c_str(),
                     job.result.diagnostics.empty() ? "no result" : job.result.diagnostics[0].message().c_str());
        return 1;
    }
    if (!shape.isRight && job.result.diagnostics.empty()) {
        std::fprintf(stderr, "%s is meant to be wrong\n", std::string(shape.name).c_str());
        return 1;
    }
    return 0;
}

}

/// cost_language make SHAPE TIMES    writes a text of TIMES the shape's small size
/// cost_language read SHAPE FILE     reads it: what a count of instructions is taken of
/// cost_language stack SHAPE KB      reads one of its large size on a small stack
int main(int argc, char **argv)
{
    const std::string_view mode = argc == 4 ? argv[1] : "";
    if (mode == "read" && argc == 4) {
        std::ifstream file(argv[3], std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        const Reading result = readText(argv[2], text);
        return file && (result.hasMeaning || lengthOfRemarks(result, text) > 0) ? 0 : 1;
    }
    const TextShape *shape = argc == 4 ? findTextShape(argv[2]) : nullptr;
    if (shape != nullptr && mode == "stack") {
        return readOnSmallStack(*shape, std::strtoull(argv[3], nullptr, 10));
    }
    if (shape != nullptr && mode == "make") {
        const std::string text = shape->make(shape->smallSize * std::strtoull(argv[3], nullptr, 10));
        return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
    }
    std::fprintf(stderr, "usage: cost_language make SHAPE TIMES | read SHAPE FILE | stack SHAPE KB\n");
    return 1;
}
