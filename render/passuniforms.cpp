// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "passuniforms.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// As the shaders have it (std140).
struct PassBlock {
    std::array<GLfloat, 2> scale;
    std::array<GLfloat, 2> jitter;
    std::array<GLfloat, 2> halfSize;
    GLfloat near;
    GLfloat range;
    GLint isPerspective;
    GLint isLit;
    GLuint number;
    GLint lightCount;
};
static_assert(sizeof(PassBlock) == 48);

struct LightBlock {
    std::array<GLfloat, 4> place;
    std::array<GLfloat, 4> colour;
};

/// What is farther away shines from its direction. The square is a float, too.
constexpr double farthestLight = 1e15;

/// Of the shaders.
constexpr GLuint passBinding = 0;
constexpr GLuint lightsBinding = 0;

GLfloat asFloat(double value)
{
    return static_cast<GLfloat>(value);
}

}

void PassUniforms::make()
{
    m_pass = makeBuffer();
    glNamedBufferStorage(m_pass, sizeof(PassBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    m_lights = makeBuffer();
}

void PassUniforms::set(const Projector &projector, const Surroundings &surroundings, bool isLit, unsigned number)
{
    const PassBlock block{
        .scale = {asFloat(projector.scaleX), asFloat(projector.scaleY)},
        .jitter = {asFloat(projector.jitter.x), asFloat(projector.jitter.y)},
        .halfSize = {asFloat(0.5 * projector.width), asFloat(0.5 * projector.height)},
        .near = asFloat(projector.near),
        .range = asFloat(projector.range),
        .isPerspective = projector.projection == Projection::Perspective,
        .isLit = isLit,
        .number = number,
        .lightCount = static_cast<GLint>(surroundings.scene->lights.size()),
    };
    glNamedBufferSubData(m_pass, 0, sizeof(block), &block);
    setLights(projector, surroundings);
}

void PassUniforms::bind() const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, passBinding, m_pass);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, lightsBinding, m_lights);
}

void PassUniforms::setLights(const Projector &projector, const Surroundings &surroundings)
{
    std::vector<LightBlock> lights;
    for (const SceneDescription::Light &light : surroundings.scene->lights) {
        glm::dvec3 place = projector.cameraFromHere * (surroundings.hereFromWorld(light.position) - projector.position);
        place *= std::min(1.0, farthestLight / glm::length(place));
        const glm::dvec3 &colour = light.colour;
        lights.push_back({{asFloat(place.x), asFloat(place.y), asFloat(place.z), 1.0f},
                          {asFloat(colour.x), asFloat(colour.y), asFloat(colour.z), 1.0f}});
    }
    lights.resize(std::max<std::size_t>(lights.size(), 1)); // a buffer of nothing cannot be bound
    glNamedBufferData(m_lights, static_cast<GLsizeiptr>(lights.size() * sizeof(LightBlock)), lights.data(),
                      GL_DYNAMIC_DRAW);
}

}
