// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QAbstractSpinBox>

namespace romanesco {

/// A spin box for whole numbers from 0 to 2^63 - 1, which QSpinBox is too small for.
class WholeNumberBox : public QAbstractSpinBox
{
    Q_OBJECT
public:
    static constexpr quint64 maximum = 0x7fff'ffff'ffff'ffff;

    explicit WholeNumberBox(QWidget *parent = nullptr);

    [[nodiscard]] quint64 value() const { return m_value; }
    /// Without valueEdited(). What is being typed stays.
    void setValue(quint64 value);

    void stepBy(int steps) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    /// By the user: a step, or a number typed and confirmed.
    void valueEdited(quint64 value);

protected:
    [[nodiscard]] StepEnabled stepEnabled() const override;
    QValidator::State validate(QString &text, int &position) const override;

private:
    void takeText();
    void change(quint64 value);

    quint64 m_value = 0;
    /// The text is the user's, not confirmed yet.
    bool m_isBeingTyped = false;
};

}
