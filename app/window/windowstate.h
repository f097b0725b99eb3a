// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QSettings>

namespace romanesco {

/// What the window remembers from one time to the next: layout, open and recent files. That is state, not settings (XDG
/// Base Directory 0.8).
class WindowState : public QSettings
{
public:
    WindowState();
};

}
