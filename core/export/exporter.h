// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/base/bytesink.h"
#include "core/base/file.h"
#include "core/scene/scene.h"
#include "exportoptions.h"
#include "forecast.h"
#include "weld.h"

namespace romanesco {

/// What an export came to.
struct ExportReport {
    std::uint64_t faces = 0;
    std::uint64_t bytes = 0;
    /// Of a GLB: see GlbReport.
    std::uint64_t bakedCopies = 0;
    std::uint64_t missingImages = 0;
    /// Of one that is welded.
    std::optional<WeldReport> weld = {};
};

/// More faces than these are hardly meant: who asks for them should be asked first.
constexpr std::uint64_t mostFacesUnasked = 1'000'000'000;

/// What an export looks at while it works.
struct ExportContext {
    /// A stop takes effect within some milliseconds; the error is then "cancelled".
    std::stop_token stop = {};
    /// Told the bytes written so far, some thousand times a second, in the thread that writes.
    std::function<void(std::uint64_t bytes)> progress = {};
    /// Where textures are read from that go into the file; null for the disk.
    const FileAccess *files = nullptr;
};

/// Why an export to this path cannot come to an end: the format or the disk cannot hold it. Empty where nothing is known
/// against it.
[[nodiscard]] std::string obstacle(const ExportForecast &forecast, const ExportOptions &options,
                                   const std::filesystem::path &path);

/// Whether an export to this path, or the file of materials beside it, would take the place of one of these files, which
/// the scene is made from.
[[nodiscard]] bool writesOver(const std::filesystem::path &path, ExportFormat format,
                              std::span<const std::filesystem::path> files);

/// In the folder where a file will stand, which is that of its target where it is a link. Nothing where that is not known.
[[nodiscard]] std::optional<std::uint64_t> freeBytes(const std::filesystem::path &path);

/// Writes a scene as one file: each item, in its distinct copies, at its place; balls where they start. Takes memory that
/// does not grow with the number of copies, but for welding. An OBJ is without its materials, which stand in a file of
/// their own. The error is why it could not be done.
[[nodiscard]] std::expected<ExportReport, std::string> exportScene(const Scene &scene, const ExportOptions &options,
                                                                   ByteSink &sink, const ExportContext &context = {});

/// The same to a file that appears whole or not at all. Beside an OBJ with materials appears another, whose name ends in
/// .mtl.
[[nodiscard]] std::expected<ExportReport, std::string> exportToFile(const Scene &scene, const ExportOptions &options,
                                                                    const std::filesystem::path &path,
                                                                    const ExportContext &context = {});

}
