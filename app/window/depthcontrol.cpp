// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "depthcontrol.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include "wholenumberbox.h"

namespace romanesco {

namespace {

/// The slider reaches twice the depth, so that there is always some way to go, within what a hand can aim at.
constexpr quint64 leastReach = 12;
constexpr quint64 greatestReach = 120;
constexpr int sliderWidth = 160;

}

DepthControl::DepthControl(const QString &name, QWidget *parent)
    : QWidget(parent)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_box(new WholeNumberBox)
{
    auto *label = new QLabel(name);
    label->setBuddy(m_box);
    const QString tip = tr("%1: changes the number of iterations in the text").arg(name);
    m_slider->setAccessibleName(name);
    m_slider->setToolTip(tip);
    m_slider->setFixedWidth(sliderWidth);
    m_slider->setPageStep(1);
    m_box->setAccessibleName(tr("%1, as a number").arg(name));
    m_box->setToolTip(tip);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(8);
    layout->addWidget(label);
    layout->addWidget(m_slider);
    layout->addWidget(m_box);

    connect(m_slider, &QSlider::sliderPressed, this, &DepthControl::dragBegan);
    connect(m_slider, &QSlider::sliderReleased, this, &DepthControl::dragEnded);
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        m_box->setValue(static_cast<quint64>(value));
        Q_EMIT depthEdited(static_cast<quint64>(value));
    });
    connect(m_box, &WholeNumberBox::valueEdited, this, [this](quint64 value) {
        updateSlider(value);
        Q_EMIT depthEdited(value);
    });
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    setDepth(std::nullopt);
}

void DepthControl::setDepth(std::optional<quint64> depth)
{
    setEnabled(depth.has_value());
    m_box->setValue(depth.value_or(0));
    updateSlider(depth.value_or(0));
}

void DepthControl::updateSlider(quint64 depth)
{
    // Under the hand the slider stays as it is.
    if (m_slider->isSliderDown()) {
        return;
    }
    const QSignalBlocker blocker(m_slider);
    const quint64 reach = std::clamp(2 * std::min(depth, greatestReach), leastReach, greatestReach);
    m_slider->setRange(0, static_cast<int>(reach));
    m_slider->setValue(static_cast<int>(std::min(depth, reach)));
}

}
