// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "figuremodel.h"

#include <limits>
#include <utility>

namespace romanesco {

void FigureModel::setTable(FigureTable table)
{
    beginResetModel();
    m_table = std::move(table);
    endResetModel();
}

int FigureModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_table.rows.size());
}

int FigureModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() || m_table.rows.empty() ? 0 : 1 + static_cast<int>(m_table.heads.size());
}

QVariant FigureModel::data(const QModelIndex &index, int role) const
{
    const FigureTable::Row &shown = row(index.row());
    const bool isName = index.column() == 0;
    const auto figure = static_cast<std::size_t>(index.column() - 1);
    switch (role) {
    case Qt::DisplayRole:
        if (isName) {
            return shown.name;
        }
        if (!shown.reason.isEmpty()) {
            return index.column() == 1 ? shown.reason : QString();
        }
        return shown.figures[figure].words;
    case SortRole:
        if (isName) {
            return index.row();
        }
        return shown.reason.isEmpty() ? shown.figures[figure].value : std::numeric_limits<double>::infinity();
    case Qt::ToolTipRole:
        return m_table.wordsOf(shown);
    case Qt::TextAlignmentRole:
        return QVariant(isName || !shown.reason.isEmpty() ? Qt::AlignLeft | Qt::AlignVCenter
                                                          : Qt::AlignRight | Qt::AlignVCenter);
    default:
        return {};
    }
}

QVariant FigureModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const FigureTable::Head &head =
        section == 0 ? m_table.nameHead : m_table.heads[static_cast<std::size_t>(section - 1)];
    switch (role) {
    case Qt::DisplayRole:
        return head.words;
    case Qt::ToolTipRole:
        return head.tip;
    default:
        return {};
    }
}

}
