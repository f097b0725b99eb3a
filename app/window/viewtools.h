// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QObject>

#include "balldropper.h"
#include "gizmotool.h"
#include "measuringtool.h"
#include "windowactions.h"

namespace romanesco {

class ViewportPane;

/// The tools of a picture, of which one at a time has the left button: each is on while its action is checked, and Esc ends
/// it.
class ViewTools : public QObject
{
    Q_OBJECT
public:
    /// pane must outlive it.
    ViewTools(const WindowActions &actions, ViewportPane &pane, QObject *parent = nullptr);

    [[nodiscard]] MeasuringTool &measuring() { return m_measuring; }
    [[nodiscard]] BallDropper &dropper() { return m_dropper; }

    /// From now on the picture is of that text, which is edited only while it is looked at too.
    void follow(TextTab &seen, bool isLookedAt) { m_gizmo.follow(seen, isLookedAt); }
    /// What the strip over the picture has to say of the tool in use; a sentence, or empty.
    [[nodiscard]] QString remark() const;

Q_SIGNALS:
    /// What a tool has to say, in one line.
    void told(const QString &words);
    void remarkChanged();

private:
    void choose();
    void copyMeasurement();

    WindowActions m_actions;
    ViewportPane &m_pane;
    MeasuringTool m_measuring;
    GizmoTool m_gizmo;
    BallDropper m_dropper;
};

}
