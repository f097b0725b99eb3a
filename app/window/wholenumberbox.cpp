// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "wholenumberbox.h"

#include <algorithm>

#include <QLineEdit>
#include <QStyleOptionSpinBox>

namespace romanesco {

WholeNumberBox::WholeNumberBox(QWidget *parent)
    : QAbstractSpinBox(parent)
{
    lineEdit()->setText(QString::number(m_value));
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { m_isBeingTyped = true; });
    connect(this, &QAbstractSpinBox::editingFinished, this, &WholeNumberBox::takeText);
}

void WholeNumberBox::setValue(quint64 value)
{
    m_value = std::min(value, maximum);
    if (!m_isBeingTyped) {
        lineEdit()->setText(QString::number(m_value));
    }
}

void WholeNumberBox::stepBy(int steps)
{
    takeText();
    const auto distance = static_cast<quint64>(std::abs(static_cast<qint64>(steps)));
    change(steps < 0 ? m_value - std::min(distance, m_value) : m_value + std::min(distance, maximum - m_value));
    selectAll();
}

QSize WholeNumberBox::sizeHint() const
{
    ensurePolished();
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const QSize content(fontMetrics().horizontalAdvance(QStringLiteral("00000000")), fontMetrics().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
}

WholeNumberBox::StepEnabled WholeNumberBox::stepEnabled() const
{
    StepEnabled enabled = StepNone;
    enabled |= m_value > 0 ? StepDownEnabled : StepNone;
    enabled |= m_value < maximum ? StepUpEnabled : StepNone;
    return enabled;
}

QValidator::State WholeNumberBox::validate(QString &text, int &) const
{
    if (text.isEmpty()) {
        return QValidator::Intermediate;
    }
    const bool isDigits = std::ranges::all_of(text, [](QChar c) { return c >= u'0' && c <= u'9'; });
    bool fits = false;
    return isDigits && text.toULongLong(&fits) <= maximum && fits ? QValidator::Acceptable : QValidator::Invalid;
}

void WholeNumberBox::takeText()
{
    if (!m_isBeingTyped) {
        return;
    }
    // An empty text is no number: the old one comes back.
    bool isNumber = false;
    const quint64 typed = lineEdit()->text().toULongLong(&isNumber);
    change(isNumber ? typed : m_value);
}

void WholeNumberBox::change(quint64 value)
{
    const bool isNew = value != m_value;
    m_isBeingTyped = false;
    setValue(value);
    if (isNew) {
        Q_EMIT valueEdited(m_value);
    }
}

}
