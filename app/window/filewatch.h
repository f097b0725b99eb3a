// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QHash>
#include <QObject>
#include <QStringList>
#include <QThread>

namespace romanesco {

/// Tells when files come to be, change or go, by whatever program and in whatever way: written in place, replaced by
/// another, with their folders removed, renamed and made again. It watches the files and all folders above them (a file
/// that is replaced takes its watch with it), and compares what is there with what was. Where the system cannot watch, it
/// looks every other second. All of it in a thread of its own, as a file may be on a slow disk.
class FileWatch : public QObject
{
    Q_OBJECT
public:
    explicit FileWatch(QObject *parent = nullptr);
    ~FileWatch() override;

    /// The files that somebody asks for, with absolute paths, in place of those he asked for before; none once he is gone.
    /// They need not exist. Of new ones it is told what changes from now on.
    void setPaths(const QObject *owner, const QStringList &paths);

    /// What happens to the file from the one to the other is the program's own doing, and not told.
    void beginOwnWrite(const QString &path);
    void endOwnWrite(const QString &path);

public Q_SLOTS:
    /// Where no system tells of changes, as on network disks: when the window comes to the front, say.
    void checkNow();

Q_SIGNALS:
    /// Within a tenth of a second after the last change, or a second after the first.
    void changed(const QStringList &paths);

private:
    class Worker;
    void forget(const QObject *owner);
    void tellWorker();

    QHash<const QObject *, QStringList> m_wanted;
    QThread m_thread;
    Worker *m_worker;
};

}
