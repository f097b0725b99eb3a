// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "balllayer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "core/scene/passages.h"
#include "shaders.h"

namespace romanesco {

namespace {

constexpr GLuint ballAttribute = 0;
constexpr GLuint colourAttribute = 1;
constexpr GLint picturePerPixel = 0;
constexpr GLuint depthsUnit = 0;
/// In units of the view: what is farther or larger is nothing that floats could draw.
constexpr double mostUnits = 1e12;

GLfloat asFloat(double value)
{
    return static_cast<GLfloat>(value);
}

}

void BallLayer::make()
{
    m_uniforms.make();
    m_buffer = makeBuffer();
    m_array = makeVertexArray();
    glVertexArrayVertexBuffer(m_array, 0, m_buffer, 0, sizeof(Instance));
    glVertexArrayBindingDivisor(m_array, 0, 1);
    const std::pair<GLuint, std::pair<GLint, std::size_t>> attributes[] = {
        {ballAttribute, {4, offsetof(Instance, ball)}},
        {colourAttribute, {3, offsetof(Instance, colour)}},
    };
    for (const auto &[attribute, layout] : attributes) {
        glEnableVertexArrayAttrib(m_array, attribute);
        glVertexArrayAttribFormat(m_array, attribute, layout.first, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(layout.second));
        glVertexArrayAttribBinding(m_array, attribute, 0);
    }
}

std::expected<void, std::string> BallLayer::use(bool isDeep, bool hasLamps)
{
    GlProgram &program = m_programs[(isDeep ? 1U : 0U) + (hasLamps ? 2U : 0U)];
    if (program == 0) {
        std::vector<const char *> macros;
        if (isDeep) {
            macros.push_back("DEEP");
        }
        if (hasLamps) {
            macros.push_back("LAMPS");
        }
        auto made =
            makeProgram({{GL_VERTEX_SHADER, shaders::ball_vert, {}}, {GL_FRAGMENT_SHADER, shaders::ball_frag, macros}});
        if (!made) {
            return std::unexpected(made.error());
        }
        program = std::move(*made);
    }
    glUseProgram(program);
    return {};
}

/// Of balls that do not overlap, what is nearer by the power of the camera's place hides what is farther; of a view without
/// a place, what is nearer along its axis.
void BallLayer::place(std::span<const BallSprite> balls, const Picture &picture)
{
    const Projector &projector = picture.projector;
    Passages passages(picture.surroundings);
    const bool isPerspective = projector.projection == Projection::Perspective;
    std::vector<std::pair<double, Instance>> sorted;
    sorted.reserve(balls.size());
    for (const BallSprite &ball : balls) {
        const auto here = passages.here(ball.place.get(), {ball.centre, ball.radius});
        if (!here) {
            continue;
        }
        const glm::dvec3 c = projector.cameraFromHere * (here->centre - projector.position);
        const double r = here->radius / projector.unit;
        if (!(glm::length(c) < mostUnits && r < mostUnits) || (isPerspective && c.z + r < projector.near)) {
            continue;
        }
        sorted.emplace_back(isPerspective ? glm::dot(c, c) - r * r : c.z,
                            Instance{{asFloat(c.x), asFloat(c.y), asFloat(c.z), asFloat(r)}, ball.colour});
    }
    std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<double, Instance>::first);
    m_instances.clear();
    for (const auto &entry : sorted) {
        m_instances.push_back(entry.second);
    }
}

std::expected<void, std::string> BallLayer::draw(std::span<const BallSprite> balls, const Picture &picture, int width,
                                                 int height)
{
    place(balls, picture);
    if (m_instances.empty()) {
        return {};
    }
    if (m_array == 0) {
        make();
    }
    if (const auto used = use(picture.projector.isDeep(), !picture.surroundings.scene->lights.empty()); !used) {
        return used;
    }
    m_uniforms.set(picture.projector, picture.surroundings, picture.isLit, 0);
    m_uniforms.bind();
    glNamedBufferData(m_buffer, static_cast<GLsizeiptr>(m_instances.size() * sizeof(Instance)), m_instances.data(),
                      GL_STREAM_DRAW);
    glUniform2f(picturePerPixel, static_cast<GLfloat>(picture.projector.width) / static_cast<GLfloat>(width),
                static_cast<GLfloat>(picture.projector.height) / static_cast<GLfloat>(height));
    glTextureParameteri(picture.depths, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(picture.depths, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTextureUnit(depthsUnit, picture.depths);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glBindVertexArray(m_array);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(m_instances.size()));
    glDisable(GL_BLEND);
    return {};
}

}
