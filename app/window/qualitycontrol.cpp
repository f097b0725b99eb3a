// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "qualitycontrol.h"

#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>

namespace romanesco {

namespace {

/// Of a step a quarter of an octave; finer is farther to the right.
constexpr double stepsOfOctave = 4.0;
constexpr int sliderWidth = 120;

int valueOf(double tolerance)
{
    return static_cast<int>(std::lround(-stepsOfOctave * std::log2(tolerance)));
}

/// Never less than it is.
QString roundedUp(double pixels)
{
    const double digit = std::pow(10.0, std::floor(std::log10(pixels)) - 1.0);
    return QLocale().toString(std::ceil(pixels / digit - 1e-9) * digit, 'g', 2);
}

}

QualityControl::QualityControl(QWidget *parent)
    : QWidget(parent)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_words(new QLabel)
{
    auto *label = new QLabel(tr("&Quality"));
    label->setBuddy(m_slider);
    m_slider->setRange(valueOf(coarsest), valueOf(finest));
    m_slider->setPageStep(static_cast<int>(stepsOfOctave));
    m_slider->setFixedWidth(sliderWidth);
    m_slider->setAccessibleName(tr("Quality"));
    m_words->setAccessibleName(tr("Pixel tolerance"));
    m_words->setTextFormat(Qt::PlainText);

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(m_slider);
    row->addWidget(m_words);
    connect(m_slider, &QSlider::valueChanged, this, [this] {
        showWords();
        Q_EMIT toleranceChanged(tolerance());
    });
    showWords();
}

double QualityControl::tolerance() const
{
    return std::exp2(-m_slider->value() / stepsOfOctave);
}

void QualityControl::setTolerance(double pixels)
{
    m_slider->setValue(pixels > 0.0 ? valueOf(pixels) : m_slider->maximum());
}

void QualityControl::setShift(double pixels)
{
    if (pixels != m_shift) {
        m_shift = pixels;
        showWords();
    }
}

void QualityControl::showWords()
{
    const QString pixels = QLocale().toString(tolerance(), 'g', 2);
    const QString shift = roundedUp(m_shift * tolerance());
    m_words->setText(tr("%1 px · off by %2 px at most").arg(pixels, shift));
    const QString tip =
        tr("Pixel tolerance: what is smaller than %1 pixels is drawn as one copy, so that nothing is more "
           "than %2 pixels from where it belongs. While the camera moves pictures may be coarser.")
            .arg(pixels, shift);
    m_slider->setToolTip(tip);
    m_words->setToolTip(tip);
}

}
