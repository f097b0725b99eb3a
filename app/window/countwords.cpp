// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "countwords.h"

#include <array>

#include <QCoreApplication>

namespace romanesco {

namespace {

constexpr qsizetype mostDigits = 15;

class CountWords
{
    Q_DECLARE_TR_FUNCTIONS(CountWords)
};

QString superscript(const QString &digits)
{
    constexpr std::array<char16_t, 10> raised{u'⁰', u'¹', u'²', u'³', u'⁴', u'⁵', u'⁶', u'⁷', u'⁸', u'⁹'};
    QString text;
    for (const QChar digit : digits) {
        text += digit.isDigit() ? QChar(raised[static_cast<std::size_t>(digit.digitValue())]) : digit;
    }
    return text;
}

QString scientific(double mantissa, const QString &exponent, const QLocale &locale)
{
    return QStringLiteral("%1 × 10%2").arg(locale.toString(mantissa, 'f', 2), superscript(exponent));
}

}

QString countText(const Count &count, const QLocale &locale)
{
    const QString text = QString::fromStdString(count.toString());
    if (!count.isExact()) {
        // "~8.81e646456992"
        const qsizetype e = text.indexOf(u'e');
        return QStringLiteral("≈ ") + scientific(text.sliced(1, e - 1).toDouble(), text.sliced(e + 1), locale);
    }
    if (text.size() > mostDigits) {
        // Three digits, the rest cut off.
        return scientific(text.first(3).toDouble() / 100.0, QString::number(text.size() - 1), locale);
    }
    return locale.toString(text.toULongLong());
}

QString summaryText(const Summary &summary, const QLocale &locale)
{
    QString power;
    if (summary.iteration && summary.iteration->depth > 1) {
        power = QStringLiteral("%1%2 = ").arg(locale.toString(static_cast<qulonglong>(summary.iteration->transforms)),
                                              superscript(QString::number(summary.iteration->depth)));
    }
    QStringList parts;
    parts += CountWords::tr("%1 copies as written").arg(power + countText(summary.instancesAsWritten, locale));
    if (summary.instancesDistinct && !(*summary.instancesDistinct == summary.instancesAsWritten)) {
        parts += CountWords::tr("%1 distinct").arg(countText(*summary.instancesDistinct, locale));
    }
    parts += CountWords::tr("%1 faces").arg(countText(summary.facesAsWritten, locale));
    return parts.join(QStringLiteral(" · "));
}

}
