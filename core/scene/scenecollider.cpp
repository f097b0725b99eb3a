// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenecollider.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <format>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>

#include "core/collide/bvhcollider.h"
#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/octreecollider.h"
#include "core/collide/simplecollider.h"
#include "core/collide/writtenout.h"
#include "core/geometry/sizes.h"
#include "scenesearch.h"

namespace romanesco {

namespace {

using Held = std::expected<std::shared_ptr<const Collider>, std::string>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// What a map may put a point off by, of the numbers that are added: nine products and sums, with factors that are rounded.
constexpr double errorOfMap = 8.0 * epsilon;
/// Where lengths change by more, the squares of what is far away might be no numbers.
constexpr double mostScale = 1e10;

template<typename Kind>
Held held(std::expected<Kind, std::string> &&collider)
{
    return std::move(collider).transform(
        [](Kind &&made) -> std::shared_ptr<const Collider> { return std::make_shared<const Kind>(std::move(made)); });
}

/// Round what a map makes of a box, rounding included; infinite where that is no number.
Box placedBox(const AffineMap &map, const Box &box)
{
    const glm::dvec3 centre = map(box.centre());
    const glm::dvec3 half = 0.5 * box.size();
    const glm::dmat3 &linear = map.linear;
    glm::dvec3 reach = glm::abs(linear[0]) * half.x + glm::abs(linear[1]) * half.y + glm::abs(linear[2]) * half.z;
    reach += errorOfMap * (sumOfSizes(map.translation) + operatorNorm(linear) * sumOfSizes(box));
    const bool isNumber = std::isfinite(sumOfSizes(centre) + sumOfSizes(reach));
    return isNumber ? Box{centre - reach, centre + reach} : Box{glm::dvec3(-infinity), glm::dvec3(infinity)};
}

/// Of places that queries can be taken out of.
std::optional<Similarity> plainSimilarity(const AffineMap &map)
{
    std::optional<Similarity> found = similarityOf(map);
    return found && found->scale <= mostScale && found->scale >= 1.0 / mostScale ? found : std::nullopt;
}

Promise promiseOf(ColliderKind kind, double excess)
{
    switch (kind) {
    case ColliderKind::Approximate:
        return excess > 0.0 ? Promise::Within : Promise::Exact;
    case ColliderKind::Greedy:
        return Promise::UpperBound;
    case ColliderKind::Octree:
        return Promise::None;
    case ColliderKind::Exact:
    case ColliderKind::Bvh:
    case ColliderKind::Simple:
        break;
    }
    return Promise::Exact;
}

}

/// Makes what is searched for each item, once where items can share it.
class SceneCollider::Builder
{
public:
    Builder(SceneCollider &made, const Options &options, const std::stop_token &stop)
        : m_made(made)
        , m_options(options)
        , m_stop(stop)
    {
    }

    std::expected<void, std::string> add(std::size_t number)
    {
        const SceneItem &item = m_made.m_scene->items[number];
        const Box box = item.model->boxes.at(item.model->graph, 0);
        if (item.kind == SceneDescription::Kind::Ball || box.isEmpty()) {
            return {};
        }
        if (m_options.kind == ColliderKind::Simple) {
            if (const auto counted = countFaces(*item.model); !counted) {
                return counted;
            }
        }
        Placed placed{.item = number, .box = placedBox(item.worldFromModel, box)};
        const bool isInPlace = item.worldFromModel == AffineMap{};
        if (!isInPlace) {
            placed.worldFromModel = plainSimilarity(item.worldFromModel);
        }
        const auto surface =
            isInPlace || placed.worldFromModel ? surfaceOf(item.model) : surfaceAt(item.model, item.worldFromModel);
        return surface.transform([&](std::size_t found) {
            placed.surface = found;
            m_made.m_placed.push_back(placed);
        });
    }

private:
    using ModelPointer = std::shared_ptr<const Model>;

    [[nodiscard]] bool writesOut() const
    {
        return m_options.kind == ColliderKind::Bvh || m_options.kind == ColliderKind::Octree;
    }

    std::size_t keep(Surface surface)
    {
        m_made.m_surfaces.push_back(std::move(surface));
        return m_made.m_surfaces.size() - 1;
    }

    /// In the model's own coordinates.
    std::expected<std::size_t, std::string> surfaceOf(const ModelPointer &model)
    {
        const auto known = m_ofModel.find(model.get());
        if (known != m_ofModel.end()) {
            return known->second;
        }
        return colliderOf(*model).transform([&](std::shared_ptr<const Collider> &&collider) {
            return m_ofModel[model.get()] = keep({std::move(collider)});
        });
    }

    /// In the world's.
    std::expected<std::size_t, std::string> surfaceAt(const ModelPointer &model, const AffineMap &worldFromModel)
    {
        if (writesOut()) {
            return colliderAt(*model, worldFromModel).transform([&](std::shared_ptr<const Collider> &&collider) {
                return keep({std::move(collider)});
            });
        }
        return surfaceOf(model).transform(
            [&](std::size_t own) { return keep({m_made.m_surfaces[own].collider, worldFromModel}); });
    }

