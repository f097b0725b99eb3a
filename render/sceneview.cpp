// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneview.h"

#include <utility>

namespace romanesco {

void SceneView::setScene(std::shared_ptr<const Scene> scene)
{
    m_scene = std::move(scene);
    if (!m_scene) {
        m_anchor.reset();
        m_surroundings.reset();
        return;
    }
    if (m_anchor) {
        for (const Anchor::Move &move : m_anchor->moveTo(m_scene)) {
            m_orbit.move(move);
        }
    } else {
        m_anchor.emplace(m_scene);
    }
    follow();
    settle();
}

void SceneView::start(double aspect)
{
    toWorld();
    if (m_scene->camera) {
        m_orbit.start(cameraOf(*m_scene->camera), *m_scene);
    } else {
        m_orbit.fit(*m_scene, aspect);
    }
    follow();
}

void SceneView::refit(double aspect)
{
    toWorld();
    m_orbit.refit(*m_scene, aspect);
    follow();
}

void SceneView::toWorld()
{
    m_anchor.emplace(m_scene);
    settle();
}

void SceneView::look(double yawDegrees, double pitchDegrees)
{
    m_orbit.look(yawDegrees, pitchDegrees);
    follow();
}

void SceneView::orbit(const glm::dvec2 &movement)
{
    m_orbit.orbit(movement);
    follow();
}

void SceneView::pan(const glm::dvec2 &movement)
{
    m_orbit.pan(movement);
    follow();
}

void SceneView::zoom(double factor, const glm::dvec2 &pointer)
{
    m_orbit.zoom(factor, pointer);
    follow();
}

void SceneView::setProjection(Projection projection)
{
    m_orbit.setProjection(projection);
    follow();
}

/// What is near a camera is what it stands at; of an orthographic one, which stands nowhere, what is in the middle of the
/// view and as large.
void SceneView::follow()
{
    if (!m_anchor) {
        return;
    }
    const Camera &camera = m_orbit.camera();
    const bool isPerspective = camera.projection == Projection::Perspective;
    const auto moves = m_anchor->follow(isPerspective ? camera.position : m_orbit.pivot(),
                                        isPerspective ? 0.0 : 0.5 * camera.viewHeight);
    for (const Anchor::Move &move : moves) {
        m_orbit.move(move);
    }
    if (!moves.empty()) {
        settle();
    }
}

void SceneView::settle()
{
    m_surroundings = m_anchor->surroundings();
    m_orbit.setNearby(2.0 * m_surroundings->nearby.radius, m_anchor->isInWorld());
}

}
