// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/formats/fractaldescription.h"
#include "core/geometry/mesh.h"
#include "render/glresources.h"
#include "render/renderer.h"

namespace romanesco::bench {

/// How many copies a text asks for, `#` counted as a transformation like the others: t^d. Nothing above 10^8.
[[nodiscard]] std::optional<std::size_t> copiesAsWritten(const FractalDescription &description);

/// The dissertation's generator (4.2.4): concat(set1, set2, …), outermost first, where concatPair() applies each matrix of one
/// set to each of the other. Matrices as a card takes them, in single precision. Precondition: there are copiesAsWritten().
[[nodiscard]] std::vector<glm::mat4> concatenated(const FractalDescription &description);

/// The shaders of Flattened. Ends the program where they do not compile.
[[nodiscard]] GlProgram flattenedProgram();

/// Draws as the dissertation does (4.1.3 to 4.3.1): the matrices of all copies lie on the card, and each frame is one
/// instanced draw of the base mesh, with a depth buffer. The shading is that of Renderer for a mesh without materials,
/// normals and lights. Beside it the shader is kept as simple as it can be, which is to its favour, and so the matrix that moves
/// the object (4.3.1) is taken into the camera's. A context has to be current. The program must outlive it.
class Flattened
{
public:
    Flattened(const GlProgram &program, const Mesh &mesh, const std::vector<glm::mat4> &copies);

    /// Only what a view asks for by its camera (of perspective), its size and the colour of its background. Waits for the card.
    void draw(const View &view);
    /// What was drawn.
    [[nodiscard]] Picture read() const;

    [[nodiscard]] std::size_t bufferBytes() const { return m_bytes; }

private:
    template<typename Row>
    GlBuffer filled(const std::vector<Row> &rows);

    GLuint m_program;
    GlVertexArray m_array;
    GlBuffer m_vertices;
    GlBuffer m_faces;
    GlBuffer m_copies;
    std::size_t m_faceCount = 0;
    std::size_t m_copyCount = 0;
    std::size_t m_bytes = 0;
    Target m_target;
};

/// The pixels of a target in sRGB, rows from the top.
[[nodiscard]] Picture pixelsOf(const Target &target);

}
