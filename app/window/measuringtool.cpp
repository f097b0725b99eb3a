// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measuringtool.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <glm/geometric.hpp>

#include "measurement.h"
#include "viewmarks.h"
#include "viewport.h"

namespace romanesco {

namespace {

constexpr QRgb light = 0xffffffff;
constexpr QRgb accent = 0xffffc46b;
constexpr double radius = 4.0;
constexpr double normalLength = 32.0;
/// A mark that may be farther off is not drawn.
constexpr double mostPixelsOff = 1.0;

}

MeasuringTool::MeasuringTool(Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    connect(&m_viewport, &Viewport::sceneChanged, this, &MeasuringTool::clear);
}

void MeasuringTool::clear()
{
    m_points.clear();
    m_distance.clear();
    m_viewport.clearMarks();
    m_viewport.updateTool();
}

bool MeasuringTool::click(const QPointF &place)
{
    if (!m_viewport.view().hasRayWalk()) {
        Q_EMIT told(tr("The surface is still being looked for. Click again in a moment."));
        return true;
    }
    const auto picked = m_viewport.surfaceAt(place);
    if (!picked) {
        Q_EMIT told(tr("There is no surface to measure."));
        return true;
    }
    if (m_points.size() == 2) {
        clear();
    }
    m_points.push_back(describe(*picked));
    m_viewport.mark(picked->point, picked->error);
    m_viewport.updateTool();
    m_distance = distanceWords();
    Q_EMIT told(words().replace(u'\n', QStringLiteral(" · ")));
    return true;
}

MeasuringTool::Point MeasuringTool::describe(const SceneView::Picked &picked) const
{
    const Surroundings &here = *m_viewport.view().surroundings();
    return {worldPlace(here, picked.point, picked.error), directionWords(picked.normal),
            m_naming ? m_naming({picked.item, picked.steps}) : QString(), picked.normal};
}

/// Empty for less than two points.
QString MeasuringTool::distanceWords() const
{
    const std::vector<SceneView::Mark> &marks = m_viewport.view().marks();
    if (marks.size() < 2) {
        return {};
    }
    const double error = marks[0].error + marks[1].error;
    return trueDigits(glm::distance(marks[0].point, marks[1].point), error,
                      m_viewport.view().surroundings()->unitExponent);
}

QString MeasuringTool::words() const
{
    QStringList lines;
    if (!m_distance.isEmpty()) {
        lines << tr("Distance %1").arg(m_distance);
    }
    for (const Point &point : m_points) {
        QString line = tr("Point %1, normal %2").arg(point.place, point.normalWords);
        lines << (point.address.isEmpty() ? line : tr("%1, of %2").arg(line, point.address));
    }
    return lines.join(u'\n');
}

std::optional<QPointF> MeasuringTool::placeOf(std::size_t number) const
{
    const SceneView::Mark &mark = m_viewport.view().marks()[number];
    const double pixel = heightAt(m_viewport.camera(), mark.point) / std::max(1, m_viewport.height());
    return mark.error < mostPixelsOff * pixel ? m_viewport.placeOf(mark.point) : std::nullopt;
}

void MeasuringTool::paint(QPainter &painter) const
{
    if (m_points.size() == 2) {
        const auto from = placeOf(0);
        const auto to = placeOf(1);
        if (from && to) {
            drawDistance(painter, *from, *to);
        }
    }
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        drawPoint(painter, i);
    }
}

void MeasuringTool::drawPoint(QPainter &painter, std::size_t number) const
{
    const auto place = placeOf(number);
    if (!place) {
        return;
    }
    const SceneView::Mark &mark = m_viewport.view().marks()[number];
    const double length = normalLength / std::max(1, m_viewport.height()) * heightAt(m_viewport.camera(), mark.point);
    if (const auto tip = m_viewport.placeOf(mark.point + length * m_points[number].normal)) {
        drawMarkLine(painter, {*place, *tip}, QColor::fromRgba(accent), 1.5);
    }
    painter.setPen(QPen(markRim(), 2.0));
    painter.setBrush(QColor::fromRgba(light));
    painter.drawEllipse(*place, radius, radius);
}

void MeasuringTool::drawDistance(QPainter &painter, const QPointF &from, const QPointF &to) const
{
    drawMarkLine(painter, {from, to}, QColor::fromRgba(light), 1.5);
    const QFontMetricsF metrics(painter.font());
    QRectF box = metrics.boundingRect(m_distance).marginsAdded({6, 3, 6, 3});
    box.moveCenter(0.5 * (from + to) + QPointF(0.0, -box.height()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(markRim());
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(QColor::fromRgba(light));
    painter.drawText(box, Qt::AlignCenter, m_distance);
}

}
