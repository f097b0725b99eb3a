// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "shownpicture.h"

#include <tuple>
#include <utility>
#include <vector>

#include "shaders.h"

namespace romanesco {

std::expected<void, std::string> ShownPicture::make()
{
    using Macros = std::vector<const char *>;
    const std::tuple<GlProgram *, const char *, Macros> programs[] = {
        {&m_accumulateProgram, shaders::accumulate_frag, {}},
        {&m_presentProgram, shaders::present_frag, {}},
        {&m_presentSingleProgram, shaders::present_frag, {"SINGLE"}},
    };
    for (const auto &[program, fragment, macros] : programs) {
        auto made = makeProgram({{GL_VERTEX_SHADER, shaders::fullscreen_vert}, {GL_FRAGMENT_SHADER, fragment, macros}});
        if (!made) {
            return std::unexpected(made.error());
        }
        *program = std::move(*made);
    }
    m_emptyArray = makeVertexArray();
    return {};
}

void ShownPicture::take(Target &pass)
{
    std::swap(pass, m_single);
    m_isSingle = true;
    m_count = 1;
}

std::expected<void, std::string> ShownPicture::add(const Target &pass, bool isFirst)
{
    if (isFirst && (m_sum.width != pass.width || m_sum.height != pass.height)) {
        auto target = makeTarget(pass.width, pass.height, GL_RGBA32F, false);
        if (!target) {
            return std::unexpected(target.error());
        }
        m_sum = std::move(*target);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_sum.framebuffer);
    glViewport(0, 0, m_sum.width, m_sum.height);
    glDisable(GL_DEPTH_TEST);
    if (isFirst) {
        glDisable(GL_BLEND);
    } else {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    glUseProgram(m_accumulateProgram);
    glBindTextureUnit(0, pass.colour);
    glBindVertexArray(m_emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    m_isSingle = false;
    m_count = isFirst ? 1 : m_count + 1;
    return {};
}

void ShownPicture::present(GLuint framebuffer, int width, int height, const Colour &top, const Colour &bottom) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    if (isEmpty()) {
        glClearColor(bottom[0], bottom[1], bottom[2], 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    if (m_isSingle) {
        glUseProgram(m_presentSingleProgram);
    } else {
        glUseProgram(m_presentProgram);
        glUniform1f(0, static_cast<float>(m_count));
    }
    glUniform3fv(1, 1, top.data());
    glUniform3fv(2, 1, bottom.data());
    const GLuint texture = m_isSingle ? m_single.bytes : m_sum.colour;
    // Between pixels only where there are others.
    const bool isScaled = width != shown().width || height != shown().height;
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, isScaled ? GL_LINEAR : GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, isScaled ? GL_LINEAR : GL_NEAREST);
    glBindTextureUnit(0, texture);
    glBindVertexArray(m_emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}
