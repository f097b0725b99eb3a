// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "deepfractal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/fractal/extent.h"

namespace romanesco {

namespace {

/// Whether copies shrink the more maps lead to them: all maps do, or at least all that is picked from one end to the other.
bool shrinks(const FractalGraph &graph)
{
    const LevelSequence &levels = graph.levels();
    double logarithm = 0.0;
    double largest = 0.0;
    for (Position position = 0; position < levels.levelCount(); ++position) {
        const SetId set = levels.set(levels.locate(position).slot);
        double here = 0.0;
        for (const MapFacts &facts : graph.facts(set)) {
            here = std::max(here, facts.norm);
        }
        largest = std::max(largest, here);
        logarithm += std::log(graph.set(set).holdsIdentity ? std::max(1.0, here) : here);
    }
    return largest < 1.0 || logarithm < 0.0;
}

/// However many levels a pick passes over, all sets come again in the next pass.
LevelSequence repeated(const LevelSequence &levels, std::uint64_t count)
{
    LevelSequence::Builder builder;
    builder.beginRepeat(count);
    for (Position position = 0; position < levels.levelCount(); ++position) {
        builder.addLevel(levels.set(levels.locate(position).slot));
    }
    builder.endRepeat();
    return std::move(builder).build();
}

}

std::expected<std::shared_ptr<const Scene>, std::string> deepFractal(const Scene &scene, std::uint64_t picks)
{
    const auto item = std::ranges::find_if(scene.items, [](const SceneItem &one) {
        const Model &model = *one.model;
        return model.graph.levels().levelCount() > 0 && !model.graph.bound(0).isEmpty();
    });
    if (item == scene.items.end()) {
        return std::unexpected("there is no fractal to go down");
    }
    std::shared_ptr<const Model> model = item->model;
    const FractalGraph &graph = model->graph;
    if (graph.levels().levelCount() < picks && shrinks(graph)) {
        FractalDescription description;
        for (SetId id = 0; id < graph.setCount(); ++id) {
            description.sets.push_back(graph.set(id));
        }
        description.levels = repeated(graph.levels(), picks);
        auto deep = FractalGraph::build(description, graph.base());
        if (!deep) {
            return std::unexpected("the fractal grows too large as its depth grows");
        }
        BoxBounds boxes(*deep, *model->mesh);
        const Box box = extent(*deep, boxes, *model->mesh);
        model =
            std::make_shared<const Model>(Model{model->mesh, std::move(*deep), std::move(boxes), box, model->meshPath});
    }
    Scene made;
    made.items.push_back({.model = std::move(model), .worldFromModel = item->worldFromModel});
    made.extent = extentOf(made.items);
    return std::make_shared<const Scene>(std::move(made));
}

}
