// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <vector>

#include <QElapsedTimer>
#include <QWidget>

#include "core/physics/livesimulation.h"

class QAction;
class QLabel;
class QTableView;

namespace romanesco {

class BallModel;
class EnergyGraph;

/// What happens to balls, what it costs, and a list of them.
class PhysicsFigures : public QWidget
{
    Q_OBJECT
public:
    explicit PhysicsFigures(QWidget *parent = nullptr);

    /// What can be done to those that are selected in the list; once.
    void addActions(const QList<QAction *> &actions);

    /// Words and rows follow some times a second.
    void show(const std::shared_ptr<const LiveSimulation::Frame> &frame);
    /// Their numbers, in order.
    [[nodiscard]] std::vector<std::uint64_t> selectedBalls() const;

Q_SIGNALS:
    void selectionChanged();

private:
    QWidget *makeWords();
    QWidget *makeList();

    QLabel *m_words;
    EnergyGraph *m_energy;
    BallModel *m_balls;
    QTableView *m_list;
    QElapsedTimer m_sinceShown;
    std::uint64_t m_shownSteps = 0;
};

}
