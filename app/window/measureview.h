// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "measuredparts.h"

class QBoxLayout;
class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QSplitter;
class QTableView;

namespace romanesco {

class FigureModel;
class MeasurePlot;

/// What was measured of a scene: a plot of error against cost beside a table of the same, and what can be done with it.
class MeasureView : public QWidget
{
    Q_OBJECT
public:
    explicit MeasureView(QWidget *parent = nullptr);

    /// One above the other, for a panel that is higher than wide.
    void setUpright(bool isUpright);
    /// Null for nothing yet.
    void setMeasured(std::shared_ptr<const MeasuredParts> measured);
    /// What is to be said of it all: sentences, or empty.
    void setRemark(const QString &remark);
    /// Why nothing can be measured now: a sentence, or empty.
    void setObstacle(const QString &obstacle);
    /// What is under way, and the share of all that is done; nothing once nothing is.
    struct Progress {
        QString what;
        double share = 0.0;
    };
    void setProgress(const std::optional<Progress> &progress);
    [[nodiscard]] MeasuredPart part() const;

Q_SIGNALS:
    void measureRequested();
    void cancelRequested();
    /// A row of the trial of part().
    void useRequested(std::size_t row);
    void exportRequested();

private:
    QWidget *makeControls();
    void makeButtons();
    void makeChoosers();
    QTableView *makeTable();
    void showPart();
    void showPlot();
    void showWords();
    void chooseRow();
    void selectRow(std::size_t row);
    [[nodiscard]] bool isOfUse() const;
    void offerUse();
    void use();
    /// Null where the part has none, or is none of these.
    template<typename Trial>
    [[nodiscard]] const Trial *shown() const
    {
        return m_measured ? m_measured->get<Trial>(part()) : nullptr;
    }
    [[nodiscard]] QuerySet set() const;
    [[nodiscard]] FramePlace place() const;
    [[nodiscard]] QStringList wordsOfTrial() const;
    [[nodiscard]] QString useTip() const;
    /// Of the trial; nothing where none is chosen.
    [[nodiscard]] std::optional<std::size_t> chosenRow() const;
    void spanReasons();

    std::shared_ptr<const MeasuredParts> m_measured;
    QString m_remark;
    QString m_obstacle;
    std::optional<Progress> m_progress;

    QBoxLayout *m_parts;
    QSplitter *m_both;
    QPushButton *m_measure;
    QPushButton *m_cancel;
    QProgressBar *m_bar;
    QFormLayout *m_form;
    QComboBox *m_part;
    /// Of queries, or places that pictures are drawn from.
    QComboBox *m_set;
    QComboBox *m_kind;
    QPushButton *m_use;
    QPushButton *m_export;
    QLabel *m_words;
    MeasurePlot *m_plot;
    FigureModel *m_figures;
    QSortFilterProxyModel *m_sorted;
    QTableView *m_table;
};

}
