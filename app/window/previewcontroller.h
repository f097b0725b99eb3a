// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "core/base/newestjob.h"
#include "core/scene/depthchange.h"
#include "core/scene/sceneloader.h"
#include "core/scene/summary.h"
#include "editor/textsnapshot.h"
#include "fdoreading.h"
#include "namedfiles.h"

namespace romanesco {

/// What one version of a text came to.
struct Preview {
    quint64 revision = 0;
    TextSnapshot text;
    /// A newer text waits to be built: its places are others.
    bool isOutdated = false;
    /// Of that text, sorted by place.
    Diagnostics diagnostics;
    /// Null after errors.
    std::shared_ptr<const Scene> scene;
    /// What is to be seen: the same, or as deep as views go.
    std::shared_ptr<const Scene> shown;
    /// Of the .fdo text of what is to be seen; else null.
    std::shared_ptr<const FdoReading> reading;
    /// What it is made of, whether that is there or not; absolute paths. Without those the program brings along.
    QStringList files;
    /// Why that is not as deep as was asked for, as a sentence; else empty.
    QString remark;
    /// Why there is no scene where the text is not to blame, as a sentence; else empty.
    QString failure;
};

/// Makes scenes of a text that changes, in the background. Of the texts that come while one is built only the newest is
/// built. What is under way may end, so that typing without a pause still shows pictures; only where it takes long is it
/// given up for the newer text, and the next may take twice as long. For the GUI thread.
class PreviewController : public QObject
{
    Q_OBJECT
public:
    /// files must outlive it, and may be called from other threads.
    explicit PreviewController(const FileAccess &files, QObject *parent = nullptr);
    /// Waits for what is under way, which has been asked to stop.
    ~PreviewController() override;

    /// Starts on a text, now or soon, and returns its revision; paths in it are relative to path's folder. built() follows,
    /// unless a newer text is given meanwhile.
    quint64 build(const std::filesystem::path &path, const TextSnapshot &text);

    /// From the next build() on: scenes are shown as if their depth had no end.
    void setEndless(bool isEndless) { m_isEndless = isEndless; }
    [[nodiscard]] bool isEndless() const { return m_isEndless; }

    /// The texts that follow are of another file: what was good of the last one is forgotten.
    void forget();

    /// Of the newest text that had no errors; null if there was none.
    [[nodiscard]] const std::shared_ptr<const Scene> &lastGoodScene() const { return m_lastGoodScene; }

Q_SIGNALS:
    void built(const romanesco::Preview &preview);
    /// Follows built() where there is a scene, unless a newer scene is there before.
    void counted(const romanesco::Summary &summary);

private:
    struct BuildJob {
        quint64 revision;
        std::filesystem::path path;
        TextSnapshot text;
        bool isEndless;
    };
    using CountJob = std::shared_ptr<const Scene>;

    void startWaiting();
    void giveUp();
    void runBuild(const BuildJob &job, const std::stop_token &stop);
    void deepen(const BuildJob &job, Preview &preview, const std::stop_token &stop);
    void runCount(const CountJob &scene, const std::stop_token &stop);
    void deliver(Preview preview);

    NamedFiles m_named;
    SceneLoader m_loader;
    DepthChange m_endlessFiles;
    SceneLoader m_endlessLoader;
    bool m_isEndless = false;
    quint64 m_newestRevision = 0;
    /// Of the file that the texts are of now.
    quint64 m_firstRevision = 0;
    quint64 m_startedRevision = 0;
    bool m_isBuilding = false;
    std::optional<BuildJob> m_waiting;
    /// Runs while the build under way may not be given up.
    QTimer m_patience;
    std::shared_ptr<const Scene> m_lastGoodScene;
    /// Counting has a thread of its own: it may take a second, and the next picture does not wait for it.
    NewestJob<CountJob> m_counting;
    NewestJob<BuildJob> m_building;
};

}
