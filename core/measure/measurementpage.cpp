// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "measurementpage.h"

#include <format>
#include <initializer_list>
#include <vector>

#include "trialplots.h"
#include "words.h"

namespace romanesco {

namespace {

constexpr const char *style = R"(:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 76rem; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
.plots { display: flex; flex-wrap: wrap; gap: 1rem; } .plots svg { max-width: 100%; height: auto; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.87rem; }
th, td { padding: 0.2rem 0.7rem; text-align: right; border-bottom: 1px solid #8884; white-space: nowrap; }
th:first-child, td:first-child, td.reason { text-align: left; }
td.reason { font-style: italic; }
.range { opacity: 0.65; }
)";

std::string cell(const std::string &words)
{
    return std::format("<td>{}</td>", escaped(words));
}

/// Its interval stands back.
std::string cell(const Share &share)
{
    const std::string words = percent(share);
    const std::size_t bracket = words.find(" (");
    return bracket == std::string::npos ? cell(words)
                                        : std::format("<td>{} <span class=\"range\">{}</span></td>",
                                                      words.substr(0, bracket), words.substr(bracket + 1));
}

std::string cell(const Spread &spread, double unit)
{
    return std::format("<td>{} <span class=\"range\">({}–{})</span></td>", figure(unit * spread.median),
                       figure(unit * spread.lowerQuartile), figure(unit * spread.upperQuartile));
}

std::string tableHead(std::initializer_list<const char *> heads)
{
    std::string text = "<div class=\"table\"><table>\n<thead><tr>";
    for (const char *head : heads) {
        text += std::format("<th>{}</th>", head);
    }
    return text + "</tr></thead>\n<tbody>\n";
}

std::string tableEnd()
{
    return "</tbody></table></div>\n";
}

std::string rowOf(const ColliderRow &row)
{
    if (!row.reason.empty()) {
        return std::format("<tr>{}<td class=\"reason\" colspan=\"10\">{}</td></tr>\n", cell(nameOf(row)),
                           escaped(row.reason));
    }
    const Survey &survey = row.survey;
    return std::format("<tr>{}{}{}{}{}{}{}{}{}{}{}</tr>\n", cell(nameOf(row)), cell(grouped(survey.asked)),
                       cell(figure(survey.faceTestsMean)), cell(figure(survey.faceTestsP99)),
                       cell(figure(survey.nodeVisitsMean)), cell(row.nanoseconds, 1e-3), cell(survey.wrong[0]),
                       cell(survey.wrong[1]), cell(survey.wrong[2]), cell(figure(survey.worst)), cell(survey.missed));
}

/// Beside one another.
std::string drawn(const std::vector<TrialPlot> &plots)
{
    std::string text = "<div class=\"plots\">\n";
    for (const TrialPlot &plot : plots) {
        text += errorPlot(plot.points, plot.costAxis, plot.errorAxis);
    }
    return text + "</div>\n";
}

std::string sectionOf(const ColliderTrial &trial, const ColliderTrial::Set &set)
{
    std::string text = std::format("<h2>{}</h2>\n<p>{}.</p>\n{}", nameOf(set.queries), escaped(wordsOf(set)),
                                   drawn(plotsOf(trial, set.queries)));
    text += tableHead({"collider", "asked", "face tests", "p99", "nodes", "µs", "wrong by 1e-6, %", "by 1 %, %",
                       "by 10 %, %", "largest error", "missed, %"});
    for (const ColliderRow &row : trial.rows) {
        text += row.queries == set.queries ? rowOf(row) : std::string();
    }
    return text + tableEnd();
}

std::string buildingOf(const ColliderTrial &trial)
{
    std::string text = "<h2>building</h2>\n" + tableHead({"collider", "ms", "bytes"});
    for (const ColliderRow &row : trial.rows) {
        if (row.queries == trial.rows.front().queries && row.reason.empty()) {
            text += std::format("<tr>{}{}{}</tr>\n", cell(nameOf(row)), cell(figure(row.buildMilliseconds.median)),
                                cell(grouped(row.bytes)));
        }
    }
    return text + tableEnd();
}

std::string sectionOf(const StepTrial &trial)
{
    std::string text = std::format("<h2>time step</h2>\n<p>{}. The energy is off in parts of what it fell with, the "
                                   "landing in radii.</p>\n{}",
                                   escaped(wordsOf(trial)), drawn(plotsOf(trial)));
    text += tableHead({"step, s", "balls", "face tests/s", "queries/s", "µs/s", "energy off by", "at worst",
                       "landing off by", "at worst", "missed, %"});
    for (const StepRow &row : trial.rows) {
        text +=
            std::format("<tr>{}{}{}{}{}{}{}{}{}{}</tr>\n", cell(nameOf(row)), cell(grouped(row.balls)),
                        cell(figure(row.faceTests)), cell(figure(row.queries)), cell(figure(row.microseconds.median)),
                        cell(figure(row.energyMedian)), cell(figure(row.energyWorst)), cell(figure(row.landingMedian)),
                        cell(figure(row.landingWorst)), cell(row.missed));
    }
    return text + tableEnd();
}

std::string sectionOf(const FrameTrial &trial, const FrameReference &reference)
{
    std::string text = std::format("<h3>{}</h3>\n<p>{}.</p>\n{}", nameOf(reference.place), escaped(wordsOf(reference)),
                                   drawn(plotsOf(trial, reference.place)));
    text += tableHead({"tolerance", "copies", "faces", "states", "ms", "a second", "bytes", "RMS, of 255",
                       "pixels off, %", "RMS alone", "pixels off alone, %"});
    for (const FrameRow &row : trial.rows) {
        if (row.place != reference.place) {
            continue;
        }
        text += !row.reason.empty()
            ? std::format("<tr>{}<td class=\"reason\" colspan=\"10\">{}</td></tr>\n", cell(nameOf(row)),
                          escaped(row.reason))
            : std::format("<tr>{}{}{}{}{}{}{}{}{}{}{}</tr>\n", cell(nameOf(row)), cell(grouped(row.cost.copies)),
                          cell(grouped(row.cost.faces)), cell(grouped(row.cost.statesVisited)),
                          cell(row.milliseconds, 1.0), cell(figure(1e3 / row.milliseconds.median)),
                          cell(grouped(row.cost.bytes)), cell(figure(row.moving.rms)),
                          cell(figure(100.0 * row.moving.share)), cell(figure(row.alone.rms)),
                          cell(figure(100.0 * row.alone.share)));
    }
    return text + tableEnd();
}

std::string sectionOf(const FrameTrial &trial)
{
    std::string text = std::format("<h2>rendering</h2>\n<p>{}. One sample a pixel is what the window draws while the "
                                   "camera moves; alone is what the tolerance does to a picture of many samples. "
                                   "Pixels are off by more than {} of 255.</p>\n",
                                   escaped(wordsOf(trial)), FrameError::plain);
    for (const FrameReference &reference : trial.references) {
        text += sectionOf(trial, reference);
    }
    return text;
}

/// Nothing is plotted: it costs the same whatever the depth.
std::string sectionOf(const DepthTrial &trial)
{
    std::string text = std::format("<h2>numbers at depth</h2>\n<p>{}.</p>\n", escaped(wordsOf(trial)));
    if (trial.rows.empty()) {
        return text;
    }
    text += tableHead({"levels", "size", "copies in view", "float, px", "double, px", "local frames, px"});
    for (const DepthRow &row : trial.rows) {
        const std::string levels = cell(std::to_string(row.depth));
        text += !row.reason.empty()
            ? std::format("<tr>{}<td class=\"reason\" colspan=\"5\">{}</td></tr>\n", levels, escaped(row.reason))
            : std::format("<tr>{}{}{}{}{}{}</tr>\n", levels, cell(sizeText(row)), cell(grouped(row.copies)),
                          cell(pixelsText(row.inFloat)), cell(pixelsText(row.inDouble)),
                          cell(pixelsText(row.inFrames)));
    }
    return text + tableEnd();
}

std::string sectionOf(const DigitTrial &trial)
{
    std::string text = std::format("<h2>export</h2>\n<p>{}.</p>\n{}", escaped(wordsOf(trial)), drawn(plotsOf(trial)));
    text +=
        tableHead({"numbers", "largest error", "RMS", "faces collapsed", "faces flat", "bytes in all", "ns a face"});
    for (const DigitRow &row : trial.rows) {
        text += std::format("<tr>{}{}{}{}{}{}{}</tr>\n", cell(nameOf(row)), cell(figure(row.worst)),
                            cell(figure(row.rms)), cell(grouped(row.collapsed)), cell(grouped(row.flat)),
                            cell(countText(row.bytes)), cell(row.nanoseconds, 1.0));
    }
    return text + tableEnd();
}

}

std::string pageOf(const Measurement &measurement)
{
    const ColliderTrial &trial = measurement.colliders;
    const std::string source = escaped(measurement.source);
    std::string text =
        std::format("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
                    "<meta charset=\"utf-8\"/>\n<title>{0}: speed against accuracy</title>\n"
                    "<style>{1}</style>\n</head>\n<body>\n<h1>{0}: speed against accuracy</h1>\n<p>{2}.</p>\n",
                    source, style, escaped(wordsOf(trial)));
    text +=
        "<p>Every way to search for the nearest point was asked the same questions, and compared with the exact "
        "answers. Full points are on the front: no other costs less and is no farther off. Shares are in per cent, "
        "and in brackets what they are of all, with a confidence of 95 %; times are the median of several rounds, and "
        "in brackets the quartiles. Missed are those of the collisions that were not found.</p>\n";
    for (const ColliderTrial::Set &set : trial.sets) {
        text += sectionOf(trial, set);
    }
    text += buildingOf(trial);
    text += measurement.steps ? sectionOf(*measurement.steps) : std::string();
    text += measurement.frames ? sectionOf(*measurement.frames) : std::string();
    text += measurement.depths ? sectionOf(*measurement.depths) : std::string();
    text += measurement.digits ? sectionOf(*measurement.digits) : std::string();
    return text + "</body>\n</html>\n";
}

}
