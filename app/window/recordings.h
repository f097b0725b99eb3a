// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>

#include <QObject>
#include <QString>

#include "backgroundtask.h"
#include "core/physics/recording.h"

class QWidget;

namespace romanesco {

class LiveSimulation;

/// Files of what was done to balls, and of what it came to.
class Recordings : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    Recordings(QWidget &window, LiveSimulation &simulation, QObject *parent = nullptr);

    /// Asks for a name and writes what was done since the scene's start, in the background: told() follows.
    void save();
    /// Asks for a file and lets it happen again.
    void open();

Q_SIGNALS:
    /// What came of it, in a sentence.
    void told(const QString &words);

private:
    void write(const QString &path);
    void read(const QString &path);

    QWidget &m_window;
    LiveSimulation &m_simulation;
    BackgroundTask<std::expected<Recording, QString>> m_reading;
};

}
