// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace romanesco::bench {

std::string number(double value)
{
    if (std::isnan(value)) {
        return "–";
    }
    char text[64];
    const int decimals = value == std::round(value) || value >= 99.95 ? 0 : value >= 0.995 ? 1 : 2;
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string digits = text;
    const std::size_t point = std::min(digits.find('.'), digits.size());
    for (std::size_t i = point; i > 3; i -= 3) {
        digits.insert(i - 3, ",");
    }
    return digits;
}

std::string joined(const std::vector<double> &values)
{
    if (std::ranges::all_of(values, [](double value) { return std::isnan(value); })) {
        return number(missing);
    }
    std::string text;
    for (const double value : values) {
        text += (text.empty() ? "" : " / ") + number(value);
    }
    return text;
}

std::string row(const std::vector<std::string> &cells)
{
    std::string text = "|";
    for (const std::string &cell : cells) {
        text += (cell.empty() ? "" : " ") + cell + " |";
    }
    return text + "\n";
}

std::string head(const std::vector<std::string> &cells)
{
    std::string text = "\n" + row(cells) + "|";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        text += "---|";
    }
    return text + "\n";
}

bool takeFlag(int &argc, char **argv, const std::string &flag)
{
    char **const end = std::remove(argv, argv + argc, flag);
    const bool isThere = end != argv + argc;
    argc = static_cast<int>(end - argv);
    return isThere;
}

void Tables::ReportRuns(const std::vector<Run> &runs)
{
    for (const Run &run : runs) {
        if (run.skipped) {
            GetErrorStream() << run.benchmark_name() << ": " << run.skip_message << "\n";
        }
        if (run.run_type == Run::RT_Aggregate ? run.aggregate_name != "median" : run.repetitions > 1) {
            continue;
        }
        Figures &figures = m_runs[run.run_name.function_name];
        const double microseconds = 1e6 / benchmark::GetTimeUnitMultiplier(run.time_unit);
        figures["us"] = run.GetAdjustedCPUTime() * microseconds;
        figures["wall_us"] = run.GetAdjustedRealTime() * microseconds;
        for (const auto &[name, counter] : run.counters) {
            figures[name] = counter.value;
        }
    }
}

double Tables::figure(const std::string &run, const std::string &what) const
{
    const auto figures = m_runs.find(run);
    if (figures == m_runs.end()) {
        return missing;
    }
    const auto value = figures->second.find(what);
    return value == figures->second.end() ? missing : value->second;
}

int run(int argc, char **argv, Tables *tables, std::vector<std::string> rounds)
{
    std::vector<char *> arguments(argv, argv + argc);
    for (std::size_t i = 0; tables && i < rounds.size(); ++i) {
        arguments.insert(arguments.begin() + 1, rounds[i].data());
    }
    argc = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&argc, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(argc, arguments.data())) {
        return 1;
    }
    tables ? benchmark::RunSpecifiedBenchmarks(tables) : benchmark::RunSpecifiedBenchmarks();
    return 0;
}

}
