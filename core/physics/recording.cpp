// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "recording.h"

#include <charconv>
#include <cmath>
#include <format>
#include <optional>
#include <span>

#include "core/formats/numbers.h"

namespace romanesco {

namespace {

constexpr std::string_view heading = "romanesco recording 1";
/// Seconds: squares of longer ones times a gravity may be no numbers.
constexpr double greatestTimeStep = 10.0;

std::string textOf(const glm::dvec3 &v)
{
    return std::format("{} {} {}", v.x, v.y, v.z);
}

std::string textOf(const SceneCollider::Options &collider)
{
    return std::format("collider {} {}", colliderNames[static_cast<std::size_t>(collider.kind)], collider.excess);
}

std::string textOf(const Recording::Drop &drop)
{
    const Ball &ball = drop.ball;
    std::string text =
        std::format("drop {} {} {} {}", textOf(ball.position), textOf(ball.velocity), ball.radius, ball.restitution);
    if (drop.place) {
        text += " in " + textOf(*drop.place);
        text.pop_back(); // its last blank
    }
    return text;
}

std::string textOf(const Recording::Removal &removal)
{
    return std::format("remove {}", removal.ball);
}

std::string_view mannerOf(const World::Options &world)
{
    return world.isAsInDissertation ? "dissertation" : "exact";
}

/// Of gravity: after all else.
std::string_view unitOf(const World::Options &world)
{
    return world.laws.isGravityInRadii ? " radii" : "";
}

std::string textOf(const World::Options &world)
{
    return std::format("rules {} {} {} {}{}", world.laws.timeStep, textOf(world.laws.gravity), world.shrinkRate,
                       mannerOf(world), unitOf(world));
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string_view::npos) {
            return words;
        }
        const std::size_t last = std::min(line.find_first_of(" \t\r", first), line.size());
        words.push_back(line.substr(first, last - first));
        line.remove_prefix(last);
    }
}

std::optional<double> numberOf(std::string_view word)
{
    const ParsedNumber number = numberFromText(word);
    const bool isGood = number.status == NumberStatus::Good || number.status == NumberStatus::Underflow;
    return isGood ? std::optional(number.value) : std::nullopt;
}

std::optional<std::uint64_t> hashOf(std::string_view word)
{
    std::uint64_t hash = 0;
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), hash, 16);
    return status == std::errc() && end == word.data() + word.size() ? std::optional(hash) : std::nullopt;
}

std::optional<glm::dvec3> vectorOf(std::span<const std::string_view> words)
{
    glm::dvec3 v;
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = numberOf(words[static_cast<std::size_t>(axis)]);
        if (!number || std::abs(*number) > SceneCollider::farthest) {
            return std::nullopt;
        }
        v[axis] = *number;
    }
    return v;
}

/// The words after "in", between single blanks.
std::optional<ScenePlace> placeOf(std::span<const std::string_view> words)
{
    std::string text;
    for (const std::string_view word : words) {
        text += std::string(word) + ' ';
    }
    return scenePlaceFromText(text);
}

/// The words after "drop".
std::optional<Recording::Drop> dropOf(std::span<const std::string_view> words)
{
    const bool hasPlace = words.size() > 9 && words[8] == "in";
    if (words.size() != 8 && !hasPlace) {
        return std::nullopt;
    }
    const auto place = hasPlace ? placeOf(words.subspan(9)) : std::nullopt;
    const auto position = vectorOf(words);
    const auto velocity = vectorOf(words.subspan(3));
    const auto radius = numberOf(words[6]);
    const auto restitution = numberOf(words[7]);
    const bool isBall = position && velocity && radius && *radius > 0.0 && *radius <= SceneCollider::farthest
        && restitution && *restitution >= 0.0 && *restitution <= 1.0 && place.has_value() == hasPlace;
    return isBall ? std::optional(Recording::Drop{{*position, *velocity, *radius, *restitution}, place}) : std::nullopt;
}

/// The words after "collider".
std::optional<SceneCollider::Options> colliderOf(std::span<const std::string_view> words)
{
    if (words.size() != 2) {
        return std::nullopt;
    }
    const auto kind = colliderKind(words[0]);
    const auto excess = numberOf(words[1]);
    const bool isCollider = kind && excess && *excess >= 0.0;
    return isCollider ? std::optional(SceneCollider::Options{*kind, *excess}) : std::nullopt;
}

bool isTimeStep(double seconds)
{
    return seconds > 0.0 && seconds <= greatestTimeStep;
}

std::optional<bool> isDissertation(std::string_view manner)
{
    const bool is = manner == "dissertation";
    return is || manner == "exact" ? std::optional(is) : std::nullopt;
}

