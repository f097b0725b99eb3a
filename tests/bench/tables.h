// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace romanesco::bench {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Three digits or so; a dash for what is missing.
[[nodiscard]] std::string number(double value);
/// With slashes; a single dash where all are missing.
[[nodiscard]] std::string joined(const std::vector<double> &values);

/// A line of a table in Markdown, and one with the rule under it.
[[nodiscard]] std::string row(const std::vector<std::string> &cells);
[[nodiscard]] std::string head(const std::vector<std::string> &cells);

/// Takes a flag out of the arguments; whether it was there.
[[nodiscard]] bool takeFlag(int &argc, char **argv, const std::string &flag);

/// Keeps what was measured, for a page to be written of it in Finalize(). Of repetitions it takes the median.
class Tables : public benchmark::BenchmarkReporter
{
public:
    bool ReportContext(const Context &) override { return true; }
    void ReportRuns(const std::vector<Run> &runs) override;

protected:
    [[nodiscard]] bool contains(const std::string &run) const { return m_runs.contains(run); }
    /// A counter by its name, the CPU time as "us" or the time that went by as "wall_us".
    [[nodiscard]] double figure(const std::string &run, const std::string &what) const;

private:
    using Figures = std::map<std::string, double>;

    std::map<std::string, Figures> m_runs;
};

/// Runs what is registered, as the arguments say, which are Google Benchmark's own. With tables these are written, of rounds
/// as its flags describe them, unless an argument says otherwise. The exit status.
[[nodiscard]] int run(int argc, char **argv, Tables *tables, std::vector<std::string> rounds);

}
