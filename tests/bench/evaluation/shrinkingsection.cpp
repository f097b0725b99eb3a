// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <format>

#include "core/measure/share.h"
#include "core/measure/spread.h"
#include "core/measure/words.h"
#include "evaluationtables.h"
#include "tests/bench/tables.h"

namespace romanesco::bench {

namespace {

constexpr double aPerCent = 0.01;

/// In per cent of the radius.
std::string perCent(double radii)
{
    return std::format("{:.1f}", std::abs(radii) < 5e-4 ? 0.0 : 100.0 * radii);
}

std::string contactRow(const std::string &name, const std::vector<FirstContact> &contacts)
{
    std::vector<double> gaps;
    std::vector<double> depths;
    Share early{.of = contacts.size()};
    Share late{.of = contacts.size()};
    std::size_t never = 0;
    for (const FirstContact &contact : contacts) {
        never += contact.ball ? 0 : 1;
        if (contact.ball) {
            gaps.push_back(contact.gap);
            early.count += contact.gap > aPerCent ? 1 : 0;
        }
        late.count += contact.depth > aPerCent ? 1 : 0;
        depths.push_back(contact.depth);
    }
    return row({name, percent(early), percent(late), std::to_string(never), perCent(quantile(gaps, 0.5)),
                std::format("{} to {}", perCent(std::ranges::min(gaps)), perCent(std::ranges::max(gaps))),
                perCent(quantile(depths, 0.5)), perCent(std::ranges::max(depths))});
}

std::string placeRow(const std::string &name, const ShrinkingTrial &trial, const std::vector<Shrinking> &all)
{
    Share rests{.of = all.size()};
    std::size_t fullSize = 0;
    Share tooLarge;
    std::vector<double> shares;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto &[rest, held, fallen] = all[i];
        rests.count += rest ? 1 : 0;
        fullSize += !rest && held ? 1 : 0;
        const Neck &wayDown = trial.waysDown[i];
        if (wayDown.radius > 0.0 && held) {
            tooLarge.of += 1;
            tooLarge.count += held->radius > wayDown.radius + wayDown.missed ? 1 : 0;
            shares.push_back(held->radius / trial.gaps[i].radius);
        }
    }
    const Spread spread = spreadOf(shares);
    return row({name, percent(rests), std::to_string(fullSize),
                std::format("{:.2f} ({:.2f}–{:.2f})", spread.median, spread.lowerQuartile, spread.upperQuartile),
                percent(tooLarge)});
}

std::string ofBall(const std::string &name, const FirstContact &contact, const Shrinking &shrinking,
                   const ShrinkingGround &ground, double radius)
{
    const std::string gap = contact.ball ? perCent(contact.gap) : "never";
    const std::string atRest = shrinking.rest ? perCent(gapOf(ground, *shrinking.rest)) : "does not rest";
    const std::string falls = !shrinking.held ? "not"
        : shrinking.rest                      ? std::format("{:.1f}", 100.0 * shrinking.held->radius / radius)
                                              : "100";
    return row({name, gap, atRest, falls});
}

}

std::string shrinkingSection(const ShrinkingGround &ground, const ShrinkingTrial &trial, const PicturedBall &pictured)
{
    const double radius = pictured.resting.radius;
    std::string text = std::format(R"(
## Figures 19 and 20: a ball that shrinks

Mesh 4, as it stands, scaled to a diagonal of 10; balls of {:.0f} % of that, without any bounce, under a gravity of 9.8. All
three colliders under the dissertation's own steps (4.4.4: move, then push out along the line from the closest point), 480 a
second, so that only the collider differs; and `exact` under ours, 240 a second. Gaps are those to the true surface,
whatever the collider takes for it, in per cent of the ball's radius; below 0 the surface reaches into the ball.

![Columns: exact, greedy, octree; rows: at first contact, at rest, when it falls through](evaluation-ball.png)

From left to right `exact` (green), `greedy` (orange) and `octree` (blue): the same ball, thrown at a groove, after the step in
which it is first touched; at rest there; and as small as it is when it is last held, before it falls through.
)",
                                   100.0 * radius / ShrinkingGround::size)
        + head({"", "gap at first contact, %", "gap at rest, %", "falls through at, % of its radius"});
    constexpr std::array names{"exact", "greedy", "octree"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += ofBall(names[i], pictured.contacts[i], pictured.shrinking[i], ground, radius);
    }
    text += std::format(R"(
The gap that is below there lets a ball of {:.1f} % through, and none of more than {:.1f} % (the widest way to where the exact
ball has fallen, by the exact distance on a grid, and what that may miss): so it has to be.

### First contact, {} drops

Balls that start at rest above, at places by chance, and that do touch the surface on their way. *Too early*: there is a gap of
more than 1 % after the step in which the collider first answers. *Too late*: the surface has reached in by more than 1 %
before that. *Never*: the ball goes through all of it, and nothing answers.
)",
                        100.0 * pictured.gap.radius / radius,
                        100.0 * (pictured.gap.radius + pictured.gap.missed) / radius, trial.contacts.front().size())
        + head({"", "too early, %", "too late, %", "never", "gap, median", "all gaps", "reached in before, median",
                "most"});
    for (std::size_t i = 1; i < manners().size(); ++i) {
        text += contactRow(manners()[i].name, trial.contacts[i]);
    }
    const auto falling = std::ranges::count_if(trial.gaps, [](const Neck &gap) { return gap.radius > 0.0; });
    text += std::format(R"(
Figure 20 has boxes that answer too early. At the depth that goes with its figure 18, 3·log8(faces), none does here: its
last boxes are smaller than faces, so that hardly more than the vertices is left of the surface, and balls sink in. A greedy
answer is never too early, since it is a point of the surface.

### Grooves, {} places

Where a ball rests by `exact`, each way is asked to hold it, and then to let it through as it shrinks to a tenth in five
seconds. *Rests there*: after a second it is within its radius of the place. *At full size*: it falls before it shrinks.
Of {} places the exact ball falls, by the dissertation's steps. *Falls at*: the radius beside that of the gap which the exact
ball falls through, the median with the quartiles: less where a ball lies beside the gap and is held, more where it takes
another way. *Too large*: it falls though no way as far down is wide enough for it that does not rise, whatever it leads
to, within one and a half radii. Widths are by the exact distance on a grid, whose error is allowed for.
)",
                        trial.resting.size(), falling)
        + head({"", "rests there, %", "at full size", "falls at, of the gap", "too large, %"});
    for (std::size_t i = 0; i < manners().size(); ++i) {
        text += placeRow(manners()[i].name, trial, trial.shrinking[i]);
    }
    return text;
}

std::string leftOutSection()
{
    return R"(
## What is not measured

- A graphics card, and its memory: there was none. Frames, and the dissertation's way to draw them, are in
  [rendering.md](rendering.md).
- Its own program and models, which are not to be had: what stands beside ours is what it published.
- `octree` on mesh 5: its vertices, written out, are too many for it. `simple` there is asked once for each set, since a
  query takes seconds.
- How a collision feels to who plays, which is what its 5.5 is after. The gaps and the radii here are what can be counted of it.
- Other libraries' trees beside ours: [colliders.md](colliders.md); many balls at once: [physics.md](physics.md).
)";
}

}
