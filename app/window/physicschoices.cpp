// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "physicschoices.h"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include "core/measure/steptrial.h"
#include "core/physics/scenephysics.h"

namespace romanesco {

namespace {

/// From a tenth to ten times, in tenths of a power of ten.
constexpr int speedSteps = 10;

struct NamedRestitution {
    const char *name;
    double value;
};
constexpr NamedRestitution materials[] = {
    {QT_TRANSLATE_NOOP("romanesco::PhysicsChoices", "Steel"), 0.3},
    {QT_TRANSLATE_NOOP("romanesco::PhysicsChoices", "Wood"), 0.5},
    {QT_TRANSLATE_NOOP("romanesco::PhysicsChoices", "Rubber"), 0.85},
    {QT_TRANSLATE_NOOP("romanesco::PhysicsChoices", "Ideal"), 1.0},
};
constexpr int wood = 1;

/// A box for a number; one that is typed counts when it is confirmed.
QDoubleSpinBox *makeNumber(double least, double greatest, double value, int decimals, const QString &name,
                           const QString &suffix = {})
{
    auto *box = new QDoubleSpinBox;
    box->setDecimals(decimals);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    // the least and the greatest number would make it far too wide
    box->setRange(0.0, 10.0);
    box->setSuffix(suffix);
    box->setFixedWidth(box->sizeHint().width());
    box->setRange(least, greatest);
    box->setValue(value);
    return box;
}

QWidget *makeColumn(QLayout *layout)
{
    auto *column = new QWidget;
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    column->setLayout(layout);
    return column;
}

/// A row whose label leads to the first of its parts.
void addRow(QFormLayout &form, const QString &words, std::initializer_list<QWidget *> parts)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    for (QWidget *part : parts) {
        row->addWidget(part);
    }
    row->addStretch(1);
    auto *label = new QLabel(words);
    label->setBuddy(*parts.begin());
    form.addRow(label, row);
}

void addButton(QWidget &row, QAction &action)
{
    auto *button = new QToolButton;
    button->setDefaultAction(&action);
    button->setFocusPolicy(Qt::TabFocus);
    row.layout()->addWidget(button);
}

QString promiseOf(ColliderKind kind)
{
    switch (kind) {
    case ColliderKind::Exact:
        return PhysicsChoices::tr("Finds the nearest point, by the fractal's own structure. No ball goes through.");
    case ColliderKind::Approximate:
        return PhysicsChoices::tr("Distances are too great by the tolerance at most. No ball goes through; it may "
                                  "bounce that much early.");
    case ColliderKind::Bvh:
        return PhysicsChoices::tr("Finds the nearest point, with every face written out. No ball goes through.");
    case ColliderKind::Simple:
        return PhysicsChoices::tr("Finds the nearest point by looking at every face: slow. No ball goes through.");
    case ColliderKind::Greedy:
    case ColliderKind::Octree:
        return PhysicsChoices::tr("As in the dissertation: the nearest point may be missed. Balls may go through.");
    }
    return {};
}

}

PhysicsChoices::PhysicsChoices(QWidget *parent)
    : QWidget(parent)
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    for (QWidget *column : {makeMotion(), makeRules(), makeCollider()}) {
        row->addWidget(column, 0, Qt::AlignTop);
    }
    showSpeed();
    showPromise();
}

QWidget *PhysicsChoices::makeMotion()
{
    auto *form = new QFormLayout;
    m_motion = makeColumn(new QHBoxLayout);
    form->addRow(m_motion);
    m_speed = new QSlider(Qt::Horizontal);
    m_speed->setRange(-speedSteps, speedSteps);
    m_speed->setPageStep(3);
    m_speed->setFixedWidth(100);
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("How fast time goes: from a tenth to ten times"));
    m_speedWords = new QLabel;
    addRow(*form, tr("Sp&eed"), {m_speed, m_speedWords});
    connect(m_speed, &QSlider::valueChanged, this, [this] {
        showSpeed();
        Q_EMIT speedChanged();
    });
    addTimeStep(*form);
    m_drops = makeColumn(new QHBoxLayout);
    form->addRow(m_drops);
    m_rainCount = new QSpinBox;
    m_rainCount->setRange(1, 100'000);
    m_rainCount->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_rainCount->setValue(100);
    m_rainCount->setAccessibleName(tr("Balls of a rain"));
    m_rainCount->setToolTip(tr("How many balls fall when it rains"));
    return makeColumn(form);
}

