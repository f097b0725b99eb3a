// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <vector>

#include <QFrame>
#include <QList>
#include <QPointF>
#include <QStringList>

#include "core/measure/plotlayout.h"
#include "core/measure/trialplots.h"

class QCPAxis;
class QCPItemText;
class QCPTextElement;
class QCustomPlot;

namespace romanesco {

/// Error against cost, as errorPlot() draws it: both by their logarithms, what is not off at all at the bottom, points of
/// the front full and joined. The mouse on a point tells its figures, a click chooses it.
class MeasurePlot : public QFrame
{
    Q_OBJECT
public:
    explicit MeasurePlot(QWidget *parent = nullptr);

    /// tips: what there is to tell of each point.
    void setPlot(TrialPlot plot, QStringList tips);
    /// The point of a row of the trial stands out.
    void choose(std::optional<std::size_t> row);

    /// Where a point is, in the widget's pixels.
    [[nodiscard]] QPointF placeOf(std::size_t point) const;
    /// Whether it is on the front, which nothing beats.
    [[nodiscard]] bool isOnFront(std::size_t point) const { return m_front[point]; }
    /// What the mouse at a place tells; empty beside all points.
    [[nodiscard]] QString wordsAt(const QPointF &place) const;

Q_SIGNALS:
    /// A row of the trial.
    void chosen(std::size_t row);
    /// By a double click.
    void activated(std::size_t row);

protected:
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void draw();
    void drawFront();
    void drawPoint(std::size_t point);
    [[nodiscard]] QCPItemText *makeLabel(const PlotPoint &point) const;
    [[nodiscard]] std::vector<std::size_t> frontFirst() const;
    void colour();
    void colour(QCPAxis &axis) const;
    void numberAxes();
    void placeLabels();
    [[nodiscard]] double heightOf(double error) const;
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF &place) const;

    QCustomPlot *m_plot;
    /// What is off, where it needs no more room than numbers do.
    QCPTextElement *m_errorAxis;
    TrialPlot m_shown;
    QStringList m_tips;
    std::vector<bool> m_front;
    Decades m_costs;
    Decades m_errors;
    QList<QCPItemText *> m_labels;
    std::optional<std::size_t> m_chosen;
};

}
