// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/vec2.hpp>

#include "camera.h"
#include "core/scene/anchor.h"

namespace romanesco {

/// A camera moved by hand about a pivot: orbit, pan, zoom to the pointer, fit. Pointer positions are fractions of the
/// view's height from its middle, x right and y up (so the top edge is y = 0.5).
class OrbitCamera
{
public:
    /// Starts from a camera as it is. The pivot is the point of its axis that is nearest to the middle of the scene, or as
    /// far away as the scene is large where the camera has that behind it. A camera that is rolled stays so as it orbits.
    void start(const Camera &camera, const Sphere &nearby);
    /// Looks at the whole scene from the direction that the program starts with.
    void fit(const Scene &scene, double aspect);
    /// The same direction, the whole scene in view.
    void refit(const Scene &scene, double aspect);

    /// The same direction, a ball in view.
    void frame(const Sphere &ball, double aspect);

    /// Looks at the pivot in the given direction: yaw from forward (z) to the right (x), pitch upwards.
    void look(double yawDegrees, double pitchDegrees);

    /// Turns about the pivot; a full view's height of movement is half a turn. Pitch stays within ±90 degrees.
    void orbit(const glm::dvec2 &movement);
    /// Moves with the pointer, so that the pivot's plane stays under it.
    void pan(const glm::dvec2 &movement);
    /// Goes along with something that moves.
    void shift(const glm::dvec3 &way);
    /// Goes along the camera's own axes, in distances of the pivot, which stays as far ahead.
    void fly(const glm::dvec3 &way);
    /// Looks about from where it is; a full view's height of movement is half a turn.
    void turn(const glm::dvec2 &movement);
    /// Moves towards (factor < 1) or away from the point of the pivot's plane under the pointer, from a ten-thousandth
    /// of what is nearby in view to a million times the scene.
    void zoom(double factor, const glm::dvec2 &pointer);
    /// Perspective and orthographic, the pivot's plane kept at its size.
    void setProjection(Projection projection);

    /// The pivot goes to this distance along the camera's axis.
    void setPivotDistance(double distance);
    /// Counts everything from another place.
    void move(const Anchor::Move &move);
    /// The size of what is nearby, and whether that is the whole scene.
    void setNearby(double size, bool isWhole);

    [[nodiscard]] const Camera &camera() const { return m_camera; }
    [[nodiscard]] const glm::dvec3 &pivot() const { return m_pivot; }

private:
    [[nodiscard]] double distance() const;
    void setDirection(double yaw, double pitch);
    /// Height of the pivot's plane that is in view.
    [[nodiscard]] double planeHeight() const;

    Camera m_camera;
    glm::dvec3 m_pivot{0.0};
    double m_nearbySize = 0.0;
    bool m_isNearbyWhole = true;
    double m_yaw = 0.0;
    double m_pitch = 0.0;
    /// From the horizontal to the camera's right, towards up.
    double m_roll = 0.0;
};

}
