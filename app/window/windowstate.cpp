// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "windowstate.h"

#include <QDir>

namespace romanesco {

namespace {

QString stateFile()
{
    QString folder = qEnvironmentVariable("XDG_STATE_HOME");
    if (folder.isEmpty()) {
        folder = QDir::home().filePath(QStringLiteral(".local/state"));
    }
    return folder + QStringLiteral("/romanesco/window.ini");
}

}

WindowState::WindowState()
    : QSettings(stateFile(), QSettings::IniFormat)
{
}

}
