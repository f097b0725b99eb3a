// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "gpuscene.h"

#include <utility>

namespace romanesco {

void GpuScene::set(const Scene *scene, const CopyRing &ring)
{
    m_bytes = 0;
    setMeshes(scene, ring);
    setTextures();
}

void GpuScene::setMeshes(const Scene *scene, const CopyRing &ring)
{
    std::map<std::shared_ptr<const Mesh>, GpuMesh> known = std::exchange(m_meshes, {});
    for (std::size_t i = 0; scene && i < scene->items.size(); ++i) {
        const Model &model = *scene->items[i].model;
        const auto [place, isNew] = m_meshes.try_emplace(model.mesh);
        if (isNew) {
            auto old = known.extract(model.mesh);
            place->second = old ? std::move(old.mapped()) : upload(*model.mesh, model.graph.base(), ring);
            m_bytes += place->second.bytes;
        }
    }
}

void GpuScene::setTextures()
{
    std::map<std::shared_ptr<const Image>, GlTexture> known = std::exchange(m_textures, {});
    for (const auto &[mesh, onCard] : m_meshes) {
        for (const Material &material : mesh->materials) {
            const std::shared_ptr<const Image> &image = material.diffuseImage;
            if (!image || m_textures.contains(image)) {
                continue;
            }
            auto old = known.extract(image);
            m_textures.emplace(image, old ? std::move(old.mapped()) : upload(*image));
            m_bytes += image->pixels.size() * 4 / 3; // with its smaller versions
        }
    }
}

GLuint GpuScene::texture(const Material &material) const
{
    const auto found = m_textures.find(material.diffuseImage);
    return found == m_textures.end() ? 0 : static_cast<GLuint>(found->second);
}

}