void PhysicsChoices::addActions(const PhysicsActions &actions, QAction &drop)
{
    for (QAction *action : {actions.play, actions.step, actions.reset}) {
        addButton(*m_motion, *action);
    }
    addButton(*m_drops, drop);
    addButton(*m_drops, *actions.rain);
    m_drops->layout()->addWidget(m_rainCount);
}

QWidget *PhysicsChoices::makeRules()
{
    auto *form = new QFormLayout;
    m_radius = makeNumber(1e-3, 100.0, 2.0, 3, tr("Radius"), tr(" %"));
    m_radius->setToolTip(
        tr("Of the balls that are dropped: a share of the scene's size; deep inside, of what is seen"));
    m_colour = new QComboBox;
    m_colour->setAccessibleName(tr("Colour"));
    m_colour->setToolTip(tr("Of the balls that are dropped"));
    // in the order of ballColours
    m_colour->addItems({tr("In turn"), tr("Orange"), tr("Sky"), tr("Green"), tr("Yellow"), tr("Red"), tr("Pink")});
    addRow(*form, tr("&Radius"), {m_radius, m_colour});
    addBounce(*form);
    addGravity(*form);
    m_shrink = makeNumber(0.0, 100.0, 0.0, 3, tr("Shrinking"));
    m_shrink->setToolTip(tr("Radii shrink by so much a second, as a power of e: 0.7 halves them each second"));
    m_asInDissertation = new QCheckBox(tr("As in the &dissertation"));
    m_asInDissertation->setToolTip(tr("Balls move in jumps and are pushed out where they overlap: they lose energy, go "
                                      "through what they jump over, and pass one another"));
    addRow(*form, tr("Shrin&k"), {m_shrink, m_asInDissertation});
    connect(m_shrink, &QDoubleSpinBox::valueChanged, this, &PhysicsChoices::rulesChanged);
    connect(m_asInDissertation, &QCheckBox::toggled, this, &PhysicsChoices::rulesChanged);
    return makeColumn(form);
}

void PhysicsChoices::addTimeStep(QFormLayout &form)
{
    m_timeStep = new QComboBox;
    m_timeStep->setAccessibleName(tr("Time step"));
    m_timeStep->setToolTip(
        tr("How long a step of the simulation is: shorter ones cost more. Balls pass through nothing "
           "whatever it is, but those of the dissertation do"));
    for (const int steps : trialStepsASecond()) {
        m_timeStep->addItem(tr("1/%1 s").arg(steps), 1.0 / steps);
    }
    m_timeStep->setCurrentIndex(m_timeStep->findData(Laws().timeStep));
    addRow(form, tr("Ti&me step"), {m_timeStep});
    connect(m_timeStep, &QComboBox::currentIndexChanged, this, &PhysicsChoices::rulesChanged);
}

void PhysicsChoices::addBounce(QFormLayout &form)
{
    m_material = new QComboBox;
    m_material->setAccessibleName(tr("Bounce, by name"));
    m_material->setToolTip(tr("How high balls bounce that are dropped"));
    for (const NamedRestitution &material : materials) {
        m_material->addItem(tr(material.name), material.value);
    }
    m_material->addItem(tr("Own"));
    m_material->setCurrentIndex(wood);
    m_restitution = makeNumber(0.0, 1.0, materials[wood].value, 3, tr("Bounce"));
    m_restitution->setToolTip(tr("What is left of the speed after a bounce: from 0 to 1"));
    addRow(form, tr("&Bounce"), {m_material, m_restitution});
    connect(m_material, &QComboBox::currentIndexChanged, this, [this] {
        if (m_material->currentData().isValid()) {
            m_restitution->setValue(m_material->currentData().toDouble());
        }
    });
    connect(m_restitution, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        const int named = m_material->findData(value);
        m_material->setCurrentIndex(named < 0 ? m_material->count() - 1 : named);
    });
}

