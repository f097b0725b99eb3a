// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measurepane.h"

#include "measureview.h"

namespace romanesco {

MeasurePane::MeasurePane(QWidget *parent)
    : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setAccessibleName(tr("Measure"));
}

void MeasurePane::showEvent(QShowEvent *event)
{
    if (!m_view) {
        m_view = new MeasureView;
        setWidget(m_view);
        turn();
        Q_EMIT opened(*m_view);
    }
    QScrollArea::showEvent(event);
}

void MeasurePane::resizeEvent(QResizeEvent *event)
{
    turn();
    QScrollArea::resizeEvent(event);
}

void MeasurePane::turn()
{
    if (m_view) {
        m_view->setUpright(width() < height());
    }
}

}
