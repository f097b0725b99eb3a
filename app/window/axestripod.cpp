// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "axestripod.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include "viewmarks.h"
#include "viewport.h"

namespace romanesco {

namespace {

constexpr int side = 96;
constexpr double length = 28.0;
/// From the middle to the middle of a letter.
constexpr double letterDistance = 38.0;
constexpr double reachOfLetter = 10.0;
constexpr double reachOfLine = 5.0;

constexpr std::array letters{u'x', u'y', u'z'};

QPointF middle()
{
    return {side / 2.0, side / 2.0};
}

double distance(const QPointF &a, const QPointF &b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}

AxesTripod::AxesTripod(Viewport &viewport)
    : QWidget(&viewport)
    , m_viewport(viewport)
{
    setFixedSize(side, side);
    setMouseTracking(true);
    setAccessibleName(tr("Axes x, y and z"));
    connect(&viewport, &Viewport::viewMoved, this, qOverload<>(&QWidget::update));
    viewport.installEventFilter(this);
    place();
}

void AxesTripod::place()
{
    move(0, m_viewport.height() - side);
}

bool AxesTripod::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

std::array<AxesTripod::Direction, 3> AxesTripod::directions() const
{
    std::array<Direction, 3> result;
    const glm::dmat3 &axes = m_viewport.camera().worldFromCamera;
    for (int i = 0; i < 3; ++i) {
        // a row of the rotation is a column of its inverse
        result[static_cast<std::size_t>(i)] = {{axes[0][i], -axes[1][i]}, axes[2][i]};
    }
    return result;
}

QPointF AxesTripod::letterAt(int axis) const
{
    return middle() + letterDistance * directions()[static_cast<std::size_t>(axis)].onScreen;
}

std::optional<int> AxesTripod::axisAt(const QPointF &place) const
{
    const std::array<Direction, 3> all = directions();
    std::optional<int> found;
    double away = 0.0;
    for (int i = 0; i < 3; ++i) {
        const Direction &direction = all[static_cast<std::size_t>(i)];
        const QPointF fromMiddle = place - middle();
        const double squared = QPointF::dotProduct(direction.onScreen, direction.onScreen);
        const double along =
            squared > 0.0 ? QPointF::dotProduct(fromMiddle, direction.onScreen) / squared / length : 0.0;
        const QPointF onLine = std::clamp(along, 0.0, 1.0) * length * direction.onScreen;
        // where the axes meet no one is meant
        const bool isOnLine = along > 0.3 && distance(onLine, fromMiddle) < reachOfLine;
        const bool isOnLetter = distance(letterDistance * direction.onScreen, fromMiddle) < reachOfLetter;
        if ((isOnLine || isOnLetter) && (!found || direction.away < away)) {
            found = i;
            away = direction.away;
        }
    }
    return found;
}

bool AxesTripod::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto &help = *static_cast<QHelpEvent *>(event);
    const std::array tips{tr("x axis: look from the side (3)"), tr("y axis: look from above (7)"),
                          tr("z axis: look from the front (1)")};
    const std::optional<int> axis = axisAt(help.pos());
    QToolTip::showText(help.globalPos(), axis ? tips[static_cast<std::size_t>(*axis)] : QString(), this);
    return true;
}

void AxesTripod::mouseMoveEvent(QMouseEvent *event)
{
    if (axisAt(event->position())) {
        setCursor(Qt::PointingHandCursor);
    } else {
        unsetCursor();
    }
    event->setAccepted(m_pressed.has_value());
}

void AxesTripod::mousePressEvent(QMouseEvent *event)
{
    const bool isPlain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
    m_pressed = isPlain ? axisAt(event->position()) : std::nullopt;
    event->setAccepted(m_pressed.has_value());
}

void AxesTripod::mouseReleaseEvent(QMouseEvent *event)
{
    event->setAccepted(m_pressed.has_value());
    const std::optional<int> pressed = std::exchange(m_pressed, std::nullopt);
    if (pressed && axisAt(event->position()) == pressed) {
        constexpr std::array sides{Viewport::Side::Right, Viewport::Side::Top, Viewport::Side::Front};
        m_viewport.lookFrom(sides[static_cast<std::size_t>(*pressed)]);
    }
}

void AxesTripod::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::array<Direction, 3> all = directions();
    std::array order{0, 1, 2};
    std::ranges::sort(order, std::ranges::greater(),
                      [&](int axis) { return all[static_cast<std::size_t>(axis)].away; });
    for (const int axis : order) {
        drawAxis(painter, axis, all[static_cast<std::size_t>(axis)]);
    }
}

void AxesTripod::drawAxis(QPainter &painter, int axis, const Direction &direction) const
{
    drawMarkLine(painter, {middle(), middle() + length * direction.onScreen}, axisColour(axis), 2.0);

    const QString letter(letters[static_cast<std::size_t>(axis)]);
    QFont bold = font();
    bold.setBold(true);
    const QRectF box = QFontMetricsF(bold).tightBoundingRect(letter);
    QPainterPath shape;
    shape.addText(middle() + letterDistance * direction.onScreen - box.center(), bold, letter);
    painter.setPen(QPen(markRim(), 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(shape);
    painter.fillPath(shape, axisColour(axis));
}

}
