// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "exportdialog.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/formats/numbertext.h"
#include "exportwords.h"
#include "messagestrip.h"

namespace romanesco {

namespace {

constexpr int typingPause = 150;
constexpr int progressInterval = 100;
constexpr int progressSteps = 1000;

std::filesystem::path nativePath(const QString &path)
{
    return QFile::encodeName(path).toStdString();
}

QString endingOf(ExportFormat format)
{
    switch (format) {
    case ExportFormat::Obj:
        return QStringLiteral(".obj");
    case ExportFormat::Ply:
        return QStringLiteral(".ply");
    case ExportFormat::Stl:
        return QStringLiteral(".stl");
    case ExportFormat::Glb:
        break;
    }
    return QStringLiteral(".glb");
}

}

ExportDialog::ExportDialog(ExportSource source, const QString &proposal, QWidget *parent)
    : QDialog(parent)
    , m_source(std::move(source))
    , m_folder(QFileInfo(proposal).dir())
    , m_format(new QComboBox)
    , m_path(new QLineEdit(QDir::toNativeSeparators(proposal)))
    , m_groups(new QCheckBox(tr("A &group for each branch")))
    , m_weld(new QCheckBox(tr("&Merge vertices that coincide, and drop walls between copies")))
    , m_digits(new QSpinBox)
    , m_form(new QWidget)
    , m_forecast(new QLabel)
    , m_trouble(new MessageStrip(MessageStrip::Closing::ByProgram))
    , m_progress(new QProgressBar)
    , m_buttons(new QDialogButtonBox)
    , m_start(m_buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole))
    , m_close(m_buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole))
    , m_estimating([this](const EstimateJob &job, const std::stop_token &stop) { runEstimate(job, stop); })
    , m_export(*this)
{
    assert(m_source.scene && "there is something to export");
    for (const QString &file : m_source.files) {
        m_files.push_back(nativePath(file));
    }
    setWindowTitle(tr("Export"));
    buildForm();
    buildButtons();
    m_forecast->setWordWrap(true);
    m_progress->setAccessibleName(tr("How far the export is"));
    m_progress->hide();
    auto *column = new QVBoxLayout(this);
    for (QWidget *part : std::initializer_list<QWidget *>{m_form, m_forecast, m_trouble, m_progress}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    column->addWidget(m_buttons);
    resize(560, sizeHint().height());

    m_estimateTimer.setSingleShot(true);
    m_estimateTimer.setInterval(typingPause);
    connect(&m_estimateTimer, &QTimer::timeout, this, &ExportDialog::postEstimate);
    m_progressTimer.setInterval(progressInterval);
    connect(&m_progressTimer, &QTimer::timeout, this, &ExportDialog::showProgress);
    takeEnding();
    postEstimate();
}

ExportDialog::~ExportDialog()
{
    m_stop.request_stop();
}

void ExportDialog::buildForm()
{
    const auto addFormat = [this](const QString &name, ExportFormat format) {
        m_format->addItem(name, static_cast<int>(format));
    };
    addFormat(tr("Wavefront OBJ, with materials (.obj)"), ExportFormat::Obj);
    addFormat(tr("PLY, with colours (.ply)"), ExportFormat::Ply);
    addFormat(tr("STL, for printing (.stl)"), ExportFormat::Stl);
    addFormat(tr("glTF, with instances and textures (.glb)"), ExportFormat::Glb);
    m_digits->setRange(0, NumberText::mostDigits);
    m_digits->setSpecialValueText(tr("As many as are needed"));
    m_digits->setToolTip(tr("Significant digits of each number in an OBJ; fewer make a smaller file"));
    m_groups->setToolTip(tr("In place of the groups of the meshes, in an OBJ"));
    m_weld->setToolTip(tr("Makes one surface of all copies and tells whether it is closed; up to %L1 faces")
                           .arg(static_cast<qulonglong>(mostWeldedFaces)));

    auto *browseButton = new QPushButton(tr("&Browse…"));
    browseButton->setAutoDefault(false);
    browseButton->setToolTip(tr("Choose the file in a list"));
    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    auto *file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(browseButton);
    auto *rows = new QFormLayout(m_form);
    rows->setContentsMargins(0, 0, 0, 0);
    auto *fileLabel = new QLabel(tr("F&ile:"));
    fileLabel->setBuddy(m_path);
    m_path->setAccessibleName(tr("File to write"));
    rows->addRow(fileLabel, file);
    rows->addRow(tr("&Format:"), m_format);
    rows->addRow(tr("&Digits:"), m_digits);
    rows->addRow(m_groups);
    rows->addRow(m_weld);

    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::takeEnding);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::changeEnding);
    connect(m_digits, &QSpinBox::valueChanged, this, &ExportDialog::change);
    connect(m_groups, &QCheckBox::toggled, this, &ExportDialog::change);
    connect(m_weld, &QCheckBox::toggled, this, &ExportDialog::change);
}

