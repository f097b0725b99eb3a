// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "filewatch.h"

#include <chrono>
#include <functional>
#include <utility>

#include <sys/stat.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QSet>
#include <QTimer>

namespace romanesco {

namespace {

using namespace std::chrono_literals;

constexpr auto quiet = 100ms;
constexpr auto longest = 1s;
constexpr auto pollPause = 2s;

/// What a path leads to. Two that are equal are the same file with the same bytes, as far as the system tells.
struct Trace {
    bool isThere = false;
    dev_t device = 0;
    ino_t number = 0;
    off_t size = 0;
    time_t seconds = 0;
    long nanoseconds = 0;

    bool operator==(const Trace &) const = default;
    [[nodiscard]] bool isSameFile(const Trace &other) const
    {
        return isThere == other.isThere && device == other.device && number == other.number;
    }
};

Trace traceOf(const QString &path)
{
    struct stat status{};
    if (::stat(QFile::encodeName(path).constData(), &status) != 0) {
        return {};
    }
    return {true, status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

}

/// Lives in the thread.
class FileWatch::Worker : public QObject
{
public:
    explicit Worker(std::function<void(const QStringList &)> report)
        : m_report(std::move(report))
        , m_watcher(this)
        , m_timer(this)
        , m_poll(this)
    {
        connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &Worker::schedule);
        connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &Worker::schedule);
        m_timer.setSingleShot(true);
        connect(&m_timer, &QTimer::timeout, this, &Worker::check);
        m_poll.setInterval(pollPause);
        connect(&m_poll, &QTimer::timeout, this, &Worker::check);
    }

    void setPaths(const QStringList &paths)
    {
        QHash<QString, Trace> files;
        for (const QString &path : paths) {
            const auto known = m_files.constFind(path);
            files.insert(path, known != m_files.cend() ? *known : traceOf(path));
        }
        m_files = files;
        watch();
        schedule(); // what happened between the two
    }

    void beginOwnWrite(const QString &path) { m_ownWrites.insert(path); }

    void endOwnWrite(const QString &path)
    {
        m_ownWrites.remove(path);
        if (const auto known = m_files.find(path); known != m_files.end()) {
            *known = traceOf(path);
        }
        schedule(); // the watch of the file that was replaced is gone
    }

    void check()
    {
        m_timer.stop();
        watch();
        QStringList changed;
        for (auto file = m_files.begin(); file != m_files.end(); ++file) {
            const Trace now = m_ownWrites.contains(file.key()) ? *file : traceOf(file.key());
            if (now != *file) {
                *file = now;
                changed += file.key();
            }
        }
        if (!changed.isEmpty()) {
            m_report(changed);
        }
    }

private:
    void schedule()
    {
        if (!m_timer.isActive()) {
            m_first.start();
        }
        // A file that is being written is told of when it is quiet, but not never.
        if (!m_timer.isActive() || m_first.durationElapsed() < longest - quiet) {
            m_timer.start(quiet);
        }
    }

    /// Makes the watches those that there should be. A folder may come while the one above it is not yet watched: until
    /// nothing is new.
    void watch()
    {
        for (int i = 0; i < 10 && watchOnce(); ++i) { }
    }

    bool watchOnce()
    {
        QSet<QString> wanted;
        QSet<QString> needed; // to know of each file
        for (auto file = m_files.cbegin(); file != m_files.cend(); ++file) {
            addPlaces(file.key(), wanted, needed);
            // A link is one file, what it leads to another.
            const QString real = QFileInfo(file.key()).canonicalFilePath();
            if (!real.isEmpty() && real != file.key()) {
                addPlaces(real, wanted, needed);
            }
        }
        dropWatches(wanted);
        bool isNew = false;
        bool isBlind = false;
        for (const QString &path : std::as_const(wanted)) {
            if (!m_watched.contains(path)) {
                const Trace trace = traceOf(path);
                const bool isWatched = m_watcher.addPath(path);
                isNew = isNew || isWatched;
                isBlind = isBlind || (!isWatched && needed.contains(path));
                if (isWatched) {
                    m_watched.insert(path, trace);
                }
            }
        }
        if (isBlind && !m_poll.isActive()) {
            m_poll.start();
        } else if (!isBlind) {
            m_poll.stop();
        }
        return isNew;
    }

    /// The file and the folders above it, as far as they are there.
    static void addPlaces(const QString &path, QSet<QString> &wanted, QSet<QString> &needed)
    {
        bool isNearest = true;
        for (QString place = path; !wanted.contains(place) || isNearest; place = QFileInfo(place).path()) {
            if (QFileInfo::exists(place)) {
                wanted.insert(place);
                if (std::exchange(isNearest, false)) {
                    needed.insert(place);
                }
            }
            if (place == QFileInfo(place).path()) {
                break;
            }
        }
    }

    /// Of what is asked for no longer, has gone, or is not what it was.
    void dropWatches(const QSet<QString> &wanted)
    {
        const QStringList paths = m_watcher.files() + m_watcher.directories();
        const QSet<QString> alive(paths.begin(), paths.end());
        for (auto watch = m_watched.begin(); watch != m_watched.end();) {
            const bool isAlive = alive.contains(watch.key());
            if (isAlive && wanted.contains(watch.key()) && traceOf(watch.key()).isSameFile(*watch)) {
                ++watch;
                continue;
            }
            if (isAlive) {
                m_watcher.removePath(watch.key());
            }
            watch = m_watched.erase(watch);
        }
    }

    std::function<void(const QStringList &)> m_report;
    QFileSystemWatcher m_watcher;
    QTimer m_timer;
    QTimer m_poll;
    QElapsedTimer m_first;
    QHash<QString, Trace> m_files;
    QHash<QString, Trace> m_watched;
    QSet<QString> m_ownWrites;
};

FileWatch::FileWatch(QObject *parent)
    : QObject(parent)
    , m_worker(new Worker([this](const QStringList &paths) {
        QMetaObject::invokeMethod(this, [this, paths] { Q_EMIT changed(paths); }, Qt::QueuedConnection);
    }))
{
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.setObjectName(QStringLiteral("FileWatch"));
    m_thread.start();
}

FileWatch::~FileWatch()
{
    m_thread.quit();
    m_thread.wait();
}

void FileWatch::setPaths(const QObject *owner, const QStringList &paths)
{
    if (!m_wanted.contains(owner)) {
        connect(owner, &QObject::destroyed, this, &FileWatch::forget);
    }
    m_wanted.insert(owner, paths);
    tellWorker();
}

void FileWatch::forget(const QObject *owner)
{
    m_wanted.remove(owner);
    tellWorker();
}

void FileWatch::tellWorker()
{
    QStringList all;
    for (const QStringList &paths : std::as_const(m_wanted)) {
        all += paths;
    }
    QMetaObject::invokeMethod(m_worker, [worker = m_worker, all] { worker->setPaths(all); });
}

void FileWatch::beginOwnWrite(const QString &path)
{
    QMetaObject::invokeMethod(m_worker, [worker = m_worker, path] { worker->beginOwnWrite(path); });
}

void FileWatch::endOwnWrite(const QString &path)
{
    QMetaObject::invokeMethod(m_worker, [worker = m_worker, path] { worker->endOwnWrite(path); });
}

void FileWatch::checkNow()
{
    QMetaObject::invokeMethod(m_worker, [worker = m_worker] { worker->check(); });
}

}
