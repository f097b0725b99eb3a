// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include "core/formats/fdomodel.h"
#include "render/camera.h"

namespace romanesco {

/// What a gizmo changes; in the order of a transformation's parts.
enum class GizmoKind { Move, Rotate, Scale };

/// Where something stands: its transformation, in the frame that this places it in.
struct GizmoFrame {
    /// To the coordinates of the camera.
    AffineMap hereFromParent;
    TransformParts parts;
};

/// Something to take hold of, which changes one component of the vector of its kind, or all three alike.
struct GizmoHandle {
    static constexpr int all = 3;
    /// 0, 1, 2 for x, y, z; or all.
    int axis = 0;
    /// In the coordinates of the camera: from what stands there out, or all round it.
    std::vector<glm::dvec3> line;
};

/// The handles, about so large, in the coordinates of the camera. Those of a direction in which the frame has no extent are
/// left out. A ring turns about what one angle turns about, given those before it, so it changes that angle alone.
[[nodiscard]] std::vector<GizmoHandle> gizmoHandles(GizmoKind kind, const GizmoFrame &frame, double size);

/// How far the point of a handle's line goes on the screen, in heights of the view, when its component (a scale's as a
/// share of itself) grows by one.
[[nodiscard]] glm::dvec2 gizmoSpeed(GizmoKind kind, const GizmoFrame &frame, const GizmoHandle &handle,
                                    std::size_t point, const Camera &camera);

/// The vector of a kind after its handle was dragged so far, in heights of the view, from where it was at that speed.
[[nodiscard]] glm::dvec3 gizmoDragged(GizmoKind kind, const TransformParts &parts, int axis, const glm::dvec2 &speed,
                                      const glm::dvec2 &way);

/// The vector of a kind.
[[nodiscard]] const glm::dvec3 &gizmoVector(GizmoKind kind, const TransformParts &parts);

}
