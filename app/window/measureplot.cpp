// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measureplot.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>
#include <utility>

#include <QEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>

#include <qcustomplot.h>

namespace romanesco {

namespace {

/// Of a point; the mouse need not meet it so exactly.
constexpr double pointSize = 9.0;
constexpr double reach = 10.0;
/// Between the numbers of an axis.
constexpr int rowOfNumbers = 26;
constexpr int columnOfNumbers = 56;
/// Beside the decades, and below them for what is not off at all: parts of all of them.
constexpr double margin = 0.04;
constexpr double zeroBand = 0.28;
/// What is not off stands so far down in that.
constexpr double zeroPlace = 0.7;

QColor colourOf(const PlotPoint &point)
{
    return QColor(QLatin1String(plotColours[static_cast<std::size_t>(point.group) % plotColours.size()]));
}

QColor faint(QColor colour, double share)
{
    colour.setAlphaF(static_cast<float>(share));
    return colour;
}

}

MeasurePlot::MeasurePlot(QWidget *parent)
    : QFrame(parent)
    , m_plot(new QCustomPlot)
    , m_errorAxis(new QCPTextElement(m_plot))
{
    setFrameShape(StyledPanel);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_plot);
    setMinimumSize(240, 160);
    setAccessibleName(tr("Plot of error against cost"));
    setAccessibleDescription(tr("The table beside it has the same figures"));
    m_plot->xAxis->setScaleType(QCPAxis::stLogarithmic);
    m_plot->yAxis->setScaleType(QCPAxis::stLogarithmic);
    m_errorAxis->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_errorAxis->setMargins({8, 4, 8, 0});
    m_plot->plotLayout()->insertRow(0);
    m_plot->plotLayout()->addElement(0, 0, m_errorAxis);
    m_plot->plotLayout()->setRowSpacing(0);
    m_plot->installEventFilter(this);
    connect(m_plot, &QCustomPlot::beforeReplot, this, &MeasurePlot::numberAxes);
    connect(m_plot, &QCustomPlot::afterLayout, this, &MeasurePlot::placeLabels);
    draw();
}

void MeasurePlot::setPlot(TrialPlot plot, QStringList tips)
{
    m_shown = std::move(plot);
    m_tips = std::move(tips);
    m_front = paretoFront(m_shown.points);
    std::vector<double> costs;
    std::vector<double> errors;
    for (const PlotPoint &point : m_shown.points) {
        costs.push_back(point.cost);
        errors.push_back(point.error);
    }
    m_costs = decadesOf(std::move(costs));
    m_errors = decadesOf(std::move(errors));
    draw();
}

void MeasurePlot::choose(std::optional<std::size_t> row)
{
    if (row != m_chosen) {
        m_chosen = row;
        draw();
    }
}

void MeasurePlot::draw()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_labels.clear();
    const bool isEmpty = m_shown.points.empty();
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setVisible(!isEmpty);
        axis->grid()->setVisible(!isEmpty);
    }
    m_plot->xAxis->setLabel(QString::fromStdString(m_shown.costAxis));
    m_errorAxis->setText(QString::fromStdString(m_shown.errorAxis));
    const double wide = m_costs.last - m_costs.first;
    const double high = m_errors.last - m_errors.first;
    m_plot->xAxis->setRange(std::pow(10.0, m_costs.first - margin * wide),
                            std::pow(10.0, m_costs.last + margin * wide));
    m_plot->yAxis->setRange(std::pow(10.0, m_errors.first - zeroBand * high),
                            std::pow(10.0, m_errors.last + margin * high));
    if (!isEmpty) {
        drawFront();
    }
    for (const PlotPoint &point : m_shown.points) {
        m_labels << makeLabel(point);
    }
    for (const std::size_t point : std::views::reverse(frontFirst())) {
        drawPoint(point);
    }
    colour();
}

/// What lies above and right of it is beaten.
void MeasurePlot::drawFront()
{
    QCPGraph *front = m_plot->addGraph();
    front->setLineStyle(QCPGraph::lsStepLeft);
    for (std::size_t i = 0; i < m_shown.points.size(); ++i) {
        if (m_front[i]) {
            front->addData(m_shown.points[i].cost, heightOf(m_shown.points[i].error));
        }
    }
    front->setPen(QPen(faint(palette().color(QPalette::Text), 0.5), 1.0, Qt::DashLine));
}

void MeasurePlot::drawPoint(std::size_t point)
{
    const PlotPoint &shown = m_shown.points[point];
    const QPen pen(colourOf(shown), 1.5);
    const double height = heightOf(shown.error);
    if (m_shown.rows[point] == m_chosen) {
        QCPGraph *ring = m_plot->addGraph();
        ring->setLineStyle(QCPGraph::lsNone);
        ring->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(palette().highlight(), 2.0), Qt::NoBrush, pointSize + 8.0));
        ring->addData(shown.cost, height);
    }
    if (shown.spread && shown.spread->lowerQuartile > 0.0) {
        QCPGraph *quartiles = m_plot->addGraph();
        quartiles->setPen(pen);
        quartiles->addData(shown.spread->lowerQuartile, height);
        quartiles->addData(shown.spread->upperQuartile, height);
    }
    QCPGraph *graph = m_plot->addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, pen,
                                           m_front[point] ? QBrush(pen.color()) : palette().base(), pointSize));
    graph->addData(shown.cost, height);
}

