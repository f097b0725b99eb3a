// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measureview.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>

#include "core/measure/trialplots.h"
#include "core/measure/words.h"
#include "figuremodel.h"
#include "measureplot.h"

namespace romanesco {

namespace {

constexpr int progressSteps = 1000;
constexpr int controlsWidth = 220;

/// A sentence with its end, as it begins.
QString sentence(const std::string &words)
{
    QString text = QString::fromStdString(words);
    text[0] = text[0].toUpper();
    return text + u'.';
}

}

MeasureView::MeasureView(QWidget *parent)
    : QWidget(parent)
    , m_parts(new QHBoxLayout(this))
    , m_both(new QSplitter)
    , m_words(new QLabel)
    , m_plot(new MeasurePlot)
    , m_figures(new FigureModel(this))
    , m_sorted(new QSortFilterProxyModel(this))
    , m_table(makeTable())
{
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setAccessibleName(tr("What was measured"));
    m_both->addWidget(m_plot);
    m_both->addWidget(m_table);
    m_both->setChildrenCollapsible(false);
    m_both->setSizes({480, 560});
    auto *column = new QVBoxLayout;
    column->setSpacing(8);
    column->addWidget(m_words);
    column->addWidget(m_both, 1);
    m_parts->setContentsMargins(8, 4, 8, 4);
    m_parts->setSpacing(16);
    m_parts->addWidget(makeControls());
    m_parts->addLayout(column, 1);
    connect(m_plot, &MeasurePlot::chosen, this, &MeasureView::selectRow);
    connect(m_plot, &MeasurePlot::activated, this, &MeasureView::use);
    setProgress({});
    showPart();
}

QWidget *MeasureView::makeControls()
{
    makeButtons();
    m_form = new QFormLayout;
    m_form->setHorizontalSpacing(8);
    m_form->setVerticalSpacing(4);
    makeChoosers();
    m_bar = new QProgressBar;
    m_bar->setRange(0, progressSteps);
    m_bar->setAccessibleName(tr("How far measuring is"));
    auto *controls = new QWidget;
    controls->setFixedWidth(controlsWidth);
    auto *column = new QVBoxLayout(controls);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    for (QWidget *part : std::initializer_list<QWidget *>{m_measure, m_cancel, m_bar}) {
        column->addWidget(part);
    }
    column->addSpacing(4);
    column->addLayout(m_form);
    column->addSpacing(4);
    column->addWidget(m_use);
    column->addWidget(m_export);
    column->addStretch(1);
    return controls;
}

void MeasureView::makeButtons()
{
    m_measure = new QPushButton(tr("&Measure This Scene"));
    connect(m_measure, &QPushButton::clicked, this, [this] {
        Q_EMIT measureRequested();
        m_cancel->setFocus();
    });
    m_cancel = new QPushButton(tr("Ca&ncel"));
    m_cancel->setToolTip(tr("Ends what is under way; what is measured by then stays"));
    connect(m_cancel, &QPushButton::clicked, this, &MeasureView::cancelRequested);
    m_use = new QPushButton;
    connect(m_use, &QPushButton::clicked, this, &MeasureView::use);
    m_export = new QPushButton(tr("E&xport as HTML…"));
    connect(m_export, &QPushButton::clicked, this, &MeasureView::exportRequested);
}

void MeasureView::makeChoosers()
{
    const auto add = [this](QComboBox *&box, const QString &words, const QString &name, const QString &tip) {
        box = new QComboBox;
        box->setAccessibleName(name);
        box->setToolTip(tip);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        m_form->addRow(words, box);
    };
    add(m_part, tr("Sho&w"), tr("What is shown"), tr("What was tried, each against what is exact"));
    // in the order of MeasuredPart
    m_part->addItems({tr("Colliders"), tr("Time step"), tr("Rendering"), tr("Depth"), tr("Export digits")});
    add(m_set, tr("&Queries"), tr("From where"),
        tr("From where the nearest point was asked for, or the scene was drawn"));
    add(m_kind, tr("&Plot"), tr("What is plotted"), tr("What the plot sets against each other"));
    connect(m_part, &QComboBox::currentIndexChanged, this, &MeasureView::showPart);
    connect(m_set, &QComboBox::currentIndexChanged, this, &MeasureView::showPlot);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &MeasureView::showPlot);
}

QTableView *MeasureView::makeTable()
{
    auto *table = new QTableView;
    m_sorted->setSourceModel(m_figures);
    m_sorted->setSortRole(FigureModel::SortRole);
    table->setModel(m_sorted);
    table->setAccessibleName(tr("Figures"));
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->setSortingEnabled(true);
    table->sortByColumn(0, Qt::AscendingOrder);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setHighlightSections(false);
    connect(table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &MeasureView::chooseRow);
    connect(table, &QTableView::activated, this, &MeasureView::use);
    connect(m_sorted, &QAbstractItemModel::layoutChanged, this, &MeasureView::spanReasons);
    return table;
}

