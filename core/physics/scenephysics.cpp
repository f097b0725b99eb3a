// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenephysics.h"

#include <algorithm>
#include <cmath>
#include <format>

#include <glm/geometric.hpp>

#include "core/scene/scenesearch.h"

namespace romanesco {

namespace {

using Kind = SceneDescription::Kind;

Ball ballOf(const SceneItem &item)
{
    Ball ball;
    ball.position = item.worldFromModel.translation;
    ball.velocity = item.velocity;
    ball.restitution = item.restitution;
    ball.radius = 0.0;
    for (const glm::dvec3 &vertex : item.model->mesh->vertices) {
        ball.radius = std::max(ball.radius, glm::length(item.worldFromModel.linear * vertex));
    }
    return ball;
}

}

std::expected<std::vector<Ball>, std::string> ballsOf(const Scene &scene)
{
    std::vector<Ball> balls;
    for (const SceneItem &item : scene.items) {
        if (item.kind != Kind::Ball) {
            continue;
        }
        balls.push_back(ballOf(item));
        if (!(balls.back().radius > 0.0 && std::isfinite(balls.back().radius))) {
            return std::unexpected(std::format("{}: a ball needs a radius above 0", item.path));
        }
    }
    return balls;
}

std::expected<Surface, std::string> surfaceOf(const std::shared_ptr<const Scene> &scene,
                                              const SceneCollider::Options &options, const std::stop_token &stop)
{
    double size = 0.0;
    for (const SceneItem &item : scene->items) {
        if (item.kind != Kind::Ball) {
            const Sphere sphere = boundingSphere(item);
            size = std::max(size, glm::length(sphere.centre) + std::max(sphere.radius, 0.0));
        }
    }
    return SceneCollider::create(scene, options, stop).transform([&](SceneCollider &&collider) {
        return Surface{std::make_shared<const SceneCollider>(std::move(collider)), provesClearance(options.kind), size,
                       provesClearance(options.kind) && options.kind != ColliderKind::Approximate};
    });
}

std::optional<BallContact> contactOf(const Surface &surface, const Ball &ball)
{
    SceneSearch search(static_cast<const SceneCollider &>(*surface.collider));
    Hit hit;
    search.closest({.p = ball.position, .radius = 2.0 * ball.radius}, hit);
    if (!hit.isFound()) {
        return std::nullopt;
    }
    return BallContact{search.item(), hit.face,      search.addressOf(hit),
                       hit.point,     hit.direction, ball.radius - hit.distance};
}

bool provesClearance(ColliderKind kind)
{
    return kind != ColliderKind::Greedy && kind != ColliderKind::Octree;
}

}
