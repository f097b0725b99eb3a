// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QImage>

namespace romanesco::test {

/// Of all pixels; all where the sizes differ. Where surfaces coincide, either may be seen: pictures of the same need not be
/// equal.
inline double shareOfDifferent(const QImage &a, const QImage &b)
{
    if (a.size() != b.size()) {
        return 1.0;
    }
    qsizetype different = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            different += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        }
    }
    return double(different) / double(a.width() * a.height());
}

inline bool isLike(const QImage &a, const QImage &b)
{
    return shareOfDifferent(a, b) < 0.001;
}

}
