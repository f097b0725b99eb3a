// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <chrono>
#include <cmath>
#include <format>
#include <limits>
#include <optional>
#include <print>

#include <QCommandLineParser>

#include "colliderchoice.h"
#include "core/formats/numbers.h"
#include "core/formats/numbertext.h"
#include "core/scene/scenecollider.h"
#include "input.h"
#include "output.h"
#include "points.h"

namespace romanesco::cli {

namespace {

struct Options {
    QCommandLineOption points{QStringLiteral("points"),
                              QStringLiteral("The points to ask from, \"x y z\" a line; - is stdin."),
                              QStringLiteral("PTS")};
    ColliderChoice collider;
    QCommandLineOption within{QStringLiteral("within"),
                              QStringLiteral("Look no farther; where nothing is nearer the distance is inf."),
                              QStringLiteral("R")};
    QCommandLineOption maxNodes{
        QStringLiteral("max-nodes"),
        QStringLiteral("Nodes that exact and approximate visit for a point; answers promise less then."),
        QStringLiteral("N")};
    QCommandLineOption quiet{QStringLiteral("quiet"), QStringLiteral("No progress.")};
};

/// What is asked of every point.
struct Wanted {
    SceneCollider::Options collider;
    Query query;
    QString points;
};

/// Complains where the options make no sense.
std::optional<Wanted> wantedOf(const QCommandLineParser &parser, const Options &options, const QString &file)
{
    const auto wrong = [](const QString &words) {
        complain(words);
        return std::nullopt;
    };
    Wanted wanted;
    wanted.points = parser.value(options.points);
    if (wanted.points.isEmpty()) {
        return wrong(QStringLiteral("closest needs --points PTS"));
    }
    if (wanted.points == QLatin1String("-") && file == wanted.points) {
        return wrong(QStringLiteral("stdin can be read once only"));
    }
    const auto collider = options.collider.chosen(parser);
    if (!collider) {
        return std::nullopt;
    }
    wanted.collider = *collider;
    const std::optional<double> within = numberOf(parser, options.within);
    if (parser.isSet(options.within) && !within) {
        return wrong(QStringLiteral("--within takes a number from 0 on, not \"%1\"").arg(parser.value(options.within)));
    }
    wanted.query.radius = within.value_or(wanted.query.radius);
    if (parser.isSet(options.maxNodes)) {
        const auto nodes = wholeFromText(parser.value(options.maxNodes).toStdString());
        if (!nodes || *nodes == 0) {
            return wrong(QStringLiteral("--max-nodes takes a whole number from 1 on, not \"%1\"")
                             .arg(parser.value(options.maxNodes)));
        }
        if (collider->kind != ColliderKind::Exact && collider->kind != ColliderKind::Approximate) {
            return wrong(QStringLiteral("only --collider exact and approximate have a limit of nodes"));
        }
        wanted.query.nodeBudget = *nodes;
    }
    return wanted;
}

/// The lines of the answers.
class AnswerTable
{
public:
    explicit AnswerTable(ByteSink &sink)
        : m_output(sink)
    {
        m_output.append("distance\tx\ty\tz\tnx\tny\tnz\tface_tests\tnode_visits\tlower\tpromise\n");
    }

    void add(const Hit &hit)
    {
        const glm::dvec3 direction = hit.isFound() ? hit.direction : glm::dvec3(0.0);
        addNumber(hit.distance);
        for (const glm::dvec3 &v : {hit.isFound() ? hit.point : glm::dvec3(0.0), direction}) {
            addNumber(v.x);
            addNumber(v.y);
            addNumber(v.z);
        }
        m_output.append(std::format("{}\t{}\t", hit.cost.faceTests, hit.cost.nodeVisits));
        addNumber(hit.lower);
        m_output.append(promiseText(hit));
        ++m_count;
    }

