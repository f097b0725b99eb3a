// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <vector>

#include <QScrollArea>

#include "editor/textnumber.h"

class QVBoxLayout;

namespace romanesco {

class DepthControl;
class FdoEditor;

/// A slider for each number of iterations in an .fdo text. What they change is the text.
class ParametersPane : public QScrollArea
{
    Q_OBJECT
public:
    explicit ParametersPane(QWidget *parent = nullptr);
    ~ParametersPane() override;

    /// From now on it is about this text, which outlives that.
    void follow(FdoEditor &editor);
    /// What the text says now. Not while a slider is dragged: its number is followed by itself.
    void update();

private:
    struct Row {
        QString name;
        DepthControl *control = nullptr;
        std::unique_ptr<TextNumber> number;
    };
    void addRow(const QString &name);
    void dropRows(std::size_t first);

    FdoEditor *m_editor = nullptr;
    QVBoxLayout *m_column;
    QWidget *m_hint;
    std::vector<Row> m_rows;
    bool m_isDragged = false;
};

}
