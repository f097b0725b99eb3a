// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renderpictures.h"

#include <algorithm>
#include <set>

#include <QImage>
#include <QList>
#include <QString>

namespace romanesco::bench {

namespace {

constexpr PictureSize thumbnail{224, 126};
constexpr int margin = 4;

QImage imageOf(const Picture &picture)
{
    return QImage(picture.pixels.data(), picture.width, picture.height, picture.width * 3, QImage::Format_RGB888)
        .copy();
}

/// Pictures of one size in rows, on white.
class Sheet
{
public:
    Sheet(int columns, int rows, int width, int height)
        : m_image(columns * (width + margin) - margin, rows * (height + margin) - margin, QImage::Format_RGB888)
    {
        m_image.fill(Qt::white);
    }

    void put(int column, int row, const QImage &picture)
    {
        const int left = column * (picture.width() + margin);
        const int top = row * (picture.height() + margin);
        for (int y = 0; y < picture.height(); ++y) {
            std::copy_n(picture.constScanLine(y), 3 * picture.width(), m_image.scanLine(top + y) + 3 * left);
        }
    }

    [[nodiscard]] const QImage &image() const { return m_image; }

private:
    QImage m_image;
};

/// With colours a few steps apart, of which there are few since all surfaces are alike: a third of the bytes.
QImage withFewColours(const QImage &image)
{
    constexpr int step = 8;
    const auto rounded = [](int value) { return std::min(value / step * step + step / 2, 255); };
    std::set<QRgb> colours{qRgb(255, 255, 255)};
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QRgb colour = image.pixel(x, y);
            colours.insert(qRgb(rounded(qRed(colour)), rounded(qGreen(colour)), rounded(qBlue(colour))));
        }
    }
    return image.convertToFormat(QImage::Format_Indexed8, QList<QRgb>(colours.begin(), colours.end()),
                                 Qt::ThresholdDither | Qt::AvoidDither);
}

void save(const QImage &image, const std::filesystem::path &path)
{
    if (!image.save(QString::fromStdString(path.string()))) {
        orEnd<int>(std::unexpected("cannot write " + path.string()));
    }
}

void writePlaces(OurFrames &frames, const std::vector<Subject> &subjects, const std::filesystem::path &path)
{
    Sheet sheet(static_cast<int>(places.size()), static_cast<int>(subjects.size()), thumbnail.width, thumbnail.height);
    for (int row = 0; const Subject &subject : subjects) {
        const auto scene = fractalText(subject.name, subject.depth).scene();
        frames.setScene(scene);
        for (int column = 0; const Place place : places) {
            View view = viewOf(subject.name, *scene, place, thumbnail, 1.0);
            view.samples = 8;
            frames.draw(view);
            sheet.put(column++, row, imageOf(frames.read()));
        }
        ++row;
    }
    save(withFewColours(sheet.image()), path);
}

/// From left to right: all copies with 16 samples a pixel, and one sample at 0, 1, 4 and 8 pixels; each pixel twice as large.
void writeTolerances(OurFrames &frames, const std::filesystem::path &path)
{
    constexpr int side = 160;
    const auto scene = fractalText("menger", 5).scene();
    frames.setScene(scene);
    Sheet sheet(5, 1, 2 * side, 2 * side);
    for (int column = 0; const double tolerance : {0.0, 0.0, 1.0, 4.0, 8.0}) {
        View view = viewOf("menger", *scene, Place::Far, {960, 540}, tolerance);
        view.samples = column == 0 ? 16 : 1;
        frames.draw(view);
        const QImage part = imageOf(frames.read()).copy((960 - side) / 2, (540 - side) / 2, side, side);
        sheet.put(column++, 0, part.scaled(2 * side, 2 * side));
    }
    save(sheet.image(), path);
}

}

void writePictures(OurFrames &frames, const std::vector<Subject> &subjects, const std::filesystem::path &folder)
{
    writePlaces(frames, subjects, folder / "rendering-places.png");
    writeTolerances(frames, folder / "rendering-tolerance.png");
}

}
