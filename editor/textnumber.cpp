// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textnumber.h"

#include <algorithm>

#include <QPlainTextEdit>

namespace romanesco {

TextNumber::TextNumber(QPlainTextEdit &editor)
    : m_edit(editor)
{
}

std::optional<quint64> TextNumber::value() const
{
    const QString text = m_edit.text();
    const bool isDigits = std::ranges::all_of(text, [](QChar c) { return c >= u'0' && c <= u'9'; });
    bool fits = false;
    const quint64 value = text.toULongLong(&fits);
    return isDigits && fits ? std::optional(value) : std::nullopt;
}

void TextNumber::setValue(quint64 value)
{
    const std::optional<quint64> old = this->value();
    if (old && *old != value) {
        m_edit.replace(QString::number(value));
    }
}

}
