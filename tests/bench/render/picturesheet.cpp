// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "picturesheet.h"

#include <algorithm>
#include <set>

#include <QList>
#include <QString>

#include "ourframes.h"

namespace romanesco::bench {

namespace {

constexpr int margin = 4;

QList<QRgb> roundedColours(const QImage &image, int step)
{
    const auto rounded = [&](int value) { return std::min(value / step * step + step / 2, 255); };
    std::set<QRgb> colours{qRgb(255, 255, 255)};
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QRgb colour = image.pixel(x, y);
            colours.insert(qRgb(rounded(qRed(colour)), rounded(qGreen(colour)), rounded(qBlue(colour))));
        }
    }
    return {colours.begin(), colours.end()};
}

}

QImage imageOf(const Picture &picture)
{
    return QImage(picture.pixels.data(), picture.width, picture.height, picture.width * 3, QImage::Format_RGB888)
        .copy();
}

PictureSheet::PictureSheet(int columns, int rows, int width, int height)
    : m_image(columns * (width + margin) - margin, rows * (height + margin) - margin, QImage::Format_RGB888)
{
    m_image.fill(Qt::white);
}

void PictureSheet::put(int column, int row, const QImage &picture)
{
    const int left = column * (picture.width() + margin);
    const int top = row * (picture.height() + margin);
    for (int y = 0; y < picture.height(); ++y) {
        std::copy_n(picture.constScanLine(y), 3 * picture.width(), m_image.scanLine(top + y) + 3 * left);
    }
}

QImage withFewColours(const QImage &image)
{
    constexpr qsizetype most = 256;
    QList<QRgb> colours;
    for (int step = 8; colours.isEmpty() || colours.size() > most; step += 4) {
        colours = roundedColours(image, step);
    }
    return image.convertToFormat(QImage::Format_Indexed8, colours, Qt::ThresholdDither | Qt::AvoidDither);
}

void save(const QImage &image, const std::filesystem::path &path)
{
    if (!image.save(QString::fromStdString(path.string()))) {
        orEnd<int>(std::unexpected("cannot write " + path.string()));
    }
}

}
