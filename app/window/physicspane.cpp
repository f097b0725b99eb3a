// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "physicspane.h"

#include <QHBoxLayout>

#include "physicschoices.h"
#include "physicsfigures.h"

namespace romanesco {

PhysicsPane::PhysicsPane(QWidget *parent)
    : QScrollArea(parent)
    , m_choices(new PhysicsChoices)
    , m_figures(new PhysicsFigures)
{
    auto *inside = new QWidget;
    auto *row = new QHBoxLayout(inside);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(16);
    row->addWidget(m_choices, 0, Qt::AlignTop);
    row->addWidget(m_figures, 1);
    setWidget(inside);
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setAccessibleName(tr("Physics"));
}

}
