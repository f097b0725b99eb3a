// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <print>

#include <QCommandLineParser>

#include "core/language/formatter.h"
#include "core/scene/sceneloader.h"
#include "core/text/places.h"
#include "input.h"
#include "output.h"

namespace romanesco::cli {

namespace {

/// Tells the lines that cannot be read, and whether there are any.
bool tellErrors(const std::string &name, const LineMap &lines, const Diagnostics &diagnostics)
{
    Places places(lines);
    bool isAny = false;
    for (const Diagnostic &diagnostic : diagnostics) {
        if (diagnostic.isError()) {
            std::println(stderr, "{}", toLines(diagnostic, name, places));
            isAny = true;
        }
    }
    return isAny;
}

/// Gives an exit status.
template<typename Syntax>
int format(const QString &file, std::string text, bool isCheck)
{
    const Syntax before(std::move(text));
    const TextEdits edits = formatting(before);
    const std::string name = shownName(file);
    const bool isWritten = !isCheck && (!edits.empty() || file == QLatin1String("-"));
    if (!isWritten) {
        const bool wouldChange = isCheck && !edits.empty();
        if (wouldChange) {
            std::println("{}: would change", name);
        }
        return tellErrors(name, before.map(), before.diagnostics()) || wouldChange ? BadInput : Done;
    }
    // places are told as they are from now on
    const Syntax after(applied(before.text(), edits));
    if (!writeWhole(file, QByteArray::fromStdString(after.text()))) {
        return CannotDo;
    }
    return tellErrors(name, after.map(), after.diagnostics()) ? BadInput : Done;
}

int format(const QString &file, bool isCheck)
{
    auto text = readText(file);
    if (!text) {
        complain(QStringLiteral("cannot read %1: %2").arg(file, QString::fromStdString(text.error())));
        return BadInput;
    }
    return fileKind(pathOf(file)) == FileKind::Sdo ? format<SdoSyntax>(file, std::move(*text), isCheck)
                                                   : format<FdoSyntax>(file, std::move(*text), isCheck);
}

bool canFormat(const QString &file)
{
    const FileKind kind = fileKind(pathOf(file));
    if (kind == FileKind::Fdo || kind == FileKind::Sdo) {
        return true;
    }
    complain(QStringLiteral("format takes .fdo and .sdo files, not %1").arg(file));
    return false;
}

}

int runFormat(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Tidies the layout of .fdo and .sdo files in place. Meaning and comments stay, and so do columns that are\n"
        "lined up. A line that cannot be read is told and keeps its layout; all others are tidied.\n"
        "Exit status: 0 done, 1 lines cannot be read, or with --check a file would change."));
    const QCommandLineOption checkOption(QStringLiteral("check"),
                                         QStringLiteral("Write nothing, only tell which files would change."));
    parser.addOption(checkOption);
    const auto files = parseFiles(parser, "format", arguments);
    if (!files) {
        return files.error();
    }
    if (!std::ranges::all_of(*files, canFormat)) {
        return WrongUsage;
    }
    int status = Done;
    for (const QString &file : *files) {
        status = std::max(status, format(file, parser.isSet(checkOption)));
    }
    return status;
}

}
