// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <qnamespace.h>

class QPainter;
class QPointF;

namespace romanesco {

/// What takes the left button from the view of a Viewport for a while, and draws over the picture. Places are in the
/// viewport.
class PointerTool
{
public:
    PointerTool() = default;
    PointerTool(const PointerTool &) = delete;
    PointerTool &operator=(const PointerTool &) = delete;
    virtual ~PointerTool() = default;

    /// Whether the drag that a press begins is the tool's; else the view has it.
    virtual bool press(const QPointF &) { return false; }
    virtual void drag(const QPointF &, Qt::KeyboardModifiers) { }
    virtual void release() { }
    /// A press and release in one place: whether it was meant for the tool, rather than to select a copy.
    virtual bool click(const QPointF &) { return false; }
    /// The mouse moves, without a button.
    virtual void hover(const QPointF &) { }
    virtual void paint(QPainter &painter) const = 0;
};

}
