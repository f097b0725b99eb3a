// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "survey.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "spread.h"

namespace romanesco {

namespace {

double meanOf(const std::vector<double> &values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// In parts of the true length.
double errorOf(const Answer &answer, const Answer &truth, double rounding)
{
    const double off = std::max(std::abs(answer.length - truth.length) - rounding, 0.0);
    return off / std::max(truth.length, rounding);
}

}

Survey survey(const Collider &collider, const Examination &examination, std::uint64_t mostOperations,
              const std::stop_token &stop)
{
    assert(!examination.asks.empty() && examination.asks.size() == examination.answers.size());
    Asker asker(collider);
    Survey survey;
    std::vector<double> faceTests;
    std::vector<double> nodeVisits;
    std::uint64_t operations = 0;
    for (std::size_t i = 0; i < examination.asks.size() && operations < mostOperations; ++i) {
        const Answer &truth = examination.answers[i];
        const Answer answer = asker(examination.asks[i], stop);
        if (stop.stop_requested()) {
            break;
        }
        ++survey.asked;
        operations += operationsOf(answer.cost);
        faceTests.push_back(static_cast<double>(answer.cost.faceTests));
        nodeVisits.push_back(static_cast<double>(answer.cost.nodeVisits));
        const double error = errorOf(answer, truth, roundingOf(examination.asks[i], examination.size));
        survey.worst = std::max(survey.worst, error);
        for (std::size_t k = 0; k < survey.wrong.size(); ++k) {
            survey.wrong[k].count += error > Survey::wrongBy[k] ? 1 : 0;
            survey.wrong[k].of += 1;
        }
        survey.missed.of += truth.touches ? 1 : 0;
        survey.missed.count += truth.touches && !answer.touches ? 1 : 0;
    }
    if (survey.asked > 0) {
        survey.faceTestsMean = meanOf(faceTests);
        survey.nodeVisitsMean = meanOf(nodeVisits);
        survey.faceTestsP99 = quantile(std::move(faceTests), 0.99);
    }
    return survey;
}

}
