// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "forecast.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "copysampler.h"
#include "core/formats/glbwriter.h"
#include "core/formats/plywriter.h"
#include "core/formats/stlwriter.h"
#include "core/fractal/counts.h"
#include "core/geometry/trs.h"
#include "exporter.h"
#include "objforecast.h"

namespace romanesco {

namespace {

/// Up to so many vertices and faces all is written to find out how long it is.
constexpr std::uint64_t mostWritten = 100'000;

/// The copies of each item.
std::optional<std::vector<Count>> copiesOf(const Scene &scene)
{
    std::map<const Model *, Count> known;
    std::vector<Count> copies;
    for (const SceneItem &item : scene.items) {
        auto model = known.find(item.model.get());
        if (model == known.end()) {
            const std::optional<Count> count = instancesDistinct(item.model->graph);
            if (!count) {
                return std::nullopt;
            }
            model = known.emplace(item.model.get(), *count).first;
        }
        copies.push_back(model->second);
    }
    return copies;
}

bool hasColours(const Scene &scene)
{
    return std::ranges::any_of(scene.items, [](const SceneItem &item) { return !item.model->mesh->colours.empty(); });
}

/// Whether every product of the maps is translation, rotation and scale, as far as some copies tell.
bool areInstances(const SceneItem &item)
{
    constexpr int sampledCopies = 200;
    CopySampler copies(item.model->graph);
    std::mt19937_64 random(20'250'607);
    for (int i = 0; i < sampledCopies; ++i) {
        if (!trsOf(item.worldFromModel * copies.sample(random))) {
            return false;
        }
    }
    return true;
}

Count glbBytes(const Scene &scene, const std::vector<Count> &copies)
{
    std::map<const Mesh *, std::uint64_t> ofCopy;
    std::set<const Mesh *> written;
    Count bytes;
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        const Mesh *mesh = scene.items[i].model->mesh.get();
        const auto [known, isNew] = ofCopy.try_emplace(mesh);
        if (isNew) {
            known->second = glbBytesOfCopy(*mesh);
        }
        if (!areInstances(scene.items[i])) {
            bytes += copies[i] * Count(known->second);
            continue;
        }
        bytes += copies[i] * Count(glbBytesOfInstance);
        bytes += Count(written.insert(mesh).second ? known->second : 0);
    }
    return bytes;
}

Count bytesOfMany(const Scene &scene, const std::vector<Count> &copies, const ExportForecast &known,
                  const ExportOptions &options)
{
    switch (options.format) {
    case ExportFormat::Ply:
        return known.vertices * Count(plyBytesOfVertex(hasColours(scene))) + known.faces * Count(plyBytesOfFace);
    case ExportFormat::Stl:
        return known.faces * Count(stlBytesOfFace);
    case ExportFormat::Glb:
        return glbBytes(scene, copies);
    case ExportFormat::Obj:
        break;
    }
    return objBytes(scene, copies, options);
}

}

std::optional<ExportForecast> forecast(const Scene &scene, const ExportOptions &options)
{
    const std::optional<std::vector<Count>> copies = copiesOf(scene);
    if (!copies) {
        return std::nullopt;
    }
    ExportForecast result;
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        const Mesh &mesh = *scene.items[i].model->mesh;
        result.vertices += (*copies)[i] * Count(mesh.vertices.size());
        result.faces += (*copies)[i] * Count(mesh.faces.size());
    }
    const std::optional<std::uint64_t> written = (result.vertices + result.faces).toInteger();
    CountingSink sink;
    ExportOptions unwelded = options;
    unwelded.isWelded = false;
    if (written && *written <= mostWritten && exportScene(scene, unwelded, sink)) {
        result.bytes = Count(sink.count());
    } else {
        result.bytes = bytesOfMany(scene, *copies, result, options);
    }
    return result;
}

}
