// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "ballsprite.h"
#include "passuniforms.h"

namespace romanesco {

/// Draws balls over a picture that is finished, hidden by what is before them there, so that balls move without the rest being
/// drawn anew. Their outlines are smooth; of balls that do not overlap, each hides what is behind it.
class BallLayer
{
public:
    /// What the balls are drawn over: how it was drawn, and its depths.
    struct Picture {
        const Projector &projector;
        const Surroundings &surroundings;
        bool isLit = true;
        GLuint depths = 0;
    };

    /// Into the bound framebuffer, which is width x height. The error is the compiler's words: the program is made when it is
    /// first wanted.
    [[nodiscard]] std::expected<void, std::string> draw(std::span<const BallSprite> balls, const Picture &picture,
                                                        int width, int height);

private:
    /// As the shader has it.
    struct Instance {
        std::array<GLfloat, 4> ball;
        std::array<GLfloat, 3> colour;
    };

    void make();
    [[nodiscard]] std::expected<void, std::string> use(bool isDeep, bool hasLamps);
    void place(std::span<const BallSprite> balls, const Picture &picture);

    PassUniforms m_uniforms;
    GlVertexArray m_array;
    GlBuffer m_buffer;
    /// By what they have code for.
    std::array<GlProgram, 4> m_programs;
    /// From back to front.
    std::vector<Instance> m_instances;
};

}
