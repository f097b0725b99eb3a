// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <atomic>
#include <expected>
#include <stop_token>

#include <QDialog>
#include <QTimer>

#include "app/drawing/turn.h"
#include "backgroundtask.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace romanesco {

/// Asks for a folder, how many pictures and how large, and writes pictures of a full turn as `romanesco render --turntable`
/// does, in the background: each file appears whole or not at all, and those that are there stay when it is cancelled.
class TurntableDialog : public QDialog
{
    Q_OBJECT
public:
    /// turn: what is drawn and from where; its count and size are asked for. proposal: of the first file without its
    /// number and ending.
    TurntableDialog(Turn turn, const QString &proposal, QWidget *parent = nullptr);
    ~TurntableDialog() override;

    [[nodiscard]] bool isDrawing() const { return m_drawing.isRunning(); }

    /// While it draws this cancels; the dialog closes when that has ended.
    void reject() override;

Q_SIGNALS:
    /// So many pictures are there, in this folder.
    void saved(int count, const QString &folder);

private:
    void buildForm(const QString &proposal);
    void browse();
    void showFiles();
    void start();
    void cancel();
    void showProgress();
    void finish(const std::expected<int, QString> &drawn);
    [[nodiscard]] std::expected<int, QString> draw(const Turn &turn, const FramePattern &names,
                                                   const std::stop_token &stop);
    [[nodiscard]] std::optional<FramePattern> names() const;

    Turn m_turn;
    QWidget *m_form;
    QLineEdit *m_folder;
    QLineEdit *m_name;
    QSpinBox *m_count;
    QSpinBox *m_width;
    QSpinBox *m_height;
    QLabel *m_words;
    QProgressBar *m_progress;
    QDialogButtonBox *m_buttons;
    QPushButton *m_start;
    QPushButton *m_close;

    std::atomic<int> m_finished = 0;
    std::stop_source m_stop;
    bool m_isClosing = false;
    QTimer m_progressTimer;
    /// Last: its end waits for the work.
    BackgroundTask<std::expected<int, QString>> m_drawing;
};

}
