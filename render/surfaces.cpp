// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "surfaces.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

#include "shaders.h"

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
    GLint isSmooth;
    GLint isLit;
    GLuint number;
    GLint lightCount;
    std::array<GLint, 3> padding;
};
static_assert(sizeof(PassBlock) == 64);

struct LightBlock {
    std::array<GLfloat, 4> place;
    std::array<GLfloat, 4> colour;
};

/// What is farther away shines from its direction. The square is a float, too.
constexpr double farthestLight = 1e15;

/// Bindings and locations of the shaders.
constexpr GLuint passBinding = 0;
constexpr GLuint lightsBinding = 0;
constexpr GLuint textureUnit = 0;
enum Uniform { Diffuse, Specular, Shininess, Emission, Opacity, HasTexture };

/// Whether some of what is behind a surface may show.
bool isSeeThrough(const Scene &scene)
{
    const auto shows = [](const Material &material) { return material.opacity < 1.0f || material.diffuseImage; };
    return std::ranges::any_of(
        scene.items, [&](const SceneItem &item) { return std::ranges::any_of(item.model->mesh->materials, shows); });
}

GLfloat asFloat(double value)
{
    return static_cast<GLfloat>(value);
}

/// Of faces without a material.
Material plainMaterial(const Mesh &mesh)
{
    Material material;
    material.diffuse = mesh.colours.empty() ? glm::vec3(0.62f, 0.53f, 0.38f) : glm::vec3(1.0f);
    material.specular = glm::vec3(0.06f);
    material.shininess = 40.0f;
    return material;
}

}

std::expected<void, std::string> Surfaces::make()
{
    m_pass = makeBuffer();
    glNamedBufferStorage(m_pass, sizeof(PassBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    m_lights = makeBuffer();
    return use(false, false, false);
}

std::expected<void, std::string> Surfaces::use(bool hasWires, bool isDeep, bool isSeeThrough)
{
    m_program = (hasWires ? 1 : 0) + (isDeep ? 2 : 0) + (isSeeThrough ? 4 : 0);
    GlProgram &program = m_programs[m_program];
    if (program != 0) {
        return {};
    }
    const ShaderStage vertex{GL_VERTEX_SHADER, shaders::instance_vert};
    const ShaderStage geometry{GL_GEOMETRY_SHADER, shaders::instance_geom};
    ShaderStage fragment{GL_FRAGMENT_SHADER, shaders::instance_frag};
    if (isDeep) {
        fragment.macros.push_back("DEEP");
    }
    if (isSeeThrough) {
        fragment.macros.push_back("SEE_THROUGH");
    }
    auto made = hasWires ? makeProgram({vertex, geometry, fragment}) : makeProgram({vertex, fragment});
    if (!made) {
        return std::unexpected(made.error());
    }
    program = std::move(*made);
    return {};
}

std::expected<void, std::string> Surfaces::beginPass(const Pass &pass, const Surroundings &surroundings,
                                                     const Appearance &appearance)
{
    m_appearance = appearance;
    if (const auto used = use(appearance.hasWires, pass.projector.isDeep(), isSeeThrough(*surroundings.scene)); !used) {
        return used;
    }
    const Projector &projector = pass.projector;
    const PassBlock block{
        .scale = {asFloat(projector.scaleX), asFloat(projector.scaleY)},
        .jitter = {asFloat(projector.jitter.x), asFloat(projector.jitter.y)},
        .halfSize = {asFloat(0.5 * projector.width), asFloat(0.5 * projector.height)},
        .near = asFloat(projector.near),
        .range = asFloat(projector.range),
        .isPerspective = projector.projection == Projection::Perspective,
        .isSmooth = appearance.isSmooth,
        .isLit = appearance.isLit,
        .number = pass.number,
        .lightCount = static_cast<GLint>(surroundings.scene->lights.size()),
        .padding = {},
    };
    glNamedBufferSubData(m_pass, 0, sizeof(block), &block);
    setLights(projector, surroundings);
    return {};
}

void Surfaces::setLights(const Projector &projector, const Surroundings &surroundings)
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

void Surfaces::draw(const GpuScene &onCard, const Model &model, GLuint first, std::size_t count, bool hasTints) const
{
    const GpuMesh &mesh = onCard.mesh(model);
    glUseProgram(m_programs[m_program]);
    glBindBufferBase(GL_UNIFORM_BUFFER, passBinding, m_pass);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, lightsBinding, m_lights);
    glBindVertexArray(mesh.array);
    hasTints ? glEnableVertexArrayAttrib(mesh.array, attribute::tint)
             : glDisableVertexArrayAttrib(mesh.array, attribute::tint);
    // Where the mesh has no attribute.
    glVertexAttrib4f(attribute::tint, 0.0f, 0.0f, 0.0f, 0.0f);
    glVertexAttrib3f(attribute::normal, 0.0f, 0.0f, 0.0f);
    glVertexAttrib2f(attribute::textureCoordinates, 0.0f, 0.0f);
    glVertexAttrib3f(attribute::colour, 1.0f, 1.0f, 1.0f);
    for (const MeshArrays::Part &part : mesh.parts) {
        setMaterial(onCard, *model.mesh, part.material);
        const auto offset = static_cast<std::uintptr_t>(part.firstFace * sizeof(Mesh::Face));
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(3 * part.faceCount), GL_UNSIGNED_INT,
                                            reinterpret_cast<const void *>(offset), static_cast<GLsizei>(count), first);
    }
}

void Surfaces::setMaterial(const GpuScene &onCard, const Mesh &mesh, std::uint32_t number) const
{
    const Material material = number == Mesh::none ? plainMaterial(mesh) : mesh.materials[number];
    const GLuint texture = m_appearance.hasTextures ? onCard.texture(material) : 0;
    glUniform3fv(Diffuse, 1, &material.diffuse.x);
    glUniform3fv(Specular, 1, &material.specular.x);
    glUniform1f(Shininess, std::max(material.shininess, 1.0f));
    glUniform3fv(Emission, 1, &material.emission.x);
    glUniform1f(Opacity, material.opacity);
    glUniform1i(HasTexture, texture != 0);
    glBindTextureUnit(textureUnit, texture);
}

}
