// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "flight.h"

#include <algorithm>
#include <chrono>
#include <iterator>

namespace romanesco {

namespace {

constexpr std::chrono::milliseconds interval(16);
/// In distances of the surface ahead, for each second.
constexpr double speed = 1.0;
/// Of a step in seconds, however long a picture took.
constexpr double longestStep = 0.1;

}

Flight::Flight(QObject *parent)
    : QObject(parent)
{
    m_steps.setInterval(interval);
    connect(&m_steps, &QTimer::timeout, this, &Flight::step);
}

bool Flight::setHeld(int key, bool isHeld)
{
    constexpr int keys[] = {Qt::Key_W, Qt::Key_S, Qt::Key_D, Qt::Key_A};
    const auto place = std::ranges::find(keys, key);
    if (place == std::end(keys)) {
        return false;
    }
    m_isHeld[static_cast<std::size_t>(place - keys)] = isHeld;
    const auto [ahead, back, right, left] = m_isHeld;
    m_way = {double(right) - double(left), 0.0, double(ahead) - double(back)};
    if (m_way == glm::dvec3(0.0)) {
        m_steps.stop();
    } else if (!isActive()) {
        Q_EMIT begun();
        m_sinceStep.start();
        m_steps.start();
    }
    return true;
}

void Flight::stop()
{
    m_isHeld = {};
    m_way = glm::dvec3(0.0);
    m_steps.stop();
}

void Flight::step()
{
    const double seconds = std::min(1e-9 * double(m_sinceStep.nsecsElapsed()), longestStep);
    m_sinceStep.start();
    Q_EMIT flown(speed * seconds * m_way);
}

}
