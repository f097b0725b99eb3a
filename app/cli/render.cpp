// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <optional>

#include <QColor>
#include <QCommandLineParser>
#include <QHash>
#include <QRegularExpression>

#include "app/drawing/painter.h"
#include "app/drawing/turn.h"
#include "app/imagedecoder.h"
#include "core/formats/sdoreader.h"
#include "core/geometry/computable.h"
#include "input.h"
#include "output.h"
#include "picturesize.h"
#include "render/sceneview.h"
#include "turntable.h"

namespace romanesco::cli {

namespace {

constexpr int mostSamples = 4'096;

struct Options {
    QCommandLineOption output{{QStringLiteral("o"), QStringLiteral("output")},
                              QStringLiteral("The picture to write; - is stdout."),
                              QStringLiteral("OUT.png")};
    QCommandLineOption size = sizeOption();
    QCommandLineOption tolerance{QStringLiteral("pixel-tolerance"),
                                 QStringLiteral("Copies smaller than this many pixels are drawn as one (1); "
                                                "0 draws every instance."),
                                 QStringLiteral("T"), QStringLiteral("1")};
    QCommandLineOption samples{QStringLiteral("samples"),
                               QStringLiteral("Samples a pixel (8); 1 is exactly the pixel centre."),
                               QStringLiteral("N"), QStringLiteral("8")};
    QCommandLineOption camera{
        QStringLiteral("camera"),
        QStringLiteral("Where from, as a scene says it: \"c (x, y, z) (pitch, yaw, roll) fov\", the "
                       "angles in radians, or with a height and orthographic after it."),
        QStringLiteral("LINE")};
    QCommandLineOption background{QStringLiteral("background"),
                                  QStringLiteral("A colour for the background, in place of a dark gradient."),
                                  QStringLiteral("#RRGGBB")};
    QCommandLineOption colourBy{QStringLiteral("colour-by"),
                                QStringLiteral("What copies are coloured by, in place of their materials: depth, "
                                               "branch (the outermost transformation) or set."),
                                QStringLiteral("WHAT")};
    QCommandLineOption wireframe{QStringLiteral("wireframe"), QStringLiteral("With the edges of all triangles.")};
    QCommandLineOption turntable{
        QStringLiteral("turntable"),
        QStringLiteral("N pictures of a full turn round what is looked at, the first as without; "
                       "OUT.png has a %d in it for the number, or %04d for four digits."),
        QStringLiteral("N")};
    QCommandLineOption frames{QStringLiteral("frames"),
                              QStringLiteral("Only these of the pictures of --turntable, from A to B; the first is 0."),
                              QStringLiteral("A..B")};
    QCommandLineOption endless{QStringLiteral("endless"),
                               QStringLiteral("As if the depth had no end: detail wherever the view leads.")};
    QCommandLineOption trail{
        QStringLiteral("trail"),
        QStringLiteral("Zoom as the dissertation does (4.3.2): the whole fractal stands where the copy "
                       "nearest to the camera is, N levels back."),
        QStringLiteral("N")};
    QCommandLineOption quiet{QStringLiteral("quiet"), QStringLiteral("No progress.")};
};

std::optional<Colouring> colouringFrom(const QCommandLineParser &parser, const Options &options)
{
    if (!parser.isSet(options.colourBy)) {
        return Colouring::Materials;
    }
    static const QHash<QString, Colouring> known{{QStringLiteral("depth"), Colouring::Depth},
                                                 {QStringLiteral("branch"), Colouring::Branch},
                                                 {QStringLiteral("set"), Colouring::Set}};
    const QString word = parser.value(options.colourBy);
    if (!known.contains(word)) {
        complain(QStringLiteral("--colour-by takes depth, branch or set, not \"%1\"").arg(word));
        return std::nullopt;
    }
    return known.value(word);
}

/// The view that the options ask for, without its camera; complains where they make no sense.
std::optional<View> viewFromOptions(const QCommandLineParser &parser, const Options &options)
{
    View view;
    view.standsAlone = true;
    const auto size = pictureSize(parser);
    if (!size) {
        return std::nullopt;
    }
    view.width = size->width();
    view.height = size->height();
    bool isNumber = false;
    view.pixelTolerance = parser.value(options.tolerance).toDouble(&isNumber);
    if (!isNumber || !(view.pixelTolerance >= 0.0 && view.pixelTolerance <= largestSide)) {
        complain(QStringLiteral("--pixel-tolerance takes a number of pixels from 0, not \"%1\"")
                     .arg(parser.value(options.tolerance)));
        return std::nullopt;
    }
    view.samples = parser.value(options.samples).toInt(&isNumber);
    if (!isNumber || view.samples < 1 || view.samples > mostSamples) {
        complain(QStringLiteral("--samples takes a whole number from 1 to %1, not \"%2\"")
                     .arg(mostSamples)
                     .arg(parser.value(options.samples)));
        return std::nullopt;
    }
    const std::optional<Colouring> colouring = colouringFrom(parser, options);
    if (!colouring) {
        return std::nullopt;
    }
    view.appearance.colours.colouring = *colouring;
    view.appearance.hasWires = parser.isSet(options.wireframe);
    if (parser.isSet(options.background)) {
        static const QRegularExpression colourPattern(QStringLiteral("^#[0-9A-Fa-f]{6}$"));
        const QString text = parser.value(options.background);
        if (!colourPattern.match(text).hasMatch()) {
            complain(QStringLiteral("--background takes a colour as #RRGGBB, not \"%1\"").arg(text));
            return std::nullopt;
        }
        const QColor colour(text);
        view.backgroundTop = {colour.redF(), colour.greenF(), colour.blueF()};
        view.backgroundBottom = view.backgroundTop;
    }
    return view;
}

/// The camera that --camera gives; complains where it is none.
std::optional<Camera> cameraFromLine(const QString &line)
{
    const SdoResult read = readSdo(line.toStdString());
    for (const Diagnostic &diagnostic : read.diagnostics) {
        complain(QStringLiteral("--camera: ") + QString::fromStdString(diagnostic.message()));
    }
    if (!read.description) {
        return std::nullopt;
    }
    const SceneDescription &scene = *read.description;
    if (!scene.camera || !scene.items.empty() || !scene.lights.empty()) {
        complain(QStringLiteral("--camera takes a line like \"c (0, 2, -9) # 60\", not \"%1\"").arg(line));
        return std::nullopt;
    }
    if (!isComputable(scene.camera->position)) {
        complain(QStringLiteral("--camera: the place is too far away (at most 1e153)"));
        return std::nullopt;
    }
    return cameraOf(*scene.camera);
}

/// What is to be drawn: pictures of a turn, one where there is no turntable.
struct Series {
    Turntable turntable;
    /// None for a single picture, which goes to the output by its own name.
    std::optional<FramePattern> names;
    QString output;

