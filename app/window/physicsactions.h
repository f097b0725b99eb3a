// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QCoreApplication>

class QAction;
class QMenu;
class QWidget;

namespace romanesco {

/// What can be done to balls, with words and keys; what they do is PhysicsController's.
struct PhysicsActions {
    Q_DECLARE_TR_FUNCTIONS(PhysicsActions)
public:
    /// viewport is the widget whose keys (Space, full stop, Backspace) work only while it has the focus.
    PhysicsActions(QWidget &window, QWidget &viewport);

    void fill(QMenu &menu) const;

    /// Checked while balls move.
    QAction *play;
    QAction *step;
    QAction *reset;
    QAction *rain;
    /// Checked while the camera goes along with a ball.
    QAction *follow;
    QAction *removeBall;
    QAction *keepBalls;
    QAction *walk;
    QAction *walkFalling;
    QAction *record;
    QAction *replay;
};

}
