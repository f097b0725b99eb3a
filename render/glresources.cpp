// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "glresources.h"

#include <format>

namespace romanesco {

namespace {

std::string compilerWords(GLuint shader)
{
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string words(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, words.data());
    return words;
}

/// After the line of the version, which has to come first.
std::string withMacros(std::string source, const std::vector<const char *> &macros)
{
    for (const char *macro : macros) {
        source.insert(source.find('\n') + 1, std::format("#define {}\n", macro));
    }
    return source;
}

void sampleWithin(GLuint texture)
{
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

GlTexture makeTexture(int width, int height, GLenum format)
{
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, width, height);
    sampleWithin(name);
    return GlTexture(name);
}

GlTexture bytesOf(GLuint texture)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glTextureView(name, GL_TEXTURE_2D, texture, GL_RGBA8, 0, 1, 0, 1);
    sampleWithin(name);
    return GlTexture(name);
}

}

bool ranOutOfMemory()
{
    // Each kind is told once, but by a context that is lost, for ever.
    constexpr int mostErrors = 16;
    bool didRunOut = false;
    GLenum error = glGetError();
    for (int i = 0; i < mostErrors && error != GL_NO_ERROR; ++i, error = glGetError()) {
        didRunOut = didRunOut || error == GL_OUT_OF_MEMORY;
    }
    return didRunOut;
}

GlBuffer makeBuffer()
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return GlBuffer(name);
}

GlVertexArray makeVertexArray()
{
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return GlVertexArray(name);
}

std::expected<GlProgram, std::string> makeProgram(std::initializer_list<ShaderStage> stages)
{
    GlProgram program(glCreateProgram());
    for (const auto &[kind, text, macros] : stages) {
        const std::string whole = withMacros(text, macros);
        const char *source = whole.c_str();
        const GLuint shader = glCreateShader(kind);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        GLint isCompiled = GL_FALSE;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
        if (!isCompiled) {
            const std::string words = compilerWords(shader);
            glDeleteShader(shader);
            return std::unexpected("A shader does not compile: " + words);
        }
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint isLinked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (!isLinked) {
        return std::unexpected(std::string("The shaders do not link."));
    }
    return program;
}

GlTexture makeDepths(int width, int height)
{
    return makeTexture(width, height, GL_DEPTH_COMPONENT32F);
}

std::expected<Target, std::string> makeTarget(int width, int height, GLenum colourFormat, bool hasDepth)
{
    static_cast<void>(ranOutOfMemory()); // of whoever used the context before
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    Target target{width, height, colourFormat, makeTexture(width, height, colourFormat), {}, {}, GlFramebuffer(name)};
    if (colourFormat == GL_SRGB8_ALPHA8) {
        target.bytes = bytesOf(target.colour);
    }
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, target.colour, 0);
    if (hasDepth) {
        target.depth = makeDepths(width, height);
        glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, target.depth, 0);
    }
    const bool isComplete = glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (glGetError() != GL_NO_ERROR || !isComplete) {
        return std::unexpected(std::format("The graphics driver has no room for a picture of {}x{}.", width, height));
    }
    return target;
}

}
