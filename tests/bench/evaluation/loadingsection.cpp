// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>

#include "core/measure/words.h"
#include "evaluationtables.h"
#include "tests/bench/tables.h"

namespace romanesco::bench {

namespace {

std::string withSpread(const Spread &spread)
{
    return std::format("{} ({}–{})", figure(spread.median), figure(spread.lowerQuartile), figure(spread.upperQuartile));
}

std::string kilobytes(std::size_t bytes)
{
    return figure(static_cast<double>(bytes) / 1e3);
}

std::string modelsTable(const std::vector<Evaluated> &evaluated)
{
    std::string text;
    for (const auto &[model, loading, colliders] : evaluated) {
        const std::string shape =
            model.shape ? std::format("{}, {}, {}", model.shape->b, model.shape->t, model.shape->d) : "–";
        const auto distinct = colliders.faces ? colliders.faces->toInteger() : std::nullopt;
        text += row({model.id, model.title, grouped(model.faces), shape, distinct ? grouped(*distinct) : "–"});
    }
    return text + R"(
The faces are those of its figure 16. Its files are not to be had, so others stand for them. 1 and 2 are closed meshes, made
for this: the convex hull of points that lie on a sphere by chance, dented along the radii, twisted and bent, so that they
are neither spheres nor grids. That they are closed is looked at in what was read from the file: each edge has two faces,
which look outwards. For 3, "a simple tree structure", stand two trees: one whose branches turn, and one that is as kind to
its collider as can be. 4 is a tree and a diamond in turn, as its figure 22 has them, 5 a Menger sponge. Copies that are there
twice are one for us.
)";
}

/// How many times as long an ordinary mesh takes to be seen.
double timesLonger(const Evaluated &ordinary, const Evaluated &fractal)
{
    const auto seen = [](const Loading &loading) { return loading.load.median + loading.picture.median; };
    return seen(ordinary.loading) / seen(fractal.loading);
}

}

std::string introduction(const std::string &machine)
{
    return std::format(R"(# The dissertation's evaluation, once more

Its chapter 5 says that fractals load in a fraction of a second, take a kilobyte, and are collided with at a cost that is
exponentially less *and fully accurate* (figures 17 and 18), and shows a ball that shrinks on one of them (figures 19
and 20). Here all of that is measured again, with what was missing: how far off each answer is. Written by
`bench_evaluation`, all in one run, on

    {}

which draws in software; no graphics card was at hand. The command:

```
packaging/devroot packaging/build bench build/bench/tests/bench/evaluation/bench_evaluation --pictures docs >docs/evaluation.md
```

Counts and errors are the same in every run. Times are medians, with the quartiles in brackets; the machine had other work as
well.

## The models

| mesh | | faces as written | b, t, d | of them distinct |
|---|---|---|---|---|
)",
                       machine);
}

std::string loadingSection(const std::vector<Evaluated> &evaluated)
{
    std::string text = modelsTable(evaluated)
        + std::format(R"(
## Figure 17: loading and storing

Its "rendering cost" is the time that a model takes to load, by a stopwatch, the mean of 10 attempts. *Load* is ours from the
file on the disk, which the system keeps in memory, to what can be searched and drawn; *first picture* from there to
1280 × 720 pixels, one sample each, at a tolerance of a pixel, shaders compiled before. {} attempts, each anew, by the
clock. *In memory*: mesh, graph and bounds; *to draw*: the renderer's own buffers and bounds after that picture.
)",
                      attempts)
        + head({"mesh", "its load, ms", "load, ms", "first picture, ms", "its file, bytes", "file, bytes",
                "in memory, kB", "to draw, kB"});
    for (const auto &[model, loading, colliders] : evaluated) {
        text += row({model.id, figure(1e3 * model.published.loadSeconds), withSpread(loading.load),
                     withSpread(loading.picture), grouped(model.published.bytes), grouped(model.fileBytes()),
                     kilobytes(loading.modelBytes), kilobytes(loading.pictureBytes)});
    }
    const Evaluated &first = evaluated.front();
    const Evaluated &third = evaluated[2];
    return text
        + std::format(R"(
What it finds of fractals holds: a kilobyte instead of megabytes, and far less than a second. That ordinary meshes take more
than a minute does not: it is in how it reads them. Mesh {} takes {:.0f} times as long as mesh {} there; here, to the first picture,
{:.1f} times. Its times are from another machine with a card of its own (a laptop's RTX 4070), and what they end with is not
said; ours have no card, so that the picture is work of the processor, and is most of the time. Our files hold the comments of
the examples; the meshes have seven digits, and no normals or texture coordinates, of which its mesh 2 seems to have many.
)",
                      first.model.id, first.model.published.loadSeconds / third.model.published.loadSeconds,
                      third.model.id, timesLonger(first, third));
}

}
