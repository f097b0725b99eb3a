// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <glm/vec3.hpp>

#include "parsedlines.h"

namespace romanesco {

/// The syntax of one .sdo text, a node for each declaration. All ranges count from the start of the line.
/// A bad declaration keeps what could be read of it; the ranges of what could not are empty, at 0.

struct NumberExpression {
    double value = 0.0;
    LineRange range;
};

/// (1, 2, 3), or `#`.
struct VectorExpression {
    /// Of `#` it is the identity of its place: 0; 1 for scales and colours.
    glm::dvec3 value{0.0};
    bool isIdentity = false;
    /// With the parentheses.
    LineRange range;
    /// Empty where it is `#`.
    std::array<LineRange, 3> numbers;
};

/// ((0, 2, 0), #, #): position, rotation in degrees, scale. Or `#`, which stands for all three.
struct TransformExpression {
    VectorExpression position;
    VectorExpression rotation;
    VectorExpression scale{.value = glm::dvec3(1.0), .range = {}, .numbers = {}};
    bool isIdentity = false;
    /// With the parentheses.
    LineRange range;
};

/// A file and where its content stands.
struct PlacedFile {
    /// With its quotes.
    LineRange path;
    TransformExpression transform;
};

/// c (-48.7, 25.5, 64.4) (-0.07, -2.49, 0) 60 perspective
struct CameraLine {
    VectorExpression position;
    /// In radians, the only angles that are.
    VectorExpression rotation;
    /// The vertical field of view in degrees; of an orthographic camera the height of the view in scene units.
    NumberExpression view;
    bool isOrthographic = false;
    /// The word at the end; empty where there is none.
    LineRange projection;
};

/// o "car.obj" ((0, 2, 0), #, #)
struct ObjectLine {
    PlacedFile file;
};

/// f "cliff.fdo" #
struct FractalLine {
    PlacedFile file;
};

/// p "ball.obj" ((0, 9, 0), #, #) 0.6 (1, 0, 0)
struct BallLine {
    PlacedFile file;
    /// From 0 to 1.
    NumberExpression restitution;
    /// At the start.
    std::optional<VectorExpression> velocity;
};

/// l (20, 40, -10) (1, 0.95, 0.9)
struct LightLine {
    VectorExpression position;
    /// Linear RGB.
    VectorExpression colour{.value = glm::dvec3(1.0), .range = {}, .numbers = {}};
};

/// One line: a declaration, or nothing but a comment or blanks.
struct SdoLine {
    /// Nothing also where the first letter is none of the five.
    std::variant<std::monostate, CameraLine, ObjectLine, FractalLine, BallLine, LightLine> declaration;
    /// From the letter to the last of what was read, the comment left out.
    LineRange range;
    /// Has its one error already.
    bool isBad = false;
    Diagnostics diagnostics;

    /// The file that the line places; null where it places none.
    [[nodiscard]] const PlacedFile *file() const
    {
        return std::visit(
            [](const auto &node) -> const PlacedFile * {
                if constexpr (requires { node.file; }) {
                    return &node.file;
                } else {
                    return nullptr;
                }
            },
            declaration);
    }
};

/// Reads one line without its end mark; its first bytes, so many, are passed over. Cost linear in the line.
[[nodiscard]] SdoLine parseSdoLine(std::string_view line, std::size_t skipped);

/// A whole text, read line by line: a bad line gets one error, and reading goes on at the next.
class SdoSyntax : public ParsedLines<SdoLine>
{
public:
    SdoSyntax() = default;
    explicit SdoSyntax(std::string text) { setText(std::move(text)); }

    /// Another text; lines that it shares with the last one, before and after what differs, are kept.
    void setText(std::string text) { ParsedLines::setText(std::move(text), parseSdoLine); }
};

}
