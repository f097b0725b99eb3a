// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "input.h"

#include <cstdio>
#include <iterator>
#include <print>

#include <QCommandLineParser>
#include <QFile>

#include "commandline.h"
#include "core/base/file.h"
#include "core/formats/fdoreader.h"
#include "core/scene/sceneloader.h"
#include "core/text/linemap.h"
#include "output.h"

namespace romanesco::cli {

namespace {

std::expected<std::string, std::string> readText(const QString &file)
{
    if (file != QLatin1String("-")) {
        return DiskFiles().read(std::filesystem::path(QFile::encodeName(file).toStdString()));
    }
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly)) {
        return std::unexpected(input.errorString().toStdString());
    }
    return input.readAll().toStdString();
}

/// The text with another depth in it, so that everything after sees an ordinary text.
std::expected<std::string, int> withDepth(std::string text, const QString &depth)
{
    const QByteArray digits = depth.toUtf8();
    const bool isWhole = !digits.isEmpty() && std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    if (!isWhole) {
        complain(QStringLiteral("--depth takes a whole number, not \"%1\"").arg(depth));
        return std::unexpected(WrongUsage);
    }
    const FdoResult read = readFdo(text);
    if (!read.description) {
        return text; // its errors are told in a moment
    }
    if (!read.description->depth) {
        complain(QStringLiteral("--depth needs a depth in the file, as in \"<$>. z 6\""));
        return std::unexpected(WrongUsage);
    }
    const SourceRange range = read.description->depth->range;
    return text.replace(range.begin, range.length(), digits.toStdString());
}

}

QCommandLineOption depthOption()
{
    return {QStringLiteral("depth"), QStringLiteral("Depth in place of the file's."), QStringLiteral("N")};
}

std::expected<QString, int> parseArguments(QCommandLineParser &parser, const char *command,
                                           const QStringList &arguments)
{
    const QString name = QStringLiteral("romanesco ") + QLatin1String(command);
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("A .fdo or .obj file; - is stdin, as .fdo."));
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Print this text."));
    parser.addOption(help);
    const bool isUnderstood = parser.parse(QStringList{name} + arguments);
    if (isUnderstood && parser.isSet(help)) {
        // Without an application object Qt does not know the program's name.
        std::print("{}", parser.helpText().replace(QLatin1String("<executable_name>"), name).toStdString());
        return std::unexpected(Done);
    }
    if (!isUnderstood) {
        complain(parser.errorText());
    } else if (parser.positionalArguments().size() != 1) {
        complain(QStringLiteral("%1 takes one FILE, given %2").arg(name).arg(parser.positionalArguments().size()));
    } else {
        return parser.positionalArguments().constFirst();
    }
    return std::unexpected(WrongUsage);
}

std::expected<Input, int> readInput(const QString &file, const QCommandLineParser &parser)
{
    const bool isStandardInput = file == QLatin1String("-");
    const std::filesystem::path path(isStandardInput ? "stdin.fdo" : QFile::encodeName(file).toStdString());
    const std::string shown = isStandardInput ? "<stdin>" : file.toStdString();
    const FileKind kind = fileKind(path);
    if (kind == FileKind::Other) {
        complain(QStringLiteral("%1: only .fdo and .obj files can be read").arg(file));
        return std::unexpected(BadInput);
    }
    auto text = readText(file);
    if (!text) {
        complain(QStringLiteral("cannot read %1: %2").arg(file, QString::fromStdString(text.error())));
        return std::unexpected(BadInput);
    }
    const std::size_t sourceBytes = text->size();
    if (parser.isSet(QStringLiteral("depth"))) {
        if (kind != FileKind::Fdo) {
            complain(QStringLiteral("--depth needs a .fdo file"));
            return std::unexpected(WrongUsage);
        }
        auto changed = withDepth(std::move(*text), parser.value(QStringLiteral("depth")));
        if (!changed) {
            return std::unexpected(changed.error());
        }
        text = std::move(*changed);
    }

    const DiskFiles files;
    SceneResult result = SceneLoader(files).load(path, *text);
    const LineMap lines(*text);
    for (const Diagnostic &diagnostic : result.diagnostics) {
        if (diagnostic.severity() != Severity::Hint) {
            std::println(stderr, "{}", toLines(diagnostic, shown, lines));
        }
    }
    if (!result.scene) {
        return std::unexpected(BadInput);
    }
    return Input{std::move(result.scene), sourceBytes};
}

}
