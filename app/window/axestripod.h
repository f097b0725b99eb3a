// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <optional>

#include <QWidget>

namespace romanesco {

class Viewport;

/// The world's axes in the lower left corner of a picture, turned as the camera sees them. A click on one looks along it;
/// what else the mouse does there goes to the picture. Lies above the picture, so that no saved picture holds it.
class AxesTripod : public QWidget
{
    Q_OBJECT
public:
    /// A child of the viewport.
    explicit AxesTripod(Viewport &viewport);

    /// 0, 1, 2 for x, y, z: which axis is drawn at a place.
    [[nodiscard]] std::optional<int> axisAt(const QPointF &place) const;
    /// Where the letter of an axis stands.
    [[nodiscard]] QPointF letterAt(int axis) const;

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    /// x right, y down; z away from who looks.
    struct Direction {
        QPointF onScreen;
        double away = 0.0;
    };
    [[nodiscard]] std::array<Direction, 3> directions() const;
    void drawAxis(QPainter &painter, int axis, const Direction &direction) const;
    void place();

    Viewport &m_viewport;
    std::optional<int> m_pressed;
};

}
