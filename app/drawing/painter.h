// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include <QByteArray>

#include "render/headless/eglcontext.h"
#include "render/renderer.h"

namespace romanesco {

/// Draws pictures of one scene, without a display. On the thread that created it only.
class Painter
{
public:
    /// The error is a sentence.
    [[nodiscard]] static std::expected<Painter, std::string> create(std::shared_ptr<const Scene> scene);

    /// Asked some times a second with the samples that are finished, and at the start; false ends the drawing.
    using GoesOn = std::function<bool(int finishedSamples)>;
    /// The error is a sentence; "cancelled" where the drawing was ended.
    [[nodiscard]] std::expected<Picture, std::string> draw(const View &view, const GoesOn &goesOn);

    /// The picture that was drawn last, of a view that leaves out balls, with these. The error is a sentence.
    [[nodiscard]] std::expected<Picture, std::string> withBalls(std::span<const BallSprite> balls);

private:
    Painter() = default;

    [[nodiscard]] std::expected<Picture, std::string> read(std::span<const BallSprite> balls);

    /// Outlives what was made in it.
    std::unique_ptr<EglContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
    /// Of the last picture.
    int m_width = 0;
    int m_height = 0;
};

[[nodiscard]] QByteArray pngOf(const Picture &picture);

}
