// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "previewcontroller.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <new>
#include <utility>

#include <QMetaObject>

#include "app/imagedecoder.h"
#include "core/language/stability.h"

namespace romanesco {

namespace {

using namespace std::chrono_literals;
constexpr auto firstPatience = 200ms;

}

PreviewController::PreviewController(const FileAccess &files, QObject *parent)
    : QObject(parent)
    , m_named(files)
    , m_loader(m_named, decodeImage)
    , m_endlessFiles(m_named, DepthChange::endless)
    , m_endlessLoader(m_endlessFiles, decodeImage)
    , m_counting([this](const CountJob &scene, const std::stop_token &stop) { runCount(scene, stop); })
    , m_building([this](const BuildJob &job, const std::stop_token &stop) { runBuild(job, stop); })
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(firstPatience);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        if (m_waiting) {
            giveUp();
        }
    });
}

PreviewController::~PreviewController() = default;

quint64 PreviewController::build(const std::filesystem::path &path, const TextSnapshot &text)
{
    ++m_newestRevision;
    m_waiting = BuildJob{m_newestRevision, path, text, m_isEndless};
    if (!m_isBuilding) {
        startWaiting();
    } else if (!m_patience.isActive()) {
        giveUp();
    }
    return m_newestRevision;
}

/// What is under way is asked to stop.
void PreviewController::startWaiting()
{
    m_isBuilding = true;
    m_startedRevision = m_waiting->revision;
    m_patience.start();
    m_building.post(*std::exchange(m_waiting, std::nullopt));
}

/// However long a text takes, the one that follows ends in time at last.
void PreviewController::giveUp()
{
    m_patience.setInterval(2 * m_patience.intervalAsDuration());
    startWaiting();
}

void PreviewController::forget()
{
    // What is under way is of the old file and must not arrive any more.
    m_firstRevision = ++m_newestRevision;
    m_waiting.reset();
    m_isBuilding = false;
    m_lastGoodScene.reset();
}

/// On the building thread, the only one to use the loader.
void PreviewController::runBuild(const BuildJob &job, const std::stop_token &stop)
{
    Preview preview;
    preview.revision = job.revision;
    preview.text = job.text;
    try {
        SceneResult result = m_loader.load(job.path, job.text.bytes(), stop);
        preview.diagnostics = std::move(result.diagnostics);
        preview.scene = std::move(result.scene);
        preview.shown = preview.scene;
        if (preview.scene && fileKind(job.path) == FileKind::Fdo && !stop.stop_requested()) {
            preview.reading = FdoReading::of(job.text.bytes());
            if (preview.reading) {
                std::ranges::move(stabilityHints(preview.reading->document, preview.reading->description),
                                  std::back_inserter(preview.diagnostics));
                sortByPlace(preview.diagnostics);
            }
        }
        if (preview.scene && job.isEndless && !stop.stop_requested()) {
            deepen(job, preview, stop);
        }
    } catch (const std::bad_alloc &) {
        // The text is worth more than its picture.
        preview.failure = tr("There is not enough memory for this fractal.");
    }
    preview.files = m_named.take();
    if (!stop.stop_requested()) {
        QMetaObject::invokeMethod(this, [this, preview] { deliver(preview); }, Qt::QueuedConnection);
    }
}

/// On the building thread.
void PreviewController::deepen(const BuildJob &job, Preview &preview, const std::stop_token &stop)
{
    const bool isFractal = fileKind(job.path) == FileKind::Fdo;
    const std::string &text = job.text.bytes();
    const std::string deeper = isFractal ? m_endlessFiles.changed(text) : text;
    if (isFractal && deeper == text) {
        return; // nothing is repeated
    }
    const SceneResult deep = m_endlessLoader.load(job.path, deeper, stop);
    if (deep.scene && isConvergent(*deep.scene)) {
        preview.shown = deep.scene;
        preview.reading = isFractal ? FdoReading::of(deeper) : nullptr;
    } else {
        preview.remark = tr("Shown at its own depth: without end there is a picture only where transformations shrink "
                            "what they repeat.");
    }
}

/// On the counting thread.
void PreviewController::runCount(const CountJob &scene, const std::stop_token &stop)
{
    try {
        const Summary summary = summarise(*scene);
        if (stop.stop_requested()) {
            return;
        }
        const auto announce = [this, scene, summary] {
            if (scene == m_lastGoodScene) {
                Q_EMIT counted(summary);
            }
        };
        QMetaObject::invokeMethod(this, announce, Qt::QueuedConnection);
    } catch (const std::bad_alloc &) {
        // Then there are no numbers to show.
    }
}

void PreviewController::deliver(Preview preview)
{
    if (preview.revision == m_startedRevision) {
        m_isBuilding = false;
        m_patience.stop();
        m_patience.setInterval(firstPatience);
        if (m_waiting) {
            startWaiting();
        }
    }
    if (preview.revision < m_firstRevision) {
        return;
    }
    preview.isOutdated = preview.revision != m_newestRevision;
    if (preview.scene) {
        m_lastGoodScene = preview.scene;
        m_counting.post(preview.scene);
    }
    Q_EMIT built(preview);
}

}
