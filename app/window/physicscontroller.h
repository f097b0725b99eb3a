// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <atomic>
#include <memory>

#include <QObject>
#include <QTimer>

#include "core/physics/livesimulation.h"
#include "physicsactions.h"

class QAction;

namespace romanesco {

class BallDropper;
class PhysicsChoices;
class PhysicsPane;
class Viewport;

/// Lets the balls of what is seen fall: panel, actions and picture of a LiveSimulation. For the GUI thread.
class PhysicsController : public QObject
{
    Q_OBJECT
public:
    /// pane, viewport and dropper must outlive it.
    PhysicsController(const PhysicsActions &actions, PhysicsPane &pane, Viewport &viewport, BallDropper &dropper,
                      QObject *parent = nullptr);
    ~PhysicsController() override;

    /// What is seen is of another text: its balls are where that has them.
    void startScene(const std::shared_ptr<const Scene> &scene);
    /// The text has changed: balls that move go on, on what it says now.
    void setScene(const std::shared_ptr<const Scene> &scene);

    [[nodiscard]] LiveSimulation &simulation() { return m_simulation; }

Q_SIGNALS:
    /// In a line.
    void told(const QString &words);

private:
    void connectActions();
    void rain();
    void removeSelected();
    void takeFrame();
    void showBalls();
    [[nodiscard]] double sceneSize() const;

    PhysicsActions m_actions;
    PhysicsPane &m_pane;
    PhysicsChoices &m_choices;
    Viewport &m_viewport;
    BallDropper &m_dropper;
    std::shared_ptr<const Scene> m_scene;
    std::shared_ptr<const LiveSimulation::Frame> m_frame;
    std::vector<std::uint64_t> m_selected;
    std::uint64_t m_rains = 0;
    /// Runs while balls move: the picture has them where they are by then.
    QTimer m_drawing;
    std::atomic<bool> m_isFrameAnnounced = false;
    /// Last: it ends before the rest goes.
    LiveSimulation m_simulation;
};

}
