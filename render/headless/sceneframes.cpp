// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneframes.h"

#include <algorithm>
#include <chrono>
#include <format>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

#include "render/sceneview.h"

namespace romanesco {

namespace {

/// How far ahead of a place near the surface is, in parts of what it was.
constexpr double nearShare = 1.0 / 16.0;
/// Rays that look for it go through so many points of the view on either side of its middle, each way.
constexpr int raysToASide = 8;

/// Points of a view, from the middle outwards.
std::vector<glm::dvec2> pointers(double aspect)
{
    std::vector<glm::dvec2> points;
    for (int y = -raysToASide; y <= raysToASide; ++y) {
        for (int x = -raysToASide; x <= raysToASide; ++x) {
            points.emplace_back(0.5 * aspect * x / raysToASide, 0.5 * y / raysToASide);
        }
    }
    std::ranges::stable_sort(points, {}, [](const glm::dvec2 &point) { return glm::dot(point, point); });
    return points;
}

void goNear(SceneView &view, const std::shared_ptr<const Scene> &scene, double aspect)
{
    auto walk = SceneRayWalk::create(scene);
    if (!walk) {
        return; // a mesh too large for rays is drawn from where it was
    }
    view.setRayWalk(std::make_shared<SceneRayWalk>(std::move(*walk)));
    const std::vector<glm::dvec2> points = pointers(aspect);
    const auto seen =
        std::ranges::find_if(points, [&](const glm::dvec2 &point) { return view.pick(point, 1e-3).has_value(); });
    if (seen != points.end()) {
        view.zoom(nearShare, *seen);
    }
}

}

SceneFrames::SceneFrames(std::shared_ptr<const Scene> scene, int width, int height)
    : m_scene(std::move(scene))
    , m_width(width)
    , m_height(height)
{
}

std::expected<std::unique_ptr<SceneFrames>, std::string> SceneFrames::create(std::shared_ptr<const Scene> scene,
                                                                             int width, int height)
{
    auto frames = std::unique_ptr<SceneFrames>(new SceneFrames(std::move(scene), width, height));
    auto context = EglContext::create();
    if (!context) {
        return std::unexpected(context.error());
    }
    frames->m_context = std::move(*context);
    auto renderer = Renderer::create();
    if (!renderer) {
        return std::unexpected(renderer.error());
    }
    frames->m_renderer = std::move(*renderer);
    frames->m_renderer->setScene(frames->m_scene);
    return frames;
}

const View &SceneFrames::viewFrom(FramePlace place)
{
    std::optional<View> &known = m_views[static_cast<std::size_t>(place)];
    if (!known) {
        const double aspect = double(m_width) / m_height;
        SceneView from;
        from.setScene(m_scene);
        from.start(aspect);
        if (place == FramePlace::Near) {
            goNear(from, m_scene, aspect);
        }
        known.emplace();
        known->camera = from.camera();
        known->surroundings = from.surroundings();
        known->width = m_width;
        known->height = m_height;
    }
    return *known;
}

std::expected<FrameCost, std::string> SceneFrames::draw(const FrameRequest &request, const std::stop_token &stop)
{
    View view = viewFrom(request.place);
    view.pixelTolerance = request.pixelTolerance;
    view.samples = request.samples;
    view.standsAlone = request.standsAlone;
    glFinish();
    const auto begin = std::chrono::steady_clock::now();
    m_renderer->begin(view);
    for (bool isFinished = false; !isFinished; isFinished = m_renderer->step(std::chrono::milliseconds(100))) {
        // before each picture too, of which a trial has many
        if (stop.stop_requested()) {
            return std::unexpected("cancelled");
        }
    }
    if (!m_renderer->error().empty()) {
        return std::unexpected(m_renderer->error());
    }
    glFinish();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const DrawStatistics drawn = m_renderer->statistics();
    return FrameCost{took.count(), drawn.instances, drawn.faces, drawn.statesVisited,
                     drawn.bufferBytes + drawn.graphBytes};
}

std::expected<std::vector<std::uint8_t>, std::string> SceneFrames::pixels()
{
    Picture picture = m_renderer->read();
    if (!m_renderer->error().empty()) {
        return std::unexpected(m_renderer->error());
    }
    if (picture.pixels.empty()) {
        return std::unexpected(
            std::format("The graphics driver has no room for a picture of {}x{}.", m_width, m_height));
    }
    return std::move(picture.pixels);
}

}
