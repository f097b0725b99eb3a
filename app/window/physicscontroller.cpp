// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "physicscontroller.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QAction>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/drawing/ballcolours.h"
#include "balldropper.h"
#include "ballkeeper.h"
#include "core/physics/ballplaces.h"
#include "core/physics/rain.h"
#include "physicschoices.h"
#include "physicsfigures.h"
#include "physicspane.h"
#include "texttab.h"
#include "viewport.h"

namespace romanesco {

namespace {

constexpr int millisecondsAPicture = 16;

/// Balls are not larger, in parts of the height that is seen.
constexpr double mostOfView = 0.25;
constexpr double mostRadiiAStep = 10.0;

constexpr std::array<float, 3> selectedColour{1.0f, 1.0f, 1.0f};

}

PhysicsController::PhysicsController(const PhysicsActions &actions, PhysicsPane &pane, Viewport &viewport,
                                     BallDropper &dropper, QWidget &window)
    : QObject(&window)
    , m_actions(actions)
    , m_pane(pane)
    , m_choices(pane.choices())
    , m_viewport(viewport)
    , m_dropper(dropper)
    , m_frame(std::make_shared<const LiveSimulation::Frame>())
    , m_inspector(viewport)
    , m_walkMode(viewport)
    , m_recordings(window, m_simulation)
    , m_simulation([this] {
        if (!m_isFrameAnnounced.exchange(true)) {
            QMetaObject::invokeMethod(this, &PhysicsController::takeFrame, Qt::QueuedConnection);
        }
    })
{
    m_drawing.setInterval(millisecondsAPicture);
    m_drawing.setTimerType(Qt::PreciseTimer);
    connect(&m_drawing, &QTimer::timeout, this, &PhysicsController::showBalls);
    m_dropper.setDrop([this](double seen) { return BallDropper::Drop{ballFor(seen), m_choices.rules().laws.gravity}; });
    connect(&m_dropper, &BallDropper::dropped, this, [this](const Ball &ball, const std::optional<ScenePlace> &place) {
        m_simulation.drop({ball}, m_choices.colour(), place);
        warnOfFall(ball, place);
        // Who holds balls where they are may place others among them.
        if (!m_frame->isStarted) {
            m_simulation.play();
        }
    });
    connect(&m_dropper, &BallDropper::told, this, &PhysicsController::told);
    connect(&m_choices, &PhysicsChoices::rulesChanged, this, [this] { m_simulation.setRules(m_choices.rules()); });
    connect(&m_choices, &PhysicsChoices::colliderChanged, this,
            [this] { m_simulation.setCollider(m_choices.collider()); });
    connect(&m_choices, &PhysicsChoices::speedChanged, this, [this] { m_simulation.setSpeed(m_choices.speed()); });
    connect(&m_pane.figures(), &PhysicsFigures::selectionChanged, this, [this] {
        m_selected = m_pane.figures().selectedBalls();
        m_actions.removeBall->setEnabled(!m_selected.empty());
        showBalls();
    });
    connectActions();
    connectWalking();
    m_pane.figures().show(m_frame);
}

PhysicsController::~PhysicsController() = default;

void PhysicsController::connectActions()
{
    connect(m_actions.play, &QAction::triggered, this,
            [this](bool isWanted) { isWanted ? m_simulation.play() : m_simulation.pause(); });
    connect(m_actions.step, &QAction::triggered, this, [this] { m_simulation.step(); });
    connect(m_actions.reset, &QAction::triggered, this, [this] { m_simulation.reset(); });
    connect(m_actions.rain, &QAction::triggered, this, &PhysicsController::rain);
    connect(m_actions.removeBall, &QAction::triggered, this, &PhysicsController::removeSelected);
    connect(m_actions.follow, &QAction::toggled, this, [this] { m_followed.reset(); });
    connect(m_actions.keepBalls, &QAction::triggered, this, &PhysicsController::keep);
    connect(m_actions.record, &QAction::triggered, &m_recordings, &Recordings::save);
    connect(m_actions.replay, &QAction::triggered, &m_recordings, &Recordings::open);
    connect(&m_recordings, &Recordings::told, this, &PhysicsController::told);
    m_actions.removeBall->setEnabled(false);
    m_pane.figures().addActions({m_actions.follow, m_actions.removeBall});
}

void PhysicsController::connectWalking()
{
    connect(m_actions.walk, &QAction::toggled, this,
            [this](bool isWanted) { isWanted ? m_walkMode.start() : m_walkMode.stop(); });
    connect(m_actions.walkFalling, &QAction::toggled, this, &PhysicsController::setWalkGravity);
    connect(&m_choices, &PhysicsChoices::rulesChanged, this, &PhysicsController::setWalkGravity);
    connect(&m_walkMode, &WalkMode::ended, this, [this](const QString &reason) {
        m_actions.walk->setChecked(false);
        Q_EMIT told(reason);
    });
    setWalkGravity();
}

void PhysicsController::setWalkGravity()
{
    m_walkMode.setGravity(m_actions.walkFalling->isChecked() ? m_choices.rules().laws.gravity : glm::dvec3(0.0));
}

void PhysicsController::start(TextTab &seen)
{
    m_seen = &seen;
    m_scene = seen.shown();
    m_simulation.startScene(m_scene);
    m_walkMode.setScene(m_scene);
}

void PhysicsController::update()
{
    if (m_seen->shown() != m_scene) {
        m_scene = m_seen->shown();
        m_simulation.setScene(m_scene);
        m_walkMode.setScene(m_scene);
    }
}

std::optional<std::vector<Ball>> PhysicsController::balls() const
{
    if (!m_frame->isStarted) {
        return std::nullopt;
    }
    std::vector<Ball> balls;
    balls.reserve(m_frame->balls.size());
    for (const LiveSimulation::BallFrame &ball : m_frame->balls) {
        balls.push_back(inWorld({ball.after, ball.velocity, ball.radius, ball.restitution},
                                m_frame->places[ball.place].surroundings.get()));
    }
    return balls;
}

/// The longest side of the box round it.
double PhysicsController::sceneSize() const
{
    const glm::dvec3 size = m_scene ? m_scene->extent.size() : glm::dvec3(0.0);
    const double longest = std::max({size.x, size.y, size.z});
    return longest > 0.0 ? longest : 1.0;
}

/// A share of the scene's size; of what is seen, where that is small beside it.
Ball PhysicsController::ballFor(double seen) const
{
    const Ball ball = m_choices.ball(sceneSize());
    return ball.radius > mostOfView * seen ? m_choices.ball(seen) : ball;
}

/// What falls so far in a step is not seen to fall.
void PhysicsController::warnOfFall(const Ball &ball, const std::optional<ScenePlace> &place)
{
    const Laws laws = m_choices.rules().laws;
    const double unit = place ? std::exp2(m_viewport.view().surroundings()->unitExponent) : 1.0;
    if (!laws.isGravityInRadii
        && glm::length(laws.gravity) * laws.timeStep * laws.timeStep > mostRadiiAStep * unit * ball.radius) {
        Q_EMIT told(tr("Balls of this size are gone at once by such a gravity. Count it in radii to see them fall."));
    }
}

void PhysicsController::rain()
{
    if (m_scene) {
        m_simulation.drop(rainOver(m_scene->extent, m_choices.rules().laws.gravity, m_choices.ball(sceneSize()),
                                   static_cast<std::size_t>(m_choices.rainCount()), m_rains++),
                          m_choices.colour());
        m_simulation.play();
    }
}

void PhysicsController::removeSelected()
{
    for (const std::uint64_t number : m_selected) {
        m_simulation.remove(number);
    }
}

/// Of the text that is seen, which another may be edited beside.
void PhysicsController::keep()
{
    const QString trouble = m_scene ? keepBalls(*m_seen, *m_scene, *m_frame) : tr("There is no scene yet.");
    Q_EMIT told(trouble.isEmpty() ? tr("The balls are kept in the text") : trouble);
}

void PhysicsController::takeFrame()
{
    m_isFrameAnnounced = false;
    m_frame = m_simulation.newest();
    m_inspector.setFrame(m_frame);
    m_actions.play->setChecked(m_frame->isPlaying);
    if (m_frame->isPlaying != m_drawing.isActive()) {
        m_frame->isPlaying ? m_drawing.start() : m_drawing.stop();
    }
    if (!m_frame->isPlaying) {
        showBalls();
    }
    m_pane.figures().show(m_frame);
    Q_EMIT colliderChanged(m_frame->isStarted ? m_choices.promise() : QString());
}

void PhysicsController::showBalls()
{
    if (!m_frame->isStarted) {
        m_viewport.setBalls(std::nullopt);
        return;
    }
    const std::chrono::duration<double> left = m_frame->due - LiveSimulation::Clock::now();
    const double share = m_frame->way.count() > 0.0 ? std::clamp(1.0 - left / m_frame->way, 0.0, 1.0) : 1.0;
    std::vector<BallSprite> sprites;
    sprites.reserve(m_frame->balls.size());
    for (const LiveSimulation::BallFrame &ball : m_frame->balls) {
        const auto own = ball.mark == 0 ? ballColour(ball.number) : ballColour(ball.mark - 1);
        const bool isSelected = std::ranges::binary_search(m_selected, ball.number);
        sprites.push_back({glm::mix(ball.before, ball.after, share), ball.radius, isSelected ? selectedColour : own,
                           m_frame->places[ball.place].surroundings});
    }
    follow(sprites);
    m_viewport.setBalls(std::move(sprites));
}

/// The first that is selected.
void PhysicsController::follow(const std::vector<BallSprite> &sprites)
{
    const auto found = m_selected.empty()
        ? m_frame->balls.end()
        : std::ranges::find(m_frame->balls, m_selected.front(), &LiveSimulation::BallFrame::number);
    if (!m_actions.follow->isChecked() || found == m_frame->balls.end()) {
        m_followed.reset();
        return;
    }
    const BallSprite &sprite = sprites[static_cast<std::size_t>(found - m_frame->balls.begin())];
    if (m_followed && m_followed->place == sprite.place && m_followed->centre != sprite.centre) {
        const double unit = sprite.place ? std::exp2(sprite.place->unitExponent) : 1.0;
        m_viewport.shift(unit * (sprite.centre - m_followed->centre));
    }
    m_followed = sprite;
}

}
