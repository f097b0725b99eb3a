// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measurecontroller.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QStandardPaths>
#include <QStatusBar>

#include "core/base/atomicfile.h"
#include "core/measure/measurementpage.h"
#include "measurepane.h"
#include "measureview.h"
#include "physicschoices.h"
#include "physicscontroller.h"
#include "qualitycontrol.h"
#include "texttab.h"

namespace romanesco {

MeasureController::MeasureController(MeasurePane &pane, const PhysicsController &physics, PhysicsChoices &choices,
                                     QualityControl &quality, QMainWindow &window)
    : QObject(&window)
    , m_pane(pane)
    , m_physics(physics)
    , m_choices(choices)
    , m_quality(quality)
    , m_window(window)
    , m_writing(*this)
    , m_task(*this)
{
    connect(&m_pane, &MeasurePane::opened, this, [this](MeasureView &view) {
        m_view = &view;
        connectView();
        showState();
    });
}

MeasureController::~MeasureController()
{
    m_stop.request_stop();
}

void MeasureController::connectView()
{
    connect(m_view, &MeasureView::measureRequested, this, &MeasureController::measure);
    connect(m_view, &MeasureView::cancelRequested, this, [this] { m_stop.request_stop(); });
    connect(m_view, &MeasureView::useRequested, this, &MeasureController::use);
    connect(m_view, &MeasureView::exportRequested, this, &MeasureController::askWhere);
}

void MeasureController::follow(TextTab &seen)
{
    m_seen = &seen;
    m_whileSeen = std::make_unique<QObject>();
    connect(&seen, &TextTab::previewed, m_whileSeen.get(), [this] { showState(); });
    showState();
}

void MeasureController::showState()
{
    if (!m_view || !m_seen) {
        return;
    }
    const bool hasErrors = m_seen->trouble().isOfText;
    m_view->setObstacle(m_seen->shown() ? QString()
                            : hasErrors
                            ? tr("There is nothing to measure: the text has errors, and had no picture yet.")
                            : tr("There is no scene yet."));
    m_view->setRemark(remark());
}

QString MeasureController::remark() const
{
    QStringList words;
    if (!m_failure.isEmpty()) {
        words << m_failure;
    }
    if (m_measured && m_measured->of.scene != m_seen->shown()) {
        words << (m_measured->of.name == m_seen->document().name()
                      ? tr("The figures are of an older text.")
                      : tr("The figures are of “%1”.").arg(m_measured->of.name));
    }
    if (m_seen->trouble().isOfText && m_seen->shown()) {
        words << tr("The text has errors: what can be measured is its last good version.");
    }
    return words.join(u' ');
}

void MeasureController::measure()
{
    if (m_task.isRunning() || !m_seen->shown()) {
        return;
    }
    m_scene = {m_seen->shown(), m_physics.balls(), m_seen->document().name()};
    // what is looked at comes first
    m_left.assign(measuredParts.begin(), measuredParts.end());
    std::ranges::rotate(m_left, std::ranges::find(m_left, m_view->part()));
    m_made = std::make_shared<MeasuredParts>(m_scene);
    m_stop = std::stop_source();
    m_failure.clear();
    showState();
    measureNext();
}

void MeasureController::measureNext()
{
    if (m_left.empty() || m_stop.stop_requested()) {
        m_view->setProgress({});
        Q_EMIT finished();
        return;
    }
    const MeasuredPart part = m_left.front();
    showProgress(tr("what there is"), 0.0);
    m_task.start(
        [this, part, scene = m_scene, stop = m_stop.get_token()] {
            const auto progress = [this](const std::string &what, double share) {
                QMetaObject::invokeMethod(
                    this, [this, what = QString::fromStdString(what), share] { showProgress(what, share); },
                    Qt::QueuedConnection);
            };
            return measurePart(part, scene, {stop, progress});
        },
        [this, part](MeasuredTrial trial) { take(part, std::move(trial)); });
}

/// What was cancelled leaves all as it is.
void MeasureController::take(MeasuredPart part, MeasuredTrial trial)
{
    m_left.erase(m_left.begin());
    if (trial || !m_stop.stop_requested()) {
        auto made = std::make_shared<MeasuredParts>(*m_made);
        made->trials[static_cast<std::size_t>(part)] = std::move(trial);
        m_made = std::move(made);
        m_measured = m_made;
        m_view->setMeasured(m_measured);
        showState();
    }
    measureNext();
}

void MeasureController::showProgress(const QString &what, double share)
{
    if (m_task.isRunning() || !m_left.empty()) {
        const double parts = measuredParts.size();
        m_view->setProgress(MeasureView::Progress{m_stop.stop_requested() ? tr("stopping") : what,
                                                  (parts - static_cast<double>(m_left.size()) + share) / parts});
    }
}

void MeasureController::use(std::size_t row)
{
    if (const auto *colliders = m_measured->get<ColliderTrial>(m_view->part())) {
        const ColliderRow &chosen = colliders->rows[row];
        const double excess = chosen.tolerance.value_or(m_choices.collider().excess);
        m_choices.setCollider({.kind = chosen.kind, .excess = excess});
        tell(tr("Balls fall by “%1” from now on").arg(QString::fromStdString(nameOf(chosen))));
    } else if (const auto *steps = m_measured->get<StepTrial>(m_view->part())) {
        const StepRow &chosen = steps->rows[row];
        m_choices.setStepping(chosen.timeStep, chosen.isAsInDissertation);
        tell(tr("Balls are stepped by “%1” from now on").arg(QString::fromStdString(nameOf(chosen))));
    } else if (const auto *frames = m_measured->get<FrameTrial>(m_view->part())) {
        const FrameRow &chosen = frames->rows[row];
        m_quality.setTolerance(chosen.tolerance);
        tell(tr("Pictures are drawn with a tolerance of %1 from now on").arg(QString::fromStdString(nameOf(chosen))));
    }
}

void MeasureController::askWhere()
{
    const Document &document = m_seen->document();
    const QDir folder = document.hasOwnFile()
        ? QFileInfo(document.path()).dir()
        : QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    auto *dialog = new QFileDialog(&m_window, tr("Export Measurement"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Pages (*.html)"));
    dialog->setDefaultSuffix(QStringLiteral("html"));
    dialog->selectFile(folder.filePath(tr("%1-measured.html").arg(QFileInfo(m_measured->of.name).completeBaseName())));
    connect(dialog, &QFileDialog::fileSelected, this, &MeasureController::write);
    dialog->open();
}

void MeasureController::write(const QString &path)
{
    m_writing.finish(); // the one before, if it still goes on
    m_writing.start(
        [path, all = *m_measured->measurement()] {
            return writeWhole(QFile::encodeName(path).toStdString(), pageOf(all));
        },
        [this, path](const std::expected<void, std::string> &written) {
            m_failure = written ? QString()
                                : tr("“%1” was not written: %2.").arg(path, QString::fromStdString(written.error()));
            if (written) {
                tell(tr("Saved %1").arg(QDir::toNativeSeparators(path)));
            }
            showState();
            Q_EMIT exported(written.has_value());
        });
}

void MeasureController::tell(const QString &words)
{
    m_window.statusBar()->showMessage(words, 5000);
}

}
