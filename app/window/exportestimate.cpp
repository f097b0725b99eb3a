// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "exportestimate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <thread>
#include <utility>

#include <QCoreApplication>

#include "resourcefiles.h"

namespace romanesco {

namespace {

using Clock = std::chrono::steady_clock;

/// As long as a sample takes once bytes come, and as long as it waits for them.
constexpr double sampleSeconds = 0.08;
constexpr std::chrono::milliseconds longestSample(1000);

class ExportWords
{
    Q_DECLARE_TR_FUNCTIONS(ExportWords)
};

/// Keeps when and how much was written first, and last, until that is enough.
class SampleSink final : public ByteSink
{
public:
    explicit SampleSink(std::stop_source enough)
        : m_enough(std::move(enough))
    {
    }

    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        m_last.seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
        m_last.bytes += static_cast<double>(bytes.size());
        if (m_first.bytes == 0.0) {
            m_first = m_last;
        } else if (m_last.seconds > sampleSeconds) {
            m_enough.request_stop();
        }
        return {};
    }

    /// What precedes the first bytes is done once; from there on the time goes with the bytes.
    [[nodiscard]] std::optional<double> secondsFor(double bytes) const
    {
        if (m_last.bytes == m_first.bytes) {
            return std::nullopt;
        }
        const double secondsPerByte = (m_last.seconds - m_first.seconds) / (m_last.bytes - m_first.bytes);
        return m_first.seconds + secondsPerByte * std::max(bytes - m_first.bytes, 0.0);
    }

private:
    struct Mark {
        double seconds = 0.0;
        double bytes = 0.0;
    };
    std::stop_source m_enough;
    Clock::time_point m_start = Clock::now();
    Mark m_first;
    Mark m_last;
};

/// Asks for a stop when the longest time of a sample has passed, or a stop was asked for before.
class SampleTimer
{
public:
    explicit SampleTimer(const std::stop_token &stop)
        : m_thread([this, stop](const std::stop_token &end) {
            const Clock::time_point last = Clock::now() + longestSample;
            while (!stop.stop_requested() && !end.stop_requested() && Clock::now() < last) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
            m_source.request_stop();
        })
    {
    }
    [[nodiscard]] const std::stop_source &source() const { return m_source; }

private:
    std::stop_source m_source;
    std::jthread m_thread;
};

/// From the speed of the bytes that come in the time of a sample.
std::optional<double> measuredSeconds(const Scene &scene, const ExportOptions &options, const Count &bytes,
                                      const std::stop_token &stop)
{
    const SampleTimer timer(stop);
    SampleSink sink(timer.source());
    const ResourceFiles files;
    const Clock::time_point start = Clock::now();
    if (exportScene(scene, options, sink, {.stop = timer.source().get_token(), .files = &files})) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }
    return sink.secondsFor(std::pow(10.0, bytes.log10()));
}

QString wordsAgainst(const ExportEstimate &estimate, const ExportOptions &options, const std::filesystem::path &path,
                     const std::vector<std::filesystem::path> &files)
{
    if (!estimate.forecast) {
        return ExportWords::tr("The copies are of too many sets to be counted. A smaller depth can be exported.");
    }
    if (writesOver(path, options.format, files)) {
        return ExportWords::tr(
            "This name, or that of the materials beside it, belongs to a file that the picture is made "
            "from. Choose another one.");
    }
    if (const std::string reason = obstacle(*estimate.forecast, options, path); !reason.empty()) {
        return ExportWords::tr("This cannot be exported: %1.").arg(QString::fromStdString(reason));
    }
    // also where nothing is known of the disk
    return estimate.forecast->faces.toInteger()
        ? QString()
        : ExportWords::tr("These are too many faces for any disk. A smaller depth can be exported.");
}

}

ExportEstimate estimateExport(const Scene &scene, const ExportOptions &options, const std::filesystem::path &path,
                              const std::vector<std::filesystem::path> &files, const std::stop_token &stop)
{
    std::error_code ignored;
    ExportEstimate estimate{.forecast = forecast(scene, options),
                            .seconds = {},
                            .freeBytes = freeBytes(path),
                            .isReplacing = std::filesystem::exists(path, ignored),
                            .obstacle = {}};
    estimate.obstacle = wordsAgainst(estimate, options, path, files);
    if (estimate.obstacle.isEmpty()) {
        estimate.seconds = measuredSeconds(scene, options, estimate.forecast->bytes, stop);
    }
    return estimate;
}

}
