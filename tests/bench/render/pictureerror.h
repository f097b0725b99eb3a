// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "render/renderer.h"

namespace romanesco::bench {

/// How far a picture is off another of the same size, in sRGB from 0 to 255.
struct PictureError {
    /// Of all pixels and colours: the absolute difference, and the root of the mean square.
    double mean = 0.0;
    double rms = 0.0;
    /// Of the pixels, those of which a colour is off by more than 16.
    double share = 0.0;
};

[[nodiscard]] PictureError errorOf(const Picture &picture, const Picture &reference);

}
