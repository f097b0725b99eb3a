// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "tooloverlay.h"

#include <QEvent>
#include <QPainter>

#include "pointertool.h"
#include "viewport.h"

namespace romanesco {

ToolOverlay::ToolOverlay(Viewport &viewport)
    : QWidget(&viewport)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
    connect(&viewport, &Viewport::viewMoved, this, qOverload<>(&QWidget::update));
    viewport.installEventFilter(this);
}

void ToolOverlay::show(const PointerTool *tool)
{
    m_tool = tool;
    setGeometry(parentWidget()->rect());
    setVisible(tool != nullptr);
    update();
}

bool ToolOverlay::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize) {
        setGeometry(parentWidget()->rect());
    }
    return QWidget::eventFilter(watched, event);
}

void ToolOverlay::paintEvent(QPaintEvent *)
{
    if (m_tool) {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_tool->paint(painter);
    }
}

}