void ExportDialog::buildButtons()
{
    m_start->setDefault(true);
    // a second Enter, after the one that starts, is not meant to cancel
    m_close->setAutoDefault(false);
    connect(m_start, &QPushButton::clicked, this, &ExportDialog::start);
    connect(m_close, &QPushButton::clicked, this, [this] {
        if (isExporting()) {
            cancel();
        } else {
            reject();
        }
    });
    showRunning(false);
}

ExportFormat ExportDialog::format() const
{
    return static_cast<ExportFormat>(m_format->currentData().toInt());
}

QString ExportDialog::path() const
{
    const QString text = QDir::fromNativeSeparators(m_path->text());
    return text.isEmpty() ? QString() : m_folder.absoluteFilePath(text);
}

ExportOptions ExportDialog::options() const
{
    const bool isObj = format() == ExportFormat::Obj;
    const bool isRounded = isObj && m_digits->value() > 0;
    return {.format = format(),
            .digits = isRounded ? std::optional(m_digits->value()) : std::nullopt,
            .isGrouped = isObj && m_groups->isChecked(),
            .isWelded = m_weld->isChecked(),
            .source = m_source.name.toStdString()};
}

void ExportDialog::browse()
{
    auto *dialog = new QFileDialog(this, tr("Export To"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    // that a file would be replaced is said here, and the button's name
    dialog->setOption(QFileDialog::DontConfirmOverwrite);
    dialog->setNameFilters({tr("Meshes (*.obj *.ply *.stl *.glb)"), tr("All files (*)")});
    dialog->setDefaultSuffix(endingOf(format()).sliced(1));
    dialog->selectFile(path());
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString &file) { m_path->setText(QDir::toNativeSeparators(file)); });
    dialog->open();
}

/// A path with an ending that says nothing leaves the format as it is.
void ExportDialog::takeEnding()
{
    if (const auto known = exportFormat(nativePath(path()))) {
        const QSignalBlocker blocker(m_format);
        m_format->setCurrentIndex(m_format->findData(static_cast<int>(*known)));
    }
    change();
}

void ExportDialog::changeEnding()
{
    const QString text = m_path->text();
    const qsizetype endingSize = exportFormat(nativePath(path())) ? endingOf(format()).size() : 0;
    if (!text.isEmpty()) {
        const QSignalBlocker blocker(m_path);
        m_path->setText(text.chopped(endingSize) + endingOf(format()));
    }
    change();
}

void ExportDialog::change()
{
    ++m_revision;
    m_isStartWanted = false;
    m_groups->setEnabled(format() == ExportFormat::Obj);
    m_digits->setEnabled(format() == ExportFormat::Obj);
    m_start->setEnabled(!m_path->text().isEmpty());
    m_start->setText(tr("&Export"));
    m_trouble->fallSilent();
    m_estimateTimer.start();
}

void ExportDialog::postEstimate()
{
    m_estimateTimer.stop();
    if (!path().isEmpty()) {
        m_estimating.post({m_revision, options(), nativePath(path())});
    }
}

void ExportDialog::runEstimate(const EstimateJob &job, const std::stop_token &stop)
{
    ExportEstimate estimate = estimateExport(*m_source.scene, job.options, job.path, m_files, stop);
    QMetaObject::invokeMethod(
        this, [this, revision = job.revision, estimate = std::move(estimate)] { takeEstimate(revision, estimate); },
        Qt::QueuedConnection);
}

void ExportDialog::takeEstimate(quint64 revision, const ExportEstimate &estimate)
{
    if (revision != m_revision || isExporting()) {
        return;
    }
    m_estimatedRevision = revision;
    m_estimate = estimate;
    showEstimate();
    // what a file would be lost by is told before it happens
    if (std::exchange(m_isStartWanted, false) && estimate.obstacle.isEmpty() && !estimate.isReplacing) {
        start();
    }
    Q_EMIT estimated();
}

void ExportDialog::showEstimate()
{
    QString words = forecastText(m_estimate, options());
    if (m_estimate.isReplacing) {
        words += u' ' + tr("There is a file of this name, which will be replaced.");
    }
    m_forecast->setText(words);
    m_start->setText(m_estimate.isReplacing ? tr("&Replace") : tr("&Export"));
    m_start->setEnabled(m_estimate.obstacle.isEmpty());
    if (!m_estimate.obstacle.isEmpty()) {
        m_trouble->say(m_estimate.obstacle);
    }
}

