// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <expected>
#include <format>
#include <optional>
#include <print>

#include <QCommandLineParser>

#include "app/imagedecoder.h"
#include "ballframes.h"
#include "colliderchoice.h"
#include "core/formats/numbertext.h"
#include "core/physics/scenephysics.h"
#include "core/physics/simulation.h"
#include "input.h"
#include "output.h"

namespace romanesco::cli {

namespace {

constexpr double leastTimeStep = 1e-6;
constexpr double greatestTimeStep = 0.1;
/// Doubles count so far.
constexpr double mostSteps = 1e15;

struct Options {
    QCommandLineOption seconds{QStringLiteral("seconds"), QStringLiteral("How long the balls move."),
                               QStringLiteral("S")};
    QCommandLineOption timeStep{QStringLiteral("dt"), QStringLiteral("Seconds a step (default: 1/240)."),
                                QStringLiteral("DT")};
    ColliderChoice collider;
    QCommandLineOption asDissertation{
        QStringLiteral("as-dissertation"),
        QStringLiteral("Move balls as the dissertation does, which loses energy and tunnels.")};
    QCommandLineOption shrink{QStringLiteral("shrink"),
                              QStringLiteral("Radii shrink as exp(-RATE t), to a billionth at most."),
                              QStringLiteral("RATE"), QStringLiteral("0")};
    QCommandLineOption record{QStringLiteral("record"), QStringLiteral("Write what is needed to run it again."),
                              QStringLiteral("F")};
    QCommandLineOption replay{
        QStringLiteral("replay"),
        QStringLiteral("Run a recording again, and tell whether it comes to the same; it says all the rest."),
        QStringLiteral("F")};
    BallFrames::Options frames;
    QCommandLineOption quiet{QStringLiteral("quiet"), QStringLiteral("No progress.")};
};

/// What is run, and of a recording what it came to.
struct Wanted {
    Recording recording;
    bool isReplay = false;
    std::optional<BallFrames::Choice> frames = {};
};

/// A wish, or an exit status after a complaint.
using Wish = std::expected<Wanted, int>;

Wish wrong(const QString &words, int status = WrongUsage)
{
    complain(words);
    return std::unexpected(status);
}

/// Clamped, with a warning.
std::optional<double> timeStepOf(const QCommandLineParser &parser, const Options &options)
{
    if (!parser.isSet(options.timeStep)) {
        return Laws().timeStep;
    }
    const auto asked = numberOf(parser, options.timeStep);
    if (!asked || *asked == 0.0) {
        complain(QStringLiteral("--dt takes a number above 0, not \"%1\"").arg(parser.value(options.timeStep)));
        return std::nullopt;
    }
    const double taken = std::clamp(*asked, leastTimeStep, greatestTimeStep);
    if (taken != *asked) {
        complain(QStringLiteral("warning: --dt %1 is taken for %2").arg(*asked).arg(taken));
    }
    return taken;
}

Wish replayOf(const QCommandLineParser &parser, const Options &options)
{
    for (const char *other : {"seconds", "dt", "collider", "tolerance", "as-dissertation", "shrink"}) {
        if (parser.isSet(QLatin1String(other))) {
            return wrong(QStringLiteral("--replay takes no --%1: the recording says it").arg(QLatin1String(other)));
        }
    }
    const QString file = parser.value(options.replay);
    const auto text = readText(file);
    if (!text) {
        return wrong(QStringLiteral("cannot read %1: %2").arg(file, QString::fromStdString(text.error())), BadInput);
    }
    auto recording = recordingFromText(*text);
    if (!recording) {
        return wrong(QStringLiteral("%1: %2").arg(file, QString::fromStdString(recording.error())), BadInput);
    }
    return Wanted{std::move(*recording), true};
}

Wish wantedOf(const QCommandLineParser &parser, const Options &options)
{
    if (parser.value(options.record) == QLatin1String("-")) {
        return wrong(QStringLiteral("--record takes a file: stdout has the rows"));
    }
    const auto seconds = numberOf(parser, options.seconds);
    if (!seconds) {
        return wrong(
            parser.isSet(options.seconds)
                ? QStringLiteral("--seconds takes a number from 0 on, not \"%1\"").arg(parser.value(options.seconds))
                : QStringLiteral("simulate needs --seconds S"));
    }
    const auto timeStep = timeStepOf(parser, options);
    const auto collider = options.collider.chosen(parser);
    if (!timeStep || !collider) {
        return std::unexpected(WrongUsage);
    }
    const auto shrink = numberOf(parser, options.shrink);
    if (!shrink) {
        return wrong(QStringLiteral("--shrink takes a number from 0 on, not \"%1\"").arg(parser.value(options.shrink)));
    }
    // as many as are needed, but none for a last digit
    const double steps = std::ceil(*seconds / *timeStep * (1.0 - 1e-12));
    if (steps > mostSteps) {
        return wrong(QStringLiteral("--seconds %1 are too many steps").arg(*seconds));
    }
    Wanted wanted;
    wanted.recording.world.laws.timeStep = *timeStep;
    wanted.recording.world.shrinkRate = *shrink;
    wanted.recording.world.isAsInDissertation = parser.isSet(options.asDissertation);
    wanted.recording.collider = *collider;
    wanted.recording.steps = static_cast<std::uint64_t>(steps);
    return wanted;
}

/// The rows of the balls.
class BallTable
{
public:
    explicit BallTable(ByteSink &sink)
        : m_output(sink)
    {
        m_output.append("step,time,ball,x,y,z,vx,vy,vz,radius,contacts,face_tests\n");
    }

