// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "physicstables.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <limits>
#include <vector>

namespace romanesco::bench {

namespace {

constexpr const char *introduction = R"(# What falling balls cost, and how deep they sink in

Written by `bench_physics`, all in one run:

```
packaging/devroot packaging/build bench build/bench/tests/bench/physics/bench_physics --markdown >docs/physics.md
```

Balls fall on fractals of `tests/data/collide`, each scaled to a diagonal of 10 and turned as `physicstables.h` says, with
a restitution of 0.5, under a gravity of 9.8, for two seconds. They start at rest, spread evenly over the fractal's width,
up to a tenth of its size above it. Seeded, so the same for both engines: *ours* on the graph, and *Bullet* 3.24 (single
precision, as Debian packages it) on the mesh written out: `btBvhTriangleMeshShape` with a margin of 0, spheres without
friction, damping or spin, continuous collision detection from half a radius of motion on with a swept sphere of
0.9 radii, no sub-steps, one thread. Where balls are not to meet each other a collision filter sees to it.

- A *ball-step* is a step of a ball that is awake and has not left the fractal below or beside; what is asleep or gone
  does not count, though its time does.
- Times are CPU time of the whole program round the step alone. Each drop is made again and again (three rounds; Bullet
  with large balls two), and of each step the least time of all rounds counts: what else the machine does only adds.
- *Deepest*: how far the surface reached into a ball after any step, in per cent of its radius, by the exact collider of
  the same fractal; most of all balls, and the median of what each had at its deepest.
- *Through*: balls whose centre is on the other side of a face after some step. For Bullet, which goes straight on in a
  step, this is exact; ours may bounce within one, so for ours it is at most.
)";

std::string per(double radius)
{
    return std::format("{:g} %", 100.0 * radius);
}

}

std::string dropRun(const Subject &subject, double radius, unsigned rate, const std::string &engine)
{
    return std::format("drop/{}/{:g}/{}/{}", subject.name, 100.0 * radius, rate, engine);
}

std::string crowdRun(const std::string &name, std::size_t balls, bool areSolid)
{
    return std::format("crowd/{}/{}/{}", name, balls, areSolid ? "solid" : "passing");
}

std::string shotRun(const std::string &engine)
{
    return "shot/" + engine;
}

void PhysicsTables::writeDrops(std::ostream &stream) const
{
    stream << "\n## Beside Bullet\n\nBall against surface alone; 1,000 balls, 100 of the largest.\n";
    stream << head({"", "radius", "Hz", "ours, million ball-steps a CPU second", "Bullet", "ratio", "deepest: ours",
                    "Bullet", "through: ours", "Bullet", "lost steps"});
    for (const Subject &subject : subjects) {
        for (const double radius : radii) {
            for (const unsigned rate : rates) {
                const std::string ours = dropRun(subject, radius, rate, "ours");
                const std::string bullet = dropRun(subject, radius, rate, "bullet");
                const auto sunk = [&](const std::string &run) {
                    return joined({figure(run, "most_%"), figure(run, "median_%")});
                };
                stream << row({subject.title, per(radius), std::to_string(rate), number(figure(ours, "rate")),
                               std::format("{:.3g}", figure(bullet, "rate")),
                               number(figure(ours, "rate") / figure(bullet, "rate")), sunk(ours), sunk(bullet),
                               number(figure(ours, "through")), number(figure(bullet, "through")),
                               number(figure(ours, "lost"))});
            }
        }
    }
}

void PhysicsTables::writeMeans(std::ostream &stream) const
{
    double logs = 0.0;
    double least = std::numeric_limits<double>::infinity();
    double steps = 0.0;
    double lost = 0.0;
    int count = 0;
    for (const Subject &subject : subjects) {
        for (const double radius : radii) {
            for (const unsigned rate : rates) {
                const std::string ours = dropRun(subject, radius, rate, "ours");
                const double ratio = figure(ours, "rate") / figure(dropRun(subject, radius, rate, "bullet"), "rate");
                logs += std::log(ratio);
                least = std::min(least, ratio);
                steps += figure(ours, "steps");
                lost += figure(ours, "lost");
                ++count;
            }
        }
    }
    stream << "\nThe geometric mean of the ratios is **" << number(std::exp(logs / count))
           << "** (asked for: 25), the least " << number(least) << ". Of " << number(steps) << " ball-steps of ours "
           << number(lost) << " were lost to the cap on queries (asked for: fewer than one in 100,000).\n";
}

