// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <format>
#include <optional>
#include <print>

#include <QCommandLineParser>
#include <QFile>
#include <QLocale>

#include "core/export/exporter.h"
#include "core/formats/numbertext.h"
#include "input.h"
#include "output.h"

namespace romanesco::cli {

namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    QCommandLineOption output{{QStringLiteral("o"), QStringLiteral("output")},
                              QStringLiteral("The file to write: .obj, .ply, .stl or .glb; - is stdout, as OBJ."),
                              QStringLiteral("OUT")};
    QCommandLineOption digits{
        QStringLiteral("digits"),
        QStringLiteral("Significant digits of each number in an OBJ, from 1 to 17, in place of the "
                       "fewest that read back as the same number."),
        QStringLiteral("N")};
    QCommandLineOption groups{QStringLiteral("groups"), QStringLiteral("An OBJ has a group for each branch.")};
    QCommandLineOption weld{QStringLiteral("weld"),
                            QStringLiteral("Merge vertices that coincide, drop walls between copies, and say whether "
                                           "the result is closed; up to 10,000,000 faces.")};
    QCommandLineOption force{QStringLiteral("force"), QStringLiteral("Write more than 1,000,000,000 faces.")};
    QCommandLineOption quiet{QStringLiteral("quiet"), QStringLiteral("No progress.")};
};

std::filesystem::path outputPath(const QString &file)
{
    return QFile::encodeName(file).toStdString();
}

/// Complains where the options make no sense.
std::optional<ExportOptions> exportOptions(const QCommandLineParser &parser, const Options &options)
{
    const auto wrong = [](const QString &words) {
        complain(words);
        return std::nullopt;
    };
    if (!parser.isSet(options.output)) {
        return wrong(QStringLiteral("export needs -o OUT.obj"));
    }
    const QString output = parser.value(options.output);
    const auto format = output == QLatin1String("-") ? ExportFormat::Obj : exportFormat(outputPath(output));
    if (!format) {
        return wrong(QStringLiteral("%1: only .obj, .ply, .stl and .glb files can be written").arg(output));
    }
    ExportOptions result{.format = *format,
                         .isGrouped = parser.isSet(options.groups),
                         .isWelded = parser.isSet(options.weld)};
    if (*format != ExportFormat::Obj && (result.isGrouped || parser.isSet(options.digits))) {
        return wrong(QStringLiteral("only an .obj file has digits and groups"));
    }
    if (parser.isSet(options.digits)) {
        bool isNumber = false;
        result.digits = parser.value(options.digits).toInt(&isNumber);
        if (!isNumber || *result.digits < 1 || *result.digits > NumberText::mostDigits) {
            return wrong(QStringLiteral("--digits takes a whole number from 1 to 17, not \"%1\"")
                             .arg(parser.value(options.digits)));
        }
    }
    return result;
}

/// "1.92 MB"; from 10^18 bytes on "3.3e+41 bytes".
std::string sizeText(const Count &bytes)
{
    constexpr std::array units{"bytes", "kB", "MB", "GB", "TB", "PB"};
    const double logarithm = bytes.log10();
    if (logarithm < 18.0) {
        const auto unit = static_cast<std::size_t>(std::max(logarithm, 0.0) / 3.0);
        return std::format("{:.3g} {}", std::pow(10.0, logarithm - 3.0 * static_cast<double>(unit)), units[unit]);
    }
    const double exponent = std::floor(logarithm);
    return std::format("{:.1f}e{:.0f} bytes", std::pow(10.0, logarithm - exponent), exponent);
}

/// Digits, or a power of ten with two of them.
std::string countText(const Count &count)
{
    const double exponent = std::floor(count.log10());
    return exponent < 15.0 ? count.toString()
                           : std::format("{:.2f}e{:.0f}", std::pow(10.0, count.log10() - exponent), exponent);
}

void printWeld(std::FILE *stream, const WeldReport &weld)
{
    std::println(stream, "welded       {} vertices merged within {:.3g}, {} faces inside and {} others dropped",
                 weld.mergedVertices, weld.tolerance, weld.droppedWalls, weld.droppedFaces);
    if (weld.isClosed()) {
        std::println(stream, "closed       yes");
    } else {
        std::println(stream, "closed       no, {} edges are open", weld.openEdges);
    }
}

/// "2.67", "42.2", "108,000", of 1 and above.
std::string threeDigits(double number)
{
    const int power = static_cast<int>(std::log10(number)) - 2;
    const double unit = std::pow(10.0, power);
    const QLocale english(QLocale::English, QLocale::UnitedStates);
    return english.toString(std::round(number / unit) * unit, 'f', std::max(-power, 0)).toStdString();
}

