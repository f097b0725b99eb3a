// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>

#include <QColor>
#include <QPainter>
#include <QPen>

namespace romanesco {

// What is drawn over a picture: light, before a dark rim, so that it is readable on any.

[[nodiscard]] inline QColor markRim()
{
    return QColor::fromRgba(0xc0101216);
}

/// 0, 1, 2 for x, y, z.
[[nodiscard]] inline QColor axisColour(int axis)
{
    constexpr std::array<QRgb, 3> colours{0xffffa79e, 0xffb4e89a, 0xff9cc4ff};
    return QColor(colours[static_cast<std::size_t>(axis)]);
}

inline void drawMarkLine(QPainter &painter, const QPolygonF &line, const QColor &colour, double width)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(markRim(), width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

}
