// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "imagedecoder.h"

#include <algorithm>

#include <QBuffer>
#include <QImage>
#include <QImageReader>

namespace romanesco {

std::expected<Image, std::string> decodeImage(const std::string &bytes)
{
    QByteArray raw = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
    QBuffer buffer(&raw);
    QImageReader reader(&buffer);
    const QSize size = reader.size();
    if (std::max(size.width(), size.height()) > longestTextureSide) {
        reader.setScaledSize(
            size.scaled(longestTextureSide, longestTextureSide, Qt::KeepAspectRatio).expandedTo({1, 1}));
    }
    const QImage read = reader.read();
    if (read.isNull()) {
        return std::unexpected("the file is no picture that can be read");
    }
    const QImage image = read.convertToFormat(QImage::Format_RGBA8888);
    Image made{image.width(), image.height(), {}};
    const auto rowBytes = static_cast<std::size_t>(made.width) * 4;
    made.pixels.reserve(rowBytes * static_cast<std::size_t>(made.height));
    for (int row = 0; row < made.height; ++row) {
        const uchar *line = image.constScanLine(row);
        made.pixels.insert(made.pixels.end(), line, line + rowBytes);
    }
    return made;
}

}
