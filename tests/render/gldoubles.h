// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <type_traits>
#include <utility>

#include <epoxy/gl.h>

/// Failures of OpenGL, for as long as these live: libepoxy calls all functions by pointers, which are put to others here.
/// What does not draw through libepoxy, Qt for one, is left alone. One of a kind at a time.
namespace romanesco::test {

/// Another function in the place of one of libepoxy's.
template<auto &place>
class Double
{
public:
    using Function = std::remove_reference_t<decltype(place)>;

    explicit Double(Function function)
    {
        s_function = function;
        s_real = std::exchange(place, function);
    }
    ~Double() { place = s_real; }
    Double(const Double &) = delete;
    Double &operator=(const Double &) = delete;

    /// Calls the one that it stands for: in its place, since a pointer's first call sets the pointer.
    template<typename... Arguments>
    static auto real(Arguments... arguments)
    {
        const struct Again {
            ~Again() { s_real = std::exchange(place, s_function); }
        } again;
        place = s_real;
        return place(arguments...);
    }

private:
    static inline Function s_function = nullptr;
    static inline Function s_real = nullptr;
};

/// The compiler is given what is no shader, after so many that are.
class BrokenShaders
{
public:
    explicit BrokenShaders(int good = 0) { s_good = good; }

private:
    using Source = Double<epoxy_glShaderSource>;

    static void source(GLuint shader, GLsizei count, const GLchar *const *texts, const GLint *lengths)
    {
        static const GLchar *none = "this is no shader\n";
        if (s_good-- > 0) {
            Source::real(shader, count, texts, lengths);
        } else {
            Source::real(shader, GLsizei(1), &none, static_cast<const GLint *>(nullptr));
        }
    }

    static inline int s_good = 0;
    Source m_source{source};
};

/// No memory for buffers, for textures, or for drawing, after so many for which there was; then for so many none.
class NoMemory
{
public:
    enum class For { Buffers, Textures, Drawing };

    explicit NoMemory(For what, int good = 0, int refused = 1'000'000)
    {
        s_what = what;
        s_good = good;
        s_refused = refused;
        s_isTold = true;
    }

private:
    using Buffer = Double<epoxy_glNamedBufferStorage>;
    using Texture = Double<epoxy_glTextureStorage2D>;
    using Draw = Double<epoxy_glDrawElementsInstancedBaseInstance>;
    using Error = Double<epoxy_glGetError>;

    static bool isRefused(For what)
    {
        const bool isRefused = what == s_what && s_good-- <= 0 && s_refused-- > 0;
        s_isTold = s_isTold && !isRefused;
        return isRefused;
    }
    static void bufferStorage(GLuint buffer, GLsizeiptr size, const void *data, GLbitfield flags)
    {
        if (!isRefused(For::Buffers)) {
            Buffer::real(buffer, size, data, flags);
        }
    }
    static void textureStorage(GLuint texture, GLsizei levels, GLenum format, GLsizei columns, GLsizei rows)
    {
        if (!isRefused(For::Textures)) {
            Texture::real(texture, levels, format, columns, rows);
        }
    }
    static void draw(GLenum mode, GLsizei count, GLenum type, const void *indices, GLsizei instances, GLuint first)
    {
        if (!isRefused(For::Drawing)) {
            Draw::real(mode, count, type, indices, instances, first);
        }
    }
    static GLenum error() { return std::exchange(s_isTold, true) ? Error::real() : GL_OUT_OF_MEMORY; }

    static inline int s_refused = 0;
    static inline For s_what = For::Buffers;
    static inline int s_good = 0;
    static inline bool s_isTold = true;
    Buffer m_buffer{bufferStorage};
    Texture m_texture{textureStorage};
    Draw m_draw{draw};
    Error m_error{error};
};

/// The driver says so many times that it was reset, after so many that it was not.
class DriverReset
{
public:
    explicit DriverReset(int times, int good = 0)
    {
        s_times = times;
        s_good = good;
    }

private:
    static GLenum status() { return s_good-- <= 0 && s_times-- > 0 ? GL_UNKNOWN_CONTEXT_RESET : GL_NO_ERROR; }

    static inline int s_good = 0;
    static inline int s_times = 0;
    Double<epoxy_glGetGraphicsResetStatus> m_status{status};
};

}
