// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "physicsactions.h"

#include <QAction>
#include <QMenu>

#include "makeaction.h"

namespace romanesco {

PhysicsActions::PhysicsActions(QWidget &window, QWidget &viewport)
    : play(makeViewAction(viewport, tr("&Play"), Qt::Key_Space))
    , step(makeViewAction(viewport, tr("&Step"), Qt::Key_Period))
    , reset(makeViewAction(viewport, tr("&Reset"), Qt::Key_Backspace))
    , rain(makeAction(window, tr("R&ain")))
    , follow(makeAction(window, tr("&Follow Ball")))
    , removeBall(makeAction(window, tr("Re&move Ball")))
    , keepBalls(makeAction(window, tr("&Keep Balls in Text")))
    , walk(makeViewAction(viewport, tr("&Walk"), Qt::Key_V))
    , walkFalling(makeAction(window, tr("&Gravity While Walking")))
    , record(makeAction(window, tr("Save Re&cording…")))
    , replay(makeAction(window, tr("Replay Recor&ding…")))
{
    play->setCheckable(true);
    play->setStatusTip(tr("Lets the balls fall, or holds them where they are"));
    step->setStatusTip(tr("One step of the simulation"));
    reset->setStatusTip(tr("All balls as the text has them"));
    rain->setStatusTip(tr("Drops many balls over all of the scene"));
    follow->setCheckable(true);
    follow->setStatusTip(tr("The camera goes along with the ball that is selected in the list"));
    removeBall->setStatusTip(tr("Takes the balls away that are selected in the list"));
    keepBalls->setStatusTip(tr("Writes the balls into the scene where they are now, a line each"));
    walk->setCheckable(true);
    walk->setStatusTip(tr("The camera goes by W, A, S, D and the wheel, looks about by drags, and enters nothing"));
    walkFalling->setCheckable(true);
    walkFalling->setChecked(true);
    walkFalling->setStatusTip(tr("Who walks falls until something carries him"));
    record->setStatusTip(tr("Saves all that is needed to let the same happen again"));
    replay->setStatusTip(tr("Lets what was recorded happen again, and tells whether it came to the same"));
}

void PhysicsActions::fill(QMenu &menu) const
{
    menu.addActions({play, step, reset});
    menu.addSeparator();
    menu.addActions({rain, follow, removeBall, keepBalls});
    menu.addSeparator();
    menu.addActions({walk, walkFalling});
    menu.addSeparator();
    menu.addActions({record, replay});
}

}
