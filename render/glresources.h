// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

namespace romanesco {

/// Owners of OpenGL names; each is destroyed with its context current. Empty owners own nothing.
template<void (*destroy)(GLuint)>
class GlName
{
public:
    GlName() = default;
    explicit GlName(GLuint name)
        : m_name(name)
    {
    }
    ~GlName() { reset(); }
    GlName(GlName &&other) noexcept
        : m_name(std::exchange(other.m_name, 0))
    {
    }
    GlName &operator=(GlName &&other) noexcept
    {
        if (this != &other) {
            reset();
            m_name = std::exchange(other.m_name, 0);
        }
        return *this;
    }
    operator GLuint() const { return m_name; }

private:
    void reset()
    {
        if (m_name != 0) {
            destroy(m_name);
        }
    }

    GLuint m_name = 0;
};

inline void deleteBuffer(GLuint name)
{
    glDeleteBuffers(1, &name);
}
inline void deleteVertexArray(GLuint name)
{
    glDeleteVertexArrays(1, &name);
}
inline void deleteTexture(GLuint name)
{
    glDeleteTextures(1, &name);
}
inline void deleteFramebuffer(GLuint name)
{
    glDeleteFramebuffers(1, &name);
}
inline void deleteProgram(GLuint name)
{
    glDeleteProgram(name);
}

/// Null is nothing, and asks nothing of contexts that know no fences.
inline void deleteFence(GLsync fence)
{
    if (fence) {
        glDeleteSync(fence);
    }
}

using GlBuffer = GlName<deleteBuffer>;
using GlVertexArray = GlName<deleteVertexArray>;
using GlTexture = GlName<deleteTexture>;
using GlFramebuffer = GlName<deleteFramebuffer>;
using GlProgram = GlName<deleteProgram>;

/// Whether the driver had no memory for something since this was asked last. Forgets all other errors.
[[nodiscard]] bool ranOutOfMemory();

[[nodiscard]] GlBuffer makeBuffer();
[[nodiscard]] GlVertexArray makeVertexArray();

struct ShaderStage {
    GLenum kind;
    const char *source;
    /// Those that are set.
    std::vector<const char *> macros{};
};

/// A linked program, or the compiler's or linker's words.
[[nodiscard]] std::expected<GlProgram, std::string> makeProgram(std::initializer_list<ShaderStage> stages);

/// A colour texture, with a 32-bit float depth buffer where asked for, to draw into.
struct Target {
    int width = 0;
    int height = 0;
    GLenum colourFormat = 0;
    GlTexture colour;
    /// Of GL_SRGB8_ALPHA8, the same bytes as they are, not as light.
    GlTexture bytes;
    GlTexture depth;
    GlFramebuffer framebuffer;
};

/// Depths like a target's.
[[nodiscard]] GlTexture makeDepths(int width, int height);

/// The error is a sentence; the driver may be out of memory.
[[nodiscard]] std::expected<Target, std::string> makeTarget(int width, int height, GLenum colourFormat, bool hasDepth);

}
