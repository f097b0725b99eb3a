// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QWidget>

class QSlider;

namespace romanesco {

class WholeNumberBox;

/// A number of iterations: a slider for the depths that make sense to look at, and a box for every other.
class DepthControl : public QWidget
{
    Q_OBJECT
public:
    /// Of what its name says.
    explicit DepthControl(const QString &name, QWidget *parent = nullptr);

    /// Shows what the text says, without a signal; nothing disables the control.
    void setDepth(std::optional<quint64> depth);

Q_SIGNALS:
    void depthEdited(quint64 depth);
    /// Round the depthEdited() of one drag of the slider.
    void dragBegan();
    void dragEnded();

private:
    void updateSlider(quint64 depth);

    QSlider *m_slider;
    WholeNumberBox *m_box;
};

}
