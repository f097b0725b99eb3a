// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QList>
#include <QWidget>

namespace romanesco {

/// What a number was over the last while, as a line: the newest to the right, between the least and the greatest that are seen.
class EnergyGraph : public QWidget
{
    Q_OBJECT
public:
    explicit EnergyGraph(QWidget *parent = nullptr);

    void add(double value);
    void clear();
    [[nodiscard]] const QList<double> &values() const { return m_values; }

    [[nodiscard]] QSize sizeHint() const override { return {160, 40}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QList<double> m_values;
};

}