    [[nodiscard]] QString name(int frame) const { return names ? names->name(frame) : output; }
    [[nodiscard]] bool isSingle() const { return turntable.count == 1; }
};

/// What --trail says, for the dissertation's zoom; complains where that makes no sense.
std::optional<std::optional<std::size_t>> trailFromOptions(const QCommandLineParser &parser, const Options &options)
{
    if (!parser.isSet(options.trail)) {
        return std::optional<std::size_t>();
    }
    bool isNumber = false;
    const std::size_t trail = parser.value(options.trail).toUInt(&isNumber);
    if (!isNumber) {
        complain(QStringLiteral("--trail takes a whole number, not \"%1\"").arg(parser.value(options.trail)));
        return std::nullopt;
    }
    return trail;
}

/// Complains where the options make no sense.
std::optional<Series> seriesFromOptions(const QCommandLineParser &parser, const Options &options)
{
    Series series;
    series.output = parser.value(options.output);
    if (!parser.isSet(options.turntable)) {
        if (parser.isSet(options.frames)) {
            complain(QStringLiteral("--frames needs --turntable"));
            return std::nullopt;
        }
        return series;
    }
    const auto turntable = readTurntable(parser.value(options.turntable), parser.value(options.frames));
    if (!turntable) {
        complain(turntable.error());
        return std::nullopt;
    }
    series.turntable = *turntable;
    if (series.isSingle() && !series.output.contains(QLatin1Char('%'))) {
        return series;
    }
    const auto names = FramePattern::parse(series.output);
    if (!names) {
        complain(QStringLiteral("-o %1 is not a pattern: %2").arg(series.output, names.error()));
        return std::nullopt;
    }
    series.names = *names;
    return series;
}

/// All pictures of a series, each file whole or not at all; an exit status.
int drawSeries(const Turn &turn, const Series &series, bool isQuiet)
{
    auto painter = Painter::create(turn.scene);
    if (!painter) {
        complain(QString::fromStdString(painter.error()));
        return CannotDo;
    }
    catchCancel();
    Progress progress(isQuiet);
    const Turntable &turntable = series.turntable;
    for (int frame = turntable.first; frame <= turntable.last; ++frame) {
        const QString what = series.isSingle()
            ? QStringLiteral("drawing")
            : QStringLiteral("drawing picture %1 up to %2").arg(frame).arg(turntable.last);
        const auto picture = painter->draw(turn.at(frame), [&](int samples) {
            progress.show(QStringLiteral("%1: %2 of %3 samples").arg(what).arg(samples).arg(turn.view.samples));
            return !isCancelled();
        });
        if (!picture) {
            complain(QString::fromStdString(picture.error()));
            return CannotDo;
        }
        if (!writeWhole(series.name(frame), pngOf(*picture))) {
            return CannotDo;
        }
    }
    return Done;
}

}

int runRender(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Draws pictures of a fractal or a scene, without a display."));
    const Options options;
    parser.addOptions({options.output, options.size, options.camera, depthOption(), options.tolerance, options.samples,
                       options.background, options.colourBy, options.wireframe, options.turntable, options.frames,
                       options.endless, options.trail, options.quiet});
    const auto file = parseArguments(parser, "render", arguments);
    if (!file) {
        return file.error();
    }
    if (!parser.isSet(options.output)) {
        complain(QStringLiteral("render needs -o OUT.png"));
        return WrongUsage;
    }
    std::optional<View> view = viewFromOptions(parser, options);
    const std::optional<Series> series = view ? seriesFromOptions(parser, options) : std::nullopt;
    const auto trail = series ? trailFromOptions(parser, options) : std::nullopt;
    if (!trail) {
        return WrongUsage;
    }
    std::optional<Camera> camera;
    if (parser.isSet(options.camera)) {
        camera = cameraFromLine(parser.value(options.camera));
        if (!camera) {
            return WrongUsage;
        }
    }
    const bool isEndless = parser.isSet(options.endless);
    if (isEndless && parser.isSet(QStringLiteral("depth"))) {
        complain(QStringLiteral("--endless and --depth exclude each other"));
        return WrongUsage;
    }
    const auto input = readInput(*file, parser, decodeImage, isEndless ? DepthChoice::Endless : DepthChoice::AsViewed);
    if (!input) {
        return input.error();
    }
    SceneView from;
    from.setScene(input->scene);
    bool isFitted = false;
    if (camera) {
        from.start(*camera);
    } else {
        isFitted = from.start(double(view->width) / view->height);
    }
    view->camera = from.camera();
    view->surroundings = from.surroundings();
    const Surroundings &here = *from.surroundings();
    const glm::dvec3 middle = input->scene->extent.centre();
    Turn turn{input->scene, *view, isFitted ? here.hereFromWorld(middle) : from.pivot(), series->turntable.count,
              *trail};
    if (turn.trail) {
        turn.view.camera = from.cameraInWorld();
        turn.pivot = isFitted ? middle : here.worldFromHere(from.pivot());
    }
    return drawSeries(turn, *series, parser.isSet(options.quiet));
}

}
