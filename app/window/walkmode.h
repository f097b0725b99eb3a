// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <stop_token>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "backgroundtask.h"
#include "core/physics/walker.h"
#include "core/scene/scene.h"

namespace romanesco {

class Viewport;

/// Walking about in a scene: the camera is a sphere that enters nothing, as large as suits what was ahead when it began, and
/// falls where there is gravity. For the GUI thread.
class WalkMode : public QObject
{
    Q_OBJECT
public:
    /// viewport must outlive it.
    explicit WalkMode(Viewport &viewport, QObject *parent = nullptr);
    ~WalkMode() override;

    void start();
    void stop();
    [[nodiscard]] bool isOn() const { return m_isOn; }

    /// What is walked in. Where the camera is stays.
    void setScene(const std::shared_ptr<const Scene> &scene);
    /// None for a walk that nothing pulls at.
    void setGravity(const glm::dvec3 &gravity);

Q_SIGNALS:
    /// It has ended by itself; a sentence says why.
    void ended(const QString &reason);

private:
    void findSurface();
    void takeSurface(const std::shared_ptr<const Surface> &surface);
    void begin();
    void walk(const glm::dvec3 &way);
    void fall();
    void go(const glm::dvec3 &way, double seconds);

    Viewport &m_viewport;
    bool m_isOn = false;
    std::shared_ptr<const Scene> m_scene;
    std::shared_ptr<const Surface> m_surface;
    std::optional<Walker> m_walker;
    /// Of the world, for a distance of what was ahead.
    double m_pace = 0.0;
    glm::dvec3 m_gravity{0.0};
    /// Runs while it falls.
    QTimer m_falling;
    QElapsedTimer m_sinceFall;
    /// What is found is wanted no more.
    std::stop_source m_stop;
    /// Last.
    BackgroundTask<std::expected<std::shared_ptr<const Surface>, std::string>> m_finding;
};

}
