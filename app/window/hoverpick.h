// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>

#include "render/appearance.h"

namespace romanesco {

class Viewport;

/// Finds the copy that the mouse rests on, without a click: not while a button or a key is held, nor while a tool has the
/// mouse, nor before the surface is known. Costs some microseconds for each rest.
class HoverPick : public QObject
{
    Q_OBJECT
public:
    /// viewport must outlive it.
    explicit HoverPick(Viewport &viewport, QObject *parent = nullptr);

Q_SIGNALS:
    void rested(const romanesco::Selection &copy);
    /// The mouse rests there no more.
    void left();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void look();
    void leave();

    Viewport &m_viewport;
    QPointF m_place;
    QTimer m_rest;
    bool m_isOver = false;
    bool m_isResting = false;
};

}
