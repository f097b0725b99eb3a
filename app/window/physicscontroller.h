// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "contactinspector.h"
#include "core/physics/livesimulation.h"
#include "physicsactions.h"
#include "recordings.h"
#include "render/ballsprite.h"
#include "walkmode.h"

class QAction;

namespace romanesco {

class BallDropper;
class PhysicsChoices;
class PhysicsPane;
class TextTab;
class Viewport;

/// Lets the balls of what is seen fall: panel, actions and picture of a LiveSimulation. For the GUI thread.
class PhysicsController : public QObject
{
    Q_OBJECT
public:
    /// window owns it; pane, viewport and dropper must outlive it.
    PhysicsController(const PhysicsActions &actions, PhysicsPane &pane, Viewport &viewport, BallDropper &dropper,
                      QWidget &window);
    ~PhysicsController() override;

    /// Another text is seen: its balls are where that has them.
    void start(TextTab &seen);
    /// The text has changed: balls that move go on, on what it says now.
    void update();

    /// Those that are there now, in the world; nothing while all are where the scene has them.
    [[nodiscard]] std::optional<std::vector<Ball>> balls() const;

    [[nodiscard]] ContactInspector &inspector() { return m_inspector; }

Q_SIGNALS:
    /// In a line.
    void told(const QString &words);
    /// Which collider balls fall by, and what it promises, in short; empty where none are there.
    void colliderChanged(const QString &words);

private:
    void connectActions();
    void rain();
    void removeSelected();
    void keep();
    void follow(const std::vector<BallSprite> &sprites);
    void connectWalking();
    void setWalkGravity();
    void takeFrame();
    void showBalls();
    [[nodiscard]] double sceneSize() const;
    [[nodiscard]] Ball ballFor(double seen) const;
    void warnOfFall(const Ball &ball, const std::optional<ScenePlace> &place);

    PhysicsActions m_actions;
    PhysicsPane &m_pane;
    PhysicsChoices &m_choices;
    Viewport &m_viewport;
    BallDropper &m_dropper;
    TextTab *m_seen = nullptr;
    std::shared_ptr<const Scene> m_scene;
    std::shared_ptr<const LiveSimulation::Frame> m_frame;
    std::vector<std::uint64_t> m_selected;
    std::uint64_t m_rains = 0;
    /// Where the ball was that the camera goes along with.
    std::optional<BallSprite> m_followed;
    ContactInspector m_inspector;
    WalkMode m_walkMode;
    /// Runs while balls move: the picture has them where they are by then.
    QTimer m_drawing;
    std::atomic<bool> m_isFrameAnnounced = false;
    Recordings m_recordings;
    /// Last: its thread ends before the rest goes.
    LiveSimulation m_simulation;
};

}
