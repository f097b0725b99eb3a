// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QAbstractTableModel>

#include "figuretable.h"

namespace romanesco {

/// A table of figures, whose first column are names. A reason stands in the second one.
class FigureModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    /// Data of this role sort as numbers; names as they came.
    static constexpr int SortRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void setTable(FigureTable table);
    [[nodiscard]] const FigureTable &table() const { return m_table; }
    [[nodiscard]] const FigureTable::Row &row(int number) const
    {
        return m_table.rows[static_cast<std::size_t>(number)];
    }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    FigureTable m_table;
};

}
