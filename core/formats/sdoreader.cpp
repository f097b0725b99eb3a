// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sdoreader.h"

#include "lineparser.h"

namespace romanesco {

namespace {

class Reader
{
public:
    explicit Reader(const SdoSyntax &syntax)
        : m_syntax(syntax)
    {
    }

    SdoResult read()
    {
        SdoResult result;
        m_diagnostics = m_syntax.diagnostics();
        for (std::size_t i = 0; i < m_syntax.lineCount(); ++i) {
            m_line = i;
            std::visit([&](const auto &node) { add(node); }, m_syntax.line(i).declaration);
        }
        sortByPlace(m_diagnostics);
        if (!hasErrors(m_diagnostics)) {
            result.description = std::move(m_scene);
        }
        result.diagnostics = std::move(m_diagnostics);
        return result;
    }

private:
    void add(std::monostate) { }

    void add(const CameraLine &camera)
    {
        const SdoLine &line = m_syntax.line(m_line);
        const SourceRange range = m_syntax.range(m_line, line.range);
        if (!m_scene.camera) {
            m_scene.camera = {camera.position.value, camera.rotation.value, camera.isOrthographic, camera.view.value,
                              range};
            m_cameraLine = m_line;
        } else if (!line.isBad) { // else it has its message already
            reportSecondCamera(range);
        }
    }

    void reportSecondCamera(SourceRange range)
    {
        const SourceRange first = m_scene.camera->range;
        m_diagnostics.push_back(
            {DiagnosticCode::SecondCamera,
             range,
             {std::to_string(m_cameraLine + 1)},
             insertion("Make it a comment", range.begin, "# "),
             {{DiagnosticCode::EarlierHere, first, {"the camera"}, {}, m_syntax.map().position(first.begin)}}});
    }

    void add(const ObjectLine &object) { m_scene.items.push_back(item(SceneDescription::Kind::Object, object.file)); }

    void add(const FractalLine &fractal)
    {
        m_scene.items.push_back(item(SceneDescription::Kind::Fractal, fractal.file));
    }

    void add(const BallLine &ball)
    {
        SceneDescription::Item &added = m_scene.items.emplace_back(item(SceneDescription::Kind::Ball, ball.file));
        added.restitution = ball.restitution.value;
        if (ball.velocity) {
            added.velocity = ball.velocity->value;
        }
    }

    void add(const LightLine &light) { m_scene.lights.push_back({light.position.value, light.colour.value}); }

    [[nodiscard]] SceneDescription::Item item(SceneDescription::Kind kind, const PlacedFile &file) const
    {
        const TransformExpression &transform = file.transform;
        SceneDescription::Item result;
        result.kind = kind;
        result.path = unquoted(m_syntax.words(m_line, file.path));
        result.pathRange = m_syntax.range(m_line, file.path);
        result.worldFromModel = mapFromParts(transform.position.value, transform.rotation.value, transform.scale.value);
        return result;
    }

    const SdoSyntax &m_syntax;
    std::size_t m_line = 0;
    std::size_t m_cameraLine = 0;
    Diagnostics m_diagnostics;
    SceneDescription m_scene;
};

}

SdoResult describeSdo(const SdoSyntax &syntax)
{
    return Reader(syntax).read();
}

SdoResult readSdo(std::string_view text)
{
    return describeSdo(SdoSyntax(std::string(text)));
}

}
