// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "exportwords.h"

#include <cmath>

#include <QCoreApplication>

#include "countwords.h"

namespace romanesco {

namespace {

class ExportWords
{
    Q_DECLARE_TR_FUNCTIONS(ExportWords)
};

QString sizeText(std::uint64_t bytes, const QLocale &locale)
{
    return locale.formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

}

QString sizeText(const Count &bytes, const QLocale &locale)
{
    constexpr std::uint64_t mostShort = 1'000'000'000'000'000'000;
    const std::optional<std::uint64_t> number = bytes.toInteger();
    return number && *number <= mostShort ? sizeText(*number, locale)
                                          : ExportWords::tr("%1 bytes").arg(countText(bytes, locale));
}

QString durationText(double seconds, const QLocale &locale)
{
    if (seconds < 1.0) {
        return ExportWords::tr("less than a second");
    }
    const auto words = [&](double number, const QString &one, const QString &several) {
        const double rounded = std::round(number);
        return rounded == 1.0 ? one : several.arg(locale.toString(rounded, 'f', 0));
    };
    if (seconds < 90.0) {
        return words(seconds, ExportWords::tr("a second"), ExportWords::tr("%1 seconds"));
    }
    if (seconds < 90.0 * 60.0) {
        return words(seconds / 60.0, ExportWords::tr("a minute"), ExportWords::tr("%1 minutes"));
    }
    return words(seconds / 3600.0, ExportWords::tr("an hour"), ExportWords::tr("%1 hours"));
}

QString forecastText(const ExportEstimate &estimate, const ExportOptions &options, const QLocale &locale)
{
    if (!estimate.forecast) {
        return {};
    }
    const Count &faces = estimate.forecast->faces;
    QStringList parts;
    parts +=
        faces == Count(1) ? ExportWords::tr("One face") : ExportWords::tr("%1 faces").arg(countText(faces, locale));
    if (options.isWelded) {
        parts.last() += ExportWords::tr(" before welding");
    }
    parts += ExportWords::tr("about %1").arg(sizeText(estimate.forecast->bytes, locale));
    if (estimate.seconds) {
        parts += *estimate.seconds < 1.0 ? ExportWords::tr("in less than a second")
                                         : ExportWords::tr("in about %1").arg(durationText(*estimate.seconds, locale));
    }
    QString text = parts.join(ExportWords::tr(", ")) + u'.';
    if (estimate.freeBytes) {
        text += u' ' + ExportWords::tr("The disk has %1 free.").arg(sizeText(*estimate.freeBytes, locale));
    }
    return text;
}

QString remarksText(const ExportReport &report, const QLocale &locale)
{
    const auto number = [&](std::uint64_t count) { return countText(Count(count), locale); };
    QStringList sentences;
    if (report.bakedCopies > 0) {
        sentences += ExportWords::tr("%1 copies are more than translation, rotation and scale: they were written out.")
                         .arg(number(report.bakedCopies));
    }
    if (report.missingImages > 0) {
        sentences +=
            ExportWords::tr("%1 of the textures cannot be read, or are neither PNG nor JPEG: they were left out.")
                .arg(number(report.missingImages));
    }
    if (report.weld) {
        sentences += ExportWords::tr("%1 vertices were merged and %2 faces dropped.")
                         .arg(number(report.weld->mergedVertices),
                              number(report.weld->droppedWalls + report.weld->droppedFaces));
        sentences += report.weld->isClosed()
            ? ExportWords::tr("The surface is closed.")
            : ExportWords::tr("The surface is not closed: %1 edges are open.").arg(number(report.weld->openEdges));
    }
    return sentences.join(u' ');
}

}
