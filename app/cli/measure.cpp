// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <expected>
#include <optional>
#include <utility>

#include <QCommandLineParser>

#include "app/imagedecoder.h"
#include "colliderchoice.h"
#include "core/measure/measurementpage.h"
#include "core/physics/scenephysics.h"
#include "input.h"
#include "measurejson.h"
#include "measuretable.h"
#include "output.h"
#include "render/headless/sceneframes.h"

namespace romanesco::cli {

namespace {

struct Options {
    QCommandLineOption json{QStringLiteral("json"), QStringLiteral("For machines.")};
    QCommandLineOption html{QStringLiteral("html"), QStringLiteral("Write a page with plots; - is stdout."),
                            QStringLiteral("OUT.html")};
    QCommandLineOption timeStep{
        QStringLiteral("timestep"),
        QStringLiteral("Also what the time step costs, on balls that are dropped: energy and where they land.")};
    QCommandLineOption rendering{
        QStringLiteral("rendering"),
        QStringLiteral(
            "Also what pictures cost, and how far off they are, by the pixel tolerance; and where copies stand "
            "on the screen by float, double and local frames.")};
    QCommandLineOption exporting{
        QStringLiteral("export"),
        QStringLiteral("Also how far off the surface is in an OBJ file, and how large that is, by the digits.")};
    QCommandLineOption radius{QStringLiteral("radius"),
                              QStringLiteral("Of the ball that may collide (default: the least of the scene, or 2 % of "
                                             "the diagonal)."),
                              QStringLiteral("R")};
    QCommandLineOption quiet{QStringLiteral("quiet"), QStringLiteral("No progress.")};
};

/// What was asked for beside the file.
struct Wanted {
    ColliderTrial::Options colliders = {};
    bool withSteps = false;
    bool withFrames = false;
    bool withDigits = false;
    bool isJson = false;
    /// Empty for none.
    QString page = {};
};

/// Complains where the options make no sense.
std::optional<Wanted> wantedOf(const QCommandLineParser &parser, const Options &options)
{
    Wanted wanted{.withSteps = parser.isSet(options.timeStep),
                  .withFrames = parser.isSet(options.rendering),
                  .withDigits = parser.isSet(options.exporting),
                  .isJson = parser.isSet(options.json),
                  .page = parser.value(options.html)};
    if (parser.isSet(options.html) && wanted.page.isEmpty()) {
        complain(QStringLiteral("--html takes a file"));
        return std::nullopt;
    }
    if (wanted.isJson && wanted.page == QLatin1String("-")) {
        complain(QStringLiteral("stdout can have either --json or --html"));
        return std::nullopt;
    }
    if (parser.isSet(options.radius)) {
        const auto radius = numberOf(parser, options.radius);
        if (!radius || *radius == 0.0) {
            complain(QStringLiteral("--radius takes a number above 0, not \"%1\"").arg(parser.value(options.radius)));
            return std::nullopt;
        }
        wanted.colliders.ballRadius = radius;
    }
    return wanted;
}

int refuse(const QString &file, const std::string &words)
{
    complain(QStringLiteral("%1: %2").arg(file, QString::fromStdString(words)));
    return CannotDo;
}

/// Where nothing can be drawn, the trial says so.
std::expected<FrameTrial, std::string> framesOf(const std::shared_ptr<const Scene> &scene, const TrialContext &context)
{
    const auto source = SceneFrames::create(scene, FrameTrial::width, FrameTrial::height);
    return source ? tryFrames(**source, *scene, {}, context) : FrameTrial{.reason = source.error()};
}

std::expected<Measurement, std::string> measured(const Input &input, const QString &file, const Wanted &wanted,
                                                 const TrialContext &context)
{
    const auto balls = ballsOf(*input.scene);
    if (!balls) {
        return std::unexpected(balls.error());
    }
    Measurement measurement{.source = shownName(file), .colliders = {}};
    auto colliders = tryColliders(input.scene, *balls, wanted.colliders, context);
    if (!colliders) {
        return std::unexpected(colliders.error());
    }
    measurement.colliders = std::move(*colliders);
    std::string failure;
    const auto take = [&](auto &into, auto trial) {
        if (!trial) {
            failure = trial.error();
            return false;
        }
        into = std::move(*trial);
        return true;
    };
    const Scene &scene = *input.scene;
    const bool isDone =
        (!wanted.withSteps
         || take(measurement.steps,
                 tryTimeSteps(input.scene, *balls, {.ballRadius = wanted.colliders.ballRadius}, context)))
        && (!wanted.withFrames
            || (take(measurement.frames, framesOf(input.scene, context))
                && take(measurement.depths, tryDepths(scene, context))))
        && (!wanted.withDigits || take(measurement.digits, tryDigits(scene, {}, context)));
    if (!isDone) {
        return std::unexpected(failure);
    }
    return measurement;
}

/// The page where it is wanted, and what goes to stdout. Whether that could be done.
bool write(const Measurement &measurement, const Wanted &wanted)
{
    const QString out = QStringLiteral("-");
    if (!wanted.page.isEmpty() && !writeWhole(wanted.page, QByteArray::fromStdString(pageOf(measurement)))) {
        return false;
    }
    return wanted.page == out
        || writeWhole(out, wanted.isJson ? jsonOf(measurement) : QByteArray::fromStdString(tableOf(measurement)));
}

}

int runMeasure(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Measures on this file what each way to search for the nearest point costs, and how far off it is.\n"
        "Every kind of collider and tolerance is asked the same questions, and compared with the exact answers. Counts "
        "and errors are the same in every run; times are the median of several rounds. Shares are in per cent, with "
        "what they are of all (95 % confidence) in brackets."));
    const Options options;
    parser.addOptions({options.timeStep, options.rendering, options.exporting, options.json, options.html,
                       options.radius, depthOption(), options.quiet});
    const auto file = parseArguments(parser, "measure", arguments);
    if (!file) {
        return file.error();
    }
    const auto wanted = wantedOf(parser, options);
    if (!wanted) {
        return WrongUsage;
    }
    const auto input = readInput(*file, parser, wanted->withFrames ? ImageDecoder(decodeImage) : ImageDecoder());
    if (!input) {
        return input.error();
    }
    catchCancel();
    const CancelWatch cancel;
    std::expected<Measurement, std::string> measurement;
    {
        Progress progress(parser.isSet(options.quiet));
        const TrialContext context{
            cancel.token(), [&](const std::string &what, double share) {
                progress.show(QStringLiteral("%1 %: %2").arg(qRound(100.0 * share)).arg(QString::fromStdString(what)));
            }};
        measurement = measured(*input, *file, *wanted, context);
    }
    if (!measurement) {
        return refuse(*file, measurement.error());
    }
    return write(*measurement, *wanted) ? Done : CannotDo;
}

}
