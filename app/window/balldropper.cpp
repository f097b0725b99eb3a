// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "balldropper.h"

#include <cmath>

#include <QPainter>

#include <glm/geometric.hpp>

#include "core/physics/ballplaces.h"
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
    const double unit = std::exp2(m_viewport.view().surroundings()->unitExponent);
    const auto [like, gravity] = m_drop(unit * heightAt(m_viewport.camera(), picked->point));
    const double pull = glm::length(gravity);
    const glm::dvec3 up = pull > 0.0 ? -gravity / pull : glm::dvec3(0.0);
    Ball ball = like;
    ball.radius /= unit;
    ball.position = picked->point + ball.radius * (offSurface * picked->normal + height * up);
    return ball;
}

bool BallDropper::click(const QPointF &place)
{
    if (!m_viewport.view().hasRayWalk()) {
        Q_EMIT told(tr("The surface is still being looked for. Click again in a moment."));
    } else if (const auto ball = ballAt(place)) {
        const Surroundings &here = *m_viewport.view().surroundings();
        here.path.empty() ? Q_EMIT dropped(inWorld(*ball, &here), std::nullopt)
                          : Q_EMIT dropped(*ball, ScenePlace{here.pathItem, here.path});
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
    const auto place = m_viewport.placeOf(ball->position);
    const double seen = heightAt(m_viewport.camera(), ball->position);
    if (!place || !(seen > 0.0)) {
        return;
    }
    const double radius = ball->radius / seen * m_viewport.height();
    painter.setBrush(Qt::NoBrush);
    for (const auto &[colour, width] : {std::pair(markRim(), 4.0), std::pair(QColor::fromRgba(accent), 1.5)}) {
        painter.setPen(QPen(colour, width));
        painter.drawEllipse(*place, radius, radius);
        painter.drawLine(*place, m_pointer);
    }
}

}