    void add(const Simulation &simulation)
    {
        const World &world = simulation.world();
        const double time = static_cast<double>(world.stepCount()) * world.options().laws.timeStep;
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const Ball ball = inWorld(world.balls()[i], simulation.places().surroundings(world.balls()[i].place).get());
            const StepReport &report = world.reports()[i];
            m_output.append(std::format("{},", world.stepCount()));
            addNumber(time);
            m_output.append(std::format("{},", i));
            for (const glm::dvec3 &v : {ball.position, ball.velocity}) {
                addNumber(v.x);
                addNumber(v.y);
                addNumber(v.z);
            }
            addNumber(ball.radius);
            m_output.append(std::format("{},{}\n", report.contacts, report.cost.faceTests));
        }
    }

    [[nodiscard]] std::expected<void, std::string> flush() { return m_output.flush(); }
    [[nodiscard]] bool isGood() const { return m_output.isGood(); }

private:
    void addNumber(double number)
    {
        char *to = m_numbers.write(m_output.room(NumberText::mostBytes + 1), number);
        *to++ = ',';
        m_output.take(to);
    }

    BufferedOutput m_output;
    NumberText m_numbers{NumberText::mostDigits};
};

int refuse(const QString &file, const std::string &words)
{
    complain(QStringLiteral("%1: %2").arg(file, QString::fromStdString(words)));
    return CannotDo;
}

/// Shows how far it is, some times a second.
class StepProgress
{
public:
    StepProgress(bool isQuiet, std::uint64_t steps)
        : m_progress(isQuiet)
        , m_steps(steps)
    {
    }

    void show(std::uint64_t step)
    {
        const auto now = std::chrono::steady_clock::now();
        if (now - m_shown >= std::chrono::milliseconds(100)) {
            m_shown = now;
            m_progress.show(QStringLiteral("step %1 of %2").arg(step).arg(m_steps));
        }
    }

private:
    Progress m_progress;
    std::uint64_t m_steps;
    std::chrono::steady_clock::time_point m_shown = std::chrono::steady_clock::now();
};

/// What is made of each step: rows, or pictures.
class Output
{
public:
    Output(StandardOutput &sink, std::optional<BallFrames> &frames)
        : m_frames(frames)
    {
        if (!m_frames) {
            m_table.emplace(sink);
        }
    }

    /// At the start and after each step. Whether to go on.
    [[nodiscard]] bool add(const Simulation &simulation)
    {
        if (m_frames) {
            m_isGood = m_frames->take(simulation);
            return m_isGood;
        }
        m_table->add(simulation);
        return m_table->isGood();
    }

