// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "picturesize.h"

#include <algorithm>

#include <QRegularExpression>

#include "output.h"

namespace romanesco::cli {

QCommandLineOption sizeOption()
{
    return {QStringLiteral("size"), QStringLiteral("Width and height in pixels (1280x720)."), QStringLiteral("WxH"),
            QStringLiteral("1280x720")};
}

std::optional<QSize> pictureSize(const QCommandLineParser &parser)
{
    static const QRegularExpression pattern(QStringLiteral("^([1-9][0-9]{0,5})x([1-9][0-9]{0,5})$"));
    const QString text = parser.value(QStringLiteral("size"));
    const QRegularExpressionMatch match = pattern.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    if (!match.hasMatch() || std::max(size.width(), size.height()) > largestSide) {
        complain(QStringLiteral("--size takes WIDTHxHEIGHT, each up to %1, not \"%2\"").arg(largestSide).arg(text));
        return std::nullopt;
    }
    return size;
}

}
