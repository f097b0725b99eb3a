// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QString>

class QWidget;

namespace romanesco {

/// What this program is, and what it runs on; graphics: as Viewport::ready() tells it, empty without OpenGL. Waits for
/// nobody.
void showAbout(QWidget &window, const QString &graphics);

}
