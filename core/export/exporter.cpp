// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "exporter.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/atomicfile.h"
#include "core/formats/glbwriter.h"
#include "core/formats/lineparser.h"
#include "core/formats/objwriter.h"
#include "core/formats/plywriter.h"
#include "core/formats/stlwriter.h"
#include "scenecopies.h"

namespace romanesco {

namespace {

using Failure = std::unexpected<std::string>;

/// Counts what goes through, tells it, and lets nothing through after a stop.
class WatchedSink final : public ByteSink
{
public:
    WatchedSink(ByteSink &sink, const ExportContext &context)
        : m_sink(sink)
        , m_context(context)
    {
    }

    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        if (m_context.stop.stop_requested()) {
            return Failure("cancelled");
        }
        auto written = m_sink.write(bytes);
        m_count += bytes.size();
        if (written && m_context.progress) {
            m_context.progress(m_count);
        }
        return written;
    }

    [[nodiscard]] std::uint64_t count() const { return m_count; }

private:
    ByteSink &m_sink;
    const ExportContext &m_context;
    std::uint64_t m_count = 0;
};

std::uint64_t facesOf(const CopySource &copies)
{
    std::uint64_t faces = 0;
    for (const CopySource::Item &item : copies.items()) {
        faces += item.copyCount * item.mesh->faces.size();
    }
    return faces;
}

/// "menger.fdo, depth 4, 1920000 faces".
std::string commentOf(const Scene &scene, const std::string &source, std::uint64_t faces)
{
    std::string comment = "Romanesco: " + source;
    // a name may hold anything, a comment ends with its line
    std::ranges::replace_if(comment, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '_');
    if (scene.depth) {
        comment += ", depth " + std::to_string(scene.depth->value);
    }
    return comment + ", " + std::to_string(faces) + (faces == 1 ? " face" : " faces");
}

std::expected<SceneCopies, std::string> copiesOf(const Scene &scene, const ExportOptions &options,
                                                 const ExportContext &context)
{
    const auto counts = SceneCopies::count(scene);
    if (!counts) {
        return Failure("the copies are too many to be counted");
    }
    const auto branches = options.isGrouped ? SceneCopies::Branches::Named : SceneCopies::Branches::Unnamed;
    return SceneCopies(scene, *counts, branches, options.source, context.stop);
}

std::expected<GlbReport, std::string> writeGlb(const CopySource &copies, const std::string &comment, ByteSink &sink,
                                               const ExportContext &context)
{
    const auto readImage = [&](const std::filesystem::path &path) {
        const auto read = context.files ? context.files->read(path) : DiskFiles().read(path);
        return read ? std::optional(*read) : std::nullopt;
    };
    return romanesco::writeGlb(copies, {comment, readImage}, sink);
}

std::expected<ExportReport, std::string> writeCopies(const CopySource &copies, const Scene &scene,
                                                     const ExportOptions &options, const std::string &materialLibrary,
                                                     ByteSink &sink, const ExportContext &context)
{
    WatchedSink watched(sink, context);
    ExportReport report{.faces = facesOf(copies)};
    const std::string comment = commentOf(scene, options.source, report.faces);
    std::expected<void, std::string> written;
    switch (options.format) {
    case ExportFormat::Obj:
        written = writeObj(copies, {comment, options.digits, materialLibrary}, watched);
        break;
    case ExportFormat::Ply:
        written = writePly(copies, comment, watched);
        break;
    case ExportFormat::Stl:
        written = writeStl(copies, comment, watched);
        break;
    case ExportFormat::Glb:
        written = writeGlb(copies, comment, watched, context).transform([&](const GlbReport &glb) {
            report.bakedCopies = glb.bakedCopies;
            report.missingImages = glb.missingImages;
        });
        break;
    }
    report.bytes = watched.count();
    return written ? std::expected<ExportReport, std::string>(report) : Failure(written.error());
}

/// All copies, or the one mesh that they are welded to: its materials have the names that they have in the library of the
/// copies.
std::expected<ExportReport, std::string> write(const CopySource &copies, const Scene &scene,
                                               const ExportOptions &options, const std::string &materialLibrary,
                                               ByteSink &sink, const ExportContext &context)
{
    if (!options.isWelded) {
        return writeCopies(copies, scene, options, materialLibrary, sink, context);
    }
    const auto welded = weld(copies, context.stop);
    if (!welded) {
        return Failure(welded.error());
    }
    auto report = writeCopies(PlainMesh(welded->mesh), scene, options, materialLibrary, sink, context);
    if (report) {
        report->weld = welded->report;
    }
    return report;
}

bool isMore(const Count &count, std::uint64_t limit)
{
    return count.toInteger().value_or(limit + 1) > limit;
}

}

