// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "contactinspector.h"

#include <chrono>
#include <cmath>
#include <limits>

#include <QLocale>
#include <QMouseEvent>
#include <QToolTip>

#include <glm/geometric.hpp>

#include "core/scene/passages.h"
#include "measurement.h"
#include "viewport.h"

namespace romanesco {

namespace {

constexpr std::chrono::milliseconds restsAfter(300);
/// Of the radius: balls lie so high at most.
constexpr double touching = 1e-4;

}

ContactInspector::ContactInspector(Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restsAfter);
    connect(&m_rest, &QTimer::timeout, this, &ContactInspector::look);
    m_viewport.installEventFilter(this);
}

bool ContactInspector::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseMove) {
        const auto &moved = *static_cast<const QMouseEvent *>(event);
        m_place = moved.position();
        const bool tells = m_frame->isStarted && !m_frame->isPlaying && moved.buttons() == Qt::NoButton;
        tells ? m_rest.start() : m_rest.stop();
    } else if (event->type() == QEvent::Leave || event->type() == QEvent::MouseButtonPress) {
        m_rest.stop();
    }
    return QObject::eventFilter(watched, event);
}

const LiveSimulation::BallFrame *ContactInspector::ballAt(const QPointF &place) const
{
    const auto &here = m_viewport.view().surroundings();
    if (!here) {
        return nullptr;
    }
    Passages passages(*here);
    const LiveSimulation::BallFrame *nearest = nullptr;
    double nearestWay = std::numeric_limits<double>::infinity();
    for (const LiveSimulation::BallFrame &ball : m_frame->balls) {
        const auto sphere = passages.here(m_frame->places[ball.place].surroundings.get(), {ball.after, ball.radius});
        const auto seen = sphere ? m_viewport.placeOf(sphere->centre) : std::nullopt;
        if (!seen) {
            continue;
        }
        const glm::dvec3 &centre = sphere->centre;
        const double radius = sphere->radius / heightAt(m_viewport.camera(), centre) * m_viewport.height();
        const double way = glm::distance(centre, m_viewport.camera().position);
        if (std::hypot(seen->x() - place.x(), seen->y() - place.y()) <= radius && way < nearestWay) {
            nearest = &ball;
            nearestWay = way;
        }
    }
    return nearest;
}

QString ContactInspector::wordsOf(const LiveSimulation::BallFrame &ball) const
{
    const QLocale locale;
    QStringList lines{ball.isAsleep ? tr("Ball %1, at rest").arg(ball.number + 1) : tr("Ball %1").arg(ball.number + 1)};
    const auto contact =
        contactOf(*m_frame->places[ball.place].surface, {.position = ball.after, .radius = ball.radius});
    if (!contact) {
        lines << tr("It touches nothing");
        return lines.join(u'\n');
    }
    const double share = contact->overlap / ball.radius;
    lines << (share < -touching ? tr("Nearest: face %1").arg(contact->face + 1)
                                : tr("Touches face %1").arg(contact->face + 1));
    if (m_naming) {
        lines << tr("of %1").arg(m_naming(contact->item, contact->address));
    }
    lines << tr("Normal %1").arg(directionWords(contact->normal));
    lines << (share < 0.0 ? tr("Gap %1 of its radius").arg(locale.toString(-share, 'g', 3))
                          : tr("Overlap %1 of its radius").arg(locale.toString(share, 'g', 3)));
    return lines.join(u'\n');
}

void ContactInspector::look()
{
    if (!m_viewport.isHeld()) {
        if (const LiveSimulation::BallFrame *ball = ballAt(m_place)) {
            QToolTip::showText(m_viewport.mapToGlobal(m_place.toPoint()), wordsOf(*ball), &m_viewport);
        }
    }
}

}
