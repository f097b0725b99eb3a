// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>

#include <QString>

namespace romanesco::cli {

/// Frames of a full turn: those from first to last, both included, of 0 to count - 1.
struct Turntable {
    int count = 1;
    int first = 0;
    int last = 0;
};

/// From what --turntable and --frames say; none of the latter is all. The error is a sentence.
[[nodiscard]] std::expected<Turntable, QString> readTurntable(const QString &count, const QString &frames);

}