void PhysicsTables::writeMaking(std::ostream &stream) const
{
    stream << "\n## To build, and to hold\n\nFrom the file that was read: ours the graph, its boxes and the collider; "
              "Bullet "
              "the arrays of\nthe mesh that was written out already, and its tree.\n";
    stream << head({"", "faces", "ours, ms", "Bullet, ms", "ours, KiB", "Bullet, KiB"});
    for (const Subject &subject : subjects) {
        const std::string ours = dropRun(subject, radii[0], rates[0], "ours");
        const std::string bullet = dropRun(subject, radii[0], rates[0], "bullet");
        stream << row({subject.title, number(figure(ours, "faces")), number(figure(ours, "build_ms")),
                       number(figure(bullet, "build_ms")), number(figure(ours, "KiB")), number(figure(bullet, "KiB"))});
    }
}

void PhysicsTables::writeCrowds(std::ostream &stream) const
{
    stream << "\n## In real time\n\n240 steps a second on two threads, two seconds. *Real time*: simulated seconds for "
              "one that "
              "goes by, over all, and in the\nslowest quarter of a second. The machine was shared, and a thread that "
              "waits for its turn counts here; *CPU*: the same\nif both threads had been at work all the time.\n\n"
              "Ball against surface, with a radius of 0.2 % (asked for: 10,000 within real time):\n";
    stream << head({"", "balls", "real time", "slowest", "CPU", "lost steps"});
    const auto addTo = [&](std::vector<std::string> &line, const std::string &run) {
        for (const std::string what : {"real_time", "slowest", "cpu_time"}) {
            line.push_back(number(figure(run, what)));
        }
    };
    for (const Subject &subject : subjects) {
        const std::string run = crowdRun(subject.name, crowds.back(), false);
        std::vector<std::string> line{subject.title, number(static_cast<double>(crowds.back()))};
        addTo(line, run);
        line.push_back(number(figure(run, "lost")));
        stream << row(line);
    }
    stream << "\nTwo sets of 7 in a tray of the same width, with a radius of 1 %: balls rain in and pile up on the "
              "fractal, "
              "among it and on\neach other, and nothing falls off (asked for: 1,000 that collide within real time). "
              "*Touching*: share of the ball-steps\nof which something was touched.\n";
    stream << head({"balls", "colliding: real time", "slowest", "CPU", "awake, %", "touching, %", "passing: real time",
                    "slowest", "CPU"});
    for (const std::size_t crowd : crowds) {
        const std::string solid = crowdRun("tray", crowd, true);
        std::vector<std::string> line{number(static_cast<double>(crowd))};
        addTo(line, solid);
        line.push_back(number(figure(solid, "awake_%")));
        line.push_back(number(figure(solid, "touching_%")));
        addTo(line, crowdRun("tray", crowd, false));
        stream << row(line);
    }
}

void PhysicsTables::writeShots(std::ostream &stream) const
{
    const double drop = 1.0 / figure(dropRun(subjects[0], radii[0], rates[0], "ours"), "rate");
    const double shot = figure(shotRun("ours"), "step_us");
    stream << "\n## Shots\n\n2,000 balls of 0.2 % are shot at the two sets of 7 from all around, 1,000 radii a step. "
              "Their "
              "first step takes "
           << number(shot) << " us each,\nthe bounces in it among them: " << number(shot / drop)
           << " times one of the drop (asked for: 30). Bullet's takes " << number(figure(shotRun("bullet"), "step_us"))
           << " us.\n";
}

void PhysicsTables::Finalize()
{
    std::ostream &stream = GetOutputStream();
    stream << introduction;
    writeDrops(stream);
    writeMeans(stream);
    writeMaking(stream);
    writeCrowds(stream);
    writeShots(stream);
}

}
