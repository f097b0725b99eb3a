// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QStringList>

namespace romanesco::cli {

/// Exit statuses, the same for every command.
enum ExitStatus { Done = 0, BadInput = 1, WrongUsage = 2, CannotDo = 3 };

/// One subcommand. run() gets the arguments after its name.
struct Command {
    const char *name;
    const char *synopsis;
    const char *summary;
    int (*run)(const QStringList &arguments);
};

/// The subcommand of that name, or null.
[[nodiscard]] const Command *findCommand(const QString &name);

/// The text of `romanesco --help`.
[[nodiscard]] QString helpText();

int runCheck(const QStringList &arguments);
int runClosest(const QStringList &arguments);
int runExport(const QStringList &arguments);
int runFormat(const QStringList &arguments);
int runInfo(const QStringList &arguments);
int runMeasure(const QStringList &arguments);
int runRender(const QStringList &arguments);
int runSimulate(const QStringList &arguments);

}