void MeasureView::setUpright(bool isUpright)
{
    m_parts->setDirection(isUpright ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_both->setOrientation(isUpright ? Qt::Vertical : Qt::Horizontal);
}

void MeasureView::setMeasured(std::shared_ptr<const MeasuredParts> measured)
{
    m_measured = std::move(measured);
    showPart();
}

void MeasureView::setRemark(const QString &remark)
{
    m_remark = remark;
    showWords();
}

void MeasureView::setObstacle(const QString &obstacle)
{
    m_obstacle = obstacle;
    m_measure->setEnabled(obstacle.isEmpty());
    m_measure->setToolTip(obstacle.isEmpty() ? tr("Tries every collider, tolerance, time step, pixel tolerance, depth "
                                                  "and number of digits on the scene as it "
                                                  "is shown, each "
                                                  "against what is exact; editing can go on")
                                             : obstacle);
    showWords();
}

void MeasureView::setProgress(const std::optional<Progress> &progress)
{
    const bool hadFocus = m_cancel->hasFocus();
    m_progress = progress;
    m_measure->setVisible(!progress);
    m_cancel->setVisible(progress.has_value());
    m_bar->setVisible(progress.has_value());
    m_bar->setValue(progress ? static_cast<int>(progress->share * progressSteps) : 0);
    if (hadFocus && !progress) {
        m_measure->setFocus();
    }
    showWords();
}

MeasuredPart MeasureView::part() const
{
    return static_cast<MeasuredPart>(m_part->currentIndex());
}

QuerySet MeasureView::set() const
{
    return static_cast<QuerySet>(m_set->currentData().toInt());
}

FramePlace MeasureView::place() const
{
    return static_cast<FramePlace>(m_set->currentData().toInt());
}

/// What there is to choose from depends on the part, and on what was measured of it.
void MeasureView::showPart()
{
    const QString set = m_set->currentText();
    {
        const QSignalBlocker blocker(m_set);
        m_set->clear();
        const auto add = [this](auto value) {
            m_set->addItem(QString::fromUtf8(nameOf(value).data(), qsizetype(nameOf(value).size())), int(value));
        };
        if (const auto *colliders = shown<ColliderTrial>()) {
            std::ranges::for_each(colliders->sets, add, &ColliderTrial::Set::queries);
        } else if (const auto *frames = shown<FrameTrial>()) {
            std::ranges::for_each(frames->references, add, &FrameReference::place);
        }
        m_set->setCurrentIndex(std::max(m_set->findText(set), 0));
    }
    qobject_cast<QLabel *>(m_form->labelForField(m_set))
        ->setText(part() == MeasuredPart::Rendering ? tr("&From") : tr("&Queries"));
    m_form->setRowVisible(m_set, part() == MeasuredPart::Colliders || part() == MeasuredPart::Rendering);
    m_form->setRowVisible(m_kind, part() != MeasuredPart::Depth);
    m_plot->setVisible(part() != MeasuredPart::Depth); // it costs the same whatever the depth
    m_use->setVisible(isOfUse());
    m_set->setEnabled(m_set->count() > 0);
    showPlot();
}

void MeasureView::showPlot()
{
    const QString chosen = m_table->currentIndex().siblingAtColumn(0).data().toString();
    std::vector<TrialPlot> plots;
    FigureTable table;
    if (const auto *colliders = shown<ColliderTrial>()) {
        plots = plotsOf(*colliders, set());
        table = FigureTable::of(*colliders, set());
    } else if (const auto *steps = shown<StepTrial>()) {
        plots = plotsOf(*steps);
        table = FigureTable::of(*steps);
    } else if (const auto *frames = shown<FrameTrial>()) {
        plots = plotsOf(*frames, place());
        table = FigureTable::of(*frames, place());
    } else if (const auto *depths = shown<DepthTrial>()) {
        table = FigureTable::of(*depths);
    } else if (const auto *digits = shown<DigitTrial>()) {
        plots = plotsOf(*digits);
        table = FigureTable::of(*digits);
    }
    m_figures->setTable(std::move(table));
    spanReasons();
    {
        const QSignalBlocker blocker(m_kind);
        const int kind = m_kind->currentIndex();
        m_kind->clear();
        for (const TrialPlot &plot : plots) {
            m_kind->addItem(QString::fromStdString(plot.title));
        }
        m_kind->setCurrentIndex(m_kind->count() == 0 ? -1 : std::clamp(kind, 0, m_kind->count() - 1));
    }
    m_kind->setEnabled(m_kind->count() > 0);
    TrialPlot plot = plots.empty() ? TrialPlot() : plots[static_cast<std::size_t>(m_kind->currentIndex())];
    const auto &rows = m_figures->table().rows;
    QStringList tips;
    for (const std::size_t number : plot.rows) {
        tips << m_figures->table().wordsOf(*std::ranges::find(rows, number, &FigureTable::Row::number));
    }
    m_plot->setPlot(std::move(plot), tips);
    m_export->setEnabled(m_measured && m_measured->measurement());
    m_export->setToolTip(m_export->isEnabled() ? tr("All that was measured, as a page with tables and plots")
                                               : tr("There is nothing to export until colliders are measured"));
    const auto again = std::ranges::find(rows, chosen, &FigureTable::Row::name);
    if (again != rows.end()) {
        selectRow(again->number);
    }
    chooseRow();
    showWords();
}

void MeasureView::showWords()
{
    QStringList words;
    const auto &trial = m_measured ? m_measured->trial(part()) : std::nullopt;
    if (m_progress) {
        words << tr("Measuring: %1…").arg(m_progress->what);
    } else if (!m_obstacle.isEmpty()) {
        words << m_obstacle;
    } else if (!m_measured) {
        words << tr(
            "Measures on this scene what each way to search for the nearest point costs and how far off it is, "
            "and the same of each time step and pixel tolerance, of places deep inside, and of the digits of an "
            "exported file. It takes some seconds, and more where there "
            "are many faces.");
    }
    if (!m_remark.isEmpty()) {
        words << m_remark;
    }
    if (trial && !*trial) {
        words << sentence(trial->error());
    }
    m_words->setText((words + wordsOfTrial()).join(u' '));
}

/// What was asked, or drawn.
QStringList MeasureView::wordsOfTrial() const
{
    QStringList words;
    if (const auto *colliders = shown<ColliderTrial>()) {
        const auto asked = std::ranges::find(colliders->sets, set(), &ColliderTrial::Set::queries);
        words << sentence(wordsOf(*colliders));
        if (asked != colliders->sets.end()) {
            words << sentence(wordsOf(*asked));
        }
    } else if (const auto *steps = shown<StepTrial>()) {
        words << sentence(wordsOf(*steps));
    } else if (const auto *frames = shown<FrameTrial>()) {
        const auto drawn = std::ranges::find(frames->references, place(), &FrameReference::place);
        words << sentence(wordsOf(*frames));
        if (drawn != frames->references.end()) {
            words << sentence(wordsOf(*drawn));
        }
    } else if (const auto *depths = shown<DepthTrial>()) {
        words << sentence(wordsOf(*depths));
    } else if (const auto *digits = shown<DigitTrial>()) {
        words << sentence(wordsOf(*digits));
    }
    return words;
}

/// A reason takes all columns but the first.
void MeasureView::spanReasons()
{
    m_table->clearSpans();
    for (int row = 0; row < m_sorted->rowCount(); ++row) {
        if (!m_figures->row(m_sorted->mapToSource(m_sorted->index(row, 0)).row()).reason.isEmpty()) {
            m_table->setSpan(row, 1, 1, m_sorted->columnCount() - 1);
        }
    }
}

std::optional<std::size_t> MeasureView::chosenRow() const
{
    const QModelIndexList chosen = m_table->selectionModel()->selectedRows();
    return chosen.isEmpty() ? std::nullopt
                            : std::optional(m_figures->row(m_sorted->mapToSource(chosen.first()).row()).number);
}

void MeasureView::chooseRow()
{
    m_plot->choose(chosenRow());
    offerUse();
}

void MeasureView::selectRow(std::size_t row)
{
    const auto &rows = m_figures->table().rows;
    const auto found = std::ranges::find(rows, row, &FigureTable::Row::number);
    if (found != rows.end()) {
        m_table->selectRow(m_sorted->mapFromSource(m_figures->index(static_cast<int>(found - rows.begin()), 0)).row());
    }
}

/// Digits are chosen for each export.
bool MeasureView::isOfUse() const
{
    return part() != MeasuredPart::Depth && part() != MeasuredPart::Digits;
}

void MeasureView::offerUse()
{
    const QModelIndexList chosen = m_table->selectionModel()->selectedRows();
    if (chosen.isEmpty()) {
        m_use->setText(tr("&Use This"));
        m_use->setEnabled(false);
        m_use->setToolTip(tr("Choose a point of the plot or a row of the table"));
        return;
    }
    const FigureTable::Row &row = m_figures->row(m_sorted->mapToSource(chosen.first()).row());
    m_use->setText(tr("&Use “%1”").arg(row.name));
    const QString why = row.reason.isEmpty() ? row.obstacle : row.reason;
    m_use->setEnabled(why.isEmpty() && isOfUse());
    m_use->setToolTip(why.isEmpty() ? useTip() : sentence(why.toStdString()));
}

QString MeasureView::useTip() const
{
    return part() == MeasuredPart::Rendering
        ? tr("Pictures at rest are drawn with this tolerance from now on (Enter in the table)")
        : tr("Balls fall by this from now on (Enter in the table)");
}

void MeasureView::use()
{
    if (m_use->isEnabled()) {
        Q_EMIT useRequested(*chosenRow());
    }
}

}
