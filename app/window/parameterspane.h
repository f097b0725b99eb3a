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
class PinnedRow;

/// A slider for each number of iterations in an .fdo text, then for each number that is pinned. What they change is the
/// text.
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
    void updatePins();

    FdoEditor *m_editor = nullptr;
    QVBoxLayout *m_column;
    QWidget *m_hint;
    std::vector<Row> m_rows;
    QVBoxLayout *m_pinColumn;
    std::vector<PinnedRow *> m_pins;
    /// Lives as long as an editor is followed, for what is connected to it.
    std::unique_ptr<QObject> m_whileFollowed;
    bool m_isDragged = false;
};

}
