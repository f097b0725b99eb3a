// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "flattened.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "ourframes.h"

namespace romanesco::bench {

namespace {

constexpr std::size_t mostCopies = 100'000'000;

constexpr const char *vertexShader = R"glsl(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in mat4 copy;
layout(location = 0) uniform mat4 cameraFromWorld;
layout(location = 1) uniform vec2 scale;
layout(location = 2) uniform float near;
layout(location = 0) out vec3 seen;
void main()
{
    seen = vec3(cameraFromWorld * (copy * vec4(position, 1.0)));
    gl_Position = vec4(scale * seen.xy, near, seen.z);
}
)glsl";

constexpr const char *fragmentShader = R"glsl(#version 450 core
layout(location = 0) in vec3 seen;
layout(location = 0) out vec4 result;
const vec3 own = vec3(0.62, 0.53, 0.38);
const vec3 toSun = normalize(vec3(-0.7, 0.75, -0.45));
void main()
{
    vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
    vec3 toViewer = -normalize(seen);
    normal = dot(normal, toViewer) < 0.0 ? -normal : normal;
    vec3 around = mix(vec3(0.07, 0.055, 0.045), vec3(0.22, 0.26, 0.33), 0.5 + 0.5 * normal.y);
    float facing = max(dot(normal, toSun), 0.0);
    float highlight = pow(max(dot(normal, normalize(toSun + toViewer)), 0.0), 40.0);
    result = vec4(own * around + vec3(1.15, 1.08, 0.95) * (own * facing + 0.06 * highlight), 1.0);
}
)glsl";

/// The sets of all levels, outermost first, with a matrix for `#`.
std::vector<std::vector<glm::mat4>> setsOf(const FractalDescription &description)
{
    std::vector<std::vector<glm::mat4>> sets;
    for (Position p = 0; p < description.levels.levelCount(); ++p) {
        const TransformSet &set = description.sets[description.levels.set(description.levels.locate(p).slot)];
        std::vector<glm::mat4> &matrices = sets.emplace_back();
        if (set.holdsIdentity) {
            matrices.emplace_back(1.0f);
        }
        for (const AffineMap &map : set.maps) {
            glm::mat4 &matrix = matrices.emplace_back(glm::mat3(map.linear));
            matrix[3] = glm::vec4(glm::vec3(map.translation), 1.0f);
        }
    }
    return sets;
}

std::vector<glm::mat4> concatPair(const std::vector<glm::mat4> &set1, const std::vector<glm::mat4> &set2)
{
    std::vector<glm::mat4> all;
    all.reserve(set1.size() * set2.size());
    for (const glm::mat4 &m1 : set1) {
        for (const glm::mat4 &m2 : set2) {
            all.push_back(m1 * m2);
        }
    }
    return all;
}

glm::mat4 cameraFromWorld(const Camera &camera)
{
    const glm::dmat3 turned = glm::transpose(camera.worldFromCamera);
    glm::mat4 matrix{glm::mat3(turned)};
    matrix[3] = glm::vec4(glm::vec3(-(turned * camera.position)), 1.0f);
    return matrix;
}

}

std::optional<std::size_t> copiesAsWritten(const FractalDescription &description)
{
    std::size_t count = 1;
    for (Position p = 0; p < description.levels.levelCount(); ++p) {
        const SetId set = description.levels.set(description.levels.locate(p).slot);
        count *= description.sets[set].size();
        if (count > mostCopies) {
            return std::nullopt;
        }
    }
    return count;
}

std::vector<glm::mat4> concatenated(const FractalDescription &description)
{
    std::vector<glm::mat4> all{glm::mat4(1.0f)};
    for (const std::vector<glm::mat4> &set : setsOf(description)) {
        all = concatPair(all, set);
    }
    return all;
}

GlProgram flattenedProgram()
{
    return orEnd(makeProgram({{GL_VERTEX_SHADER, vertexShader}, {GL_FRAGMENT_SHADER, fragmentShader}}));
}

Flattened::Flattened(const GlProgram &program, const Mesh &mesh, const std::vector<glm::mat4> &copies)
    : m_program(program)
    , m_array(makeVertexArray())
    , m_faceCount(mesh.faces.size())
    , m_copyCount(copies.size())
{
    m_vertices = filled(std::vector<glm::vec3>(mesh.vertices.begin(), mesh.vertices.end()));
    m_faces = filled(mesh.faces);
    m_copies = filled(copies);

    glVertexArrayElementBuffer(m_array, m_faces);
    glVertexArrayVertexBuffer(m_array, 0, m_vertices, 0, sizeof(glm::vec3));
    glVertexArrayVertexBuffer(m_array, 1, m_copies, 0, sizeof(glm::mat4));
    glVertexArrayBindingDivisor(m_array, 1, 1);
    glEnableVertexArrayAttrib(m_array, 0);
    glVertexArrayAttribFormat(m_array, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(m_array, 0, 0);
    for (GLuint column = 0; column < 4; ++column) {
        glEnableVertexArrayAttrib(m_array, 1 + column);
        glVertexArrayAttribFormat(m_array, 1 + column, 4, GL_FLOAT, GL_FALSE, column * sizeof(glm::vec4));
        glVertexArrayAttribBinding(m_array, 1 + column, 1);
    }
}

template<typename Row>
GlBuffer Flattened::filled(const std::vector<Row> &rows)
{
    GlBuffer buffer = makeBuffer();
    const std::size_t size = rows.size() * sizeof(Row);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(size), rows.data(), 0);
    m_bytes += size;
    return buffer;
}

void Flattened::draw(const View &view)
{
    if (m_target.width != view.width || m_target.height != view.height) {
        m_target = orEnd(makeTarget(view.width, view.height, GL_SRGB8_ALPHA8, true));
    }
    const GLfloat farthest = 0.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, m_target.framebuffer);
    glViewport(0, 0, view.width, view.height);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_FRAMEBUFFER_SRGB); // a background is given in sRGB
    const auto &[red, green, blue] = view.backgroundTop;
    glClearColor(red, green, blue, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearNamedFramebufferfv(m_target.framebuffer, GL_DEPTH, 0, &farthest);
    glEnable(GL_FRAMEBUFFER_SRGB);
    // 1 near, 0 at any distance: a range costs nothing in this way
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);

    const double scale = 1.0 / std::tan(0.5 * view.camera.fieldOfView * std::numbers::pi / 180.0);
    glUseProgram(m_program);
    glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(cameraFromWorld(view.camera)));
    glUniform2f(1, static_cast<GLfloat>(scale * view.height / view.width), static_cast<GLfloat>(scale));
    glUniform1f(2, 1e-4f);
    glBindVertexArray(m_array);
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(3 * m_faceCount), GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(m_copyCount));
    glDisable(GL_FRAMEBUFFER_SRGB);
    glFinish();
}

Picture Flattened::read() const
{
    return pixelsOf(m_target);
}

Picture pixelsOf(const Target &target)
{
    Picture picture{target.width, target.height, {}};
    const std::size_t rowBytes = static_cast<std::size_t>(target.width) * 3;
    const auto height = static_cast<std::size_t>(target.height);
    picture.pixels.resize(rowBytes * height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (std::size_t y = 0; y < height; ++y) {
        // the card counts rows from the bottom
        glReadPixels(0, static_cast<GLint>(height - 1 - y), target.width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                     picture.pixels.data() + y * rowBytes);
    }
    return picture;
}

}
