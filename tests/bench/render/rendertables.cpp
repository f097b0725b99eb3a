// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "rendertables.h"

#include <algorithm>
#include <cmath>
#include <format>

namespace romanesco::bench {

namespace {

constexpr const char introduction[] = R"(# What drawing costs, and how far off it is

Written by `bench_render`, all in one run, on

    {}

{}. The command, which takes ten minutes and 3 GB:

```
packaging/devroot packaging/build bench build/bench/tests/bench/render/bench_render --markdown --pictures docs >docs/rendering.md
```

`flattened` is the dissertation's way (4.2.4, 4.3.1), measured beside ours: the matrices of all copies, t^d of them, are
concatenated set by set and put into one buffer, and each frame is one instanced draw of the base mesh. Its shader is its
own and shades as ours does. Ours is at a tolerance of so many pixels: copies that are smaller are drawn as one; 0 draws
all. One sample a pixel, no window; each frame ends when the card has drawn it, and but for the first has one before it from
the same place.

Processor time is that of all threads, which in software is all that drawing takes; times are the median of three rounds in
which everything takes its turn in random order, so that what else the machine does slows all alike.

![From left to right: far, near, inside](rendering-places.png)
)";

constexpr const char *goalsIntroduction = R"(
## What is asked for

*Times less*: processor time of a frame, beside the flattened way. *As good*: neither the mean nor the root of the mean
square of the errors below is more than 1 % greater. That the window takes at most 100 MB more than an empty one is not
measured here.
)";

constexpr const char *startsIntroduction = R"(
## Until something is seen

From the text to what can be drawn, from there to the first picture, from far, and the processor time of both, in
milliseconds: flattened / ours at a tolerance of 1. Shaders were compiled before. Copies as the text writes them, all of
which the flattened way draws; ours leaves out those that are there twice. Memory: buffers, without the picture's; 64 bytes
for each copy, or the most that ours held. A dash: too many copies to be written out.
)";

constexpr const char *framesIntroduction = R"(
## Frames

Of the flattened picture and ours at tolerances of 1 and 4 pixels: milliseconds of processor time, and what went by. *Times
less*: processor time of the flattened frame, divided by ours at 1 and at 4. *Drawn*: copies at a tolerance of 1.
*Unlike*: pixels, in per cent, of which the flattened picture and ours of all copies differ by more than 16 of 255.
)";

constexpr const char *errorsIntroduction = R"(
## How far off pictures are

Pictures of one sample, beside one of all copies with 64 samples a pixel (where it says so, of copies above a quarter of a
pixel): mean absolute difference / root of the mean square, in sRGB from 0 to 255 / share of the pixels, in per cent, of
which a colour is off by more than 16. Most of it is what one sample cannot tell at edges, whatever is drawn.
)";

constexpr const char *depthsIntroduction = R"(
## With the depth

Frames at a tolerance of 1, from far: nothing is written out, and what is too small to be seen is not gone through.
)";

std::string titled(const Subject &subject)
{
    return subject.title + ", d = " + std::to_string(subject.depth);
}

std::string named(Place place)
{
    return placeNames[static_cast<std::size_t>(place)];
}

std::string runOf(const Subject &subject, Place place, const std::string &kind)
{
    return runName(subject.name, subject.depth, place, kind);
}

std::string sized(const PictureSize &size)
{
    return std::format("{}x{}", size.width, size.height);
}

/// With a limit that is not to be passed: where isLeast, downwards.
std::string goalRow(const std::string &what, const std::string &asked, double limit, bool isLeast, double measured)
{
    const bool isMet = isLeast ? measured >= limit : measured <= limit;
    return row({what, asked, number(measured), std::isnan(measured) ? "" : isMet ? "yes" : "**no**"});
}

/// What is as good but for what rounding of colours makes of it.
constexpr double asGood = 1.01;

}

double RenderTables::gain(const Subject &subject, Place place, int tolerance) const
{
    return figure(runOf(subject, place, "flattened"), "us")
        / figure(runOf(subject, place, std::to_string(tolerance)), "us");
}

