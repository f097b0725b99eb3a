// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <pthread.h>

#include "core/formats/fdoreader.h"
#include "tests/bench/texts.h"

using namespace romanesco;

namespace {

/// Reads a text of the shape on a stack of some kilobytes: what a file says must not decide how deep calls go. A stack
/// that is used up is a crash.
int readOnSmallStack(const TextShape &shape, std::size_t kilobytes)
{
    struct Job {
        std::string text;
        FdoResult result;
    } job{shape.make(shape.largeSize), {}};
    const auto read = [](void *argument) -> void * {
        auto &work = *static_cast<Job *>(argument);
        work.result = readFdo(work.text);
        const FdoResult copy = work.result; // copying and destroying may recurse too
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
    if (shape.isRight && (!job.result.description || !job.result.diagnostics.empty())) {
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
/// cost_language read FILE           reads it: what a count of instructions is taken of
/// cost_language stack SHAPE KB      reads one of its large size on a small stack
int main(int argc, char **argv)
{
    const std::string_view mode = argc == 3 || argc == 4 ? argv[1] : "";
    if (mode == "read" && argc == 3) {
        std::ifstream file(argv[2], std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        const FdoResult result = readFdo(text);
        return file && (result.description || !result.diagnostics.empty()) ? 0 : 1;
    }
    const TextShape *shape = argc == 4 ? findTextShape(argv[2]) : nullptr;
    if (shape != nullptr && mode == "stack") {
        return readOnSmallStack(*shape, std::strtoull(argv[3], nullptr, 10));
    }
    if (shape != nullptr && mode == "make") {
        const std::string text = shape->make(shape->smallSize * std::strtoull(argv[3], nullptr, 10));
        return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
    }
    std::fprintf(stderr, "usage: cost_language make SHAPE TIMES | read FILE | stack SHAPE KB\n");
    return 1;
}
