// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "keptballs.h"

#include <algorithm>
#include <format>
#include <string>
#include <variant>
#include <vector>

#include "placement.h"

namespace romanesco {

namespace {

/// The shortest digits that read back as the same.
std::string textOf(const glm::dvec3 &v)
{
    return std::format("({}, {}, {})", v.x, v.y, v.z);
}

/// What follows the transformation.
std::string motionOf(const KeptBall &ball)
{
    const std::string restitution = std::format(" {}", ball.restitution);
    return ball.velocity == glm::dvec3(0.0) ? restitution : restitution + ' ' + textOf(ball.velocity);
}

/// The lines that place balls.
std::vector<std::size_t> ballLines(const SdoSyntax &scene)
{
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < scene.lineCount(); ++i) {
        if (std::holds_alternative<BallLine>(scene.line(i).declaration)) {
            lines.push_back(i);
        }
    }
    return lines;
}

bool isAsWritten(const BallLine &line, const KeptBall &ball)
{
    const glm::dvec3 velocity = line.velocity ? line.velocity->value : glm::dvec3(0.0);
    return line.file.transform.position.value == ball.position && ball.scale == 1.0
        && line.restitution.value == ball.restitution && velocity == ball.velocity;
}

/// Its words, but for what has changed.
std::string lineOf(std::string_view written, const BallLine &line, const KeptBall &ball)
{
    const auto wordsOf = [&](const LineRange &range) {
        return range.end > range.begin ? std::string(written.substr(range.begin, range.end - range.begin)) : "#";
    };
    const TransformExpression &transform = line.file.transform;
    const std::string scale =
        ball.scale == 1.0 ? wordsOf(transform.scale.range) : textOf(transform.scale.value * ball.scale);
    return std::format("p {} ({}, {}, {}){}", wordsOf(line.file.path), textOf(ball.position),
                       wordsOf(transform.rotation.range), scale, motionOf(ball));
}

}

std::size_t ballCount(const SdoSyntax &scene)
{
    return ballLines(scene).size();
}

TextEdits withBalls(const SdoSyntax &scene, std::span<const KeptBall> balls, std::string_view path)
{
    TextEdits edits;
    const std::vector<std::size_t> lines = ballLines(scene);
    auto ball = balls.begin();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const SdoLine &line = scene.line(lines[i]);
        const SourceRange whole = scene.map().line(lines[i]);
        const auto &written = std::get<BallLine>(line.declaration);
        if (ball == balls.end() || ball->own != i) {
            // with its line end, but what is said beside it stays
            const bool isAlone = line.range.end == whole.end - whole.begin;
            const std::size_t next =
                lines[i] + 1 < scene.lineCount() ? scene.map().line(lines[i] + 1).begin : whole.end;
            edits.push_back({{whole.begin, isAlone ? next : whole.begin + line.range.end}, {}});
            continue;
        }
        if (!isAsWritten(written, *ball)) {
            const std::string_view text = std::string_view(scene.text()).substr(whole.begin, whole.end - whole.begin);
            edits.push_back(
                {{whole.begin + line.range.begin, whole.begin + line.range.end}, lineOf(text, written, *ball)});
        }
        ++ball;
    }
    std::string added;
    for (; ball != balls.end(); ++ball) {
        added += std::format("\np \"{}\" ({}, #, {}){}", path, textOf(ball->position), textOf(glm::dvec3(ball->scale)),
                             motionOf(*ball));
    }
    if (added.empty()) {
        return edits;
    }
    TextEdit addition = withPlacedLines(scene, added);
    if (!edits.empty() && edits.back().range.end > addition.range.begin) {
        // in place of the last line, which goes
        edits.back().text = added.substr(1) + '\n';
    } else {
        edits.push_back(std::move(addition));
    }
    return edits;
}

}