int refuse(const QString &file, const std::string &words)
{
    complain(QStringLiteral("%1: %2").arg(file, QString::fromStdString(words)));
    return CannotDo;
}

/// Shows how far the writing is, some times a second.
class ExportProgress
{
public:
    ExportProgress(const ExportForecast &forecast, bool isQuiet)
        : m_faces(static_cast<double>(forecast.faces.toInteger().value_or(0)))
        , m_bytes(static_cast<double>(forecast.bytes.toInteger().value_or(1)))
        , m_progress(isQuiet)
    {
    }

    void show(std::uint64_t bytes)
    {
        const Clock::time_point now = Clock::now();
        if (now - m_shown < std::chrono::milliseconds(100)) {
            return;
        }
        m_shown = now;
        const double share = std::min(static_cast<double>(bytes) / m_bytes, 1.0);
        m_progress.show(QString::fromStdString(
            std::format("writing: {:.0f} of {:.0f} faces ({:.0f} %)", share * m_faces, m_faces, 100.0 * share)));
    }

private:
    double m_faces;
    double m_bytes;
    Progress m_progress;
    Clock::time_point m_shown = Clock::now();
};

std::expected<ExportReport, std::string> exportTo(const QString &output, const Scene &scene,
                                                  const ExportOptions &options, const ExportForecast &forecast,
                                                  bool isQuiet)
{
    catchCancel();
    const CancelWatch cancel;
    ExportProgress progress(forecast, isQuiet);
    const ExportContext context{cancel.token(), [&](std::uint64_t bytes) { progress.show(bytes); }};
    if (output == QLatin1String("-")) {
        StandardOutput sink;
        return exportScene(scene, options, sink, context);
    }
    return exportToFile(scene, options, outputPath(output), context);
}

}

int runExport(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Writes all copies of a fractal, or all that a scene holds, as one mesh. Copies that stand in "
                       "the same place by\n"
                       "different words are written once. Memory does not grow with the number of copies."));
    const Options options;
    parser.addOptions(
        {options.output, depthOption(), options.digits, options.groups, options.weld, options.force, options.quiet});
    const auto file = parseArguments(parser, "export", arguments);
    if (!file) {
        return file.error();
    }
    std::optional<ExportOptions> wanted = exportOptions(parser, options);
    if (!wanted) {
        return WrongUsage;
    }
    const auto input = readInput(*file, parser);
    if (!input) {
        return input.error();
    }
    const QString output = parser.value(options.output);
    const bool isStreamed = output == QLatin1String("-");
    if (!isStreamed && writesOver(outputPath(output), wanted->format, input->files)) {
        complain(QStringLiteral("%1, or its materials, would be written over a file that it is made from").arg(output));
        return WrongUsage;
    }
    wanted->source = std::filesystem::path(shownName(*file)).filename().string();
    const auto known = forecast(*input->scene, *wanted);
    if (!known) {
        return refuse(*file, "the copies are of too many sets to be counted");
    }
    const std::string size = std::format("{} faces, about {}", countText(known->faces), sizeText(known->bytes));
    const std::optional<std::uint64_t> faces = known->faces.toInteger();
    if ((!faces || *faces > mostFacesUnasked) && !parser.isSet(options.force)) {
        return refuse(*file, size + "; --force writes more than 1000000000 faces");
    }
    if (const std::string reason = obstacle(*known, *wanted, isStreamed ? "." : outputPath(output)); !reason.empty()) {
        return refuse(*file, size + ": " + reason);
    }
    const Clock::time_point start = Clock::now();
    const auto report = exportTo(output, *input->scene, *wanted, *known, parser.isSet(options.quiet));
    if (!report) {
        return refuse(QStringLiteral("cannot write ") + output, report.error());
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    std::FILE *stream = isStreamed ? stderr : stdout;
    if (report->missingImages > 0) {
        complain(QStringLiteral("%1 of the textures cannot be read, or are neither PNG nor JPEG: left out")
                     .arg(report->missingImages));
    }
    std::println(stream, "faces        {}", report->faces);
    if (report->bakedCopies > 0) {
        std::println(stream, "baked        {} copies that are not translation, rotation and scale",
                     report->bakedCopies);
    }
    if (report->weld) {
        printWeld(stream, *report->weld);
    }
    std::println(stream, "bytes        {}", report->bytes);
    std::println(stream, "seconds      {:.3f}", seconds);
    const double ratio =
        static_cast<double>(report->bytes) / static_cast<double>(std::max<std::uint64_t>(input->sourceBytes, 1));
    std::println(stream, "source       {} bytes, {} times {}", input->sourceBytes,
                 threeDigits(std::max(ratio, 1.0 / ratio)), ratio < 1.0 ? "more" : "less");
    return Done;
}

}
