// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measuretable.h"

#include <format>

#include "core/measure/words.h"

namespace romanesco::cli {

namespace {

constexpr std::string_view cells = "  {:<17} {:>5} {:>9} {:>9} {:>8} {:>9} {:>16} {:>16} {:>16} {:>8} {:>16}\n";

std::string lineOf(const ColliderRow &row)
{
    if (!row.reason.empty()) {
        return std::format("  {:<17} {}\n", nameOf(row), row.reason);
    }
    const Survey &survey = row.survey;
    return std::format(cells, nameOf(row), survey.asked, figure(survey.faceTestsMean), figure(survey.faceTestsP99),
                       figure(survey.nodeVisitsMean), figure(1e-3 * row.nanoseconds.median), percent(survey.wrong[0]),
                       percent(survey.wrong[1]), percent(survey.wrong[2]), figure(survey.worst),
                       percent(survey.missed));
}

std::string tableOfSet(const ColliderTrial &trial, const ColliderTrial::Set &set)
{
    std::string text = std::format("\n{}: {}\n", nameOf(set.queries), wordsOf(set))
        + std::format(cells, "collider", "asked", "faces", "p99", "nodes", "µs", "wrong by 1e-6 %", "by 1 %", "by 10 %",
                      "worst", "missed %");
    for (const ColliderRow &row : trial.rows) {
        if (row.queries == set.queries) {
            text += lineOf(row);
        }
    }
    return text;
}

/// Of each kind once.
std::string tableOfBuilding(const ColliderTrial &trial)
{
    std::string text = std::format("\nbuilding\n  {:<17} {:>9} {:>14}\n", "collider", "ms", "bytes");
    for (const ColliderRow &row : trial.rows) {
        if (row.queries == trial.rows.front().queries && row.reason.empty()) {
            text += std::format("  {:<17} {:>9} {:>14}\n", nameOf(row), figure(row.buildMilliseconds.median),
                                grouped(row.bytes));
        }
    }
    return text;
}

std::string tableOfSteps(const StepTrial &trial)
{
    constexpr std::string_view steps = "  {:<17} {:>5} {:>9} {:>9} {:>9} {:>13} {:>9} {:>14} {:>9} {:>16}\n";
    std::string text = std::format("\ntime step: {}\n", wordsOf(trial))
        + std::format(steps, "step, s", "balls", "faces/s", "queries/s", "µs/s", "energy off by", "worst",
                      "landing off by", "worst", "missed %");
    for (const StepRow &row : trial.rows) {
        text += std::format(steps, nameOf(row), row.balls, figure(row.faceTests), figure(row.queries),
                            figure(row.microseconds.median), figure(row.energyMedian), figure(row.energyWorst),
                            figure(row.landingMedian), figure(row.landingWorst), percent(row.missed));
    }
    return text;
}

std::string tableOfFrames(const FrameTrial &trial)
{
    constexpr std::string_view frames = "  {:<9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>12} {:>7} {:>7} {:>10} {:>7}\n";
    std::string text = std::format("\nrendering: {}\n", wordsOf(trial));
    for (const FrameReference &reference : trial.references) {
        text += std::format("\nrendering, {}: {}\n", nameOf(reference.place), wordsOf(reference))
            + std::format(frames, "tolerance", "copies", "faces", "states", "ms", "a second", "bytes", "RMS", "off %",
                          "RMS alone", "off %");
        for (const FrameRow &row : trial.rows) {
            if (row.place != reference.place) {
                continue;
            }
            text += !row.reason.empty()
                ? std::format("  {:<9} {}\n", nameOf(row), row.reason)
                : std::format(frames, nameOf(row), grouped(row.cost.copies), grouped(row.cost.faces),
                              grouped(row.cost.statesVisited), figure(row.milliseconds.median),
                              figure(1e3 / row.milliseconds.median), grouped(row.cost.bytes), figure(row.moving.rms),
                              figure(100.0 * row.moving.share), figure(row.alone.rms), figure(100.0 * row.alone.share));
        }
    }
    return text;
}

std::string tableOfDepths(const DepthTrial &trial)
{
    constexpr std::string_view depths = "  {:<9} {:>9} {:>9} {:>13} {:>13} {:>13}\n";
    std::string text = std::format("\nnumbers at depth: {}\n", wordsOf(trial));
    if (trial.rows.empty()) {
        return text;
    }
    text += std::format(depths, "levels", "size", "copies", "float", "double", "local frames");
    for (const DepthRow &row : trial.rows) {
        text += !row.reason.empty() ? std::format("  {:<9} {}\n", row.depth, row.reason)
                                    : std::format(depths, row.depth, sizeText(row), row.copies, pixelsText(row.inFloat),
                                                  pixelsText(row.inDouble), pixelsText(row.inFrames));
    }
    return text;
}

std::string tableOfDigits(const DigitTrial &trial)
{
    constexpr std::string_view digits = "  {:<9} {:>9} {:>9} {:>15} {:>15} {:>17} {:>9}\n";
    std::string text = std::format("\nexport: {}\n", wordsOf(trial))
        + std::format(digits, "numbers", "worst", "RMS", "faces collapsed", "faces flat", "bytes in all", "ns a face");
    for (const DigitRow &row : trial.rows) {
        text += std::format(digits, nameOf(row), figure(row.worst), figure(row.rms), grouped(row.collapsed),
                            grouped(row.flat), countText(row.bytes), figure(row.nanoseconds.median));
    }
    return text;
}

}

std::string tableOf(const Measurement &measurement)
{
    const ColliderTrial &trial = measurement.colliders;
    std::string text = std::format("{}: {}\n", measurement.source, wordsOf(trial));
    for (const ColliderTrial::Set &set : trial.sets) {
        text += tableOfSet(trial, set);
    }
    text += tableOfBuilding(trial);
    text += measurement.steps ? tableOfSteps(*measurement.steps) : std::string();
    text += measurement.frames ? tableOfFrames(*measurement.frames) : std::string();
    text += measurement.depths ? tableOfDepths(*measurement.depths) : std::string();
    text += measurement.digits ? tableOfDigits(*measurement.digits) : std::string();
    return text;
}

}
