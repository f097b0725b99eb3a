// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <expected>
#include <string>

#include "glresources.h"

namespace romanesco {

/// What there is to see: the average of those passes of a picture that are finished. It stays until the first pass of the
/// next picture is. Every call needs the context current in which make() was called.
class ShownPicture
{
public:
    /// Before all else. The error is a sentence.
    [[nodiscard]] std::expected<void, std::string> make();

    /// The only pass of a picture, which becomes that. What was shown so before is given in its place, to be drawn into.
    void take(Target &pass);
    /// One of several; the first starts the picture. The error is a sentence.
    [[nodiscard]] std::expected<void, std::string> add(const Target &pass, bool isFirst);

    /// Nothing has been finished yet.
    [[nodiscard]] bool isEmpty() const { return m_count == 0; }
    [[nodiscard]] int width() const { return shown().width; }
    [[nodiscard]] int height() const { return shown().height; }

    using Colour = std::array<float, 3>;
    /// Into a framebuffer (0 for a window's own), scaled to width x height, over a gradient from the top to the bottom edge.
    void present(GLuint framebuffer, int width, int height, const Colour &top, const Colour &bottom) const;

private:
    [[nodiscard]] const Target &shown() const { return m_isSingle ? m_single : m_sum; }

    GlProgram m_accumulateProgram;
    GlProgram m_presentProgram;
    GlProgram m_presentSingleProgram;
    GlVertexArray m_emptyArray;
    /// The last picture of one pass.
    Target m_single;
    Target m_sum;
    bool m_isSingle = false;
    /// Passes in the sum.
    int m_count = 0;
};

}
