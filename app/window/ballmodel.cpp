// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "ballmodel.h"

#include <algorithm>
#include <cmath>

#include <QLocale>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

bool areTheSame(const std::vector<LiveSimulation::BallFrame> &a, const std::vector<LiveSimulation::BallFrame> &b)
{
    return std::ranges::equal(a, b, {}, &LiveSimulation::BallFrame::number, &LiveSimulation::BallFrame::number);
}

}

void BallModel::setFrame(std::shared_ptr<const LiveSimulation::Frame> frame)
{
    // Rows stay as they are, and selected, as long as no ball comes or goes.
    if (areTheSame(frame->balls, m_frame->balls)) {
        m_frame = std::move(frame);
        if (rowCount() > 0) {
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        }
        return;
    }
    beginResetModel();
    m_frame = std::move(frame);
    endResetModel();
}

int BallModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_frame->balls.size());
}

int BallModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant BallModel::data(const QModelIndex &index, int role) const
{
    if (role != Qt::DisplayRole) {
        return {};
    }
    const LiveSimulation::BallFrame &ball = m_frame->balls[static_cast<std::size_t>(index.row())];
    const Surroundings *place = m_frame->places[ball.place].surroundings.get();
    const double unit = place ? std::exp2(place->unitExponent) : 1.0;
    const QLocale locale;
    switch (index.column()) {
    case Number:
        return QVariant::fromValue(ball.number + 1);
    case Speed:
        return locale.toString(unit * glm::length(ball.velocity), 'g', 3);
    case Radius:
        return locale.toString(unit * ball.radius, 'g', 3);
    case State:
        return ball.isAsleep ? tr("rests") : ball.contacts > 0 ? tr("touches") : tr("flies");
    default:
        return {};
    }
}

QVariant BallModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Number:
        return tr("Ball");
    case Speed:
        return tr("Speed");
    case Radius:
        return tr("Radius");
    case State:
        return tr("State");
    default:
        return {};
    }
}

}
