// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <optional>
#include <string>

#include "appearance.h"
#include "cut.h"
#include "glresources.h"
#include "gpuscene.h"

namespace romanesco {

/// The programs that draw copies of meshes.
class Surfaces
{
public:
    /// The error is the compiler's words. Comes before all else.
    [[nodiscard]] std::expected<void, std::string> make();

    /// One pass over a scene: what all its draws have in common.
    struct Pass {
        const Projector &projector;
        unsigned number = 0;
    };
    /// The error is the compiler's words: programs are made when they are first wanted.
    [[nodiscard]] std::expected<void, std::string> beginPass(const Pass &pass, const Surroundings &surroundings,
                                                             const Appearance &appearance);

    /// So many copies in the ring from first on, with all materials of their mesh; into the bound framebuffer.
    void draw(const GpuScene &onCard, const Model &model, GLuint first, std::size_t count, bool hasTints) const;

private:
    void setLights(const Projector &projector, const Surroundings &surroundings);
    void setMaterial(const GpuScene &onCard, const Mesh &mesh, std::uint32_t material) const;

    [[nodiscard]] std::expected<void, std::string> use(bool hasWires, bool isDeep, bool isSeeThrough);

    /// With wires or not, for long ranges of depth or not, for scenes that can be seen through or not, which are drawn faster;
    /// made when they are first wanted.
    std::array<GlProgram, 8> m_programs;
    std::size_t m_program = 0;
    GlBuffer m_pass;
    GlBuffer m_lights;
    Appearance m_appearance;
};

}
