// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "figuretable.h"

#include <limits>

#include "core/measure/words.h"
#include "qualitycontrol.h"

namespace romanesco {

namespace {

using Figure = FigureTable::Figure;

Figure figureOf(double value)
{
    return {QString::fromStdString(figure(value)), value};
}

/// With its quartiles.
Figure figureOf(const Spread &spread, double unit)
{
    const auto words = [unit](double value) { return QString::fromStdString(figure(unit * value)); };
    return {QStringLiteral("%1 (%2–%3)")
                .arg(words(spread.median), words(spread.lowerQuartile), words(spread.upperQuartile)),
            spread.median};
}

/// With its interval.
Figure figureOf(const Share &share)
{
    return {QString::fromStdString(percent(share)), share.of == 0 ? -1.0 : share.value()};
}

Figure figureOf(std::size_t count)
{
    return {QString::fromStdString(grouped(count)), static_cast<double>(count)};
}

Figure pixelsOf(double pixels)
{
    return {QString::fromStdString(pixelsText(pixels)), pixels};
}

QString missedTip()
{
    return FigureTable::tr("Collisions that were not found, in per cent; in brackets what they are of all such, with a "
                           "confidence of 95 %");
}

}

FigureTable FigureTable::of(const ColliderTrial &trial, QuerySet set)
{
    FigureTable table{
        .nameHead = {tr("Collider"), tr("The way to search, and its tolerance")},
        .heads = {
            {tr("µs"), tr("Of the processor's time for a query; the median of several rounds, and the quartiles")},
            {tr("Faces"), tr("Face tests a query, in the mean: the same in every run")},
            {tr("Largest error"), tr("In parts of the distance")},
            {tr("Wrong by 1 %"),
             tr("Answers that are off by more than 1 % of the distance, in per cent; in brackets what they are of "
                "all, with a confidence of 95 %")},
            {tr("Missed"), missedTip()},
            {tr("Build, ms"), tr("Milliseconds until the first query can be asked")},
            {tr("Bytes"), tr("Kept beside the mesh and the graph")}}};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const ColliderRow &row = trial.rows[i];
        if (row.queries != set) {
            continue;
        }
        Row shown{.number = i,
                  .name = QString::fromStdString(nameOf(row)),
                  .reason = QString::fromStdString(row.reason)};
        if (row.reason.empty()) {
            shown.figures = {figureOf(row.nanoseconds, 1e-3),
                             figureOf(row.survey.faceTestsMean),
                             figureOf(row.survey.worst),
                             figureOf(row.survey.wrong[1]),
                             figureOf(row.survey.missed),
                             figureOf(row.buildMilliseconds.median),
                             figureOf(row.bytes)};
        }
        table.rows.push_back(std::move(shown));
    }
    return table;
}

FigureTable FigureTable::of(const StepTrial &trial)
{
    FigureTable table{
        .nameHead = {tr("Step"), tr("Who steps, and for how many seconds")},
        .heads = {{tr("µs"), tr("Of the processor's time, for a ball and a second that it moves; with the quartiles")},
                  {tr("Queries"), tr("Of a ball and a second")},
                  {tr("Energy off by"), tr("In parts of what a ball fell with: the median")},
                  {tr("At worst"), tr("Of the energy")},
                  {tr("Landing off by"),
                   tr("How far a ball was from where it lands when it was found to touch, in radii: the median")},
                  {tr("At worst"), tr("Of the landing")},
                  {tr("Missed"), missedTip()}}};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const StepRow &row = trial.rows[i];
        table.rows.push_back(
            {.number = i,
             .name = QString::fromStdString(nameOf(row)),
             .figures = {figureOf(row.microseconds, 1.0), figureOf(row.queries), figureOf(row.energyMedian),
                         figureOf(row.energyWorst), figureOf(row.landingMedian), figureOf(row.landingWorst),
                         figureOf(row.missed)}});
    }
    return table;
}

