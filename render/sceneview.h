// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/anchor.h"
#include "core/scene/sceneraywalk.h"
#include "orbitcamera.h"

namespace romanesco {

/// A camera in a scene, moved by hand, as far inside as there are levels: it is counted from the node that is near
/// (see Anchor), which changes as it moves. Pointer positions as OrbitCamera has them. One thread.
class SceneView
{
public:
    /// The camera stays where it is; deep inside, at the node that the same steps lead to in the new scene, or as far
    /// along them as they go. Null shows nothing.
    void setScene(std::shared_ptr<const Scene> scene);

    /// The view that a scene begins with: the one that was saved, as far as the way to it is there; or from its own camera;
    /// or all of it, which is told.
    bool start(double aspect);
    /// From a camera in the world.
    void start(const Camera &camera);
    /// All of the scene, from where the camera looks now.
    void refit(double aspect);

    /// All that some steps from the root of an item lead to, from where the camera looks now; false where there is no such
    /// way, or nothing at its end.
    bool goTo(std::size_t item, std::span<const Step> steps, double aspect);

    // As OrbitCamera's.
    void look(double yawDegrees, double pitchDegrees);
    void orbit(const glm::dvec2 &movement);
    void pan(const glm::dvec2 &movement);
    void turn(const glm::dvec2 &movement);
    /// In the world.
    void shift(const glm::dvec3 &way);
    /// In distances of the surface ahead, where there is one and it can be found.
    void fly(const glm::dvec3 &way);
    /// Towards or away from the surface under the pointer, where there is one and it can be found.
    void zoom(double factor, const glm::dvec2 &pointer);
    void setProjection(Projection projection);

    /// With a number, what is seen is the dissertation's dynamic fractals with so long a trail (see dynamicSurroundings()),
    /// and the view is counted from the world.
    void setTrail(std::optional<std::size_t> trail);
    [[nodiscard]] const std::optional<std::size_t> &trail() const { return m_trail; }

    /// Lets surfaces be found under the pointer; of another scene than the one that is looked at it is of no use.
    void setRayWalk(std::shared_ptr<SceneRayWalk> walk) { m_walk = std::move(walk); }
    [[nodiscard]] bool hasRayWalk() const { return m_walk && m_walk->scene() == m_scene; }

    /// The copy under the pointer.
    struct Picked {
        std::size_t item = 0;
        /// From the item's root.
        std::vector<Step> steps;
        /// Along the camera's axis, in the coordinates of surroundings().
        double distance = 0.0;
        /// Of the surface, in the same coordinates; the normal, of length 1, against the camera.
        glm::dvec3 point{0.0};
        glm::dvec3 normal{0.0};
        /// How far off the point may be, by rounding.
        double error = 0.0;
    };
    /// Copies narrower than a share of the view's height are found as they are drawn, several as one; with 0, each by itself.
    /// Costs microseconds.
    [[nodiscard]] std::optional<Picked> pick(const glm::dvec2 &pointer, double share) const;

    /// A place in the scene that stays where it is while the camera is counted from one node after another.
    struct Mark {
        /// In the coordinates of surroundings().
        glm::dvec3 point{0.0};
        /// How far off that may be, by rounding on the way.
        double error = 0.0;
    };
    /// Those of the scene as it is; another has none.
    [[nodiscard]] const std::vector<Mark> &marks() const { return m_marks; }
    /// As pick() finds a point.
    void mark(const glm::dvec3 &point, double error) { m_marks.push_back({point, error}); }
    void clearMarks() { m_marks.clear(); }

    /// To begin with another time; there is a scene. Counted from the world as long as its coordinates are exact enough. The
    /// depth is the text's.
    [[nodiscard]] SavedView saved() const;
    /// As exactly as the world's coordinates can say.
    [[nodiscard]] Camera cameraInWorld() const;

    /// In the coordinates of surroundings().
    [[nodiscard]] const Camera &camera() const { return m_orbit.camera(); }
    [[nodiscard]] const glm::dvec3 &pivot() const { return m_orbit.pivot(); }
    /// Null without a scene.
    [[nodiscard]] const std::shared_ptr<const Surroundings> &surroundings() const { return m_surroundings; }

private:
    void toWorld();
    void move(const Anchor::Move &move);
    void countMarksFromHere();
    [[nodiscard]] bool enter(std::size_t item, std::span<const Step> steps);
    [[nodiscard]] bool startFrom(const SavedView &view);
    void follow();
    void settle();

    std::shared_ptr<const Scene> m_scene;
    std::optional<Anchor> m_anchor;
    std::optional<std::size_t> m_trail;
    std::shared_ptr<const Surroundings> m_surroundings;
    OrbitCamera m_orbit;
    std::shared_ptr<SceneRayWalk> m_walk;
    std::vector<Mark> m_marks;
};

}