/// The words after "rules".
std::optional<World::Options> rulesOf(std::span<const std::string_view> words)
{
    const bool isInRadii = words.size() == 7 && words[6] == "radii";
    if (words.size() != 6 && !isInRadii) {
        return std::nullopt;
    }
    const auto timeStep = numberOf(words[0]);
    const auto gravity = vectorOf(words.subspan(1));
    const auto shrinkRate = numberOf(words[4]);
    const auto manner = isDissertation(words[5]);
    if (!timeStep || !isTimeStep(*timeStep) || !gravity || !shrinkRate || *shrinkRate < 0.0 || !manner) {
        return std::nullopt;
    }
    World::Options world;
    world.laws.timeStep = *timeStep;
    world.laws.gravity = *gravity;
    world.laws.isGravityInRadii = isInRadii;
    world.shrinkRate = *shrinkRate;
    world.isAsInDissertation = *manner;
    return world;
}

/// The words after "remove".
std::optional<Recording::Removal> removalOf(std::span<const std::string_view> words)
{
    const auto ball = words.size() == 1 ? wholeFromText(words[0]) : std::nullopt;
    return ball ? std::optional(Recording::Removal{*ball}) : std::nullopt;
}

/// Takes line after line.
class Reader
{
public:
    Recording recording;

    /// False where a line makes no sense.
    bool take(std::span<const std::string_view> words)
    {
        const std::string_view what = words.front();
        const auto rest = words.subspan(1);
        if (what == "at") {
            return takeInput(rest);
        }
        if (what == "end") {
            return takeEnd(rest);
        }
        if (what == "collider") {
            const auto collider = colliderOf(rest);
            recording.collider = collider.value_or(recording.collider);
            return collider.has_value();
        }
        if (what == "gravity") {
            const bool isInRadii = rest.size() == 4 && rest[3] == "radii";
            const auto gravity = rest.size() == 3 || isInRadii ? vectorOf(rest) : std::nullopt;
            recording.world.laws.gravity = gravity.value_or(glm::dvec3(0.0));
            recording.world.laws.isGravityInRadii = isInRadii;
            return gravity.has_value();
        }
        return rest.size() == 1 && takeOne(what, rest.front());
    }

    [[nodiscard]] bool hasEnded() const { return m_hasEnded; }

private:
    bool takeOne(std::string_view what, std::string_view word)
    {
        if (what == "start") {
            const auto hash = hashOf(word);
            recording.startHash = hash.value_or(0);
            return hash.has_value();
        }
        if (what == "manner") {
            const auto manner = isDissertation(word);
            recording.world.isAsInDissertation = manner.value_or(false);
            return manner.has_value();
        }
        const auto number = numberOf(word);
        if (what == "time-step") {
            recording.world.laws.timeStep = number.value_or(0.0);
            return isTimeStep(recording.world.laws.timeStep);
        }
        recording.world.shrinkRate = number.value_or(-1.0);
        return what == "shrink" && recording.world.shrinkRate >= 0.0;
    }

    bool takeInput(std::span<const std::string_view> words)
    {
        const auto step = words.size() > 1 ? wholeFromText(words[0]) : std::nullopt;
        if (!step || (!recording.inputs.empty() && *step < recording.inputs.back().step)) {
            return false;
        }
        const auto rest = words.subspan(2);
        const auto add = [&](const auto &what) {
            if (what) {
                recording.inputs.push_back({*step, *what});
            }
            return what.has_value();
        };
        return (words[1] == "drop" && add(dropOf(rest))) || (words[1] == "collider" && add(colliderOf(rest)))
            || (words[1] == "remove" && add(removalOf(rest))) || (words[1] == "rules" && add(rulesOf(rest)));
    }

    bool takeEnd(std::span<const std::string_view> words)
    {
        const auto steps = words.size() == 2 ? wholeFromText(words[0]) : std::nullopt;
        const auto hash = steps ? hashOf(words[1]) : std::nullopt;
        recording.steps = steps.value_or(0);
        recording.endHash = hash.value_or(0);
        m_hasEnded = true;
        return hash.has_value();
    }

    bool m_hasEnded = false;
};

}

std::string textOf(const Recording &recording)
{
    const World::Options &world = recording.world;
    std::string text = std::format("{}\ntime-step {}\ngravity {}{}\nshrink {}\nmanner {}\n{}\nstart {:016x}\n", heading,
                                   world.laws.timeStep, textOf(world.laws.gravity), unitOf(world), world.shrinkRate,
                                   mannerOf(world), textOf(recording.collider), recording.startHash);
    for (const Recording::Input &input : recording.inputs) {
        text += std::visit([&](const auto &what) { return std::format("at {} {}\n", input.step, textOf(what)); },
                           input.what);
    }
    return text + std::format("end {} {:016x}\n", recording.steps, recording.endHash);
}

std::expected<Recording, std::string> recordingFromText(std::string_view text)
{
    Reader reader;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::vector<std::string_view> words = wordsOf(line);
        if (number == 1) {
            if (line != heading) {
                return std::unexpected("line 1: this is no recording");
            }
        } else if (!words.empty() && (reader.hasEnded() || !reader.take(words))) {
            return std::unexpected(std::format("line {}: this is not understood", number));
        }
    }
    if (!reader.hasEnded()) {
        return std::unexpected("the end is missing");
    }
    return std::move(reader.recording);
}

}
