// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneplace.h"

#include <algorithm>
#include <charconv>
#include <format>

namespace romanesco {

namespace {

/// A repetition of more than an anchor goes down is no place.
constexpr std::size_t mostSteps = 100'000;

/// Takes an expected text off the front of the words.
bool take(std::string_view &words, std::string_view expected)
{
    const bool isThere = words.starts_with(expected);
    words.remove_prefix(isThere ? expected.size() : 0);
    return isThere;
}

template<typename Number>
std::optional<Number> takeNumber(std::string_view &words)
{
    Number number = 0;
    const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
    if (error != std::errc()) {
        return std::nullopt;
    }
    words.remove_prefix(static_cast<std::size_t>(end - words.data()));
    return number;
}

struct Run {
    Step step;
    std::size_t count;
};

/// SET.MAP or SET.MAP*COUNT, and a blank.
std::optional<Run> takeRun(std::string_view &words)
{
    const auto set = takeNumber<std::uint32_t>(words);
    if (!set || !take(words, ".")) {
        return std::nullopt;
    }
    const auto map = takeNumber<std::uint32_t>(words);
    const auto count = take(words, "*") ? takeNumber<std::size_t>(words) : std::optional<std::size_t>(1);
    return map && count && take(words, " ") ? std::optional<Run>({{*set, *map}, *count}) : std::nullopt;
}

}

std::string textOf(const ScenePlace &place)
{
    std::string text = std::format("{}: ", place.item);
    const std::vector<Step> &steps = place.steps;
    for (auto step = steps.begin(); step != steps.end();) {
        const auto end = std::find_if(step, steps.end(), [&](const Step &other) { return other != *step; });
        text += std::format("{}.{}", step->set, step->map);
        text += end - step > 1 ? std::format("*{} ", end - step) : " ";
        step = end;
    }
    return text;
}

std::optional<ScenePlace> scenePlaceFromText(std::string_view text)
{
    const auto item = takeNumber<std::uint32_t>(text);
    if (!item || !take(text, ": ")) {
        return std::nullopt;
    }
    std::vector<Run> runs; // written out once all of it is right
    std::size_t count = 0;
    while (!text.empty()) {
        const auto run = takeRun(text);
        if (!run || run->count > mostSteps - count) {
            return std::nullopt;
        }
        count += run->count;
        runs.push_back(*run);
    }
    ScenePlace place{*item};
    place.steps.reserve(count);
    for (const Run &run : runs) {
        place.steps.insert(place.steps.end(), run.count, run.step);
    }
    return place;
}

}
