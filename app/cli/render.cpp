// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <optional>

#include <QBuffer>
#include <QColor>
#include <QCommandLineParser>
#include <QHash>
#include <QImage>
#include <QRegularExpression>

#include "app/imagedecoder.h"
#include "core/formats/sdoreader.h"
#include "input.h"
#include "output.h"
#include "render/headless/eglcontext.h"
#include "render/renderer.h"

namespace romanesco::cli {

namespace {

constexpr int largestSide = 16'384;
constexpr int mostSamples = 4'096;

struct Options {
    QCommandLineOption output{{QStringLiteral("o"), QStringLiteral("output")},
                              QStringLiteral("The picture to write; - is stdout."),
                              QStringLiteral("OUT.png")};
    QCommandLineOption size{QStringLiteral("size"), QStringLiteral("Width and height in pixels (1280x720)."),
                            QStringLiteral("WxH"), QStringLiteral("1280x720")};
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
    static const QRegularExpression sizePattern(QStringLiteral("^([1-9][0-9]{0,5})x([1-9][0-9]{0,5})$"));
    const QRegularExpressionMatch size = sizePattern.match(parser.value(options.size));
    view.width = size.captured(1).toInt();
    view.height = size.captured(2).toInt();
    if (!size.hasMatch() || std::max(view.width, view.height) > largestSide) {
        complain(QStringLiteral("--size takes WIDTHxHEIGHT, each up to %1, not \"%2\"")
                     .arg(largestSide)
                     .arg(parser.value(options.size)));
        return std::nullopt;
    }
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

/// The picture, or an exit status after a complaint.
std::expected<Picture, int> draw(const std::shared_ptr<const Scene> &scene, const View &view, bool isQuiet)
{
    const auto fail = [](const std::string &words) {
        complain(QString::fromStdString(words));
        return std::unexpected(CannotDo);
    };
    const auto context = EglContext::create();
    if (!context) {
        return fail(context.error());
    }
    const auto renderer = Renderer::create();
    if (!renderer) {
        return fail(renderer.error());
    }
    catchCancel();
    Progress progress(isQuiet);
    (*renderer)->setScene(scene);
    (*renderer)->begin(view);
    while (!(*renderer)->step(std::chrono::milliseconds(100))) {
        if (isCancelled()) {
            return fail("cancelled");
        }
        progress.show(
            QStringLiteral("drawing: %1 of %2 samples").arg((*renderer)->finishedSamples()).arg(view.samples));
    }
    if (!(*renderer)->error().empty()) {
        return fail((*renderer)->error());
    }
    return (*renderer)->read();
}

QByteArray png(const Picture &picture)
{
    const QImage image(picture.pixels.data(), picture.width, picture.height, picture.width * 3, QImage::Format_RGB888);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

}

int runRender(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Draws one picture of a fractal or a scene, without a display."));
    const Options options;
    parser.addOptions({options.output, options.size, options.camera, depthOption(), options.tolerance, options.samples,
                       options.background, options.colourBy, options.wireframe, options.quiet});
    const auto file = parseArguments(parser, "render", arguments);
    if (!file) {
        return file.error();
    }
    if (!parser.isSet(options.output)) {
        complain(QStringLiteral("render needs -o OUT.png"));
        return WrongUsage;
    }
    std::optional<View> view = viewFromOptions(parser, options);
    if (!view) {
        return WrongUsage;
    }
    std::optional<Camera> camera;
    if (parser.isSet(options.camera)) {
        camera = cameraFromLine(parser.value(options.camera));
        if (!camera) {
            return WrongUsage;
        }
    }
    const auto input = readInput(*file, parser, decodeImage);
    if (!input) {
        return input.error();
    }
    view->camera = camera ? *camera : startCamera(*input->scene, double(view->width) / view->height);
    const auto picture = draw(input->scene, *view, parser.isSet(options.quiet));
    if (!picture) {
        return picture.error();
    }
    return writeWhole(parser.value(options.output), png(*picture)) ? Done : CannotDo;
}

}
