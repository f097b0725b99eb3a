// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "turntable.h"

#include <QRegularExpression>

namespace romanesco::cli {

namespace {

constexpr int mostFrames = 1'000'000;

/// Digits, at most as many as an int holds in any case; -1 for anything else.
int wholeNumber(const QString &text)
{
    static const QRegularExpression digits(QStringLiteral("^[0-9]{1,9}$"));
    return digits.match(text).hasMatch() ? text.toInt() : -1;
}

}

std::expected<Turntable, QString> readTurntable(const QString &count, const QString &frames)
{
    Turntable turntable{.count = wholeNumber(count)};
    if (turntable.count < 1 || turntable.count > mostFrames) {
        return std::unexpected(
            QStringLiteral("--turntable takes a whole number from 1 to %1, not \"%2\"").arg(mostFrames).arg(count));
    }
    turntable.last = turntable.count - 1;
    if (frames.isNull()) {
        return turntable;
    }
    const QStringList ends = frames.split(QLatin1String(".."));
    turntable.first = ends.size() == 2 ? wholeNumber(ends[0]) : -1;
    turntable.last = ends.size() == 2 ? wholeNumber(ends[1]) : -1;
    if (turntable.first < 0 || turntable.last < turntable.first || turntable.last >= turntable.count) {
        return std::unexpected(QStringLiteral("--frames takes A..B, two of the numbers from 0 to %1, not \"%2\"")
                                   .arg(turntable.count - 1)
                                   .arg(frames));
    }
    return turntable;
}

}
