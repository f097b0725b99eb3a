// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdio>
#include <cstdlib>
#include <expected>
#include <memory>
#include <span>
#include <string>

#include "render/glresources.h"
#include "render/headless/eglcontext.h"
#include "render/renderer.h"

namespace romanesco::bench {

/// What is there; else ends the program with the error's words.
template<typename T>
T orEnd(std::expected<T, std::string> made)
{
    if (!made) {
        std::fprintf(stderr, "%s\n", made.error().c_str());
        std::exit(1);
    }
    return std::move(*made);
}

/// Renderer as a window has it: each picture goes into a target in sRGB. Makes a context of its own, which is current from
/// then on. Ends the program where something fails.
class OurFrames
{
public:
    void setScene(std::shared_ptr<const Scene> scene) { m_renderer->setScene(std::move(scene)); }

    /// Starts a picture, which draw() does too.
    void begin(const View &view);
    /// Draws what was begun, and waits for the card.
    void finish();
    void draw(const View &view);

    /// What was drawn, with balls where it was drawn without.
    [[nodiscard]] Picture read(std::span<const BallSprite> balls = {}) const { return m_renderer->read(balls); }
    [[nodiscard]] DrawStatistics statistics() const { return m_renderer->statistics(); }
    [[nodiscard]] std::string description() const { return m_renderer->description(); }

private:
    std::unique_ptr<EglContext> m_context = orEnd(EglContext::create());
    std::unique_ptr<Renderer> m_renderer = orEnd(Renderer::create());
    Target m_target;
};

}
