// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <array>
#include <format>
#include <iterator>
#include <print>

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/imagedecoder.h"
#include "core/language/stability.h"
#include "core/scene/sceneloader.h"
#include "core/text/linemap.h"
#include "core/text/places.h"
#include "input.h"

namespace romanesco::cli {

namespace {

/// A file with all that there is to remark on.
struct Checked {
    std::string name;
    std::string text;
    Diagnostics diagnostics;
};

Checked check(SceneLoader &loader, const QString &file)
{
    Checked checked{shownName(file), {}, {}};
    const auto cannotRead = [&](const std::string &reason) {
        checked.diagnostics.push_back({DiagnosticCode::CannotRead, {0, 0}, {checked.name, reason}});
        return checked;
    };
    const std::filesystem::path path = pathOf(file);
    const FileKind kind = fileKind(path);
    if (kind == FileKind::Other) {
        return cannotRead("only .fdo, .sdo and .obj files can be read");
    }
    auto text = readText(file);
    if (!text) {
        return cannotRead(text.error());
    }
    checked.text = std::move(*text);
    checked.diagnostics = loader.load(path, checked.text).diagnostics;
    if (kind == FileKind::Fdo) {
        std::ranges::move(stabilityHints(checked.text), std::back_inserter(checked.diagnostics));
        sortByPlace(checked.diagnostics);
    }
    return checked;
}

QString words(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QJsonObject place(TextPosition position)
{
    return {{QStringLiteral("line"), static_cast<qint64>(position.line)},
            {QStringLiteral("column"), static_cast<qint64>(position.column)}};
}

QJsonObject place(Places &places, SourceRange range)
{
    QJsonObject object = place(places.at(range.begin));
    const TextPosition end = places.at(range.end);
    object[QStringLiteral("end_line")] = static_cast<qint64>(end.line);
    object[QStringLiteral("end_column")] = static_cast<qint64>(end.column);
    return object;
}

QJsonObject json(const Fix &fix, Places &places)
{
    QJsonArray edits;
    for (const TextEdit &edit : fix.edits) {
        QJsonObject object = place(places, edit.range);
        object[QStringLiteral("text")] = words(edit.text);
        edits.append(object);
    }
    return {{QStringLiteral("title"), words(fix.title)}, {QStringLiteral("edits"), edits}};
}

QJsonArray json(const std::vector<Note> &notes, const std::string &file)
{
    QJsonArray array;
    for (const Note &note : notes) {
        QJsonObject object = place(note.position);
        object[QStringLiteral("file")] = words(seenFrom(file, note.file));
        object[QStringLiteral("message")] = words(note.message());
        array.append(object);
    }
    return array;
}

void append(QJsonArray &array, const Checked &checked)
{
    const LineMap lines(checked.text);
    Places places(lines);
    for (const Diagnostic &diagnostic : checked.diagnostics) {
        QJsonObject object = place(places, diagnostic.range);
        object[QStringLiteral("file")] = words(checked.name);
        object[QStringLiteral("severity")] = words(name(diagnostic.severity()));
        object[QStringLiteral("code")] = words(name(diagnostic.code));
        object[QStringLiteral("message")] = words(diagnostic.message());
        if (diagnostic.fix) {
            object[QStringLiteral("fix")] = json(*diagnostic.fix, places);
        }
        if (!diagnostic.notes.empty()) {
            object[QStringLiteral("notes")] = json(diagnostic.notes, checked.name);
        }
        array.append(object);
    }
}

/// "2 errors, 1 hint in 3 files".
std::string summary(const std::array<std::size_t, 3> &counts, qsizetype files)
{
    std::string text;
    for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Hint}) {
        const std::size_t count = counts[static_cast<std::size_t>(severity)];
        if (count > 0) {
            text += std::format("{}{} {}{}", text.empty() ? "" : ", ", count, name(severity), count == 1 ? "" : "s");
        }
    }
    return std::format("{} in {} file{}", text.empty() ? "no problems" : text, files, files == 1 ? "" : "s");
}

}

int runCheck(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Tells all that is wrong with .fdo, .sdo and .obj files and the files they name, and what may surprise.\n"
        "Exit status: 0 no errors, 1 errors."));
    const QCommandLineOption jsonOption(QStringLiteral("json"),
                                        QStringLiteral("For machines: one array, with fixes, on stdout."));
    parser.addOption(jsonOption);
    const auto names = parseFiles(parser, "check", arguments);
    if (!names) {
        return names.error();
    }

    const DiskFiles disk;
    SceneLoader loader(disk, decodeImage);
    QJsonArray array;
    std::array<std::size_t, 3> counts{};
    for (const QString &name : *names) {
        const Checked checked = check(loader, name);
        for (const Diagnostic &diagnostic : checked.diagnostics) {
            ++counts[static_cast<std::size_t>(diagnostic.severity())];
        }
        if (parser.isSet(jsonOption)) {
            append(array, checked);
            continue;
        }
        const LineMap lines(checked.text);
        Places places(lines);
        for (const Diagnostic &diagnostic : checked.diagnostics) {
            std::println(stderr, "{}", toLines(diagnostic, checked.name, places));
        }
    }
    if (parser.isSet(jsonOption)) {
        std::print("{}", QJsonDocument(array).toJson().toStdString());
    } else {
        std::println("{}", summary(counts, names->size()));
    }
    return counts[static_cast<std::size_t>(Severity::Error)] > 0 ? BadInput : Done;
}

}
