// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "collidesurvey.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

#include "heap.h"

namespace romanesco::bench {

namespace {

Survey::Cost costOf(std::vector<double> counts)
{
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(counts.size()))) - 1;
    std::ranges::nth_element(counts, counts.begin() + rank);
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    return {sum / static_cast<double>(counts.size()), counts[rank]};
}

}

Answered answered(const Collider &exact, std::vector<glm::dvec3> points)
{
    Answered answered{std::move(points), {}, {}};
    const auto search = exact.search();
    Hit hit;
    for (const glm::dvec3 &p : answered.points) {
        search->closest({p}, hit);
        answered.distances.push_back(hit.distance);
        answered.directions.push_back(hit.direction);
    }
    return answered;
}

Survey survey(const Collider &collider, const Answered &truth, double reach, std::size_t most)
{
    Survey survey;
    const std::size_t count = std::min(most, truth.points.size());
    std::vector<double> faceTests(count);
    std::vector<double> nodeVisits(count);
    Hit hit;
    const std::size_t before = heapInUse();
    const auto search = collider.search();
    const double share = 1.0 / static_cast<double>(count);
    const double leastCosine = std::cos(10.0 * std::numbers::pi / 180.0);
    for (std::size_t i = 0; i < count; ++i) {
        search->closest({.p = truth.points[i], .nodeBudget = nodeBudget}, hit);
        survey.cutOff += hit.cost.nodeVisits >= nodeBudget ? share : 0.0;
        faceTests[i] = static_cast<double>(hit.cost.faceTests);
        nodeVisits[i] = static_cast<double>(hit.cost.nodeVisits);
        if (truth.distances.empty()) {
            continue;
        }
        const double distance = truth.distances[i];
        for (std::size_t k = 0; k < survey.wrong.size(); ++k) {
            survey.wrong[k] += std::abs(hit.distance - distance) > Survey::wrongBy[k] * distance ? share : 0.0;
        }
        survey.missed += distance < reach && hit.distance >= reach ? share : 0.0;
        survey.turned += glm::dot(hit.direction, truth.directions[i]) < leastCosine ? share : 0.0;
    }
    survey.searchBytes = heapInUse() - before;
    survey.faceTests = costOf(std::move(faceTests));
    survey.nodeVisits = costOf(std::move(nodeVisits));
    return survey;
}

}
