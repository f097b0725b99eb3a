// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <expected>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "appearance.h"
#include "ballsprite.h"
#include "camera.h"
#include "core/scene/anchor.h"

namespace romanesco {

/// One picture: from where, how large, how exact.
struct View {
    /// In the coordinates of the place that surroundings tell of, or the world's.
    Camera camera;
    /// Null, or of another scene than the one that is drawn: the whole scene as it stands in the world.
    std::shared_ptr<const Surroundings> surroundings{};
    int width = 0;
    int height = 0;
    /// Copies whose bound is smaller than this on the screen are drawn as one; 0 draws every instance of the depth.
    double pixelTolerance = 1.0;
    /// Pictures with shifted pixels that are averaged; 1 is exactly the pixel centre.
    int samples = 1;
    Appearance appearance{};
    /// The balls of the scene are left out, and presentBalls() can draw others.
    bool leavesOutBalls = false;
    /// Copies behind all that is drawn are not sent, which no pixel shows; otherwise all are, to measure what that is worth.
    bool leavesOutHidden = true;
    /// Nothing is taken from the picture before, not even a guess of what is hidden: equal views make equal pictures, where
    /// surfaces coincide too.
    bool standsAlone = false;
    /// sRGB, 0 to 1: a gradient from the top edge to the bottom edge.
    std::array<float, 3> backgroundTop{0.13f, 0.14f, 0.17f};
    std::array<float, 3> backgroundBottom{0.06f, 0.06f, 0.08f};
};

/// Rows from the top, 8 bits each of red, green, blue in sRGB.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// What the last finished pass over the scene took.
struct DrawStatistics {
    std::uint64_t instances = 0;
    std::uint64_t faces = 0;
    std::uint64_t statesVisited = 0;
    /// Own buffers, on the graphics card and off it, without the picture's.
    std::size_t bufferBytes = 0;
    std::size_t graphBytes = 0;
    double milliseconds = 0.0;
};

/// Draws scenes with OpenGL 4.5 into framebuffers of its own. Works in slices, so that a window stays alive however
/// long a picture takes. Every call needs the context current in which it was created, its destructor too.
class Renderer
{
public:
    /// The error is a sentence that says what the current context lacks.
    [[nodiscard]] static std::expected<std::unique_ptr<Renderer>, std::string> create();
    ~Renderer();
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    /// What the next begin() draws; null for nothing but the background. Meshes that stay are not uploaded again.
    void setScene(std::shared_ptr<const Scene> scene);

    /// Starts a picture and drops the one under way. What was finished stays to be presented until the first sample of
    /// the new picture is.
    void begin(const View &view);

    /// Draws on for about the given time, at least a little; whether the picture is finished.
    bool step(std::chrono::milliseconds budget);

    [[nodiscard]] bool isFinished() const;
    /// Why the picture under way cannot be drawn (no memory for it), as a sentence; empty while all is well.
    [[nodiscard]] const std::string &error() const;
    /// The driver was reset: nothing more can be drawn. Only another renderer may help, in another context.
    [[nodiscard]] bool isLost() const;
    /// Samples of the picture under way that are finished: from 1 on present() shows it.
    [[nodiscard]] int finishedSamples() const;

    /// Puts the average of the finished samples into a framebuffer (0 for a window's own), scaled to width x height.
    void present(unsigned framebuffer, int width, int height);

    /// Over that, what is seen of balls from where the shown picture was taken; nothing where that has all its own balls. The
    /// error is a sentence.
    [[nodiscard]] std::expected<void, std::string> presentBalls(unsigned framebuffer, int width, int height,
                                                                std::span<const BallSprite> balls);

    /// The same, with balls or without, off the card, at its own size. Waits for the card. Without pixels where there is nothing
    /// to show, or no memory for it.
    [[nodiscard]] Picture read(std::span<const BallSprite> balls = {});

    [[nodiscard]] DrawStatistics statistics() const;
    /// "OpenGL 4.5, llvmpipe (…)".
    [[nodiscard]] std::string description() const;

private:
    class Private;
    explicit Renderer(std::unique_ptr<Private> p);
    std::unique_ptr<Private> d;
};

}
