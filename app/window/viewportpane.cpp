// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "viewportpane.h"

#include <algorithm>

#include <QEvent>
#include <QLabel>
#include <QStackedLayout>
#include <QToolBar>
#include <QVBoxLayout>

#include "axestripod.h"
#include "messagestrip.h"
#include "qualitycontrol.h"
#include "viewport.h"

namespace romanesco {

ViewportPane::ViewportPane(QWidget *parent)
    : QWidget(parent)
    , m_viewport(new Viewport)
    , m_axes(new AxesTripod(*m_viewport))
    , m_reason(new QLabel)
    , m_layout(new QStackedLayout)
    , m_strip(new MessageStrip(MessageStrip::Closing::ByProgram, this))
    , m_bar(new QToolBar(tr("Picture tools")))
    , m_quality(new QualityControl)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(m_layout, 1);
    column->addWidget(m_bar);
    m_bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    auto *space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_firstRight = m_bar->addWidget(space);
    m_bar->addWidget(m_quality);
    m_reason->setAlignment(Qt::AlignCenter);
    m_reason->setWordWrap(true);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setMargin(32);
    m_reason->setMinimumSize(m_viewport->minimumSize());
    m_layout->addWidget(m_viewport);
    m_layout->addWidget(m_reason);
    connect(m_viewport, &Viewport::unavailable, this, &ViewportPane::showReason);
    connect(m_viewport, &Viewport::ready, this, &ViewportPane::showPicture);
}

void ViewportPane::addTools(const QList<QAction *> &tools)
{
    m_bar->insertActions(m_firstRight, tools);
}

bool ViewportPane::event(QEvent *event)
{
    // The strip's text, and with it its height, has changed.
    if (event->type() == QEvent::LayoutRequest) {
        placeStrip();
    }
    return QWidget::event(event);
}

void ViewportPane::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placeStrip();
}

void ViewportPane::placeStrip()
{
    const int needed = m_strip->hasHeightForWidth() ? m_strip->heightForWidth(width()) : m_strip->sizeHint().height();
    m_strip->setGeometry(0, 0, width(), std::min(needed, height()));
    m_strip->raise();
}

void ViewportPane::showReason(const QString &reason)
{
    m_reason->setText(
        tr("No picture here.\n\n%1\n\nThe text can be edited, checked and saved all the same.").arg(reason));
    m_layout->setCurrentWidget(m_reason);
    placeStrip();
}

void ViewportPane::showPicture()
{
    m_layout->setCurrentWidget(m_viewport);
    placeStrip();
}

}