/// Those that were measured.
std::vector<Place> RenderTables::placesOf(const Subject &subject) const
{
    std::vector<Place> measured;
    std::ranges::copy_if(places, std::back_inserter(measured),
                         [&](Place place) { return contains(runOf(subject, place, "1")); });
    return measured;
}

std::string RenderTables::error(const Subject &subject, Place place, const std::string &kind) const
{
    const std::string run = runOf(subject, place, "1");
    const double mean = figure(run, "error_mean/" + kind);
    return std::isnan(mean) ? number(mean)
                            : std::format("{:.2f} / {:.2f} / {:.2f}", mean, figure(run, "error_rms/" + kind),
                                          figure(run, "error_%/" + kind));
}

int RenderTables::asGoodAsFlattened(const Subject &subject, Place place) const
{
    const std::string run = runOf(subject, place, "1");
    int found = -1;
    for (const int tolerance : tolerances) {
        const auto isAsGood = [&](const std::string &what) {
            return figure(run, what + std::to_string(tolerance)) <= asGood * figure(run, what + "flattened");
        };
        found = isAsGood("error_mean/") && isAsGood("error_rms/") ? tolerance : found;
    }
    return found;
}

double RenderTables::growth(const std::string &name, std::uint64_t from, std::uint64_t to) const
{
    return figure(depthRunName(name, to), "us") / figure(depthRunName(name, from), "us");
}

void RenderTables::writeMengerGoals(std::ostream &stream, const Subject &subject) const
{
    for (const Place place : placesOf(subject)) {
        const std::string title = titled(subject) + ", " + named(place) + ": times less at ";
        if (place != Place::Far) {
            stream << goalRow(title + "1", "≥ 3", 3.0, true, gain(subject, place, 1));
        }
        if (const int best = asGoodAsFlattened(subject, place); best >= 0) {
            stream << goalRow(title + std::to_string(best) + ", the greatest that is as good as flattened", "≥ 10",
                              10.0, true, gain(subject, place, best));
        }
    }
}

void RenderTables::writeGoals(std::ostream &stream) const
{
    stream << goalsIntroduction << head({"", "asked", "measured", "met"});
    double least = missing;
    std::string slowest;
    int slower = 0;
    int all = 0;
    double memory = 0.0;
    for (const Subject &subject : m_subjects) {
        if (subject.name == "menger" && subject.depth == 5) {
            writeMengerGoals(stream, subject);
        }
        for (const Place place : placesOf(subject)) {
            memory = std::max(memory, figure(runOf(subject, place, "1"), "MB"));
            const double times = gain(subject, place, 1);
            slower += times < 1.0 ? 1 : 0;
            all += std::isnan(times) ? 0 : 1;
            if (!std::isnan(times) && !(least <= times)) {
                least = times;
                slowest = titled(subject) + ", " + named(place);
            }
        }
    }
    stream << goalRow(
        std::format("never slower at 1: times less at least, of {} (slower at {} of {})", slowest, slower, all), "≥ 1",
        1.0, true, least);
    stream << goalRow("Sierpinski, far: d = 30 in units of d = 12", "≤ 1.25", 1.25, false,
                      growth("sierpinski", 12, 30));
    stream << goalRow("appendix B as written: seconds to the first picture of all, shaders compiled too", "≤ 1", 1.0,
                      false, m_coldSeconds);
    stream << goalRow("own buffers in MB, the most at 1", "≤ 64", 64.0, false, memory);
}

void RenderTables::writeStarts(std::ostream &stream) const
{
    stream << startsIntroduction
           << head({"", "copies as written", "load", "first picture", "processor", "memory in MB"});
    for (const Subject &subject : m_subjects) {
        const std::string ours = runOf(subject, Place::Far, "1");
        const std::string flattened = runOf(subject, Place::Far, "flattened");
        if (!contains(ours)) {
            continue;
        }
        const auto both = [&](const std::string &what) {
            return joined({figure(flattened, what), figure(ours, what)});
        };
        stream << row({titled(subject), number(figure(flattened, "copies")), both("load_ms"), both("first_ms"),
                       both("start_cpu_ms"), both("MB")});
    }
}

