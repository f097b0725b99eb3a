// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QKeySequence>
#include <QString>

class QAction;
class QWidget;

namespace romanesco {

/// An action of a window, whose tool tip tells its key. text is as in a menu.
[[nodiscard]] QAction *makeAction(QWidget &owner, const QString &text, const QKeySequence &key = {});

/// One whose key means a letter or a figure everywhere but in the viewport.
[[nodiscard]] QAction *makeViewAction(QWidget &viewport, const QString &text, const QKeySequence &key);

}
