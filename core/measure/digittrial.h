// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "core/base/count.h"
#include "core/scene/scene.h"
#include "spread.h"
#include "trialcontext.h"

namespace romanesco {

/// An OBJ file whose numbers have so many digits, and how far its surface is off.
struct DigitRow {
    /// Significant ones, from 3 to 17; none for the shortest that read back alike, as files are written unless asked
    /// otherwise.
    std::optional<int> digits = {};

    /// Of a vertex, in parts of the diagonal: the largest, and the root of the mean square.
    double worst = 0.0;
    double rms = 0.0;
    /// Faces of which two corners became one, and those that became flat otherwise; none that were so before.
    std::size_t collapsed = 0;
    std::size_t flat = 0;
    /// Of the whole file, as the exporter foretells it; nothing where the copies cannot be counted.
    std::optional<Count> bytes = {};
    /// To write a face with its vertices.
    Spread nanoseconds = {};
};

/// A scene written as OBJ and read back.
struct DigitTrial {
    struct Options {
        /// More faces are not written: then copies are drawn at random.
        std::uint64_t mostFaces = 50'000;
    };

    /// That were written and read, and of all; nothing where those cannot be counted.
    std::size_t faces = 0;
    std::size_t vertices = 0;
    std::optional<Count> facesInAll = {};
    /// All copies were written.
    bool isWhole = false;
    /// Of the box round the scene.
    double diagonal = 0.0;
    /// By digits, ascending.
    std::vector<DigitRow> rows = {};
};

/// "6 digits", "shortest".
[[nodiscard]] std::string nameOf(const DigitRow &row);

/// Writes the copies of a scene by the exporter's own writer, with all numbers of digits, and looks at what is read back. Errors
/// and bytes are the same in every run, times are not. The error is a sentence: nothing to write, cancelled. Costs a second
/// or two.
[[nodiscard]] std::expected<DigitTrial, std::string> tryDigits(const Scene &scene, const DigitTrial::Options &options,
                                                               const TrialContext &context = {});

}
