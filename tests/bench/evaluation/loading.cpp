// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "loading.h"

#include <chrono>

#include "render/camera.h"

namespace romanesco::bench {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

std::size_t bytesOf(const Model &model)
{
    const Mesh &mesh = *model.mesh;
    return mesh.vertices.size() * sizeof(mesh.vertices[0]) + mesh.faces.size() * sizeof(mesh.faces[0])
        + model.graph.memoryUse() + model.boxes.memoryUse();
}

}

Loading loaded(const EvaluationModel &model, OurFrames &frames)
{
    Loading made;
    std::vector<double> loads;
    std::vector<double> pictures;
    for (int i = 0; i < attempts; ++i) {
        const Clock::time_point begin = Clock::now();
        const std::shared_ptr<const Scene> scene = model.scene();
        loads.push_back(millisecondsSince(begin));

        const Clock::time_point read = Clock::now();
        View view;
        view.width = 1280;
        view.height = 720;
        view.camera = fittedCamera(*scene, 1280.0 / 720.0);
        frames.setScene(scene);
        frames.draw(view);
        pictures.push_back(millisecondsSince(read));

        made.modelBytes = bytesOf(*scene->items.front().model);
        made.pictureBytes = frames.statistics().bufferBytes + frames.statistics().graphBytes;
        frames.setScene(nullptr);
        frames.draw(view);
    }
    made.load = spreadOf(std::move(loads));
    made.picture = spreadOf(std::move(pictures));
    return made;
}

}
