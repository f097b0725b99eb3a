// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QSize>

namespace romanesco::cli {

constexpr int largestSide = 16'384;

/// --size
[[nodiscard]] QCommandLineOption sizeOption();
/// What it says; complains where that makes no sense.
[[nodiscard]] std::optional<QSize> pictureSize(const QCommandLineParser &parser);

}
