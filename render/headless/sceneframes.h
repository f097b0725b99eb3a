// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/measure/framesource.h"
#include "core/scene/scene.h"
#include "eglcontext.h"
#include "render/renderer.h"

namespace romanesco {

/// Draws pictures of a scene to measure them, without a window or a display. On the thread that created it only, whose
/// context it makes its own.
class SceneFrames final : public FrameSource
{
public:
    /// The error is a sentence: see EglContext and Renderer.
    [[nodiscard]] static std::expected<std::unique_ptr<SceneFrames>, std::string>
    create(std::shared_ptr<const Scene> scene, int width, int height);

    [[nodiscard]] std::string description() const override { return m_renderer->description(); }
    [[nodiscard]] std::expected<FrameCost, std::string> draw(const FrameRequest &request,
                                                             const std::stop_token &stop) override;
    [[nodiscard]] std::expected<std::vector<std::uint8_t>, std::string> pixels() override;

private:
    SceneFrames(std::shared_ptr<const Scene> scene, int width, int height);

    /// Found out when it is first asked for; of a place near costs a ray walk's making.
    [[nodiscard]] const View &viewFrom(FramePlace place);

    std::shared_ptr<const Scene> m_scene;
    int m_width;
    int m_height;
    /// By place.
    std::array<std::optional<View>, framePlaceNames.size()> m_views;
    /// Outlives what was made in it.
    std::unique_ptr<EglContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
};

}
