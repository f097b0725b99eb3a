// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "errorplot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <format>

#include "plotlayout.h"
#include "words.h"

namespace romanesco {

namespace {

constexpr double width = 560.0;
constexpr double height = 360.0;
constexpr double left = 64.0;
constexpr double right = 16.0;
constexpr double top = 12.0;
constexpr double bottom = 44.0;
/// For what is not off at all.
constexpr double zeroBand = 30.0;
constexpr double letterWidth = 6.2;
constexpr double letterHeight = 12.0;
/// Beside a label.
constexpr double gap = 2.0;
/// Of an axis.
constexpr int mostNumbers = 8;

class Plot
{
public:
    Plot(std::span<const PlotPoint> points, std::vector<bool> front)
        : m_points(points)
        , m_front(std::move(front))
    {
        std::vector<double> costs;
        std::vector<double> errors;
        for (const PlotPoint &point : points) {
            assert(point.cost > 0.0 && point.error >= 0.0 && "logarithms are drawn");
            costs.push_back(point.cost);
            errors.push_back(point.error);
        }
        m_costs = decadesOf(std::move(costs));
        m_errors = decadesOf(std::move(errors));
    }

    std::string drawn(const std::string &costAxis, const std::string &errorAxis)
    {
        m_svg = std::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                            "height=\"{1}\" font-family=\"sans-serif\" font-size=\"11\" fill=\"currentColor\">\n",
                            width, height);
        drawGrid();
        drawAxes(costAxis, errorAxis);
        drawFront();
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            drawPoint(m_points[i], m_front[i]);
        }
        for (const PlotPoint &point : m_points) {
            drawLabel(point);
        }
        return m_svg + "</svg>\n";
    }

private:
    [[nodiscard]] double xOf(double cost) const { return left + m_costs.shareOf(cost) * (width - left - right); }
    [[nodiscard]] double yOf(double error) const
    {
        return error == 0.0 ? height - bottom - zeroBand / 2.0
                            : height - bottom - zeroBand - m_errors.shareOf(error) * plotHeight;
    }

    void line(double x1, double y1, double x2, double y2, const char *style)
    {
        m_svg +=
            std::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"currentColor\" {}/>\n",
                        x1, y1, x2, y2, style);
    }

    void text(double x, double y, const char *style, const std::string &words)
    {
        m_svg += std::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, escaped(words));
    }

    void drawGrid()
    {
        constexpr const char *faint = "stroke-opacity=\"0.15\"";
        for (int decade = m_costs.first; decade <= m_costs.last; ++decade) {
            const double x = xOf(std::pow(10.0, decade));
            line(x, top, x, height - bottom, faint);
            if ((decade - m_costs.first) % m_costs.step(mostNumbers) == 0) {
                text(x, height - bottom + 15.0, "text-anchor=\"middle\"", decadeText(decade));
            }
        }
        for (int decade = m_errors.first; decade <= m_errors.last; ++decade) {
            const double y = yOf(std::pow(10.0, decade));
            line(left, y, width - right, y, faint);
            if ((decade - m_errors.first) % m_errors.step(mostNumbers) == 0) {
                text(left - 6.0, y + 4.0, "text-anchor=\"end\"", decadeText(decade));
            }
        }
        text(left - 6.0, yOf(0.0) + 4.0, "text-anchor=\"end\"", "none");
    }

    void drawAxes(const std::string &costAxis, const std::string &errorAxis)
    {
        line(left, height - bottom, width - right, height - bottom, "stroke-opacity=\"0.6\"");
        line(left, top, left, height - bottom, "stroke-opacity=\"0.6\"");
        text((left + width - right) / 2.0, height - 8.0, "text-anchor=\"middle\"", costAxis);
        const double middle = (top + height - bottom) / 2.0;
        text(14.0, middle, std::format("text-anchor=\"middle\" transform=\"rotate(-90 14 {:.1f})\"", middle).c_str(),
             errorAxis);
    }

    /// What lies above and right of it is beaten.
    void drawFront()
    {
        std::vector<const PlotPoint *> front;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            if (m_front[i]) {
                front.push_back(&m_points[i]);
            }
        }
        std::ranges::sort(front, {}, &PlotPoint::cost);
        std::string way;
        for (const PlotPoint *point : front) {
            const double x = xOf(point->cost);
            way += way.empty() ? std::format("M{:.1f} {:.1f}", x, yOf(point->error))
                               : std::format("H{:.1f}V{:.1f}", x, yOf(point->error));
        }
        m_svg += std::format("<path d=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.5\" "
                             "stroke-dasharray=\"4 3\"/>\n",
                             way);
    }

    void drawPoint(const PlotPoint &point, bool isOnFront)
    {
        const double x = xOf(point.cost);
        const double y = yOf(point.error);
        const char *colour = plotColours[static_cast<std::size_t>(point.group) % plotColours.size()];
        m_room.take({x - 5.0, y - 5.0, 10.0, 10.0});
        m_svg += std::format("<g class=\"point\"><title>{}: cost {}, error {}{}</title>", escaped(point.label),
                             figure(point.cost), figure(point.error), isOnFront ? ", on the front" : "");
        if (point.spread && point.spread->lowerQuartile > 0.0) {
            const double from = std::max(xOf(point.spread->lowerQuartile), left);
            const double to = std::min(xOf(point.spread->upperQuartile), width - right);
            m_room.take({from, y - 1.0, to - from, 2.0});
            m_svg += std::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>", from,
                                 y, to, y, colour);
        }
        m_svg += std::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\" stroke=\"{}\" "
                             "stroke-width=\"1.5\"/></g>\n",
                             x, y, isOnFront ? colour : "none", colour);
    }

    /// Beside the point, where there is room; else the point's title has to do.
    void drawLabel(const PlotPoint &point)
    {
        const double wide = letterWidth * static_cast<double>(point.label.size()) + 2.0 * gap;
        if (const auto place = m_room.besidePoint(xOf(point.cost), yOf(point.error), wide, letterHeight)) {
            text(place->x + gap, place->y + letterHeight - 3.0, "font-size=\"11\"", point.label);
        }
    }

    static constexpr double plotHeight = height - top - bottom - zeroBand;

    std::span<const PlotPoint> m_points;
    std::vector<bool> m_front;
    Decades m_costs;
    Decades m_errors;
    LabelRoom m_room{{left, top, width - left - right + 8.0, height - bottom - top}};
    std::string m_svg;
};

bool beats(const PlotPoint &a, const PlotPoint &b)
{
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

}

std::vector<bool> paretoFront(std::span<const PlotPoint> points)
{
    std::vector<bool> front;
    for (const PlotPoint &point : points) {
        front.push_back(std::ranges::none_of(points, [&](const PlotPoint &other) { return beats(other, point); }));
    }
    return front;
}

std::string errorPlot(std::span<const PlotPoint> points, const std::string &costAxis, const std::string &errorAxis)
{
    return points.empty() ? std::string() : Plot(points, paretoFront(points)).drawn(costAxis, errorAxis);
}

std::string escaped(std::string_view text)
{
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            // XML has no other control characters
            safe += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
        }
    }
    return safe;
}

}
