// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QLocale>
#include <QString>

#include "core/base/count.h"
#include "core/scene/summary.h"

namespace romanesco {

/// A count as people write it: "244,140,625"; from 16 digits on "1.20 × 10⁴⁰", and where the count is not exact "≈ …".
[[nodiscard]] QString countText(const Count &count, const QLocale &locale = QLocale());

/// "5⁷ = 78,125 copies as written · 21,845 distinct · 2,187,500 faces".
[[nodiscard]] QString summaryText(const Summary &summary, const QLocale &locale = QLocale());

}