void ExportDialog::start()
{
    std::error_code ignored;
    const bool isNewlyThere = !m_estimate.isReplacing && std::filesystem::exists(nativePath(path()), ignored);
    if (!isEstimated() || isNewlyThere) {
        m_isStartWanted = true;
        postEstimate();
        return;
    }
    m_stop = std::stop_source();
    m_written = 0;
    m_isClosing = false;
    m_elapsed.start();
    m_trouble->fallSilent();
    m_export.start(
        [this, scene = m_source.scene, options = options(), path = nativePath(path()), stop = m_stop.get_token()] {
            const auto progress = [this](std::uint64_t bytes) { m_written = bytes; };
            return exportToFile(*scene, options, path, {.stop = stop, .progress = progress, .files = &m_resources});
        },
        [this](const Outcome &outcome) { finish(outcome); });
    showRunning(true);
}

void ExportDialog::showRunning(bool isRunning)
{
    if (isRunning) {
        m_close->setFocus();
        m_progressTimer.start();
        showProgress();
    } else {
        m_progressTimer.stop();
    }
    m_form->setEnabled(!isRunning);
    m_start->setEnabled(!isRunning);
    m_progress->setVisible(isRunning);
    m_close->setEnabled(true);
    m_close->setText(isRunning ? tr("&Cancel") : tr("&Close"));
    m_close->setToolTip(isRunning ? tr("Stop; the file is left as it was") : tr("Close this window (Esc)"));
}

/// Before the first bytes nothing is known of how far it is.
void ExportDialog::showProgress()
{
    const auto written = static_cast<double>(m_written.load());
    const double all = std::pow(10.0, m_estimate.forecast->bytes.log10());
    const double share = std::min(written / all, 1.0);
    m_progress->setRange(0, written > 0.0 ? progressSteps : 0);
    m_progress->setValue(static_cast<int>(share * progressSteps));
    const QString size = sizeText(m_estimate.forecast->bytes);
    if (m_stop.stop_requested()) {
        m_forecast->setText(tr("Stopping…"));
    } else if (written <= 0.0) {
        m_forecast->setText(tr("Going through the copies…"));
    } else if (share >= 1.0) {
        m_forecast->setText(tr("Waiting for the disk…"));
    } else {
        const double left = static_cast<double>(m_elapsed.elapsed()) / 1000.0 * (1.0 - share) / share;
        m_forecast->setText(
            tr("%1 of about %2, about %3 left").arg(sizeText(Count(m_written.load())), size, durationText(left)));
    }
}

void ExportDialog::cancel()
{
    m_stop.request_stop();
    m_close->setEnabled(false);
    showProgress();
}

void ExportDialog::reject()
{
    if (!isExporting()) {
        QDialog::reject();
    } else if (m_stop.stop_requested() || m_elapsed.elapsed() <= m_patience.count()) {
        m_isClosing = true;
        cancel();
    } else {
        askWhetherToClose();
    }
}

/// The export goes on meanwhile, and the question goes away with its end.
void ExportDialog::askWhetherToClose()
{
    if (m_question) {
        return;
    }
    m_question = new QMessageBox(QMessageBox::Question, tr("Export"),
                                 tr("The export has been running for %1. Closing this window stops it, and nothing is "
                                    "written.")
                                     .arg(durationText(static_cast<double>(m_elapsed.elapsed()) / 1000.0)),
                                 QMessageBox::NoButton, this);
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton *stop = m_question->addButton(tr("&Stop and Close"), QMessageBox::AcceptRole);
    QPushButton *goOn = m_question->addButton(tr("&Go On"), QMessageBox::RejectRole);
    m_question->setDefaultButton(goOn);
    connect(stop, &QPushButton::clicked, this, [this] {
        m_isClosing = true;
        cancel();
    });
    m_question->open();
}

void ExportDialog::finish(const Outcome &outcome)
{
    if (m_question) {
        m_question->close();
    }
    showRunning(false);
    if (outcome) {
        const QString file = path();
        accept();
        Q_EMIT exported(file, outcome->bytes, remarksText(*outcome));
    } else if (m_isClosing) {
        QDialog::reject();
    } else {
        showEstimate();
        m_path->setFocus();
        m_trouble->say(m_stop.stop_requested()
                           ? tr("The export was cancelled. Nothing was written.")
                           : tr("“%1” was not written: %2.").arg(path(), QString::fromStdString(outcome.error())));
    }
}

}
