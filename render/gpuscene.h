// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <map>
#include <memory>

#include "core/scene/scene.h"
#include "gpumesh.h"

namespace romanesco {

/// What a scene needs of the card: its base meshes and their textures.
class GpuScene
{
public:
    /// What stays is not uploaded again, what is not needed any more goes. A null scene needs nothing.
    void set(const Scene *scene, const CopyRing &ring);

    [[nodiscard]] const GpuMesh &mesh(const Model &model) const { return m_meshes.at(model.mesh); }
    /// Zero where there is none, or the card had no room for it.
    [[nodiscard]] GLuint texture(const Material &material) const;

    /// On the card.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    void setMeshes(const Scene *scene, const CopyRing &ring);
    void setTextures();

    std::map<std::shared_ptr<const Mesh>, GpuMesh> m_meshes;
    std::map<std::shared_ptr<const Image>, GlTexture> m_textures;
    std::size_t m_bytes = 0;
};

}
