// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <initializer_list>
#include <vector>

#include <QWidget>

#include "core/physics/world.h"
#include "core/scene/scenecollider.h"
#include "physicsactions.h"

class QAction;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSlider;
class QSpinBox;

namespace romanesco {

/// What is dropped and how fast time goes, what balls obey, how their surface is searched and what that promises.
class PhysicsChoices : public QWidget
{
    Q_OBJECT
public:
    explicit PhysicsChoices(QWidget *parent = nullptr);

    /// The buttons; once. drop is the tool that drops balls.
    void addActions(const PhysicsActions &actions, QAction &drop);

    [[nodiscard]] World::Options rules() const;
    /// The nearest step that is offered, in seconds, and whether balls move as in the dissertation.
    void setStepping(double timeStep, bool isAsInDissertation);
    [[nodiscard]] SceneCollider::Options collider() const;
    void setCollider(const SceneCollider::Options &collider);
    /// Which collider, and whether balls may go through by it: "exact · no ball goes through".
    [[nodiscard]] QString promise() const;
    /// Simulated seconds for each that goes by.
    [[nodiscard]] double speed() const;
    /// What is dropped in a scene of that size, at the origin.
    [[nodiscard]] Ball ball(double sceneSize) const;
    /// The number of one of ballColours, from 1; 0 for one after another.
    [[nodiscard]] unsigned colour() const;
    [[nodiscard]] int rainCount() const;

Q_SIGNALS:
    void rulesChanged();
    void colliderChanged();
    void speedChanged();

private:
    QWidget *makeMotion();
    QWidget *makeRules();
    QWidget *makeCollider();
    void addBounce(QFormLayout &form);
    void addGravity(QFormLayout &form);
    void addTimeStep(QFormLayout &form);
    void showSpeed();
    void showPromise();

    QWidget *m_motion;
    QWidget *m_drops;
    QSlider *m_speed;
    QLabel *m_speedWords;
    QComboBox *m_timeStep;
    QDoubleSpinBox *m_radius;
    QComboBox *m_colour;
    QComboBox *m_material;
    QDoubleSpinBox *m_restitution;
    QSpinBox *m_rainCount;
    std::vector<QDoubleSpinBox *> m_gravity;
    QComboBox *m_gravityUnit;
    QDoubleSpinBox *m_shrink;
    QCheckBox *m_asInDissertation;
    QComboBox *m_collider;
    QDoubleSpinBox *m_tolerance;
    QLabel *m_promise;
};

}
