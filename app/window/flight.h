// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <glm/vec3.hpp>

namespace romanesco {

/// Flying by keys that are held: W and S ahead and back, D and A to the right and left. For the GUI thread.
class Flight : public QObject
{
    Q_OBJECT
public:
    explicit Flight(QObject *parent = nullptr);

    /// A key goes down or up. Whether it is one of those.
    bool setHeld(int key, bool isHeld);
    /// All keys go up.
    void stop();
    [[nodiscard]] bool isActive() const { return m_steps.isActive(); }

Q_SIGNALS:
    void begun();
    /// Right, up, forward, in distances of what lies ahead.
    void flown(const glm::dvec3 &way);

private:
    void step();

    /// W, S, D, A.
    std::array<bool, 4> m_isHeld{};
    /// The ways that keys are held for.
    glm::dvec3 m_way{0.0};
    QTimer m_steps;
    QElapsedTimer m_sinceStep;
};

}
