// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "hover.h"

#include <format>
#include <numbers>

#include "core/formats/lineparser.h"
#include "core/geometry/rotation.h"
#include "fdowords.h"
#include "plainwords.h"

namespace romanesco {

namespace {

/// What a line of a scene says, by what the cursor touches in it.
class SdoHoverer
{
public:
    SdoHoverer(const SdoSyntax &syntax, std::size_t line, std::size_t offset)
        : m_syntax(syntax)
        , m_line(line)
        , m_offset(offset)
    {
    }

    std::optional<Hover> operator()(std::monostate) const { return std::nullopt; }

    std::optional<Hover> operator()(const CameraLine &camera) const
    {
        const glm::dvec3 degrees = camera.rotation.value * (180.0 / std::numbers::pi);
        const std::string view = plainWords(camera.view.value);
        return whole(
            camera.isOrthographic ? "orthographic camera" : "camera",
            {"at " + plainWords(camera.position.value), "looks along " + plainWords(rotationFromDegrees(degrees)[2]),
             "turned by " + plainWords(degrees) + " degrees",
             camera.isOrthographic ? "sees a height of " + view : "sees " + view + " degrees from top to bottom"});
    }

    std::optional<Hover> operator()(const LightLine &light) const
    {
        return whole(
            "point light",
            {"at " + plainWords(light.position.value), "colour " + plainWords(light.colour.value) + " (linear)"});
    }

    std::optional<Hover> operator()(const ObjectLine &object) const { return placed(object.file, "object", {}); }
    std::optional<Hover> operator()(const FractalLine &fractal) const { return placed(fractal.file, "fractal", {}); }

    std::optional<Hover> operator()(const BallLine &ball) const
    {
        std::vector<std::string> lines{"coefficient of restitution " + plainWords(ball.restitution.value)};
        if (ball.velocity) {
            lines.push_back("starts with velocity " + plainWords(ball.velocity->value));
        }
        return placed(ball.file, "ball", std::move(lines));
    }

private:
    [[nodiscard]] bool touches(LineRange range) const
    {
        return range.length() > 0 && m_syntax.range(m_line, range).touches(m_offset);
    }

    /// About the whole line, if nothing is wrong with it.
    [[nodiscard]] std::optional<Hover> whole(std::string title, std::vector<std::string> lines) const
    {
        const SdoLine &line = m_syntax.line(m_line);
        if (line.isBad || !touches(line.range)) {
            return std::nullopt;
        }
        return Hover{m_syntax.range(m_line, line.range), std::move(title), std::move(lines)};
    }

    [[nodiscard]] std::optional<Hover> placed(const PlacedFile &file, const char *what,
                                              std::vector<std::string> lines) const
    {
        const std::string path(unquoted(m_syntax.words(m_line, file.path)));
        if (touches(file.path)) {
            return Hover{m_syntax.range(m_line, file.path), path, {what}};
        }
        const TransformExpression &transform = file.transform;
        if (!m_syntax.line(m_line).isBad && touches(transform.range)) {
            return Hover{m_syntax.range(m_line, transform.range), "placed by",
                         transformWords({transform.position.value, transform.rotation.value, transform.scale.value})};
        }
        lines.insert(lines.begin(), "at " + plainWords(transform.position.value));
        return whole(std::format("{} {}", what, path), std::move(lines));
    }

    const SdoSyntax &m_syntax;
    std::size_t m_line;
    std::size_t m_offset;
};

}

std::optional<Hover> hover(const SdoSyntax &syntax, std::size_t offset)
{
    const std::size_t line = syntax.map().lineAt(offset);
    if (line >= syntax.lineCount()) {
        return std::nullopt;
    }
    return std::visit(SdoHoverer(syntax, line, offset), syntax.line(line).declaration);
}

}
