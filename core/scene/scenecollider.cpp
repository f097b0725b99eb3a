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

#include <glm/geometric.hpp>

#include "core/collide/bvhcollider.h"
#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/nearest.h"
#include "core/collide/octreecollider.h"
#include "core/collide/simplecollider.h"
#include "core/collide/sweeping.h"
#include "core/collide/writtenout.h"
#include "core/geometry/sizes.h"

namespace romanesco {

namespace {

using Held = std::expected<std::shared_ptr<const Collider>, std::string>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// What a map may put a point off by, of the numbers that are added: nine products and sums, with factors that are rounded.
constexpr double errorOfMap = 8.0 * epsilon;
/// What a similarity may put a length off by, of itself, that it brings to another scale: similarityOf() lets angles
/// change by 1e-14.
constexpr double errorOfScale = 64.0 * epsilon;
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

/// Never more than it is.
double distanceToBox(const glm::dvec3 &p, const Box &box)
{
    return glm::length(glm::max(glm::max(box.least - p, p - box.greatest), glm::dvec3(0.0))) * (1.0 - 4.0 * epsilon);
}

/// Never more than it is. What counts is how large numbers are as seen from the start, which both may be far from.
double wayToPlaced(const Path &path, const Box &box)
{
    const Box seen{box.least - path.start, box.greatest - path.start};
    return wayToBox(seen, {path.sphere.direction, path.sphere.radius + errorOfWays * reachFromStart(path, seen)});
}

/// A point of the world in a model. What is taken back first is where the model's origin stands: p - t is not rounded, or
/// once, so that the point is as exact as if both were near the world's origin.
///
/// With d = |p - t|, its coordinates added up, and u = 2^-53, it is off, in the world's unit, by 1 u·d for p - t; by 3 u·d
/// for three products and two sums, as the columns of a similarity of scale 1 have length 1; and by 8.3 u·d for the
/// columns of the inverse (cofactors 2.2, the determinant 5.2, the quotient 1). errorOfMap is 16 u.
glm::dvec3 modelFromWorld(const Similarity &worldFromModel, const glm::dvec3 &p)
{
    return worldFromModel.inverse.linear * (p - worldFromModel.map.translation);
}
double errorInModel(const Similarity &worldFromModel, const glm::dvec3 &p)
{
    return errorOfMap * sumOfSizes(p - worldFromModel.map.translation);
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

SceneSearch::SceneSearch(const SceneCollider &collider)
    : m_collider(collider)
    , m_searches(collider.m_surfaces.size())
{
}

void SceneSearch::closest(const Query &query, Hit &hit)
{
    assert(glm::all(glm::lessThanEqual(glm::abs(query.p), glm::dvec3(SceneCollider::farthest)))
           && "squares of distances are numbers");
    clear(hit);
    hit.lower = infinity;
    listItems([&](const Box &box) { return distanceToBox(query.p, box); });
    Query left = query;
    bool isCutShort = false;
    while (!m_waiting.empty()) {
        const Waiting next = takeNearest();
        if (next.distance > left.radius || left.nodeBudget == 0 || query.stop.stop_requested()) {
            isCutShort = isCutShort || next.distance <= left.radius;
            hit.lower = std::min(hit.lower, next.distance); // and all that wait are farther
            break;
        }
        const SceneCollider::Placed &placed = m_collider.m_placed[next.placed];
        searchItem(placed, left);
        isCutShort = isCutShort || m_ofItem.promise != m_collider.m_promise || m_ofItem.excess != m_collider.m_excess;
        left.nodeBudget -= std::min(left.nodeBudget, m_ofItem.cost.nodeVisits);
        take(placed, hit);
        left.radius = std::min(query.radius, hit.distance / (1.0 + m_collider.m_excess));
    }
    promise(query, isCutShort, hit);
}

template<typename DistanceTo>
void SceneSearch::listItems(const DistanceTo &distanceTo)
{
    m_waiting.clear();
    for (std::size_t i = 0; i < m_collider.m_placed.size(); ++i) {
        m_waiting.push_back({distanceTo(m_collider.m_placed[i].box), i});
    }
    std::ranges::make_heap(m_waiting, std::greater(), [](const Waiting &w) { return std::pair(w.distance, w.placed); });
}

SceneSearch::Waiting SceneSearch::takeNearest()
{
    std::ranges::pop_heap(m_waiting, std::greater(), [](const Waiting &w) { return std::pair(w.distance, w.placed); });
    const Waiting nearest = m_waiting.back();
    m_waiting.pop_back();
    return nearest;
}

Search &SceneSearch::searchOf(const SceneCollider::Placed &placed)
{
    std::unique_ptr<Search> &search = m_searches[placed.surface];
    if (!search) {
        const auto &[collider, worldFromModel, state] = m_collider.m_surfaces[placed.surface];
        search = !state.empty() ? collider->searchBelow(state, worldFromModel)
            : worldFromModel    ? collider->searchPlaced(*worldFromModel)
                                : collider->search();
        assert(search && "kinds that cannot be placed are written out in the world");
    }
    return *search;
}

/// What is found there, and proved of it, in the world.
void SceneSearch::searchItem(const SceneCollider::Placed &placed, const Query &query)
{
    if (placed.worldFromModel) {
        searchModel(searchOf(placed), *placed.worldFromModel, query);
    } else {
        searchOf(placed).closest(query, m_ofItem);
    }
}

void SceneSearch::searchModel(Search &search, const Similarity &worldFromModel, const Query &query)
{
    const auto &[map, inverse, scale] = worldFromModel;
    const double error = errorInModel(worldFromModel, query.p);
    Query inModel = query;
    inModel.p = modelFromWorld(worldFromModel, query.p);
    inModel.motion = query.motion.transform([&](const glm::dvec3 &motion) { return inverse.linear * motion * scale; });
    inModel.radius = (query.radius + error) / scale * (1.0 + errorOfScale);
    search.closest(inModel, m_ofItem);
    m_ofItem.lower = std::max(m_ofItem.lower * scale * (1.0 - errorOfScale) - error, 0.0);
    if (m_ofItem.isFound()) {
        m_ofItem.distance = std::min(m_ofItem.distance * scale, query.radius); // farther by rounding alone
    }
    m_ofItem.point = map(m_ofItem.point);
    m_ofItem.direction = glm::normalize(map.linear * m_ofItem.direction / scale);
}

/// The better of what was found, and what is proved of both.
void SceneSearch::take(const SceneCollider::Placed &placed, Hit &hit)
{
    const double lower = std::min(hit.lower, m_ofItem.lower);
    const SearchCost cost{hit.cost.faceTests + m_ofItem.cost.faceTests, hit.cost.nodeVisits + m_ofItem.cost.nodeVisits};
    if (m_ofItem.distance < hit.distance) {
        std::swap(hit, m_ofItem);
        m_found = static_cast<std::size_t>(&placed - m_collider.m_placed.data());
    }
    hit.lower = lower;
    hit.cost = cost;
}

void SceneSearch::sweep(const Sweep &sweep, Touch &touch)
{
    assert(glm::all(glm::lessThanEqual(glm::max(glm::abs(sweep.p), glm::abs(sweep.v)), glm::dvec3(m_collider.farthest)))
           && sweep.radius <= m_collider.farthest && "squares of distances are numbers");
    clear(touch);
    const Path path(sweep);
    listItems([&](const Box &box) { return path.timeOf(wayToPlaced(path, box)); });
    const double slack = path.speed > 0.0 ? path.slack / path.speed : 0.0;
    Sweep left = sweep;
    double lower = infinity;
    bool isCutShort = false;
    while (!m_waiting.empty()) {
        const Waiting next = takeNearest();
        const double until = touch.isFound() ? earlierThan(touch.time, slack) : sweep.time;
        const bool isBeyond = next.distance > until || next.distance == infinity;
        if (isBeyond || left.nodeBudget == 0 || sweep.stop.stop_requested()) {
            isCutShort = isCutShort || !isBeyond;
            lower = std::min(lower, next.distance); // and all that wait are later
            break;
        }
        left.time = until;
        const SceneCollider::Placed &placed = m_collider.m_placed[next.placed];
        sweepItem(placed, left);
        isCutShort = isCutShort || m_touchOfItem.promise == Promise::UpperBound;
        left.nodeBudget -= std::min(left.nodeBudget, m_touchOfItem.cost.nodeVisits);
        lower = std::min(lower, m_touchOfItem.lower);
        take(placed, touch);
    }
    const bool proves = m_collider.m_promise == Promise::Exact || m_collider.m_promise == Promise::Within;
    touch.lower = proves ? std::clamp(lower, 0.0, std::min(touch.time, sweep.time)) : 0.0;
    touch.promise = !proves ? m_collider.m_promise : isCutShort ? Promise::UpperBound : Promise::Exact;
}

void SceneSearch::sweepItem(const SceneCollider::Placed &placed, const Sweep &sweep)
{
    Search &search = searchOf(placed);
    if (!placed.worldFromModel) {
        search.sweep(sweep, m_touchOfItem);
        return;
    }
    const auto &[map, inverse, scale] = *placed.worldFromModel;
    const Path path(sweep);
    const Box seen{placed.box.least - sweep.p, placed.box.greatest - sweep.p};
    const double reach = std::min(reachFromStart(path, seen), SceneCollider::farthest); // the box may be infinite
    // where it starts, and what its direction puts it off by on the way
    const double error = errorInModel(*placed.worldFromModel, sweep.p) + errorOfMap * reach;
    Sweep inModel = sweep;
    inModel.p = modelFromWorld(*placed.worldFromModel, sweep.p);
    inModel.v = inverse.linear * sweep.v;
    inModel.radius = (sweep.radius + error) / scale * (1.0 + errorOfScale);
    search.sweep(inModel, m_touchOfItem);
    m_touchOfItem.point = map(m_touchOfItem.point);
    m_touchOfItem.direction = glm::normalize(map.linear * m_touchOfItem.direction / scale);
}

void SceneSearch::take(const SceneCollider::Placed &placed, Touch &touch)
{
    const SearchCost cost{touch.cost.faceTests + m_touchOfItem.cost.faceTests,
                          touch.cost.nodeVisits + m_touchOfItem.cost.nodeVisits};
    if (m_touchOfItem.time < touch.time) {
        std::swap(touch, m_touchOfItem);
        m_found = static_cast<std::size_t>(&placed - m_collider.m_placed.data());
    }
    touch.cost = cost;
}

Address SceneSearch::addressOf(const SurfacePoint &found) const
{
    if (!m_collider.m_place) {
        return found.address;
    }
    const Surroundings &place = *m_collider.m_place;
    const Surroundings::Node &node = place.nodes[m_collider.m_placed[m_found].node];
    std::vector<Step> steps(place.path.begin(), place.path.begin() + static_cast<std::ptrdiff_t>(node.sharedSteps));
    steps.insert(steps.end(), node.steps.begin(), node.steps.end());
    StateTable table(m_collider.m_scene->items[node.item].model->graph);
    Address address = romanesco::addressOf(table, steps).value_or(Address{});
    address.insert(address.end(), found.address.begin(), found.address.end());
    return address;
}

void SceneSearch::promise(const Query &query, bool isCutShort, Hit &hit) const
{
    const bool proves = m_collider.m_promise == Promise::Exact || m_collider.m_promise == Promise::Within;
    hit.lower = proves ? std::clamp(hit.lower, 0.0, std::min(hit.distance, query.radius)) : 0.0;
    hit.promise = m_collider.m_promise;
    hit.excess = m_collider.m_excess;
    if (isCutShort && proves) {
        const bool isBounded = hit.lower > 0.0 && hit.isFound();
        hit.promise = isBounded ? Promise::Within : Promise::UpperBound;
        hit.excess = isBounded ? hit.distance / hit.lower - 1.0 : 0.0;
    }
}

}
