// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "ballframes.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "app/drawing/ballcolours.h"
#include "colliderchoice.h"
#include "output.h"
#include "picturesize.h"
#include "render/sceneview.h"

namespace romanesco::cli {

namespace {

constexpr int samples = 8;
constexpr double mostPerSecond = 1e6;

}

BallFrames::Options::Options()
    : m_size(sizeOption())
{
}

std::optional<BallFrames::Choice> BallFrames::Options::chosen(const QCommandLineParser &parser) const
{
    const auto names = FramePattern::parse(parser.value(m_render));
    if (!names) {
        complain(QStringLiteral("--render %1 is not a pattern: %2").arg(parser.value(m_render), names.error()));
        return std::nullopt;
    }
    const auto size = pictureSize(parser);
    if (!size) {
        return std::nullopt;
    }
    const auto perSecond = numberOf(parser, m_perSecond);
    if (!perSecond || *perSecond <= 0.0 || *perSecond > mostPerSecond) {
        complain(QStringLiteral("--fps takes a number above 0, not \"%1\"").arg(parser.value(m_perSecond)));
        return std::nullopt;
    }
    return Choice{*names, size->width(), size->height(), *perSecond};
}

BallFrames::BallFrames(const Choice &choice, Painter painter)
    : m_choice(choice)
    , m_painter(std::move(painter))
{
}

std::expected<BallFrames, std::string> BallFrames::create(const Choice &choice,
                                                          const std::shared_ptr<const Scene> &scene)
{
    auto painter = Painter::create(scene);
    if (!painter) {
        return std::unexpected(painter.error());
    }
    SceneView from;
    from.setScene(scene);
    from.start(double(choice.width) / choice.height);
    View view;
    view.camera = from.camera();
    view.surroundings = from.surroundings();
    view.width = choice.width;
    view.height = choice.height;
    view.samples = samples;
    view.standsAlone = true;
    view.leavesOutBalls = true;
    const auto drawn = painter->draw(view, [](int) { return !isCancelled(); });
    if (!drawn) {
        return std::unexpected(drawn.error());
    }
    return BallFrames(choice, std::move(*painter));
}

bool BallFrames::take(const Simulation &simulation)
{
    const World &world = simulation.world();
    const std::span<const BallState> balls = world.balls();
    const double timeStep = world.options().laws.timeStep;
    const double now = static_cast<double>(world.stepCount()) * timeStep;
    for (double due = m_next / m_choice.perSecond; due <= now; due = ++m_next / m_choice.perSecond) {
        const double share = world.stepCount() == 0 ? 1.0 : std::clamp(1.0 - (now - due) / timeStep, 0.0, 1.0);
        std::vector<BallSprite> sprites;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            sprites.push_back({glm::mix(simulation.before()[i], balls[i].position, share), balls[i].radius,
                               ballColour(i), simulation.places().surroundings(balls[i].place)});
        }
        const auto picture = m_painter.withBalls(sprites);
        if (!picture) {
            complain(QString::fromStdString(picture.error()));
            return false;
        }
        if (!writeWhole(m_choice.names.name(m_next), pngOf(*picture))) {
            return false;
        }
    }
    return true;
}

}