void RenderTables::writeFrames(std::ostream &stream) const
{
    stream << framesIntroduction
           << head({"", "size", "processor: flattened", "at 1", "at 4", "went by: flattened", "at 1", "at 4",
                    "times less", "drawn", "unlike"});
    for (const Subject &subject : m_subjects) {
        for (const Place place : placesOf(subject)) {
            const std::string flattened = runOf(subject, place, "flattened");
            std::vector<std::string> cells{titled(subject) + ", " + named(place), sized(subject.size)};
            for (const std::string what : {"us", "wall_us"}) {
                for (const std::string kind : {"flattened", "1", "4"}) {
                    cells.push_back(number(figure(runOf(subject, place, kind), what) / 1e3));
                }
            }
            cells.push_back(joined({gain(subject, place, 1), gain(subject, place, 4)}));
            cells.push_back(number(figure(runOf(subject, place, "1"), "copies")));
            cells.push_back(number(figure(flattened, "unlike_%")));
            stream << row(cells);
        }
    }
}

void RenderTables::writeTolerances(std::ostream &stream) const
{
    stream << "\nThose that are timed at all tolerances, processor time in milliseconds and times less:\n"
           << head({"", "0", "1", "2", "4", "8"});
    for (const Subject &subject : m_subjects) {
        for (const Place place : placesOf(subject)) {
            if (subject.timedTolerances.size() < tolerances.size()) {
                continue;
            }
            std::vector<std::string> cells{titled(subject) + ", " + named(place)};
            for (const int tolerance : tolerances) {
                const std::string run = runOf(subject, place, std::to_string(tolerance));
                cells.push_back(joined({figure(run, "us") / 1e3, gain(subject, place, tolerance)}));
            }
            stream << row(cells);
        }
    }
}

void RenderTables::writeErrors(std::ostream &stream) const
{
    stream << errorsIntroduction << head({"", "size", "flattened", "0", "1", "2", "4", "8"});
    for (const Subject &subject : m_subjects) {
        for (const Place place : subject.comparedPlaces) {
            if (!contains(runOf(subject, place, "1"))) {
                continue;
            }
            const bool isWhole = subject.referenceTolerance == 0.0;
            std::vector<std::string> cells{titled(subject) + ", " + named(place) + (isWhole ? "" : " (a quarter)"),
                                           sized(subject.comparedSize), error(subject, place, "flattened")};
            for (const int tolerance : tolerances) {
                cells.push_back(error(subject, place, std::to_string(tolerance)));
            }
            stream << row(cells);
        }
    }
    stream
        << "\n![All copies with 16 samples a pixel, and one sample at a tolerance of 0, 1, 4 and 8 pixels]"
           "(rendering-tolerance.png)\n\nMenger at d = 5, a part of a picture of 960x540 magnified twice: all copies "
           "with 16 samples a pixel, then one sample at\na tolerance of 0, 1, 4 and 8 pixels.\n";
}

void RenderTables::writeDepths(std::ostream &stream) const
{
    stream << depthsIntroduction
           << head({"", "size", "processor, ms", "went by, ms", "drawn", "nodes", "memory in MB"});
    for (const Subject &subject : m_depths) {
        const std::string run = depthRunName(subject.name, subject.depth);
        if (contains(run)) {
            stream << row({titled(subject), sized(subject.size), number(figure(run, "us") / 1e3),
                           number(figure(run, "wall_us") / 1e3), number(figure(run, "copies")),
                           number(figure(run, "nodes")), number(figure(run, "MB"))});
        }
    }
}

void RenderTables::Finalize()
{
    std::ostream &stream = GetOutputStream();
    const bool isSoftware = m_machine.find("llvmpipe") != std::string::npos;
    stream << std::format(introduction, m_machine,
                          isSoftware ? "which draws in software; no graphics card was at hand"
                                     : "which is a graphics card");
    writeGoals(stream);
    writeStarts(stream);
    writeFrames(stream);
    writeTolerances(stream);
    writeErrors(stream);
    writeDepths(stream);
}

}
