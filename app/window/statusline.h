// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QStatusBar>

#include "core/scene/summary.h"
#include "render/renderer.h"

class QLabel;

namespace romanesco {

/// The line at the bottom: where the cursor is, what the text describes, what was drawn of it and at what cost.
class StatusLine : public QStatusBar
{
    Q_OBJECT
public:
    explicit StatusLine(QWidget *parent = nullptr);

    /// Both from 1.
    void setCursorPlace(int line, int column);
    void setSummary(const std::optional<Summary> &summary);
    void setDepth(std::optional<quint64> depth);
    /// How the surface is searched for balls, and whether they may go through; empty while none are there.
    void setCollider(const QString &words);
    void setDrawn(const DrawStatistics &statistics, double pixelTolerance);
    /// Nothing is drawn.
    void clearDrawn();

private:
    QLabel *m_place;
    QLabel *m_summary;
    QLabel *m_depth;
    QLabel *m_collider;
    QLabel *m_drawn;
};

}
