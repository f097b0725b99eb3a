// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <QObject>

#include "backgroundtask.h"
#include "measuredparts.h"

class QMainWindow;

namespace romanesco {

class MeasurePane;
class MeasureView;
class PhysicsChoices;
class PhysicsController;
class QualityControl;
class TextTab;

/// Measures the scene that is seen, in the background, and lets balls fall and pictures be drawn by what is chosen of it. For the GUI thread.
class MeasureController : public QObject
{
    Q_OBJECT
public:
    /// window owns it; all others must outlive it.
    MeasureController(MeasurePane &pane, const PhysicsController &physics, PhysicsChoices &choices,
                      QualityControl &quality, QMainWindow &window);
    /// Waits for what is under way, which hears of it as TrialContext says.
    ~MeasureController() override;

    /// Another text is seen.
    void follow(TextTab &seen);

Q_SIGNALS:
    /// All was measured, or that was cancelled.
    void finished();
    /// The page is there, or could not be written.
    void exported(bool isThere);

private:
    void connectView();
    void showState();
    [[nodiscard]] QString remark() const;
    void measure();
    void measureNext();
    void take(MeasuredPart part, MeasuredTrial trial);
    void showProgress(const QString &what, double share);
    void use(std::size_t row);
    void askWhere();
    void write(const QString &path);
    void tell(const QString &words);

    MeasurePane &m_pane;
    const PhysicsController &m_physics;
    PhysicsChoices &m_choices;
    QualityControl &m_quality;
    QMainWindow &m_window;
    /// Null until the panel is opened.
    MeasureView *m_view = nullptr;
    TextTab *m_seen = nullptr;
    /// Lives as long as this text is seen, for what is connected to it.
    std::unique_ptr<QObject> m_whileSeen;

    /// What is under way: of what, what is left of it, and what it has come to.
    MeasuredScene m_scene;
    std::vector<MeasuredPart> m_left;
    std::shared_ptr<const MeasuredParts> m_made;
    std::stop_source m_stop;
    /// What is shown.
    std::shared_ptr<const MeasuredParts> m_measured;
    /// Why a page was not written: a sentence, or empty.
    QString m_failure;
    /// Last: their ends wait for the work.
    BackgroundTask<std::expected<void, std::string>> m_writing;
    BackgroundTask<MeasuredTrial> m_task;
};

}
