// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "energygraph.h"

#include <algorithm>

#include <QPainter>

namespace romanesco {

namespace {

constexpr qsizetype mostValues = 300;

}

EnergyGraph::EnergyGraph(QWidget *parent)
    : QWidget(parent)
{
    setMinimumSize(80, 24);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void EnergyGraph::add(double value)
{
    m_values << value;
    if (m_values.size() > mostValues) {
        m_values.removeFirst();
    }
    update();
}

void EnergyGraph::clear()
{
    m_values.clear();
    update();
}

void EnergyGraph::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (m_values.size() < 2) {
        return;
    }
    const auto [least, greatest] = std::ranges::minmax(m_values);
    const double range = greatest - least;
    const double high = height() - 4.0;
    QPolygonF line;
    for (qsizetype i = 0; i < m_values.size(); ++i) {
        const double x = width() - double(m_values.size() - 1 - i) * width() / double(mostValues - 1);
        const double share = range > 0.0 ? (m_values[i] - least) / range : 0.5;
        line << QPointF(x, 2.0 + high * (1.0 - share));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().highlight(), 1.5));
    painter.drawPolyline(line);
}

}
