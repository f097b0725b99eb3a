// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <format>
#include <functional>
#include <string_view>

#include "core/measure/words.h"
#include "evaluationtables.h"
#include "tests/bench/tables.h"

namespace romanesco::bench {

namespace {

constexpr std::size_t byOnePerCent = 1;

using Rows = std::vector<const ColliderRow *>;

/// The sets' rows of a kind.
Rows rowsOf(const ColliderTrial &trial, const std::string &name)
{
    Rows rows;
    for (const ColliderRow &row : trial.rows) {
        if (nameOf(row) == name) {
            rows.push_back(&row);
        }
    }
    return rows;
}

/// A cell with what each set has, between slashes.
std::string ofSets(const Rows &rows, const std::function<std::string(const ColliderRow &)> &cell)
{
    std::string text;
    for (const ColliderRow *row : rows) {
        text += (text.empty() ? "" : " / ") + cell(*row);
    }
    return text;
}

std::string tests(const ColliderRow &row)
{
    return figure(row.survey.faceTestsMean);
}

std::string nodes(const ColliderRow &row)
{
    return figure(row.survey.nodeVisitsMean);
}

std::string wrong(const ColliderRow &row)
{
    return percent(row.survey.wrong[byOnePerCent]);
}

std::string worst(const ColliderRow &row)
{
    return figure(100.0 * row.survey.worst);
}

std::string missedOf(const ColliderRow &row)
{
    return std::format("{} of {}", row.survey.missed.count, row.survey.missed.of);
}

/// Of the set that has the most.
std::string collisionsMissed(const Rows &rows)
{
    const auto near = std::ranges::find(rows, QuerySet::Near, &ColliderRow::queries);
    return near == rows.end() ? "–" : missedOf(**near);
}

std::string times(const ColliderRow &row)
{
    const auto &[median, lower, upper] = row.nanoseconds;
    return std::format("{} ({}–{})", figure(1e-3 * median), figure(1e-3 * lower), figure(1e-3 * upper));
}

/// Beside its figures 17 and 18: what it counts, and what is off.
std::string comparison(const std::vector<Evaluated> &evaluated)
{
    std::string text = head({"mesh", "its simple", "its fractal", "greedy, counted", "greedy wrong", "missed",
                             "its boxes", "octree, counted", "octree wrong", "missed", "exact", "nodes", "wrong"});
    for (const auto &[model, loading, trial] : evaluated) {
        const Rows greedy = rowsOf(trial, "greedy");
        const Rows octree = rowsOf(trial, "octree");
        const Rows exact = rowsOf(trial, "exact");
        std::vector<std::string> cells{model.id, grouped(model.faces),
                                       model.shape ? grouped(model.published.faceTests) : "–"};
        if (model.shape) {
            cells.insert(cells.end(), {tests(*greedy.front()), ofSets(greedy, wrong), collisionsMissed(greedy)});
        } else {
            cells.insert(cells.end(), 3, "–");
        }
        cells.push_back(grouped(model.published.boxTests));
        if (octree.front()->reason.empty()) {
            cells.insert(cells.end(), {ofSets(octree, tests), ofSets(octree, wrong), collisionsMissed(octree)});
        } else {
            cells.insert(cells.end(), 3, "–");
        }
        cells.insert(cells.end(), {ofSets(exact, tests), ofSets(exact, nodes), ofSets(exact, wrong)});
        text += row(cells);
    }
    return text;
}

std::string tableOf(const Evaluated &evaluated)
{
    const auto &[model, loading, trial] = evaluated;
    std::string text = std::format("\n### Mesh {}, {}: {}\n\n", model.id, model.title, facesText(trial.faces));
    for (const ColliderTrial::Set &set : trial.sets) {
        text += std::format("- {}: {}.\n", nameOf(set.queries), wordsOf(set));
    }
    text += head({"", "µs", "face tests", "nodes", "wrong by 1 %", "worst, %", "missed, near", "built in ms", "kB"});
    std::string reasons;
    std::string last;
    for (const ColliderRow &each : trial.rows) {
        const std::string name = nameOf(each);
        if (!isShown(each) || each.queries != trial.rows.front().queries) {
            continue;
        }
        const Rows rows = rowsOf(trial, name);
        if (!each.reason.empty()) {
            reasons += std::format("\n`{}`: {}.\n", name, each.reason);
            continue;
        }
        const std::size_t asked = each.survey.asked;
        const bool isFewer = asked < trial.sets.front().points;
        text +=
            row({isFewer ? std::format("{}, {} asked", name, asked) : name, ofSets(rows, times), ofSets(rows, tests),
                 ofSets(rows, nodes), ofSets(rows, wrong), ofSets(rows, worst), collisionsMissed(rows),
                 figure(each.buildMilliseconds.median), figure(static_cast<double>(each.bytes) / 1e3)});
    }
    return text + reasons;
}

}

bool isShown(const ColliderRow &row)
{
    return !row.tolerance || *row.tolerance == 1e-3 || *row.tolerance == 1e-2;
}

std::string collisionSection(const std::vector<Evaluated> &evaluated)
{
    std::string text = R"(
## Figures 17 and 18: collision, with the errors

Its cost is the number of times that the closest point of a face is computed for one query; ours is counted in the same
way. Three figures stand for three sets of queries, *uniform / near / pocket* (see below each mesh); *wrong*: share of the
answers, in per cent, that are off by more than 1 % of the true distance, with what that tells of all (95 % confidence) in
brackets; *missed*: near collisions, of a ball of 2 % of the diagonal, that are not found. A *node* is a state of the fractal
that was entered, its children bounded together: about as much work as four faces.
)" + comparison(evaluated)
        + R"(
- Its fractal collider, here `greedy`, costs b·t·d, as it says. "Fully accurate" it is not: it goes on in the copy whose *base
  mesh* is nearest, which says nothing of what grows on it. How much that does depends on the fractal, as the two trees show.
- The 420 that it gives for mesh 3 is not 10·7·5 = 350, which is what such a collider counts.
- Its costs of boxes are a formula, 96·log2(faces), as if all eight octants of each level held something; `octree` counts
  those that do.
- Its simple collider is exact, and all faces are its cost. `exact` is so at a few faces: that recursion makes an exact
  answer cheap is right, by another algorithm, which also costs less than its greedy one.
- An ordinary mesh is not out of reach either: a tree of boxes (`bvh`, which `exact` uses there) costs a hundred faces or so
  where its table has all of them. What it takes beside that is memory, and time to build.

Every way to search, on each mesh. *Worst*: the largest error, in per cent of the distance. Times are of the thread, the
median of seven rounds. Of an ordinary mesh the nodes of `exact` are copies, of which there is one; what its tree visits
stands beside `bvh`. `greedy` is there as good as `simple`. Slow ones were asked less, as they say. The same of any file: `romanesco measure`, see
[measuring.md](measuring.md).
)";
    for (const Evaluated &each : evaluated) {
        text += tableOf(each);
    }
    return text;
}

}
