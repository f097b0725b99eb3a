// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QLocale>
#include <QString>

#include "exportestimate.h"

namespace romanesco {

/// "12.3 MB"; beyond all disks "4.07 × 10⁴¹ bytes".
[[nodiscard]] QString sizeText(const Count &bytes, const QLocale &locale = QLocale());

/// "less than a second", "40 seconds", "6 minutes", "3 hours"; seconds of 0 and above.
[[nodiscard]] QString durationText(double seconds, const QLocale &locale = QLocale());

/// "240,000 faces, about 12.3 MB, in about 4 seconds. 31 GB are free on the disk."
[[nodiscard]] QString forecastText(const ExportEstimate &estimate, const ExportOptions &options,
                                   const QLocale &locale = QLocale());

/// Sentences about what of an export is not as one might think: copies baked, textures left out, what welding did.
[[nodiscard]] QString remarksText(const ExportReport &report, const QLocale &locale = QLocale());

}