FigureTable FigureTable::of(const FrameTrial &trial, FramePlace place)
{
    FigureTable table{
        .nameHead = {tr("Tolerance"), tr("Below how many pixels copies are drawn as one")},
        .heads = {
            {tr("ms"), tr("Of a frame that follows another, of one sample a pixel; with the quartiles")},
            {tr("Copies"), tr("Drawn in such a frame")},
            {tr("Off by"), tr("What the tolerance alone does, of 255: the root of the mean square of all differences")},
            {tr("Plainly, %"), tr("Pixels that the tolerance alone puts off by more than 8 of 255, in per cent")},
            {tr("While moving"), tr("The same as off by, of one sample a pixel: what that leaves jagged, too")},
            {tr("Bytes"), tr("Buffers, on the graphics card and off it")}}};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const FrameRow &row = trial.rows[i];
        if (row.place != place) {
            continue;
        }
        Row shown{.number = i,
                  .name = QString::fromStdString(nameOf(row)),
                  .reason = QString::fromStdString(row.reason)};
        if (row.reason.empty()) {
            shown.figures = {figureOf(row.milliseconds, 1.0),   figureOf(row.cost.copies), figureOf(row.alone.rms),
                             figureOf(100.0 * row.alone.share), figureOf(row.moving.rms),  figureOf(row.cost.bytes)};
        }
        if (row.tolerance < QualityControl::finest) {
            shown.obstacle = tr("the finest that the quality can be set to is %1 px").arg(QualityControl::finest);
        }
        table.rows.push_back(std::move(shown));
    }
    return table;
}

FigureTable FigureTable::of(const DepthTrial &trial)
{
    FigureTable table{
        .nameHead = {tr("Levels"), tr("How far down the fractal")},
        .heads = {{tr("Size"), tr("Of what is there, in parts of the scene")},
                  {tr("Copies"), tr("That are in view there")},
                  {tr("Float, px"),
                   tr("How far any of them is from its place on the screen by maps in float, as in the dissertation")},
                  {tr("Double, px"), tr("The same by maps in double, counted from the world")},
                  {tr("Local frames, px"), tr("The same by maps that are counted from a place near by, as here")}}};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const DepthRow &row = trial.rows[i];
        Row shown{.number = i, .name = QString::number(row.depth), .reason = QString::fromStdString(row.reason)};
        if (row.reason.empty()) {
            shown.figures = {{QString::fromStdString(sizeText(row)), row.sizeLog10},
                             figureOf(row.copies),
                             pixelsOf(row.inFloat),
                             pixelsOf(row.inDouble),
                             pixelsOf(row.inFrames)};
        }
        table.rows.push_back(std::move(shown));
    }
    return table;
}

FigureTable FigureTable::of(const DigitTrial &trial)
{
    FigureTable table{.nameHead = {tr("Numbers"), tr("The digits of each in a file in OBJ")},
                      .heads = {{tr("Largest error"), tr("Of a vertex, in parts of the scene's diagonal")},
                                {tr("RMS"), tr("The root of the mean square of all such errors")},
                                {tr("Collapsed"), tr("Faces of which two corners became one")},
                                {tr("Flat"), tr("Faces that became flat otherwise")},
                                {tr("Bytes in all"), tr("Of the file, if all copies were written")},
                                {tr("ns a face"), tr("To write a face with its vertices; with the quartiles")}}};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const DigitRow &row = trial.rows[i];
        const double bytes = row.bytes ? row.bytes->log10() : std::numeric_limits<double>::infinity();
        table.rows.push_back({.number = i,
                              .name = QString::fromStdString(nameOf(row)),
                              .figures = {figureOf(row.worst),
                                          figureOf(row.rms),
                                          figureOf(row.collapsed),
                                          figureOf(row.flat),
                                          {QString::fromStdString(countText(row.bytes)), bytes},
                                          figureOf(row.nanoseconds, 1.0)}});
    }
    return table;
}

QString FigureTable::wordsOf(const Row &row) const
{
    QStringList lines{row.name};
    for (std::size_t i = 0; i < row.figures.size(); ++i) {
        lines << QStringLiteral("%1: %2").arg(heads[i].words, row.figures[i].words);
    }
    if (!row.reason.isEmpty()) {
        lines << row.reason;
    }
    return lines.join(u'\n');
}

}
