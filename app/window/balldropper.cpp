// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "balldropper.h"

#include <cmath>

#include <QPainter>

#include <glm/geometric.hpp>

#include "viewmarks.h"
#include "viewport.h"

namespace romanesco {

namespace {

constexpr QRgb accent = 0xffffc46b;
/// Above the surface, in radii: so that it is seen to fall.
constexpr double height = 4.0;
/// Off the surface that was clicked, in radii.
constexpr double offSurface = 1.02;

}

BallDropper::BallDropper(Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
{
}

std::optional<Ball> BallDropper::ballAt(const QPointF &place) const
{
    const auto picked = m_viewport.surfaceAt(place);
    if (!picked || !m_drop) {
        return std::nullopt;
    }
    const auto [like, gravity] = m_drop();
    const double pull = glm::length(gravity);
    const glm::dvec3 up = pull > 0.0 ? -gravity / pull : glm::dvec3(0.0);
    Ball ball = like;
    ball.position = m_viewport.view().surroundings()->worldFromHere(picked->point)
        + ball.radius * (offSurface * picked->normal + height * up);
    return ball;
}

bool BallDropper::click(const QPointF &place)
{
    if (!m_viewport.view().hasRayWalk()) {
        Q_EMIT told(tr("The surface is still being looked for. Click again in a moment."));
    } else if (const auto ball = ballAt(place)) {
        Q_EMIT dropped(*ball);
    } else {
        Q_EMIT told(tr("There is no surface to drop a ball on."));
    }
    return true;
}

void BallDropper::hover(const QPointF &place)
{
    m_pointer = place;
    m_viewport.updateTool();
}

void BallDropper::paint(QPainter &painter) const
{
    const auto ball = m_viewport.underMouse() ? ballAt(m_pointer) : std::nullopt;
    if (!ball) {
        return;
    }
    const Surroundings &here = *m_viewport.view().surroundings();
    const glm::dvec3 centre = here.hereFromWorld(ball->position);
    const auto place = m_viewport.placeOf(centre);
    const double seen = heightAt(m_viewport.camera(), centre);
    if (!place || !(seen > 0.0)) {
        return;
    }
    const double radius = ball->radius * std::exp2(-here.unitExponent) / seen * m_viewport.height();
    painter.setBrush(Qt::NoBrush);
    for (const auto &[colour, width] : {std::pair(markRim(), 4.0), std::pair(QColor::fromRgba(accent), 1.5)}) {
        painter.setPen(QPen(colour, width));
        painter.drawEllipse(*place, radius, radius);
        painter.drawLine(*place, m_pointer);
    }
}

}
