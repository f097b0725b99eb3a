// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QLocale>
#include <QStringList>

namespace romanesco {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr int mostDigits = 15;
/// Beyond, a number is written from its logarithm.
constexpr double greatestExponent = 1000.0;

/// All figures by which the number can be told from its neighbours, without zeros at the end.
QString inDigits(double value, int digits)
{
    return QLocale::c().toString(value, 'g', digits);
}

}

QString trueDigits(double value, double error, double exponent)
{
    const double relative = error / std::abs(value) + rounding * std::abs(exponent);
    if (!(relative < 0.5)) {
        return QStringLiteral("0");
    }
    const int digits = std::clamp(static_cast<int>(std::floor(-std::log10(2.0 * relative))), 1, mostDigits);
    if (std::abs(exponent) < greatestExponent) {
        const double scaled = value * std::exp2(exponent);
        if (std::isnormal(scaled)) {
            return inDigits(scaled, digits);
        }
    }
    const double logarithm = std::log10(std::abs(value)) + exponent * std::log10(2.0);
    const double whole = std::floor(logarithm);
    QString text = inDigits(std::pow(10.0, logarithm - whole), digits);
    const QString sign = value < 0.0 ? QStringLiteral("-") : QString();
    return sign + text + QStringLiteral("e%1").arg(QString::number(whole, 'f', 0));
}

QString worldPlace(const Surroundings &place, const glm::dvec3 &point, double error)
{
    const glm::dvec3 inWorld = place.worldFromHere(point);
    const double unit = std::exp2(place.unitExponent);
    QStringList words;
    for (int i = 0; i < 3; ++i) {
        const double off = unit * error + 4.0 * rounding * std::abs(place.origin[i]);
        words << trueDigits(inWorld[i], std::max(off, std::numeric_limits<double>::min()));
    }
    return u'(' + words.join(QStringLiteral(", ")) + u')';
}

QString directionWords(const glm::dvec3 &direction)
{
    QStringList words;
    for (int i = 0; i < 3; ++i) {
        // no "-0"
        words << QLocale::c().toString(std::round(direction[i] * 1e4) / 1e4 + 0.0, 'g', 4);
    }
    return u'(' + words.join(QStringLiteral(", ")) + u')';
}

}
