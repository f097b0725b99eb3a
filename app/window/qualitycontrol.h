// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QWidget>

class QLabel;
class QSlider;

namespace romanesco {

/// A slider for how exact pictures are at rest: below how many pixels copies are drawn as one, from 16 down to a quarter,
/// with how far off that can put anything beside it.
class QualityControl : public QWidget
{
    Q_OBJECT
public:
    static constexpr double coarsest = 16.0;
    static constexpr double finest = 0.25;

    explicit QualityControl(QWidget *parent = nullptr);

    [[nodiscard]] double tolerance() const;
    /// The nearest that the slider has.
    void setTolerance(double pixels);
    /// How far off a tolerance of one pixel can put anything (see Viewport::shiftOfTolerance()).
    void setShift(double pixels);

Q_SIGNALS:
    void toleranceChanged(double pixels);

private:
    void showWords();

    QSlider *m_slider;
    QLabel *m_words;
    double m_shift = 1.0;
};

}
