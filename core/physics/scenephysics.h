// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "ball.h"
#include "core/scene/scenecollider.h"
#include "surface.h"

namespace romanesco {

/// The balls of a scene, in the order of its text. Each is a sphere, whatever its mesh: the centre is where its place puts the
/// mesh's origin, the radius reaches to the vertex that is farthest from there (4.3.3 of the dissertation). The error is
/// a sentence: of a ball without extent.
[[nodiscard]] std::expected<std::vector<Ball>, std::string> ballsOf(const Scene &scene);

/// All that is no ball. The error is SceneCollider's.
[[nodiscard]] std::expected<Surface, std::string> surfaceOf(const std::shared_ptr<const Scene> &scene,
                                                            const SceneCollider::Options &options,
                                                            const std::stop_token &stop = {});

/// What a ball is nearest to.
struct BallContact {
    std::size_t item = 0;
    /// Of the item's base mesh, in the copy with this address.
    std::uint32_t face = 0;
    Address address;
    glm::dvec3 point{0.0};
    /// From there to the centre, of length 1.
    glm::dvec3 normal{0.0};
    /// How far the ball reaches in; negative for a gap.
    double overlap = 0.0;
};

/// By a surface that surfaceOf() made; nothing where none is within twice the radius. Costs some microseconds.
[[nodiscard]] std::optional<BallContact> contactOf(const Surface &surface, const Ball &ball);

/// Whether a kind of collider proves that nothing is nearer than it says: else balls may go through the surface.
[[nodiscard]] bool provesClearance(ColliderKind kind);

}
