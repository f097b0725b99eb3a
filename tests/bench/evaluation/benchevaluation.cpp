// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <format>
#include <string>
#include <thread>

#include "ballpictures.h"
#include "evaluationtables.h"

using namespace romanesco;
using namespace romanesco::bench;

namespace {

/// All that can be written out is, and all of it is looked at, once at least.
constexpr ColliderTrial::Options trialOptions{.mostFaces = 50'000'000, .mostOperations = 20'000'000};

/// A folder that goes with it.
class ScratchFolder
{
public:
    ScratchFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "evaluation-XXXXXX").string();
        if (!::mkdtemp(name.data())) {
            orEnd<int>(std::unexpected("cannot make a folder for the meshes"));
        }
        m_path = name;
    }
    ~ScratchFolder() { std::filesystem::remove_all(m_path); }
    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;

    [[nodiscard]] const std::filesystem::path &path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

void tell(const std::string &words)
{
    std::fprintf(stderr, "%s\n", words.c_str());
}

Evaluated evaluated(const EvaluationModel &model, OurFrames &frames)
{
    tell(std::format("mesh {}: loading", model.id));
    const Loading loading = loaded(model, frames);
    const TrialContext context{{}, [&](const std::string &what, double) {
                                   tell(std::format("mesh {}: {}", model.id, what));
                               }};
    return {model, loading, orEnd(tryColliders(model.scene(), {}, trialOptions, context))};
}

void print(const std::string &text)
{
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

}

/// Writes docs/evaluation.md to stdout; --pictures FOLDER writes its picture.
int main(int argc, char **argv)
{
    const bool hasFolder = argc == 3 && std::string(argv[1]) == "--pictures";
    if (argc != 1 && !hasFolder) {
        tell("usage: bench_evaluation [--pictures FOLDER]");
        return 2;
    }
    const ScratchFolder scratch;
    const std::vector<EvaluationModel> models = evaluationModels(scratch.path());

    // shaders are compiled before anything is timed
    OurFrames frames;
    frames.setScene(models[2].scene());
    View view;
    view.width = 64;
    view.height = 64;
    frames.draw(view);

    std::vector<Evaluated> all;
    for (const EvaluationModel &model : models) {
        all.push_back(evaluated(model, frames));
    }
    const auto onFour = std::ranges::find(models, "4", &EvaluationModel::id);
    const ShrinkingGround ground = shrinkingGround(*onFour->scene());
    tell("balls");
    const ShrinkingTrial trial = shrinkingTrial(ground);
    const PicturedBall pictured = picturedBall(ground, trial);
    if (hasFolder) {
        writeBallPicture(frames, ground, pictured, std::filesystem::path(argv[2]) / "evaluation-ball.png");
    }
    const std::string machine = std::format("{}, {} cores", frames.description(), std::thread::hardware_concurrency());
    print(introduction(machine) + loadingSection(all) + collisionSection(all)
          + shrinkingSection(ground, trial, pictured) + leftOutSection());
    return 0;
}
