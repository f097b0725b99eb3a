// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

#include <QString>

#include "core/export/exporter.h"

namespace romanesco {

/// What an export to a path would come to.
struct ExportEstimate {
    /// Before welding. Nothing where the copies cannot be counted.
    std::optional<ExportForecast> forecast;
    /// About; without what the disk takes longer than memory. Nothing where a moment was too short to tell.
    std::optional<double> seconds;
    /// On the disk that would hold the file; nothing where that is not known.
    std::optional<std::uint64_t> freeBytes;
    /// The path has a file already.
    bool isReplacing = false;
    /// Why it cannot be done, as a sentence; else empty.
    QString obstacle;
};

/// Nothing is written. files are those that the scene is made from, which are never written over. Cost: a tenth of a second,
/// or one where the first bytes take long, in which a part of the export is made for nobody, to measure how fast that goes.
[[nodiscard]] ExportEstimate estimateExport(const Scene &scene, const ExportOptions &options,
                                            const std::filesystem::path &path,
                                            const std::vector<std::filesystem::path> &files,
                                            const std::stop_token &stop);

}
