// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace romanesco {

/// Where a scene is drawn from.
enum class FramePlace {
    View, ///< as it is looked at first: the view that is saved in it, its camera, or all of it
    Near, ///< from there towards what is seen nearest to the middle, until a sixteenth of the way is left
};

/// In the order of their numbers.
inline constexpr std::array<std::string_view, 2> framePlaceNames{"view", "near"};

[[nodiscard]] constexpr std::string_view nameOf(FramePlace place)
{
    return framePlaceNames[static_cast<std::size_t>(place)];
}

/// A picture to be drawn.
struct FrameRequest {
    FramePlace place = FramePlace::View;
    /// Copies that are smaller on the screen are drawn as one; 0 draws all.
    double pixelTolerance = 1.0;
    /// A pixel; 1 is its middle.
    int samples = 1;
    /// Else it may learn from the picture before what is hidden, as a window does whose camera hardly moves.
    bool standsAlone = true;
};

/// What the last sample of a picture took, and the picture.
struct FrameCost {
    /// All samples, until the card has drawn them.
    double seconds = 0.0;
    std::uint64_t copies = 0;
    std::uint64_t faces = 0;
    /// Of the graph.
    std::uint64_t statesVisited = 0;
    /// The drawing's own buffers, on the graphics card and off it, and the graph; without the picture's.
    std::size_t bytes = 0;

    [[nodiscard]] std::uint64_t operations() const { return faces + 2 * (copies + statesVisited); }
};

/// Draws pictures of a scene, all of one size. One thread.
class FrameSource
{
public:
    virtual ~FrameSource() = default;

    /// What draws: "OpenGL 4.5, llvmpipe (…)".
    [[nodiscard]] virtual std::string description() const = 0;

    /// Equal pictures that stand alone are alike to the last bit, and so is what they cost, but for the seconds. The error
    /// is a sentence; "cancelled" once a stop is asked for, which is heard within some tenths of a second.
    [[nodiscard]] virtual std::expected<FrameCost, std::string> draw(const FrameRequest &request,
                                                                     const std::stop_token &stop) = 0;

    /// What was drawn last: rows from the top, 8 bits each of red, green, blue in sRGB. The error is a sentence.
    [[nodiscard]] virtual std::expected<std::vector<std::uint8_t>, std::string> pixels() = 0;
};

}
