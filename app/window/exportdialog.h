// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

#include "backgroundtask.h"
#include "core/base/newestjob.h"
#include "exportestimate.h"
#include "resourcefiles.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QMessageBox;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace romanesco {

class MessageStrip;

/// What is to be exported.
struct ExportSource {
    /// Not null.
    std::shared_ptr<const Scene> scene;
    /// What it is called in the file: the name of its text.
    QString name;
    /// What it is made from, never written over; absolute paths.
    QStringList files;
};

/// Asks for a file and its format, tells what it will come to, and writes it in the background. The file appears whole or not
/// at all. The dialog closes once it is there; it stays open after an error, with a sentence that says why.
class ExportDialog : public QDialog
{
    Q_OBJECT
public:
    /// proposal: an absolute path, whose ending chooses the format. Paths that are typed are relative to its folder.
    ExportDialog(ExportSource source, const QString &proposal, QWidget *parent = nullptr);
    /// Stops what is under way and waits for it, some milliseconds unless the disk is slow.
    ~ExportDialog() override;

    /// An export that has run for longer is not thrown away by closing the dialog before a question; 5 s at first.
    void setPatience(std::chrono::milliseconds patience) { m_patience = patience; }

    /// Where the file will stand, and how it is written, as it is chosen now.
    [[nodiscard]] QString path() const;
    [[nodiscard]] ExportOptions options() const;

    [[nodiscard]] bool isExporting() const { return m_export.isRunning(); }
    /// Of path() and options().
    [[nodiscard]] bool isEstimated() const { return m_estimatedRevision == m_revision; }

    /// Closes at once unless an export runs: that is stopped first, after a question where it has run for long.
    void reject() override;

Q_SIGNALS:
    void estimated();
    /// The file is there, and the dialog closed. remarks: sentences about what is not as one might think; often empty.
    void exported(const QString &path, quint64 bytes, const QString &remarks);

private:
    using Outcome = std::expected<ExportReport, std::string>;
    struct EstimateJob {
        quint64 revision;
        ExportOptions options;
        std::filesystem::path path;
    };

    void buildForm();
    void buildButtons();
    void browse();
    void takeEnding();
    void changeEnding();
    void change();
    void postEstimate();
    void showEstimate();
    void runEstimate(const EstimateJob &job, const std::stop_token &stop);
    void takeEstimate(quint64 revision, const ExportEstimate &estimate);
    void start();
    void showRunning(bool isRunning);
    void showProgress();
    void cancel();
    void askWhetherToClose();
    void finish(const Outcome &outcome);
    [[nodiscard]] ExportFormat format() const;

    ExportSource m_source;
    std::vector<std::filesystem::path> m_files;
    QDir m_folder;
    std::chrono::milliseconds m_patience{5000};

    QComboBox *m_format;
    QLineEdit *m_path;
    QCheckBox *m_groups;
    QCheckBox *m_weld;
    QSpinBox *m_digits;
    QWidget *m_form;
    QLabel *m_forecast;
    MessageStrip *m_trouble;
    QProgressBar *m_progress;
    QDialogButtonBox *m_buttons;
    QPushButton *m_start;
    QPushButton *m_close;
    QPointer<QMessageBox> m_question;

    ResourceFiles m_resources;
    /// Of what is chosen, and of what the forecast shown is about.
    quint64 m_revision = 0;
    quint64 m_estimatedRevision = 0;
    /// As soon as it is known what it comes to.
    bool m_isStartWanted = false;
    ExportEstimate m_estimate;
    QTimer m_estimateTimer;

    std::atomic<quint64> m_written = 0;
    std::stop_source m_stop;
    bool m_isClosing = false;
    QElapsedTimer m_elapsed;
    QTimer m_progressTimer;
    /// Last: their ends wait for the work.
    NewestJob<EstimateJob> m_estimating;
    BackgroundTask<Outcome> m_export;
};

}
