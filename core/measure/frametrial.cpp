// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "frametrial.h"

#include <algorithm>
#include <array>
#include <format>
#include <ranges>
#include <utility>

#include "scenefaces.h"
#include "words.h"

namespace romanesco {

namespace {

constexpr std::array tolerances{0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
constexpr std::array places{FramePlace::View, FramePlace::Near};

/// How much more a picture may take at half the tolerance: what is seen of a surface that fills space.
constexpr std::uint64_t growth = 4;
constexpr int leastSamples = 8;
constexpr std::uint64_t leastTimed = 5;
constexpr std::uint64_t mostTimed = 15;
/// Of the frames that are timed.
constexpr std::uint64_t timedOperations = 5'000'000;

using Pixels = std::vector<std::uint8_t>;
using Done = std::expected<void, std::string>;

class Trial
{
public:
    Trial(FrameSource &source, const Scene &scene, const FrameTrial::Options &options, const TrialContext &context)
        : m_source(source)
        , m_faces(facesOf(scene.items))
        , m_options(options)
        , m_context(context)
    {
    }

    std::expected<FrameTrial, std::string> run()
    {
        m_made.device = m_source.description();
        for (const FramePlace place : places) {
            m_place = place;
            if (const Done done = tryPlace(); !done) {
                return std::unexpected(done.error());
            }
        }
        return std::move(m_made);
    }

private:
    /// A tolerance that is drawn, with its picture of one sample.
    struct Drawn {
        FrameRow row;
        Pixels moving;
        /// Of that picture, which stands alone.
        FrameCost cost;

        /// The same copies are the same picture, wherever in a pixel samples lie.
        [[nodiscard]] bool isLike(const Drawn &other) const
        {
            return cost.copies == other.cost.copies && cost.statesVisited == other.cost.statesVisited
                && moving == other.moving;
        }
    };

    Done tryPlace()
    {
        std::vector<Drawn> drawn; // the largest tolerance first
        std::vector<FrameRow> left;
        for (const double tolerance : tolerances | std::views::reverse) {
            FrameRow row{.place = m_place, .tolerance = tolerance};
            row.reason = drawn.empty() ? std::string() : obstacleTo(tolerance, drawn.back());
            if (!row.reason.empty()) {
                left.push_back(std::move(row));
                continue;
            }
            tell(row);
            auto next = drawMoving(std::move(row));
            if (!next) {
                return std::unexpected(next.error());
            }
            drawn.push_back(std::move(*next));
        }
        std::ranges::reverse(drawn);
        if (Done done = compare(drawn); !done) {
            return done;
        }
        std::ranges::reverse(left);
        std::ranges::move(left, std::back_inserter(m_made.rows));
        std::ranges::move(drawn | std::views::transform(&Drawn::row), std::back_inserter(m_made.rows));
        return {};
    }

    /// Why a picture is not drawn that is finer than another; empty where it is.
    [[nodiscard]] std::string obstacleTo(double tolerance, const Drawn &coarser) const
    {
        const std::optional<std::uint64_t> faces = m_faces ? m_faces->toInteger() : std::nullopt;
        if (faces && *faces <= m_options.mostOperations) {
            return {};
        }
        if (tolerance == 0.0) {
            return std::format("not possible: {} (at most {})", facesText(m_faces), grouped(m_options.mostOperations));
        }
        return growth * coarser.cost.operations() <= m_options.mostOperations
            ? std::string()
            : std::format("not drawn: at {} it is {} copies already", nameOf(coarser.row),
                          grouped(coarser.cost.copies));
    }

    void tell(const FrameRow &row)
    {
        const auto all = static_cast<double>(2 * tolerances.size() * places.size());
        m_context.tell(std::format("pictures, {}, {}", nameOf(m_place), nameOf(row)), m_told++ / all);
    }

    std::expected<Pixels, std::string> pixelsOf(const FrameRow &row, int samples, FrameCost *cost = nullptr)
    {
        const auto drawn = m_source.draw({m_place, row.tolerance, samples}, m_context.stop);
        if (!drawn) {
            return std::unexpected(drawn.error());
        }
        if (cost) {
            *cost = *drawn;
        }
        return m_source.pixels();
    }

    /// A picture, and what the frames take that follow.
    std::expected<Drawn, std::string> drawMoving(FrameRow row)
    {
        Drawn made;
        auto pixels = pixelsOf(row, 1, &made.cost);
        if (!pixels) {
            return std::unexpected(pixels.error());
        }
        made.moving = std::move(*pixels);
        const FrameRequest next{.place = m_place, .pixelTolerance = row.tolerance, .standsAlone = false};
        const std::uint64_t count = std::clamp(timedOperations / (made.cost.operations() + 1), leastTimed, mostTimed);
        std::vector<double> milliseconds;
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto cost = m_source.draw(next, m_context.stop);
            if (!cost) {
                return std::unexpected(cost.error());
            }
            row.cost = *cost;
            milliseconds.push_back(1e3 * cost->seconds);
        }
        row.milliseconds = spreadOf(std::move(milliseconds));
        made.row = std::move(row);
        return made;
    }

    /// As many as can be drawn in time at all these tolerances.
    [[nodiscard]] int samplesFor(const std::vector<Drawn> &drawn) const
    {
        std::uint64_t operations = 0;
        for (const Drawn &one : drawn) {
            operations += one.cost.operations();
        }
        int samples = m_options.mostSamples;
        while (samples > leastSamples && static_cast<std::uint64_t>(samples) * operations > m_options.mostInAll) {
            samples /= 2;
        }
        return samples;
    }

    /// The least tolerance comes first, and is the reference.
    Done compare(std::vector<Drawn> &drawn)
    {
        const int samples = samplesFor(drawn);
        const FrameRow &finest = drawn.front().row;
        const auto half = pixelsOf(finest, samples / 2);
        if (!half) {
            return std::unexpected(half.error());
        }
        const auto reference = pixelsOf(finest, samples);
        if (!reference) {
            return std::unexpected(reference.error());
        }
        m_made.references.push_back({m_place, finest.tolerance, samples, errorOf(*half, *reference)});
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            FrameRow &row = drawn[i].row;
            tell(row);
            row.moving = errorOf(drawn[i].moving, *reference);
            if (i == 0 || drawn[i].isLike(drawn[i - 1])) {
                row.alone = i == 0 ? FrameError() : drawn[i - 1].row.alone;
                continue;
            }
            const auto fine = pixelsOf(row, samples);
            if (!fine) {
                return std::unexpected(fine.error());
            }
            row.alone = errorOf(*fine, *reference);
        }
        return {};
    }

    FrameSource &m_source;
    std::optional<Count> m_faces;
    const FrameTrial::Options &m_options;
    const TrialContext &m_context;
    FramePlace m_place = FramePlace::View;
    double m_told = 0.0;
    FrameTrial m_made;
};

}

std::span<const double> framePixelTolerances()
{
    return tolerances;
}

std::string nameOf(const FrameRow &row)
{
    return std::format("{} px", briefly(row.tolerance));
}

std::expected<FrameTrial, std::string> tryFrames(FrameSource &source, const Scene &scene,
                                                 const FrameTrial::Options &options, const TrialContext &context)
{
    return Trial(source, scene, options, context).run();
}

}
