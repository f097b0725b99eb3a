// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <bitset>
#include <expected>
#include <map>
#include <optional>
#include <string>

#include "appearance.h"
#include "cut.h"
#include "glresources.h"
#include "gpuscene.h"
#include "passuniforms.h"

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
    void beginPass(const Pass &pass, const Surroundings &surroundings, const Appearance &appearance);

    /// So many copies in the ring from first on, with all materials of their mesh; into the bound framebuffer. The error is
    /// the compiler's words: programs are made when they are first wanted.
    [[nodiscard]] std::expected<void, std::string> draw(const GpuScene &onCard, const Model &model, GLuint first,
                                                        std::size_t count, bool hasTints);

private:
    static void setMaterial(const Material &material);

    /// What a program has code for: software computes all that is there for each pixel.
    using Features = std::bitset<8>;
    [[nodiscard]] std::expected<void, std::string> use(const Features &features);

    std::map<unsigned long, GlProgram> m_programs;
    /// Of all draws of the pass.
    Features m_passFeatures;
    PassUniforms m_uniforms;
    Appearance m_appearance;
};

}
