// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenesearch.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/collide/nearest.h"
#include "core/collide/sweeping.h"
#include "core/geometry/sizes.h"

namespace romanesco {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// What a map may put a point or a way off by, of the numbers that are added: see modelFromWorld().
constexpr double errorOfMap = 8.0 * epsilon;
/// What a similarity may put a length off by, of itself, that it brings to another scale: similarityOf() lets angles
/// change by 1e-14.
constexpr double errorOfScale = 64.0 * epsilon;

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