    [[nodiscard]] std::expected<void, std::string> flush() { return m_output.flush(); }
    [[nodiscard]] bool isGood() const { return m_output.isGood(); }
    [[nodiscard]] std::uint64_t count() const { return m_count; }

private:
    void addNumber(double number)
    {
        char *to = m_output.room(NumberText::mostBytes + 1);
        to = std::isinf(number) ? std::format_to(to, "inf") : m_numbers.write(to, number);
        *to++ = '\t';
        m_output.take(to);
    }

    static std::string promiseText(const Hit &hit)
    {
        switch (hit.promise) {
        case Promise::Exact:
            return "exact\n";
        case Promise::Within:
            return std::format("within {}\n", hit.excess);
        case Promise::UpperBound:
            return "upper\n";
        case Promise::None:
            break;
        }
        return "none\n";
    }

    BufferedOutput m_output;
    NumberText m_numbers{NumberText::mostDigits};
    std::uint64_t m_count = 0;
};

int refuse(const QString &file, const std::string &words)
{
    complain(QStringLiteral("%1: %2").arg(file, QString::fromStdString(words)));
    return CannotDo;
}

/// Shows how many points were answered, some times a second.
class PointProgress
{
public:
    explicit PointProgress(bool isQuiet)
        : m_progress(isQuiet)
    {
    }

    void show(std::uint64_t count)
    {
        const auto now = std::chrono::steady_clock::now();
        if (now - m_shown >= std::chrono::milliseconds(100)) {
            m_shown = now;
            m_progress.show(QStringLiteral("%1 points").arg(count));
        }
    }

private:
    Progress m_progress;
    std::chrono::steady_clock::time_point m_shown = std::chrono::steady_clock::now();
};

/// An answer for each point, before more points are waited for. An exit status.
int answer(PointReader &points, Search &search, Query query, bool isQuiet)
{
    StandardOutput sink;
    AnswerTable answers(sink);
    PointProgress progress(isQuiet);
    Hit hit;
    int status = Done;
    while (answers.isGood()) {
        if (points.isEmpty()) {
            (void)answers.flush(); // it is asked again at the end
        }
        const auto point = points.next();
        if (!point) {
            std::println(stderr, "{}", point.error());
            status = BadInput;
            break;
        }
        if (!*point) {
            break;
        }
        query.p = **point;
        search.closest(query, hit);
        if (query.stop.stop_requested()) {
            break; // perhaps too early for that answer
        }
        answers.add(hit);
        progress.show(answers.count());
    }
    if (const auto written = answers.flush(); !written) {
        return refuse(QStringLiteral("cannot write -"), written.error());
    }
    if (isCancelled()) {
        complain(QStringLiteral("cancelled"));
        return CannotDo;
    }
    return status;
}

}

int runClosest(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Finds the point of the surface that is nearest to each of many points, in all objects and "
        "fractals of a scene.\n"
        "Prints a line for each: distance x y z nx ny nz face_tests node_visits lower promise, with tabs "
        "between.\n"
        "n is the direction from the surface to the point that was asked; nothing is nearer than lower.\n"
        "promise: exact; within X, at most 1 + X times the least; upper, of a point that may not be the "
        "nearest; none."));
    const Options options;
    parser.addOptions({options.points, options.within, options.maxNodes, depthOption(), options.quiet});
    options.collider.addTo(parser);
    const auto file = parseArguments(parser, "closest", arguments);
    if (!file) {
        return file.error();
    }
    std::optional<Wanted> wanted = wantedOf(parser, options, *file);
    if (!wanted) {
        return WrongUsage;
    }
    const auto input = readInput(*file, parser);
    if (!input) {
        return input.error();
    }
    auto points = PointReader::open(wanted->points);
    if (!points) {
        complain(QStringLiteral("cannot read %1: %2").arg(wanted->points, QString::fromStdString(points.error())));
        return BadInput;
    }
    catchCancel();
    const CancelWatch cancel;
    wanted->query.stop = cancel.token();
    const auto collider = SceneCollider::create(input->scene, wanted->collider, cancel.token());
    if (!collider) {
        return refuse(*file, collider.error());
    }
    return answer(*points, *collider->search(), wanted->query, parser.isSet(options.quiet));
}

}