void PhysicsChoices::addGravity(QFormLayout &form)
{
    const Laws laws;
    for (int axis = 0; axis < 3; ++axis) {
        const QString name = tr("Gravity along %1").arg(QLatin1Char("xyz"[axis]));
        QDoubleSpinBox *box = makeNumber(-1e9, 1e9, laws.gravity[axis], 3, name);
        box->setToolTip(tr("%1, a second squared").arg(name));
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setFixedWidth(52);
        connect(box, &QDoubleSpinBox::valueChanged, this, &PhysicsChoices::rulesChanged);
        m_gravity.push_back(box);
    }
    m_gravityUnit = new QComboBox;
    m_gravityUnit->setAccessibleName(tr("Unit of gravity"));
    m_gravityUnit->setToolTip(
        tr("In the scene's units; or in radii of each ball, so that small ones fall as they look"));
    m_gravityUnit->addItems({tr("units"), tr("radii")});
    connect(m_gravityUnit, &QComboBox::currentIndexChanged, this, &PhysicsChoices::rulesChanged);
    addRow(form, tr("&Gravity"), {m_gravity[0], m_gravity[1], m_gravity[2], m_gravityUnit});
}

QWidget *PhysicsChoices::makeCollider()
{
    auto *form = new QFormLayout;
    m_collider = new QComboBox;
    m_collider->setAccessibleName(tr("Collider"));
    m_collider->setToolTip(tr("How the surface is searched"));
    for (const std::string_view name : colliderNames) {
        m_collider->addItem(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    }
    m_tolerance = makeNumber(1e-6, 0.5, SceneCollider::Options().excess, 6, tr("Tolerance"));
    m_tolerance->setToolTip(tr("Of approximate: how much too great a distance may be, as a share"));
    m_promise = new QLabel;
    m_promise->setWordWrap(true);
    m_promise->setFixedWidth(230);
    addRow(*form, tr("&Collider"), {m_collider});
    addRow(*form, tr("To&lerance"), {m_tolerance});
    form->addRow(m_promise);
    const auto changed = [this] {
        showPromise();
        Q_EMIT colliderChanged();
    };
    connect(m_collider, &QComboBox::currentIndexChanged, this, changed);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, changed);
    return makeColumn(form);
}

World::Options PhysicsChoices::rules() const
{
    World::Options world;
    for (int axis = 0; axis < 3; ++axis) {
        world.laws.gravity[axis] = m_gravity[static_cast<std::size_t>(axis)]->value();
    }
    world.laws.isGravityInRadii = m_gravityUnit->currentIndex() == 1;
    world.laws.timeStep = m_timeStep->currentData().toDouble();
    world.shrinkRate = m_shrink->value();
    world.isAsInDissertation = m_asInDissertation->isChecked();
    return world;
}

void PhysicsChoices::setStepping(double timeStep, bool isAsInDissertation)
{
    const auto offTo = [timeStep](int steps) { return std::abs(std::log(timeStep * steps)); };
    const auto nearest = std::ranges::min_element(trialStepsASecond(), {}, offTo);
    {
        const QSignalBlocker oneChange(this);
        m_timeStep->setCurrentIndex(static_cast<int>(nearest - trialStepsASecond().begin()));
        m_asInDissertation->setChecked(isAsInDissertation);
    }
    Q_EMIT rulesChanged();
}

void PhysicsChoices::setCollider(const SceneCollider::Options &collider)
{
    {
        const QSignalBlocker oneChange(this);
        m_tolerance->setValue(collider.excess);
        m_collider->setCurrentIndex(static_cast<int>(collider.kind));
    }
    Q_EMIT colliderChanged();
}

SceneCollider::Options PhysicsChoices::collider() const
{
    return {static_cast<ColliderKind>(m_collider->currentIndex()), m_tolerance->value()};
}

QString PhysicsChoices::promise() const
{
    return provesClearance(collider().kind) && !m_asInDissertation->isChecked()
        ? tr("%1 · no ball goes through").arg(m_collider->currentText())
        : tr("%1 · balls may go through").arg(m_collider->currentText());
}

double PhysicsChoices::speed() const
{
    return std::pow(10.0, double(m_speed->value()) / speedSteps);
}

Ball PhysicsChoices::ball(double sceneSize) const
{
    Ball ball;
    ball.radius = 0.01 * m_radius->value() * sceneSize;
    ball.restitution = m_restitution->value();
    return ball;
}

unsigned PhysicsChoices::colour() const
{
    return static_cast<unsigned>(m_colour->currentIndex());
}

int PhysicsChoices::rainCount() const
{
    return m_rainCount->value();
}

void PhysicsChoices::showSpeed()
{
    m_speedWords->setText(tr("×%1").arg(QLocale().toString(speed(), 'g', 2)));
}

void PhysicsChoices::showPromise()
{
    const ColliderKind kind = collider().kind;
    m_tolerance->setEnabled(kind == ColliderKind::Approximate);
    m_promise->setText(promiseOf(kind));
}

}