std::optional<ExportFormat> exportFormat(const std::filesystem::path &path)
{
    const std::string ending = path.extension().string();
    return hasEnding(ending, ".obj") ? std::optional(ExportFormat::Obj)
        : hasEnding(ending, ".ply")  ? std::optional(ExportFormat::Ply)
        : hasEnding(ending, ".stl")  ? std::optional(ExportFormat::Stl)
        : hasEnding(ending, ".glb")  ? std::optional(ExportFormat::Glb)
                                     : std::nullopt;
}

bool writesOver(const std::filesystem::path &path, ExportFormat format, std::span<const std::filesystem::path> files)
{
    const auto isAmong = [&](const std::filesystem::path &written) {
        return std::ranges::any_of(files, [&](const std::filesystem::path &file) {
            std::error_code ignored;
            return std::filesystem::equivalent(written, file, ignored);
        });
    };
    return isAmong(path)
        || (format == ExportFormat::Obj && isAmong(std::filesystem::path(path).replace_extension(".mtl")));
}

std::optional<std::uint64_t> freeBytes(const std::filesystem::path &path)
{
    std::error_code error;
    const std::filesystem::path target = std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
    const std::filesystem::space_info space = std::filesystem::space(target.parent_path(), error);
    return error ? std::nullopt : std::optional(std::uint64_t{space.available});
}

std::string obstacle(const ExportForecast &forecast, const ExportOptions &options, const std::filesystem::path &path)
{
    if (options.format == ExportFormat::Stl && isMore(forecast.faces, mostStlFaces)) {
        return "an STL file holds at most " + std::to_string(mostStlFaces) + " faces";
    }
    if (options.format == ExportFormat::Ply && isMore(forecast.vertices, mostPlyVertices)) {
        return "a PLY file holds at most " + std::to_string(mostPlyVertices) + " vertices";
    }
    if (options.format == ExportFormat::Glb && isMore(forecast.bytes, mostGlbBytes)) {
        return "a GLB file holds at most " + std::to_string(mostGlbBytes) + " bytes";
    }
    if (options.isWelded && isMore(forecast.faces, mostWeldedFaces)) {
        return "welding holds all faces in memory, at most " + std::to_string(mostWeldedFaces);
    }
    const std::optional<std::uint64_t> space = freeBytes(path);
    if (space && isMore(forecast.bytes, *space)) {
        return "there are " + std::to_string(*space) + " bytes free on the disk";
    }
    return {};
}

std::expected<ExportReport, std::string> exportScene(const Scene &scene, const ExportOptions &options, ByteSink &sink,
                                                     const ExportContext &context)
{
    const auto copies = copiesOf(scene, options, context);
    return copies ? write(*copies, scene, options, {}, sink, context) : Failure(copies.error());
}

std::expected<ExportReport, std::string> exportToFile(const Scene &scene, const ExportOptions &options,
                                                      const std::filesystem::path &path, const ExportContext &context)
{
    const auto copies = copiesOf(scene, options, context);
    if (!copies) {
        return Failure(copies.error());
    }
    auto file = AtomicFile::create(path);
    if (!file) {
        return Failure(std::move(file.error()));
    }
    // Both files are written before the first takes its name, so that a full disk changes neither.
    const MaterialTable materials(copies->items());
    const bool hasMaterials = options.format == ExportFormat::Obj && !materials.entries().empty();
    const std::filesystem::path library = std::filesystem::path(path).replace_extension(".mtl");
    std::optional<AtomicFile> libraryFile;
    if (hasMaterials) {
        auto created = AtomicFile::create(library);
        auto filled = created ? created->write(mtlText(materials, path.parent_path())) : Failure(created.error());
        if (!filled) {
            return Failure(library.filename().string() + ": " + filled.error());
        }
        libraryFile.emplace(std::move(*created));
    }
    auto report = write(*copies, scene, options, hasMaterials ? library.filename().string() : "", *file, context);
    if (!report) {
        return report;
    }
    for (AtomicFile *finished : {libraryFile ? &*libraryFile : nullptr, &*file}) {
        if (auto committed = finished ? finished->commit() : std::expected<void, std::string>(); !committed) {
            return Failure(std::move(committed.error()));
        }
    }
    return report;
}

}
