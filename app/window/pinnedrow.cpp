// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "pinnedrow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

namespace romanesco {

namespace {

/// To each side: what a hand can aim at.
constexpr int reach = 100;
constexpr int sliderWidth = 160;

}

PinnedRow::PinnedRow(PinnedNumbers &numbers, int id, QWidget *parent)
    : QWidget(parent)
    , m_id(id)
    , m_name(new QLabel)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_number(new QLabel)
{
    m_slider->setRange(-reach, reach);
    m_slider->setPageStep(10);
    m_slider->setFixedWidth(sliderWidth);
    m_name->setTextFormat(Qt::PlainText);
    m_number->setTextFormat(Qt::PlainText);
    auto *unpin = new QToolButton;
    unpin->setText(QStringLiteral("✕"));
    unpin->setAutoRaise(true);
    unpin->setToolTip(tr("Unpin this number"));
    unpin->setAccessibleName(tr("Unpin this number"));

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(m_name);
    row->addWidget(m_slider);
    row->addWidget(m_number);
    row->addWidget(unpin);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);

    connect(m_slider, &QSlider::sliderPressed, &numbers, [&numbers, id] { numbers.beginGesture(id); });
    connect(m_slider, &QSlider::valueChanged, &numbers, [&numbers, id](int steps) { numbers.step(id, steps); });
    connect(m_slider, &QSlider::sliderReleased, &numbers, [this, &numbers, id] {
        centre();
        numbers.endGesture(id);
    });
    connect(unpin, &QToolButton::clicked, &numbers, [&numbers, id] { numbers.unpin(id); });
}

void PinnedRow::setPin(const PinnedNumbers::Pin &pin, bool canEdit)
{
    const QString name = tr("%1 (line %2)").arg(pin.name).arg(pin.line);
    m_name->setText(name);
    m_number->setText(pin.number);
    m_slider->setAccessibleName(name);
    m_slider->setToolTip(tr("%1: changes this number in the text").arg(name));
    m_slider->setEnabled(canEdit);
    centre();
}

/// Where it is, there is as far to go to both sides. Under the hand it stays as it is.
void PinnedRow::centre()
{
    if (!m_slider->isSliderDown()) {
        const QSignalBlocker blocker(m_slider);
        m_slider->setValue(0);
    }
}

}
