// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "input.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <mutex>
#include <print>
#include <utility>

#include <QCommandLineParser>
#include <QFile>

#include "commandline.h"
#include "core/base/file.h"
#include "core/scene/depthchange.h"
#include "core/scene/sceneloader.h"
#include "core/text/linemap.h"
#include "core/text/places.h"
#include "output.h"

namespace romanesco::cli {

namespace {

constexpr QLatin1StringView standardInput("-");

/// The files that the arguments name. The error is an exit status, after help or a complaint.
std::expected<QStringList, int> parsed(QCommandLineParser &parser, const char *command, const QStringList &arguments)
{
    const QString name = QStringLiteral("romanesco ") + QLatin1String(command);
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
        return std::unexpected(WrongUsage);
    }
    return parser.positionalArguments();
}

/// The files of the disk; keeps count of what was read.
class InputFiles final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override
    {
        auto text = DiskFiles().read(path);
        if (text) {
            const std::lock_guard lock(m_mutex);
            m_read.insert_or_assign(path, text->size());
        }
        return text;
    }

    [[nodiscard]] std::expected<void, std::string> check(const std::filesystem::path &path) const override
    {
        return DiskFiles().check(path);
    }

    /// Paths, and the bytes of each.
    [[nodiscard]] const std::map<std::filesystem::path, std::uint64_t> &read() const { return m_read; }

private:
    mutable std::mutex m_mutex;
    mutable std::map<std::filesystem::path, std::uint64_t> m_read;
};

/// Empty where the option is not given; the error is an exit status after a complaint.
std::expected<std::string, int> depthDigits(const QCommandLineParser &parser, FileKind kind)
{
    if (!parser.isSet(QStringLiteral("depth"))) {
        return {};
    }
    const QString depth = parser.value(QStringLiteral("depth"));
    const QByteArray digits = depth.toUtf8();
    if (digits.isEmpty() || !std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; })) {
        complain(QStringLiteral("--depth takes a whole number, not \"%1\"").arg(depth));
        return std::unexpected(WrongUsage);
    }
    if (kind == FileKind::Obj) {
        complain(QStringLiteral("--depth needs a .fdo or .sdo file"));
        return std::unexpected(WrongUsage);
    }
    return digits.toStdString();
}

struct Loaded {
    /// With its depth.
    std::string text;
    SceneResult result;
    bool isInVain = false;
};

Loaded loadAt(const std::string &digits, const FileAccess &files, const std::filesystem::path &path,
              const std::string &text, const ImageDecoder &decoder)
{
    const DepthChange change(files, digits);
    Loaded loaded{fileKind(path) == FileKind::Fdo ? change.changed(text) : text, {}, false};
    loaded.result = SceneLoader(change, decoder).load(path, loaded.text);
    loaded.isInVain = change.isInVain();
    return loaded;
}

/// What was loaded at an endless depth has one.
bool isWithoutEnd(const Loaded &loaded)
{
    return loaded.result.scene && !loaded.isInVain && isConvergent(*loaded.result.scene);
}

}

QCommandLineOption depthOption()
{
    return {QStringLiteral("depth"), QStringLiteral("Depth in place of the file's."), QStringLiteral("N")};
}

std::expected<QString, int> parseArguments(QCommandLineParser &parser, const char *command,
                                           const QStringList &arguments)
{
    parser.addPositionalArgument(QStringLiteral("FILE"),
                                 QStringLiteral("A .fdo, .sdo or .obj file; - is stdin, as .fdo."));
    const auto files = parsed(parser, command, arguments);
    if (files && files->size() != 1) {
        complain(
            QStringLiteral("romanesco %1 takes one FILE, given %2").arg(QLatin1String(command)).arg(files->size()));
        return std::unexpected(WrongUsage);
    }
    return files.transform([](const QStringList &one) { return one.constFirst(); });
}

std::expected<QStringList, int> parseFiles(QCommandLineParser &parser, const char *command,
                                           const QStringList &arguments)
{
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("One file or more; - is stdin, as .fdo."),
                                 QStringLiteral("FILE..."));
    auto files = parsed(parser, command, arguments);
    if (files && files->isEmpty()) {
        complain(QStringLiteral("romanesco %1 takes a FILE or more, given none").arg(QLatin1String(command)));
        return std::unexpected(WrongUsage);
    }
    if (files && files->count(standardInput) > 1) {
        complain(QStringLiteral("stdin can be read once only"));
        return std::unexpected(WrongUsage);
    }
    return files;
}

std::filesystem::path pathOf(const QString &file)
{
    return file == standardInput ? "stdin.fdo" : QFile::encodeName(file).toStdString();
}

std::string shownName(const QString &file)
{
    return file == standardInput ? "<stdin>" : file.toStdString();
}

std::expected<std::string, std::string> readText(const QString &file)
{
    if (file != standardInput) {
        return DiskFiles().read(pathOf(file));
    }
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly)) {
        return std::unexpected(input.errorString().toStdString());
    }
    return input.readAll().toStdString();
}

std::expected<Input, int> readInput(const QString &file, const QCommandLineParser &parser, ImageDecoder decoder,
                                    DepthChoice choice)
{
    const std::filesystem::path path = pathOf(file);
    const std::string shown = shownName(file);
    const FileKind kind = fileKind(path);
    if (kind == FileKind::Other) {
        complain(QStringLiteral("%1: only .fdo, .sdo and .obj files can be read").arg(file));
        return std::unexpected(BadInput);
    }
    auto text = readText(file);
    if (!text) {
        complain(QStringLiteral("cannot read %1: %2").arg(file, QString::fromStdString(text.error())));
        return std::unexpected(BadInput);
    }
    const auto depth = depthDigits(parser, kind);
    if (!depth) {
        return std::unexpected(depth.error());
    }
    Input input{nullptr, {path}, text->size(), kind == FileKind::Sdo};
    const InputFiles files;
    const auto load = [&](const std::string &digits) { return loadAt(digits, files, path, *text, decoder); };
    const bool isEndless = choice == DepthChoice::Endless;
    const auto view = choice == DepthChoice::AsViewed && depth->empty() ? findView(*text) : std::nullopt;
    const bool isViewEndless = view && view->first.isEndless;
    Loaded loaded = load(isEndless || isViewEndless ? DepthChange::endless : *depth);
    if (isViewEndless && !isWithoutEnd(loaded)) {
        loaded = load({});
    }
    SceneResult &result = loaded.result;
    if (result.scene && loaded.isInVain) {
        complain(QStringLiteral("%1 needs a depth in the file, as in \"<$>. z 6\"")
                     .arg(QLatin1String(isEndless ? "--endless" : "--depth")));
        return std::unexpected(WrongUsage);
    }
    if (result.scene && isEndless && !isWithoutEnd(loaded)) {
        complain(QStringLiteral("%1: --endless needs transformations that shrink what they repeat").arg(file));
        return std::unexpected(BadInput);
    }
    text = std::move(loaded.text);
    const LineMap lines(*text);
    Places places(lines);
    for (const Diagnostic &diagnostic : result.diagnostics) {
        if (diagnostic.severity() != Severity::Hint) {
            std::println(stderr, "{}", toLines(diagnostic, shown, places));
        }
    }
    if (!result.scene) {
        return std::unexpected(BadInput);
    }
    input.scene = std::move(result.scene);
    for (const auto &[read, bytes] : files.read()) {
        input.files.push_back(read);
        input.sourceBytes += bytes;
    }
    return input;
}

}