    /// An exit status.
    [[nodiscard]] int finish()
    {
        const auto written = m_table ? m_table->flush() : std::expected<void, std::string>();
        if (!written) {
            complain(QStringLiteral("cannot write -: %1").arg(QString::fromStdString(written.error())));
        }
        return written && m_isGood ? Done : CannotDo;
    }

private:
    std::optional<BallFrames> &m_frames;
    std::optional<BallTable> m_table;
    bool m_isGood = true;
};

/// Moves the balls. An exit status.
int run(Simulation &simulation, const Recording &wanted, const QString &file, const CancelWatch &cancel, Output &output,
        bool isQuiet)
{
    StepProgress progress(isQuiet, wanted.steps);
    bool goesOn = output.add(simulation);
    auto input = wanted.inputs.begin();
    for (std::uint64_t step = 0; step < wanted.steps && goesOn && !isCancelled(); ++step) {
        for (; input != wanted.inputs.end() && input->step == step; ++input) {
            if (const auto applied = simulation.apply(*input, cancel.token()); !applied) {
                return refuse(file, applied.error());
            }
        }
        simulation.step();
        goesOn = output.add(simulation);
        progress.show(step + 1);
    }
    if (const int status = output.finish(); status != Done) {
        return status;
    }
    if (isCancelled()) {
        complain(QStringLiteral("cancelled"));
        return CannotDo;
    }
    return Done;
}

/// Says what it came to, and keeps it where that is wanted. An exit status.
int conclude(const Simulation &simulation, const Wanted &wanted, const QString &record)
{
    const Recording recording = simulation.recording();
    std::println(stderr, "state {:016x}", recording.endHash);
    if (const std::uint64_t lost = simulation.world().lostSteps(); lost > 0) {
        complain(QStringLiteral("warning: %1 times a ball was not done with a step and lost the rest of it").arg(lost));
    }
    if (wanted.isReplay && recording.endHash != wanted.recording.endHash) {
        complain(QStringLiteral("the recording came to another state"));
        return CannotDo;
    }
    return record.isEmpty() || writeWhole(record, QByteArray::fromStdString(textOf(recording))) ? Done : CannotDo;
}

}

int runSimulate(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Lets the balls of a scene fall on its objects and fractals, at 9.8 units a second squared.\n"
        "Prints a row for each ball at each step: step,time,ball,x,y,z,vx,vy,vz,radius,contacts,face_tests.\n"
        "Balls are numbered from 0, in the order of the text. With --render there are pictures instead. At last the "
        "state's hash is told on stderr, which is the "
        "same for the same scene and options on every machine."));
    const Options options;
    parser.addOptions({options.seconds, options.timeStep, options.asDissertation, options.shrink, options.record,
                       options.replay, depthOption(), options.quiet});
    options.collider.addTo(parser);
    options.frames.addTo(parser);
    const auto file = parseArguments(parser, "simulate", arguments);
    if (!file) {
        return file.error();
    }
    Wish wanted = parser.isSet(options.replay) ? replayOf(parser, options) : wantedOf(parser, options);
    if (!wanted) {
        return wanted.error();
    }
    if (options.frames.areSet(parser)) {
        wanted->frames = options.frames.chosen(parser);
        if (!wanted->frames) {
            return WrongUsage;
        }
    }
    const auto input = readInput(*file, parser, wanted->frames ? decodeImage : ImageDecoder());
    if (!input) {
        return input.error();
    }
    catchCancel();
    // what takes the output may have a limit: an error, not the end of the program
    std::signal(SIGXFSZ, SIG_IGN);
    const CancelWatch cancel;
    auto simulation =
        Simulation::start(input->scene, wanted->recording.world, wanted->recording.collider, cancel.token());
    if (!simulation) {
        return refuse(*file, simulation.error());
    }
    if (wanted->isReplay && simulation->world().stateHash() != wanted->recording.startHash) {
        return refuse(*file, "its balls are not those of the recording");
    }
    if (!provesClearance(wanted->recording.collider.kind) || wanted->recording.world.isAsInDissertation) {
        complain(QStringLiteral("warning: balls may go through the surface"));
    }
    std::optional<BallFrames> frames;
    if (wanted->frames) {
        auto made = BallFrames::create(*wanted->frames, input->scene);
        if (!made) {
            return refuse(*file, made.error());
        }
        frames.emplace(std::move(*made));
    }
    StandardOutput sink;
    Output output(sink, frames);
    const int status = run(*simulation, wanted->recording, *file, cancel, output, parser.isSet(options.quiet));
    return status == Done ? conclude(*simulation, *wanted, parser.value(options.record)) : status;
}

}
