// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "viewtools.h"

#include <QActionGroup>
#include <QClipboard>
#include <QGuiApplication>

#include "viewport.h"
#include "viewportpane.h"

namespace romanesco {

ViewTools::ViewTools(const WindowActions &actions, ViewportPane &pane, QObject *parent)
    : QObject(parent)
    , m_actions(actions)
    , m_pane(pane)
    , m_measuring(pane.viewport())
    , m_gizmo(pane.viewport())
    , m_dropper(pane.viewport())
{
    connect(m_actions.tools, &QActionGroup::triggered, this, &ViewTools::choose);
    connect(&m_pane.viewport(), &Viewport::toolDismissed, this, [this] {
        if (QAction *on = m_actions.tools->checkedAction()) {
            on->trigger();
        }
    });
    connect(&m_gizmo, &GizmoTool::remarkChanged, this, &ViewTools::remarkChanged);
    connect(&m_measuring, &MeasuringTool::told, this, &ViewTools::told);
    connect(m_actions.copyMeasurement, &QAction::triggered, this, &ViewTools::copyMeasurement);
}

void ViewTools::choose()
{
    const QAction *on = m_actions.tools->checkedAction();
    Viewport &viewport = m_pane.viewport();
    m_measuring.clear();
    if (on == m_actions.measure) {
        viewport.setTool(&m_measuring);
        Q_EMIT told(tr("Click a point of the surface, and another for the distance"));
    } else if (on == m_actions.dropBalls) {
        viewport.setTool(&m_dropper);
        Q_EMIT told(tr("Click where a ball is to fall"));
    } else {
        m_gizmo.setKind(on == m_actions.move         ? GizmoKind::Move
                            : on == m_actions.rotate ? GizmoKind::Rotate
                                                     : GizmoKind::Scale);
        viewport.setTool(on ? &m_gizmo : nullptr);
        Q_EMIT told(QString());
    }
    Q_EMIT remarkChanged();
}

QString ViewTools::remark() const
{
    return m_pane.viewport().tool() == &m_gizmo ? m_gizmo.remark() : QString();
}

void ViewTools::copyMeasurement()
{
    const QString words = m_measuring.words();
    if (words.isEmpty()) {
        Q_EMIT told(tr("Nothing is measured yet."));
        return;
    }
    QGuiApplication::clipboard()->setText(words);
    Q_EMIT told(tr("The measurement is copied"));
}

}
