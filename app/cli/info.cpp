// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <format>
#include <print>

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/scene/summary.h"
#include "input.h"

namespace romanesco::cli {

namespace {

constexpr std::size_t mostSizesShown = 16;

std::string place(const glm::dvec3 &v)
{
    return std::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

std::string levelText(const Summary &summary)
{
    std::string text = std::to_string(*summary.levelCount);
    for (std::size_t i = 0; i < summary.levelSizes.size(); ++i) {
        if (i == mostSizesShown) {
            return text + " × …";
        }
        text += std::format("{}{}", i == 0 ? ", of " : " × ", summary.levelSizes[i]);
    }
    return text;
}

void printText(const Input &input, const Summary &summary)
{
    const Scene &scene = *input.scene;
    const Model &model = *scene.items.front().model;
    const std::string base = model.meshPath.empty() ? "" : model.meshPath + ", ";
    std::println("base         {}{} faces", base, *summary.facesPerBase);
    std::println("levels       {}", levelText(summary));
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
    const Sphere bound = boundingSphere(scene);
    std::println("bounds       {} to {}", place(scene.extent.least), place(scene.extent.greatest));
    std::println("             within {:.6g} of {}", bound.radius, place(bound.centre));
    std::println("storage      {} bytes of text, {} bytes as a graph", input.sourceBytes, model.graph.memoryUse());
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
    object[QStringLiteral("base")] = QString::fromStdString(scene.items.front().model->meshPath);
    object[QStringLiteral("faces_per_base")] = static_cast<qint64>(*summary.facesPerBase);
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
    const Sphere bound = boundingSphere(scene);
    object[QStringLiteral("bounds")] = QJsonObject{{QStringLiteral("centre"), json(bound.centre)},
                                                   {QStringLiteral("radius"), bound.radius},
                                                   {QStringLiteral("min"), json(scene.extent.least)},
                                                   {QStringLiteral("max"), json(scene.extent.greatest)}};
    object[QStringLiteral("storage")] =
        QJsonObject{{QStringLiteral("source_bytes"), QString::number(input.sourceBytes)}};
    return object;
}

}

int runInfo(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Prints the numbers of a fractal: faces, levels, depth, counts."));
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
