// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QPointF>

#include "core/physics/ball.h"
#include "core/scene/sceneplace.h"
#include "pointertool.h"

namespace romanesco {

class Viewport;

/// Drops a ball above each place of the surface that is clicked. Where it would start is drawn under the pointer.
class BallDropper : public QObject, public PointerTool
{
    Q_OBJECT
public:
    explicit BallDropper(Viewport &viewport, QObject *parent = nullptr);

    /// What is dropped where so much of the world is seen across, which it need not be small beside; and which way it falls.
    struct Drop {
        Ball ball;
        glm::dvec3 gravity{0.0};
    };
    void setDrop(std::function<Drop(double seen)> drop) { m_drop = std::move(drop); }

    bool click(const QPointF &place) override;
    void hover(const QPointF &place) override;
    void paint(QPainter &painter) const override;

Q_SIGNALS:
    /// Counted from a place, or in the world.
    void dropped(const romanesco::Ball &ball, const std::optional<romanesco::ScenePlace> &place);
    /// Why nothing was, in a line.
    void told(const QString &words);

private:
    /// In the view's coordinates.
    [[nodiscard]] std::optional<Ball> ballAt(const QPointF &place) const;

    Viewport &m_viewport;
    std::function<Drop(double seen)> m_drop;
    QPointF m_pointer;
};

}