    Held colliderOf(const Model &model)
    {
        const Mesh &mesh = *model.mesh;
        switch (m_options.kind) {
        case ColliderKind::Exact:
        case ColliderKind::Approximate:
            return held(ExactCollider::create(model.graph, model.boxes, mesh, m_made.m_excess, m_stop));
        case ColliderKind::Greedy:
            return held(GreedyCollider::create(model.graph, mesh));
        case ColliderKind::Octree:
            return held(OctreeCollider::create(model.graph, mesh, m_stop));
        case ColliderKind::Simple:
            return std::make_shared<const SimpleCollider>(model.graph, mesh);
        case ColliderKind::Bvh:
            break;
        }
        return model.graph.levels().levelCount() == 0 ? held(BvhCollider::create(mesh, m_stop)) : colliderAt(model, {});
    }

    Held colliderAt(const Model &model, const AffineMap &worldFromModel)
    {
        const bool isOctree = m_options.kind == ColliderKind::Octree;
        const std::uint64_t most = isOctree ? OctreeCollider::mostFaces : m_facesLeft;
        auto mesh = writtenOut(model.graph, *model.mesh, worldFromModel, most, m_stop);
        if (!mesh) {
            return std::unexpected(mesh.error());
        }
        if (isOctree) {
            return held(OctreeCollider::create(FractalGraph::ofMesh(boundingSphere(*mesh)), *mesh, m_stop));
        }
        m_facesLeft -= mesh->faces.size();
        m_made.m_meshes.push_back(std::make_shared<const Mesh>(std::move(*mesh)));
        return held(BvhCollider::create(*m_made.m_meshes.back(), m_stop));
    }

    /// Those of an item that are looked at for each point.
    std::expected<void, std::string> countFaces(const Model &model)
    {
        const auto known = m_facesOf.find(&model);
        if (known != m_facesOf.end() && known->second <= m_facesLeft) {
            m_facesLeft -= known->second;
            return {};
        }
        return faceCount(model.graph, *model.mesh, m_facesLeft).transform([&](std::uint64_t faces) {
            m_facesOf[&model] = faces;
            m_facesLeft -= faces;
        });
    }

    SceneCollider &m_made;
    const Options &m_options;
    const std::stop_token &m_stop;
    std::map<const Model *, std::size_t> m_ofModel;
    std::map<const Model *, std::uint64_t> m_facesOf;
    std::uint64_t m_facesLeft = mostFaces;
};

std::expected<SceneCollider, std::string> SceneCollider::create(std::shared_ptr<const Scene> scene,
                                                                const Options &options, const std::stop_token &stop)
{
    SceneCollider made;
    made.m_scene = std::move(scene);
    made.m_kind = options.kind;
    made.m_excess = options.kind == ColliderKind::Approximate ? options.excess : 0.0;
    made.m_promise = promiseOf(options.kind, made.m_excess);
    Builder builder(made, options, stop);
    for (std::size_t i = 0; i < made.m_scene->items.size(); ++i) {
        if (const auto added = builder.add(i); !added) {
            const std::string &path = made.m_scene->items[i].path;
            return std::unexpected(path.empty() ? added.error() : std::format("{}: {}", path, added.error()));
        }
        if (stop.stop_requested()) {
            return std::unexpected("cancelled");
        }
    }
    return made;
}

SceneCollider SceneCollider::at(std::shared_ptr<const Surroundings> place) const
{
    assert(place->scene->items.size() == m_scene->items.size() && searchesBelow() && "colliders are shared");
    std::map<const Model *, std::shared_ptr<const Collider>> ofModel;
    for (const Placed &placed : m_placed) {
        ofModel[m_scene->items[placed.item].model.get()] = m_surfaces[placed.surface].collider;
    }
    SceneCollider made;
    made.m_scene = m_scene;
    made.m_kind = m_kind;
    made.m_promise = m_promise;
    made.m_excess = m_excess;
    for (std::size_t i = 0; i < place->nodes.size(); ++i) {
        const Surroundings::Node &node = place->nodes[i];
        const SceneItem &item = m_scene->items[node.item];
        const Positions state = node.isMeshOnly ? Positions{item.model->graph.levels().levelCount()} : node.state;
        Box box = Box::ofNothing();
        for (const Position position : state) {
            box = box.with(item.model->boxes.at(item.model->graph, position));
        }
        const auto collider = ofModel.find(item.model.get());
        if (item.kind == SceneDescription::Kind::Ball || box.isEmpty() || collider == ofModel.end()) {
            continue;
        }
        Placed placed{.item = node.item,
                      .box = placedBox(node.hereFromNode, box),
                      .surface = made.m_surfaces.size(),
                      .node = i};
        placed.worldFromModel = plainSimilarity(node.hereFromNode);
        made.m_surfaces.push_back(
            {collider->second, placed.worldFromModel ? std::nullopt : std::optional(node.hereFromNode), state});
        made.m_placed.push_back(placed);
    }
    made.m_place = std::move(place);
    return made;
}

std::unique_ptr<Search> SceneCollider::search() const
{
    return std::make_unique<SceneSearch>(*this);
}

std::size_t SceneCollider::memoryUse() const
{
    std::size_t bytes = sizeof(*this) + m_surfaces.capacity() * sizeof(Surface) + m_placed.capacity() * sizeof(Placed);
    for (const Surface &surface : m_surfaces) {
        bytes += surface.worldFromModel ? 0 : surface.collider->memoryUse();
    }
    for (const auto &mesh : m_meshes) {
        bytes += mesh->vertices.capacity() * sizeof(glm::dvec3) + mesh->faces.capacity() * sizeof(Mesh::Face);
    }
    return bytes;
}

}
