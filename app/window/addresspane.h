// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "fdoreading.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace romanesco {

/// The way to the copy that stands out, a step a row, each of which leads to its words in the text and lets all that it
/// leads to stand out.
class AddressPane : public QWidget
{
    Q_OBJECT
public:
    explicit AddressPane(QWidget *parent = nullptr);

    void setSteps(const std::vector<AddressStep> &steps);
    /// The depth for which the chosen step would be the last; nothing where none is.
    void setCollapse(std::optional<quint64> depth);

Q_SIGNALS:
    /// A row was chosen: so many of the steps lead there.
    void chosen(std::size_t count);
    /// The copy that stands out shall fill the view.
    void zoomRequested();
    void collapseRequested();

private:
    QLabel *m_hint;
    QListWidget *m_list;
    QPushButton *m_zoom;
    QPushButton *m_collapse;
};

}
