// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renderpictures.h"

#include "picturesheet.h"

namespace romanesco::bench {

namespace {

constexpr PictureSize thumbnail{224, 126};

void writePlaces(OurFrames &frames, const std::vector<Subject> &subjects, const std::filesystem::path &path)
{
    PictureSheet sheet(static_cast<int>(places.size()), static_cast<int>(subjects.size()), thumbnail.width,
                       thumbnail.height);
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
    PictureSheet sheet(5, 1, 2 * side, 2 * side);
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