QCPItemText *MeasurePlot::makeLabel(const PlotPoint &point) const
{
    auto *label = new QCPItemText(m_plot);
    label->setText(QString::fromStdString(point.label));
    label->position->setType(QCPItemPosition::ptAbsolute);
    label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setPadding({});
    return label;
}

/// The points, which these may hide, or their labels.
std::vector<std::size_t> MeasurePlot::frontFirst() const
{
    std::vector<std::size_t> points(m_shown.points.size());
    std::ranges::iota(points, std::size_t(0));
    std::ranges::stable_partition(points, [this](std::size_t point) { return m_front[point]; });
    return points;
}

/// As the palette has it.
void MeasurePlot::colour()
{
    m_plot->setBackground(palette().base());
    colour(*m_plot->xAxis);
    colour(*m_plot->yAxis);
    m_errorAxis->setTextColor(palette().color(QPalette::Text));
    m_errorAxis->setFont(font());
    for (QCPItemText *label : std::as_const(m_labels)) {
        label->setColor(palette().color(QPalette::Text));
        label->setFont(font());
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void MeasurePlot::colour(QCPAxis &axis) const
{
    const QColor text = palette().color(QPalette::Text);
    axis.setBasePen(QPen(faint(text, 0.6)));
    axis.setTickPen(Qt::NoPen);
    axis.setSubTickPen(Qt::NoPen);
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    axis.setTickLabelFont(font());
    axis.setLabelFont(font());
    axis.grid()->setPen(QPen(faint(text, 0.15)));
    axis.grid()->setZeroLinePen(Qt::NoPen);
}

/// As many numbers as there is room for.
void MeasurePlot::numberAxes()
{
    const auto number = [](QCPAxis &axis, const Decades &decades, int most) {
        const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
        for (int decade = decades.first; decade <= decades.last; ++decade) {
            const bool hasNumber = (decade - decades.first) % decades.step(std::max(most, 1)) == 0;
            ticker->addTick(std::pow(10.0, decade), hasNumber ? QString::fromStdString(decadeText(decade)) : QString());
        }
        axis.setTicker(ticker);
        return ticker;
    };
    number(*m_plot->xAxis, m_costs, m_plot->width() / columnOfNumbers);
    number(*m_plot->yAxis, m_errors, m_plot->height() / rowOfNumbers)->addTick(heightOf(0.0), tr("none"));
}

/// Beside the points, where there is room; else the mouse tells.
void MeasurePlot::placeLabels()
{
    const QRect all = m_plot->axisRect()->rect();
    LabelRoom room({double(all.x()), double(all.y()), double(all.width()), double(all.height())});
    for (std::size_t i = 0; i < m_shown.points.size(); ++i) {
        const QPointF place = placeOf(i);
        const double half = 0.5 * pointSize + 1.0;
        room.take({place.x() - half, place.y() - half, 2.0 * half, 2.0 * half});
        if (const auto &spread = m_shown.points[i].spread; spread && spread->lowerQuartile > 0.0) {
            const double from = m_plot->xAxis->coordToPixel(spread->lowerQuartile);
            room.take({from, place.y() - 1.0, m_plot->xAxis->coordToPixel(spread->upperQuartile) - from, 2.0});
        }
    }
    const QFontMetricsF metrics(font());
    for (const std::size_t i : frontFirst()) {
        QCPItemText *label = m_labels[static_cast<qsizetype>(i)];
        const QPointF point = placeOf(i);
        const double width = metrics.horizontalAdvance(label->text()) + 4.0;
        const auto place = room.besidePoint(point.x(), point.y(), width, metrics.height());
        label->setVisible(place.has_value());
        if (place) {
            label->position->setPixelPosition({place->x + 2.0, place->y});
        }
    }
}

double MeasurePlot::heightOf(double error) const
{
    const double high = m_errors.last - m_errors.first;
    return error > 0.0 ? error : std::pow(10.0, m_errors.first - zeroPlace * zeroBand * high);
}

QPointF MeasurePlot::placeOf(std::size_t point) const
{
    const PlotPoint &shown = m_shown.points[point];
    return {m_plot->xAxis->coordToPixel(shown.cost), m_plot->yAxis->coordToPixel(heightOf(shown.error))};
}

std::optional<std::size_t> MeasurePlot::pointAt(const QPointF &place) const
{
    std::optional<std::size_t> nearest;
    double least = reach;
    for (std::size_t i = 0; i < m_shown.points.size(); ++i) {
        const double distance = QLineF(place, placeOf(i)).length();
        if (distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

QString MeasurePlot::wordsAt(const QPointF &place) const
{
    const auto point = pointAt(place);
    return point ? m_tips[static_cast<qsizetype>(*point)] : QString();
}

void MeasurePlot::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        draw();
    }
}

bool MeasurePlot::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonPress
        || event->type() == QEvent::MouseButtonDblClick) {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        const auto point = pointAt(mouse->position());
        if (event->type() == QEvent::MouseMove) {
            m_plot->setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
            QToolTip::showText(mouse->globalPosition().toPoint(), wordsAt(mouse->position()), m_plot);
        } else if (point && mouse->button() == Qt::LeftButton) {
            const std::size_t row = m_shown.rows[*point];
            Q_EMIT chosen(row);
            if (event->type() == QEvent::MouseButtonDblClick) {
                Q_EMIT activated(row);
            }
        }
    }
    return QFrame::eventFilter(watched, event);
}

}
