// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QScrollArea>

namespace romanesco {

class PhysicsChoices;
class PhysicsFigures;

/// The panel of balls: what is chosen for them, and what happens to them.
class PhysicsPane : public QScrollArea
{
    Q_OBJECT
public:
    explicit PhysicsPane(QWidget *parent = nullptr);

    [[nodiscard]] PhysicsChoices &choices() const { return *m_choices; }
    [[nodiscard]] PhysicsFigures &figures() const { return *m_figures; }

private:
    PhysicsChoices *m_choices;
    PhysicsFigures *m_figures;
};

}
