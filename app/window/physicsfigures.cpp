// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "physicsfigures.h"

#include <algorithm>

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableView>
#include <QVBoxLayout>

#include "ballmodel.h"
#include "energygraph.h"

namespace romanesco {

namespace {

/// Milliseconds.
constexpr qint64 betweenWords = 200;

QString wordsOf(const LiveSimulation::Frame &frame)
{
    const QLocale locale;
    QStringList lines;
    if (!frame.remark.empty()) {
        lines << QString::fromStdString(frame.remark);
    }
    if (!frame.isStarted) {
        lines << PhysicsFigures::tr("Play lets the balls of the scene fall. Drop others by a click, or let it rain.");
        return lines.join(u'\n');
    }
    const auto resting = std::ranges::count_if(frame.balls, &LiveSimulation::BallFrame::isAsleep);
    lines << PhysicsFigures::tr("Balls %1 · at rest %2 · contacts %3")
                 .arg(frame.balls.size())
                 .arg(resting)
                 .arg(frame.contacts);
    lines << PhysicsFigures::tr("%1 s, step %2")
                 .arg(locale.toString(frame.seconds, 'f', 2), locale.toString(frame.stepCount));
    const StepMeter::Figures &figures = frame.figures;
    if (figures.realTimeFactor > 0.0) {
        lines << PhysicsFigures::tr("%1× real time, %2 ms a step")
                     .arg(locale.toString(figures.realTimeFactor, 'g', 2),
                          locale.toString(figures.milliseconds, 'g', 2));
    }
    if (figures.nanoseconds > 0.0) {
        lines << PhysicsFigures::tr("%1 face tests, %2 ns a query")
                     .arg(locale.toString(figures.faceTests, 'f', 1), locale.toString(figures.nanoseconds, 'f', 0));
    }
    if (frame.lostSteps > 0) {
        lines << PhysicsFigures::tr("Steps that balls lost the rest of: %1").arg(frame.lostSteps);
    }
    lines << PhysicsFigures::tr("Energy %1").arg(locale.toString(frame.energy, 'g', 4));
    return lines.join(u'\n');
}

}

PhysicsFigures::PhysicsFigures(QWidget *parent)
    : QWidget(parent)
    , m_balls(new BallModel(this))
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    row->addWidget(makeWords());
    row->addWidget(makeList(), 1);
    m_sinceShown.start();
}

QWidget *PhysicsFigures::makeWords()
{
    auto *words = new QWidget;
    auto *column = new QVBoxLayout(words);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_words = new QLabel;
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setFixedWidth(230);
    m_words->setAccessibleName(tr("Figures"));
    m_energy = new EnergyGraph;
    m_energy->setToolTip(tr("The energy of all balls: of motion and of height"));
    column->addWidget(m_words);
    column->addWidget(m_energy, 1);
    return words;
}

QWidget *PhysicsFigures::makeList()
{
    m_list = new QTableView;
    m_list->setModel(m_balls);
    m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_list->setTabKeyNavigation(false);
    m_list->setShowGrid(false);
    m_list->setAccessibleName(tr("Balls"));
    m_list->setToolTip(tr("Those that are selected stand out in the picture"));
    m_list->verticalHeader()->hide();
    m_list->verticalHeader()->setDefaultSectionSize(m_list->fontMetrics().height() + 4);
    m_list->horizontalHeader()->setDefaultSectionSize(54);
    m_list->horizontalHeader()->setStretchLastSection(true);
    m_list->setMinimumWidth(180);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PhysicsFigures::selectionChanged);
    connect(m_balls, &QAbstractItemModel::modelReset, this, &PhysicsFigures::selectionChanged);
    return m_list;
}

void PhysicsFigures::addActions(const QList<QAction *> &actions)
{
    m_list->addActions(actions);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
}

std::vector<std::uint64_t> PhysicsFigures::selectedBalls() const
{
    std::vector<std::uint64_t> numbers;
    for (const QModelIndex &index : m_list->selectionModel()->selectedRows()) {
        numbers.push_back(m_balls->numberAt(index.row()));
    }
    std::ranges::sort(numbers);
    return numbers;
}

void PhysicsFigures::show(const std::shared_ptr<const LiveSimulation::Frame> &frame)
{
    if (frame->isPlaying && m_sinceShown.elapsed() < betweenWords) {
        return;
    }
    m_sinceShown.start();
    if (frame->stepCount < m_shownSteps) {
        m_energy->clear();
    }
    if (frame->stepCount != m_shownSteps) {
        m_energy->add(frame->energy);
    }
    m_shownSteps = frame->stepCount;
    m_balls->setFrame(frame);
    m_words->setText(wordsOf(*frame));
}

}
