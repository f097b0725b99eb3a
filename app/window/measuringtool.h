// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "pointertool.h"
#include "render/appearance.h"
#include "render/sceneview.h"

namespace romanesco {

class Viewport;

/// Measures the surface under clicks: of one its place, its normal and its address, of two the distance between them.
/// A third begins anew. What was measured stays true however far the camera goes, and is gone with its scene.
class MeasuringTool : public QObject, public PointerTool
{
    Q_OBJECT
public:
    /// viewport must outlive it.
    explicit MeasuringTool(Viewport &viewport, QObject *parent = nullptr);

    /// How a copy is called; without that nothing is said of copies.
    void setNaming(std::function<QString(const Selection &)> naming) { m_naming = std::move(naming); }

    /// All that is measured, a line for each point and one for the distance; empty where nothing is.
    [[nodiscard]] QString words() const;
    void clear();

    bool click(const QPointF &place) override;
    void paint(QPainter &painter) const override;

Q_SIGNALS:
    /// What a click has found, in one line.
    void told(const QString &words);

private:
    struct Point {
        /// In the world, with as many digits as are true.
        QString place;
        QString normalWords;
        QString address;
        /// With the world's axes.
        glm::dvec3 normal{0.0};
    };
    [[nodiscard]] Point describe(const SceneView::Picked &picked) const;
    [[nodiscard]] QString distanceWords() const;
    void drawPoint(QPainter &painter, std::size_t number) const;
    void drawDistance(QPainter &painter, const QPointF &from, const QPointF &to) const;
    [[nodiscard]] std::optional<QPointF> placeOf(std::size_t number) const;

    Viewport &m_viewport;
    std::function<QString(const Selection &)> m_naming;
    /// At the view's marks.
    std::vector<Point> m_points;
    /// Of two points, as it was when they were measured.
    QString m_distance;
};

}
