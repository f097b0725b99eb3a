// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
//
// bench_startup PROGRAM   how long PROGRAM takes until its window is painted and its fractal is there, what it does while
// nobody does anything, and how much memory it has, beside an empty window with a view of OpenGL. Each as its user starts it
// the first time.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <print>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "processfigures.h"
#include "screen.h"

namespace {

using namespace romanesco::bench;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int rounds = 9;
constexpr auto longest = 20s;
constexpr auto idleTime = 10s;

struct Moment {
    double seconds = 0.0;
    /// Of the processor.
    double cpu = 0.0;
};

struct Start {
    Moment painted;
    std::optional<Moment> fractal;
};

class Program
{
public:
    explicit Program(const std::string &path)
        : m_process(fork())
    {
        if (m_process == 0) {
            execl(path.c_str(), path.c_str(), nullptr);
            _exit(EXIT_FAILURE);
        }
    }
    ~Program()
    {
        kill(m_process, SIGTERM);
        waitpid(m_process, nullptr, 0);
    }
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    [[nodiscard]] pid_t process() const { return m_process; }
    [[nodiscard]] Moment now() const
    {
        return {std::chrono::duration<double>(Clock::now() - m_start).count(), cpuSeconds(m_process)};
    }

private:
    Clock::time_point m_start = Clock::now();
    pid_t m_process;
};

/// A home that no program has seen, but for the caches of drivers and fonts, which are there on every system.
void makeHome(const std::filesystem::path &home)
{
    for (const char *folder : {"config", "state", "data"}) {
        std::filesystem::remove_all(home / folder);
    }
    setenv("HOME", home.c_str(), 1);
    setenv("XDG_CONFIG_HOME", (home / "config").c_str(), 1);
    setenv("XDG_STATE_HOME", (home / "state").c_str(), 1);
    setenv("XDG_DATA_HOME", (home / "data").c_str(), 1);
    setenv("XDG_CACHE_HOME", (home / "cache").c_str(), 1);
}

Start startOf(const Program &program, const Screen &screen, bool hasFractal)
{
    Start start;
    for (bool isPainted = false;;) {
        const Screen::Look look = screen.look();
        const Moment now = program.now();
        if (look.isPainted && !isPainted) {
            isPainted = true;
            start.painted = now;
        }
        if (look.hasFractal && hasFractal) {
            start.fractal = now;
        }
        if (isPainted && (start.fractal || !hasFractal)) {
            return start;
        }
        if (now.seconds > std::chrono::duration<double>(longest).count()) {
            std::println(stderr, "nothing was seen of it in {}", longest);
            std::exit(EXIT_FAILURE);
        }
        std::this_thread::sleep_for(2ms);
    }
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Figures {
    std::vector<double> painted;
    std::vector<double> paintedCpu;
    std::vector<double> fractal;
    double idleCpu = 0.0;
    Memory memory;
};

void addStart(Figures &figures, const std::string &path, const Screen &screen, bool hasFractal)
{
    const Program program(path);
    const Start start = startOf(program, screen, hasFractal);
    figures.painted.push_back(start.painted.seconds);
    figures.paintedCpu.push_back(start.painted.cpu);
    if (start.fractal) {
        figures.fractal.push_back(start.fractal->seconds);
    }
}

void addRest(Figures &figures, const std::string &path, const Screen &screen, bool hasFractal)
{
    const Program program(path);
    (void)startOf(program, screen, hasFractal);
    std::this_thread::sleep_for(5s); // the picture becomes finer
    const double before = program.now().cpu;
    std::this_thread::sleep_for(idleTime);
    figures.idleCpu = program.now().cpu - before;
    figures.memory = memoryOf(program.process());
}

}

int main(int argc, char *argv[])
{
    if (argc != 2) {
        std::println(stderr, "bench_startup PROGRAM");
        return EXIT_FAILURE;
    }
    const std::string program = argv[1];
    const std::string empty = std::filesystem::path(argv[0]).replace_filename("bench_emptywindow");
    const std::filesystem::path home = std::filesystem::temp_directory_path() / "bench_startup";
    const Screen screen;
    Figures ours;
    Figures theirs;
    for (int i = 0; i <= rounds; ++i) {
        if (i == 1) { // the first round fills caches
            ours = theirs = {};
        }
        makeHome(home);
        addStart(theirs, empty, screen, false);
        makeHome(home);
        addStart(ours, program, screen, true);
    }
    addRest(theirs, empty, screen, false);
    makeHome(home);
    addRest(ours, program, screen, true);
    std::filesystem::remove_all(home);

    std::println("| | painted after | of the processor | fractal after | idle, of 10 s | memory | its own |");
    std::println("|---|---|---|---|---|---|---|");
    const auto row = [](const char *name, const Figures &of) {
        const std::string fractal = of.fractal.empty() ? "" : std::format("{:.0f} ms", 1000.0 * median(of.fractal));
        std::println("| {} | {:.0f} ms | {:.0f} ms | {} | {:.0f} ms | {:.0f} MiB | {:.0f} MiB |", name,
                     1000.0 * median(of.painted), 1000.0 * median(of.paintedCpu), fractal, 1000.0 * of.idleCpu,
                     of.memory.resident, of.memory.own);
    };
    row("empty window", theirs);
    row("romanesco", ours);
    std::println("\nRatio of painting: {:.2f}, of the processor's time until then {:.2f}",
                 median(ours.painted) / median(theirs.painted), median(ours.paintedCpu) / median(theirs.paintedCpu));
}
