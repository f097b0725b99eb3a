// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Texts that change faster than scenes are made of them: the newest is always made, results only grow newer, and a
// scene is read by one thread while the next is made by another.

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "core/base/newestjob.h"
#include "core/fractal/counts.h"
#include "core/scene/sceneloader.h"

namespace {

using namespace romanesco;

class OneMesh final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &) const override
    {
        return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    }
};

struct Text {
    int revision = 0;
    std::string text;
};

std::string textOfDepth(int depth)
{
    return "v 0.5 0 0\nhalf 0.5 0.5 0.5\nx. \"x.obj\"\nt.p. (p, #, half)\nz<x>. [#, t.1] x\n<$>. z "
        + std::to_string(depth) + '\n';
}

void require(bool condition, const char *words)
{
    if (!condition) {
        std::fprintf(stderr, "failed: %s\n", words);
        std::abort();
    }
}

}

int main()
{
    constexpr int revisions = 3'000;
    const OneMesh files;
    SceneLoader loader(files);
    std::mutex mutex;
    std::shared_ptr<const Scene> newest;
    int newestRevision = 0;
    std::atomic<int> made = 0;
    {
        NewestJob<Text> building([&](const Text &job, const std::stop_token &stop) {
            SceneResult result = loader.load("a.fdo", job.text, stop);
            const std::lock_guard lock(mutex);
            if (result.scene) {
                require(job.revision > newestRevision, "results only grow newer");
                newestRevision = job.revision;
                newest = std::move(result.scene);
                ++made;
            }
        });
        const auto snapshot = [&] {
            const std::lock_guard lock(mutex);
            return std::pair(newestRevision, newest);
        };
        for (int revision = 1; revision <= revisions; ++revision) {
            building.post({revision, textOfDepth(revision % 40)});
            // Now and then a text is waited for, so that scenes are made and read; whatever was dropped before it, the
            // last one posted is made.
            const bool waits = revision % 16 == 0 || revision == revisions;
            while (waits && snapshot().first != revision) {
                std::this_thread::yield();
            }
            if (const std::shared_ptr<const Scene> scene = snapshot().second) {
                require(instancesDistinct(scene->items.front().model->graph).has_value(),
                        "a scene can be read while others are made");
            }
        }
    }
    require(made >= revisions / 16 && made <= revisions, "every text that was waited for made one scene");
    std::printf("%d of %d texts were made into scenes\n", made.load(), revisions);
    return 0;
}
