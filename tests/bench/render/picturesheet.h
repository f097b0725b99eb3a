// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>

#include <QImage>

#include "render/renderer.h"

namespace romanesco::bench {

[[nodiscard]] QImage imageOf(const Picture &picture);

/// Pictures of one size in rows, on white.
class PictureSheet
{
public:
    PictureSheet(int columns, int rows, int width, int height);

    void put(int column, int row, const QImage &picture);

    [[nodiscard]] const QImage &image() const { return m_image; }

private:
    QImage m_image;
};

/// With colours a few steps apart, 256 at most, so that a file of it takes a third of the bytes.
[[nodiscard]] QImage withFewColours(const QImage &image);

/// Ends the program where it cannot be written.
void save(const QImage &image, const std::filesystem::path &path);

}
