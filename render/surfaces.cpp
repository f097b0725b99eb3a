// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "surfaces.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "shaders.h"

namespace romanesco {

namespace {

/// Bindings and locations of the shaders.
constexpr GLuint textureUnit = 0;
enum Uniform { Diffuse, Specular, Shininess, Emission, Opacity };

/// In the order of their macros.
enum Feature : std::size_t { Smooth, Textured, Coloured, Tinted, Wires, Lamps, SeeThrough, Deep };
constexpr std::array featureMacros{"SMOOTH", "TEXTURED", "COLOURED", "TINTED", "WIRES", "LAMPS", "SEE_THROUGH", "DEEP"};

/// Whether some of what is behind a surface may show.
bool isSeeThrough(const Scene &scene)
{
    const auto shows = [](const Material &material) { return material.opacity < 1.0f || material.diffuseImage; };
    return std::ranges::any_of(
        scene.items, [&](const SceneItem &item) { return std::ranges::any_of(item.model->mesh->materials, shows); });
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
    m_uniforms.make();
    return use({});
}

std::expected<void, std::string> Surfaces::use(const Features &features)
{
    GlProgram &program = m_programs[features.to_ulong()];
    if (program == 0) {
        std::vector<const char *> macros;
        for (std::size_t i = 0; i < featureMacros.size(); ++i) {
            if (features[i]) {
                macros.push_back(featureMacros[i]);
            }
        }
        const ShaderStage vertex{GL_VERTEX_SHADER, shaders::instance_vert, macros};
        const ShaderStage geometry{GL_GEOMETRY_SHADER, shaders::instance_geom, macros};
        const ShaderStage fragment{GL_FRAGMENT_SHADER, shaders::instance_frag, macros};
        auto made = features[Wires] ? makeProgram({vertex, geometry, fragment}) : makeProgram({vertex, fragment});
        if (!made) {
            return std::unexpected(made.error());
        }
        program = std::move(*made);
    }
    glUseProgram(program);
    return {};
}

void Surfaces::beginPass(const Pass &pass, const Surroundings &surroundings, const Appearance &appearance)
{
    m_appearance = appearance;
    m_passFeatures.set(Wires, appearance.hasWires);
    m_passFeatures.set(Lamps, !surroundings.scene->lights.empty());
    m_passFeatures.set(SeeThrough, isSeeThrough(*surroundings.scene));
    m_passFeatures.set(Deep, pass.projector.isDeep());
    m_uniforms.set(pass.projector, surroundings, appearance.isLit, pass.number);
}

std::expected<void, std::string> Surfaces::draw(const GpuScene &onCard, const Model &model, GLuint first,
                                                std::size_t count, bool hasTints)
{
    const GpuMesh &mesh = onCard.mesh(model);
    m_uniforms.bind();
    glBindVertexArray(mesh.array);
    hasTints ? glEnableVertexArrayAttrib(mesh.array, attribute::tint)
             : glDisableVertexArrayAttrib(mesh.array, attribute::tint);
    // where a mesh with a texture has no coordinates
    glVertexAttrib2f(attribute::textureCoordinates, 0.0f, 0.0f);
    Features features = m_passFeatures;
    features.set(Tinted, hasTints);
    features.set(Coloured, mesh.colours != 0);
    features.set(Smooth, m_appearance.isSmooth && mesh.normals != 0);
    for (const MeshArrays::Part &part : mesh.parts) {
        const Material material =
            part.material == Mesh::none ? plainMaterial(*model.mesh) : model.mesh->materials[part.material];
        const GLuint texture = m_appearance.hasTextures ? onCard.texture(material) : 0;
        features.set(Textured, texture != 0);
        if (const auto used = use(features); !used) {
            return used;
        }
        glBindTextureUnit(textureUnit, texture);
        setMaterial(material);
        const auto offset = static_cast<std::uintptr_t>(part.firstFace * sizeof(Mesh::Face));
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(3 * part.faceCount), GL_UNSIGNED_INT,
                                            reinterpret_cast<const void *>(offset), static_cast<GLsizei>(count), first);
    }
    return {};
}

void Surfaces::setMaterial(const Material &material)
{
    glUniform3fv(Diffuse, 1, &material.diffuse.x);
    glUniform3fv(Specular, 1, &material.specular.x);
    glUniform1f(Shininess, std::max(material.shininess, 1.0f));
    glUniform3fv(Emission, 1, &material.emission.x);
    glUniform1f(Opacity, material.opacity);
}

}
