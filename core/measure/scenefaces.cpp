// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenefaces.h"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

#include "core/fractal/counts.h"

namespace romanesco {

namespace {

/// More are hardly made before copies are points, but where maps shrink little.
constexpr int mostPicks = 10'000;
constexpr double pointShare = 1e-9;

double lengthOfLongest(const glm::dmat3 &linear)
{
    return std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
}

/// Goes one pick on. Whether there is any: the word may end here, and does by chance.
bool goOn(StateTable &states, StateId &state, AffineMap &map, std::mt19937_64 &random)
{
    const Expansion &expansion = states.expansion(state);
    std::uint64_t choices = expansion.hasLeaf ? 1 : 0;
    for (const ChildRange &range : expansion.ranges) {
        choices += range.endMap - range.firstMap;
    }
    if (choices == 0) {
        return false;
    }
    std::uint64_t choice = random() % choices;
    for (const ChildRange &range : expansion.ranges) {
        const std::uint64_t size = range.endMap - range.firstMap;
        if (choice < size) {
            map = map * states.graph().set(range.set).maps[range.firstMap + choice];
            state = range.next;
            return true;
        }
        choice -= size;
    }
    return false;
}

FaceSource::Face faceOf(const Mesh &mesh, const AffineMap &map, std::mt19937_64 &random)
{
    const Mesh::Face &face = mesh.faces[random() % mesh.faces.size()];
    const glm::dvec3 &corner = mesh.vertices[face[0]];
    return {map(corner),
            {map.linear * (mesh.vertices[face[1]] - corner), map.linear * (mesh.vertices[face[2]] - corner)}};
}

}

std::optional<Count> facesOf(const std::vector<SceneItem> &items)
{
    std::map<const Model *, std::optional<Count>> known;
    Count sum = 0;
    for (const SceneItem &item : items) {
        const Model &model = *item.model;
        const auto [copies, isNew] = known.try_emplace(&model);
        if (isNew) {
            copies->second = instancesDistinct(model.graph);
        }
        if (!copies->second) {
            return std::nullopt;
        }
        sum += *copies->second * Count(model.mesh->faces.size());
    }
    return sum;
}

SceneFaces::SceneFaces(const Scene &scene, double size)
    : m_leastSize(pointShare * size)
{
    for (const SceneItem &item : scene.items) {
        const Model &model = *item.model;
        if (item.kind == SceneDescription::Kind::Ball || model.boxes.at(model.graph, 0).isEmpty()) {
            continue;
        }
        std::unique_ptr<StateTable> &states = m_states[&model];
        if (!states) {
            states = std::make_unique<StateTable>(model.graph);
        }
        m_items.push_back({&item, states.get()});
    }
}

FaceSource::Face SceneFaces::draw(std::mt19937_64 &random)
{
    const auto [item, states] = m_items[random() % m_items.size()];
    AffineMap map = item->worldFromModel;
    StateId state = states->root();
    for (int picks = 0; goOn(*states, state, map, random); ++picks) {
        const Sphere &bound = states->state(state).bound;
        if (picks == mostPicks || lengthOfLongest(map.linear) * bound.radius < m_leastSize) {
            return {.corner = map(bound.centre)};
        }
    }
    return faceOf(*item->model->mesh, map, random);
}

}
