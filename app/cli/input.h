// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <QStringList>

#include "core/scene/scene.h"
#include "core/scene/textures.h"

class QCommandLineOption;
class QCommandLineParser;

namespace romanesco::cli {

/// A scene from the command line, with what belongs to its file.
struct Input {
    std::shared_ptr<const Scene> scene;
    /// All files that it is made from, FILE first, and their bytes in all.
    std::vector<std::filesystem::path> files;
    std::uint64_t sourceBytes = 0;
    /// The file is an .sdo, which places other files.
    bool isAssembled = false;
};

[[nodiscard]] QCommandLineOption depthOption();

/// Parses a command's arguments, `--help` and the one FILE included. The error is an exit status; what has to be said
/// is said (help on stdout, mistakes on stderr).
[[nodiscard]] std::expected<QString, int> parseArguments(QCommandLineParser &parser, const char *command,
                                                         const QStringList &arguments);

/// The same for a command that takes one FILE or more.
[[nodiscard]] std::expected<QStringList, int> parseFiles(QCommandLineParser &parser, const char *command,
                                                         const QStringList &arguments);

/// What FILE is in the file system; `-` stands in the current folder, as .fdo.
[[nodiscard]] std::filesystem::path pathOf(const QString &file);
/// What FILE is called in messages.
[[nodiscard]] std::string shownName(const QString &file);
/// The bytes of FILE (`-` is stdin), or a phrase that completes "cannot read …: ".
[[nodiscard]] std::expected<std::string, std::string> readText(const QString &file);

/// How deep fractals are: as the text or --depth says; as a saved view asks for where --depth says nothing and that can be; without end.
enum class DepthChoice { AsWritten, AsViewed, Endless };

/// Reads FILE (`-` is stdin, as .fdo), with another depth in place of the text's, or of every fractal's in a scene, where
/// that is asked for. Errors and warnings go to stderr as FILE:LINE:COL; the error is an exit status. Who draws gives a decoder.
[[nodiscard]] std::expected<Input, int> readInput(const QString &file, const QCommandLineParser &parser,
                                                  ImageDecoder decoder = {},
                                                  DepthChoice choice = DepthChoice::AsWritten);

}
