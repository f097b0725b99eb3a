// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "makeaction.h"

#include <QAction>
#include <QWidget>

namespace romanesco {

QAction *makeAction(QWidget &owner, const QString &text, const QKeySequence &key)
{
    auto *action = new QAction(text, &owner);
    action->setShortcut(key);
    QString tip = text;
    tip.remove(u'&').remove(u'…');
    // On buttons, where an ellipsis would only be noise.
    action->setIconText(tip);
    if (!key.isEmpty()) {
        tip += QStringLiteral(" (%1)").arg(key.toString(QKeySequence::NativeText));
    }
    action->setToolTip(tip);
    return action;
}

QAction *makeViewAction(QWidget &viewport, const QString &text, const QKeySequence &key)
{
    QAction *action = makeAction(viewport, text, key);
    action->setShortcutContext(Qt::WidgetShortcut);
    viewport.addAction(action);
    return action;
}

}
