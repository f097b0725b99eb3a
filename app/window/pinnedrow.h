// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QWidget>

#include "editor/pinnednumbers.h"

class QLabel;
class QSlider;

namespace romanesco {

/// A slider that moves a pinned number by steps of its last decimal, from the middle to both sides, and a button that lets
/// go of it.
class PinnedRow : public QWidget
{
    Q_OBJECT
public:
    /// numbers must outlive it.
    PinnedRow(PinnedNumbers &numbers, int id, QWidget *parent = nullptr);

    [[nodiscard]] int id() const { return m_id; }
    void setPin(const PinnedNumbers::Pin &pin, bool canEdit);

private:
    void centre();

    int m_id;
    QLabel *m_name;
    QSlider *m_slider;
    QLabel *m_number;
};

}
