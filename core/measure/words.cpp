// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "words.h"

#include <cmath>
#include <format>

namespace romanesco {

namespace {

/// Of a percentage, two digits or so.
std::string brief(double value)
{
    return value >= 10.0 ? std::format("{:.0f}", value) : std::format("{:.2g}", value);
}

std::string_view meaningOf(QuerySet set)
{
    switch (set) {
    case QuerySet::Uniform:
        return "anywhere in 1.5 times the box";
    case QuerySet::Near:
        return "near the surface, 0.1 to 5 % of the diagonal off it";
    case QuerySet::Pocket:
        return "in the box, away from the surface";
    case QuerySet::Balls:
        break;
    }
    return "as the balls of the scene ask";
}

}

std::string figure(double value)
{
    if (value < 1e-3 || value >= 1e9) {
        return value == 0.0 ? "0" : std::format("{:.2g}", value);
    }
    if (value >= 999.5) {
        return grouped(static_cast<std::uint64_t>(std::llround(value)));
    }
    return std::format("{:.3g}", value);
}

std::string briefly(double value)
{
    std::string text = std::format("{}", value);
    if (const std::size_t exponent = text.find("e-0"); exponent != std::string::npos) {
        text.erase(exponent + 2, 1);
    }
    return text;
}

std::string grouped(std::uint64_t number)
{
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) {
        digits.insert(i - 3, ",");
    }
    return digits;
}

std::string facesText(const std::optional<Count> &faces)
{
    if (!faces) {
        return "too many faces to be counted";
    }
    if (faces->log10() >= 15.0) {
        return std::format("more than 10^{:.0f} faces", std::floor(faces->log10()));
    }
    return std::format("{} faces", grouped(faces->toInteger().value()));
}

std::string sizeText(const DepthRow &row)
{
    return row.sizeLog10 > -300.0 ? figure(std::pow(10.0, row.sizeLog10)) : std::format("1e{:.0f}", row.sizeLog10);
}

std::string pixelsText(double pixels)
{
    return std::isfinite(pixels) ? figure(pixels) : "not seen";
}

std::string countText(const std::optional<Count> &count)
{
    if (!count) {
        return "–";
    }
    const std::optional<std::uint64_t> number = count->toInteger();
    return number ? grouped(*number) : std::format("10^{:.1f}", count->log10());
}

std::string percent(const Share &share)
{
    if (share.of == 0) {
        return "–";
    }
    const auto [least, greatest] = share.interval();
    return std::format("{} ({}–{})", brief(100.0 * share.value()), brief(100.0 * least), brief(100.0 * greatest));
}

std::string wordsOf(const ColliderTrial &trial)
{
    return std::format("{}, a box of diagonal {:.4g}, a ball of radius {:.4g}", facesText(trial.faces), trial.diagonal,
                       trial.ballRadius);
}

std::string wordsOf(const ColliderTrial::Set &set)
{
    std::string words = std::format("{} queries {}, {} of them collisions", grouped(set.points), meaningOf(set.queries),
                                    grouped(set.touching));
    if (set.undecided > 0) {
        words += std::format("; {} more would take too long to answer exactly", grouped(set.undecided));
    }
    return words;
}

std::string wordsOf(const StepTrial &trial)
{
    return std::format("balls of radius {:.4g} that bounce for ever fall {:.3g} to {:.3g} and go on, {:.3g} s in all",
                       trial.ballRadius, 0.5 * trial.height, trial.height, trial.seconds);
}

std::string wordsOf(const FrameTrial &trial)
{
    return trial.reason.empty()
        ? std::format("pictures of {} x {}, drawn by {}", FrameTrial::width, FrameTrial::height, trial.device)
        : trial.reason;
}

std::string wordsOf(const FrameReference &reference)
{
    return std::format("{}, beside {} samples a pixel at a tolerance of {} px, which are off by {} of 255 themselves",
                       reference.place == FramePlace::View
                           ? "as the scene is looked at first"
                           : "a sixteenth of the way off what is seen in the middle of that",
                       reference.samples, briefly(reference.tolerance), figure(reference.leftover.rms));
}

std::string wordsOf(const DepthTrial &trial)
{
    return trial.reason.empty()
        ? std::format("how far from its place a copy stands on a screen of {} x {}, in pixels, beside 700 digits",
                      DepthTrial::width, DepthTrial::height)
        : trial.reason;
}

std::string wordsOf(const DigitTrial &trial)
{
    const std::string copies = trial.isWhole
        ? std::format("all {} faces written as OBJ and read back", grouped(trial.faces))
        : std::format("{} faces of copies drawn at random, of {}, written as OBJ and read back", grouped(trial.faces),
                      facesText(trial.facesInAll));
    return std::format("{}; vertices are off in parts of the diagonal", copies);
}

}
