// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <span>

namespace romanesco {

/// How far a picture is off another, in sRGB, which is about as evenly spaced as the eye sees.
struct FrameError {
    /// The root of the mean square of the differences, of all pixels and colours, from 0 to 255.
    double rms = 0.0;
    /// Of the pixels, from 0 to 1: those of which a colour is off by more than `plain`.
    double share = 0.0;
    static constexpr int plain = 8;
};

/// Of two pictures of as many pixels, one or more, as FrameSource::pixels() gives them.
[[nodiscard]] FrameError errorOf(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> reference);

}
