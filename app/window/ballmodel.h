// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QAbstractTableModel>

#include "core/physics/livesimulation.h"

namespace romanesco {

/// The balls of a simulation, a row each.
class BallModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { Number, Speed, Radius, State, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setFrame(std::shared_ptr<const LiveSimulation::Frame> frame);
    /// Its number in the simulation.
    [[nodiscard]] std::uint64_t numberAt(int row) const { return m_frame->balls[static_cast<std::size_t>(row)].number; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const LiveSimulation::Frame> m_frame = std::make_shared<LiveSimulation::Frame>();
};

}
