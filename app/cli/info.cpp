// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <format>
#include <map>
#include <numeric>
#include <print>
#include <ranges>

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/export/forecast.h"
#include "core/scene/summary.h"
#include "input.h"

namespace romanesco::cli {

namespace {

constexpr std::size_t mostSizesShown = 16;
constexpr std::size_t mostItemsShown = 24;

std::string place(const glm::dvec3 &v)
{
    return std::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

std::string levelText(Position count, const std::vector<std::uint64_t> &sizes)
{
    std::string text = std::to_string(count);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (i == mostSizesShown) {
            return text + " × …";
        }
        text += std::format("{}{}", i == 0 ? ", of " : " × ", sizes[i]);
    }
    return text;
}

/// A line for each item, with the letter that it has in the text.
void printItems(const Scene &scene)
{
    std::println("items        {}", scene.items.size());
    std::map<const Model *, std::string> known;
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        if (i == mostItemsShown) {
            std::println("             and {} more", scene.items.size() - mostItemsShown);
            return;
        }
        const SceneItem &item = scene.items[i];
        std::string &words = known[item.model.get()];
        if (words.empty()) {
            const Summary summary = summarise(*item.model);
            words = std::format("instances {}, faces {}", summary.instancesAsWritten.toString(),
                                summary.facesAsWritten.toString());
        }
        std::println("             {} \"{}\": {}", "ofp"[static_cast<std::size_t>(item.kind)], item.path, words);
    }
}

std::size_t graphBytes(const Scene &scene)
{
    std::map<const Model *, std::size_t> bytes;
    for (const SceneItem &item : scene.items) {
        bytes[item.model.get()] = item.model->graph.memoryUse();
    }
    const auto sizes = std::views::values(bytes);
    return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
}

/// What an OBJ file of the scene would take, about; nothing where its copies cannot be counted.
std::optional<std::string> flattenedBytes(const Scene &scene)
{
    return forecast(scene, {}).transform([](const ExportForecast &known) { return known.bytes.toString(); });
}

void printText(const Input &input, const Summary &summary)
{
    const Scene &scene = *input.scene;
    if (input.isAssembled) {
        printItems(scene);
        std::println("camera       {}", scene.camera ? "in the text" : "fitted");
        std::println("lights       {}", scene.lights.size());
    }
    if (summary.facesPerBase && summary.levelCount) {
        const Model &model = *scene.items.front().model;
        const std::string base = model.meshPath.empty() ? "" : model.meshPath + ", ";
        std::println("base         {}{} faces", base, *summary.facesPerBase);
        std::println("levels       {}", levelText(*summary.levelCount, summary.levelSizes));
    }
    if (summary.iteration) {
        std::println("iteration    {} transformations, depth {}", summary.iteration->transforms,
                     summary.iteration->depth);
    }
    std::println("instances    {} as written", summary.instancesAsWritten.toString());
    std::println("             {} distinct",
                 summary.instancesDistinct ? summary.instancesDistinct->toString() : "too many sets to count");
    std::println("faces        {} as written", summary.facesAsWritten.toString());
    if (summary.contraction) {
        std::println("scales       {:.6g} to {:.6g}: {}", summary.contraction->least, summary.contraction->greatest,
                     summary.isContracting ? "contracting" : "not contracting");
    }
    if (summary.similarityDimension) {
        std::println("dimension    {:.6g} (similarity)", *summary.similarityDimension);
    }
    const Sphere bound = boundingSphere(scene);
    std::println("bounds       {} to {}", place(scene.extent.least), place(scene.extent.greatest));
    std::println("             within {:.6g} of {}", std::max(bound.radius, 0.0), place(bound.centre));
    std::println("storage      {} bytes of source, {} bytes as a graph", input.sourceBytes, graphBytes(scene));
    std::println("             {} bytes flattened to OBJ",
                 flattenedBytes(scene).value_or("too many sets to count the"));
}

QJsonArray json(const glm::dvec3 &v)
{
    return {v.x, v.y, v.z};
}

QJsonValue json(const Count &count)
{
    return QString::fromStdString(count.toString());
}

/// Counts are strings of digits, since JSON's numbers end at 2^53.
QJsonObject json(const Input &input, const Summary &summary)
{
    const Scene &scene = *input.scene;
    QJsonArray levels;
    for (const std::uint64_t size : summary.levelSizes) {
        levels.append(static_cast<qint64>(size));
    }
    QJsonObject object;
    const bool hasBase = summary.facesPerBase.has_value();
    object[QStringLiteral("base")] =
        hasBase ? QJsonValue(QString::fromStdString(scene.items.front().model->meshPath)) : QJsonValue();
    object[QStringLiteral("faces_per_base")] =
        hasBase ? QJsonValue(static_cast<qint64>(*summary.facesPerBase)) : QJsonValue();
    const bool hasSizes = summary.levelSizes.size() == summary.levelCount;
    object[QStringLiteral("levels")] = hasSizes ? QJsonValue(levels) : QJsonValue();
    object[QStringLiteral("transforms_per_iteration")] =
        summary.iteration ? QJsonValue(static_cast<qint64>(summary.iteration->transforms)) : QJsonValue();
    object[QStringLiteral("depth")] =
        summary.iteration ? QJsonValue(static_cast<qint64>(summary.iteration->depth)) : QJsonValue();
    object[QStringLiteral("faces_as_written")] = json(summary.facesAsWritten);
    object[QStringLiteral("instances_as_written")] = json(summary.instancesAsWritten);
    object[QStringLiteral("instances_distinct")] =
        summary.instancesDistinct ? json(*summary.instancesDistinct) : QJsonValue();
    object[QStringLiteral("contracting")] = summary.isContracting;
    object[QStringLiteral("contraction")] = summary.contraction
        ? QJsonValue(QJsonObject{{QStringLiteral("min"), summary.contraction->least},
                                 {QStringLiteral("max"), summary.contraction->greatest}})
        : QJsonValue();
    object[QStringLiteral("similarity_dimension")] =
        summary.similarityDimension ? QJsonValue(*summary.similarityDimension) : QJsonValue();
    const Sphere bound = boundingSphere(scene);
    object[QStringLiteral("bounds")] = QJsonObject{{QStringLiteral("centre"), json(bound.centre)},
                                                   {QStringLiteral("radius"), std::max(bound.radius, 0.0)},
                                                   {QStringLiteral("min"), json(scene.extent.least)},
                                                   {QStringLiteral("max"), json(scene.extent.greatest)}};
    const std::optional<std::string> flattened = flattenedBytes(scene);
    object[QStringLiteral("storage")] =
        QJsonObject{{QStringLiteral("source_bytes"), QString::number(input.sourceBytes)},
                    {QStringLiteral("flattened_obj_bytes"),
                     flattened ? QJsonValue(QString::fromStdString(*flattened)) : QJsonValue()}};
    return object;
}

}

int runInfo(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Prints the numbers of a fractal or a scene: faces, levels, depth, counts."));
    const QCommandLineOption jsonOption(QStringLiteral("json"), QStringLiteral("For machines."));
    parser.addOption(depthOption());
    parser.addOption(jsonOption);
    const auto file = parseArguments(parser, "info", arguments);
    if (!file) {
        return file.error();
    }
    const auto input = readInput(*file, parser);
    if (!input) {
        return input.error();
    }
    const Summary summary = summarise(*input->scene);
    if (parser.isSet(jsonOption)) {
        std::print("{}", QJsonDocument(json(*input, summary)).toJson().toStdString());
    } else {
        printText(*input, summary);
    }
    return Done;
}

}
