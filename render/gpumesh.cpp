// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "gpumesh.h"

#include <algorithm>
#include <bit>

namespace romanesco {

namespace {

template<typename Row>
GlBuffer filled(const std::vector<Row> &rows, std::size_t &bytes)
{
    const std::size_t size = rows.size() * sizeof(Row);
    GlBuffer buffer = makeBuffer();
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(size), rows.data(), 0);
    bytes += size;
    return buffer;
}

/// An attribute whose buffer is bound at its own number.
template<std::size_t size>
GlBuffer attach(const GpuMesh &mesh, GLuint attribute, const std::vector<std::array<float, size>> &rows,
                std::size_t &bytes)
{
    if (rows.empty()) {
        return {};
    }
    GlBuffer buffer = filled(rows, bytes);
    glEnableVertexArrayAttrib(mesh.array, attribute);
    glVertexArrayAttribFormat(mesh.array, attribute, size, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(mesh.array, attribute, attribute);
    glVertexArrayVertexBuffer(mesh.array, attribute, buffer, 0, size * sizeof(float));
    return buffer;
}

void attachCopies(const GpuMesh &mesh, const CopyRing &ring)
{
    constexpr GLuint binding = attribute::copy;
    for (GLuint row = 0; row < 3; ++row) {
        glEnableVertexArrayAttrib(mesh.array, attribute::copy + row);
        glVertexArrayAttribFormat(mesh.array, attribute::copy + row, 4, GL_FLOAT, GL_FALSE,
                                  row * sizeof(Instance::rows[0]));
        glVertexArrayAttribBinding(mesh.array, attribute::copy + row, binding);
    }
    glVertexArrayBindingDivisor(mesh.array, binding, 1);
    glVertexArrayVertexBuffer(mesh.array, binding, ring.copies(), 0, sizeof(Instance));

    // enabled only where copies have tints
    glVertexArrayAttribFormat(mesh.array, attribute::tint, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
    glVertexArrayAttribBinding(mesh.array, attribute::tint, attribute::tint);
    glVertexArrayBindingDivisor(mesh.array, attribute::tint, 1);
    glVertexArrayVertexBuffer(mesh.array, attribute::tint, ring.tints(), 0, sizeof(Tint));
}

}

GpuMesh upload(const Mesh &mesh, const Sphere &base, const CopyRing &ring)
{
    MeshArrays arrays = arraysOf(mesh, base);
    GpuMesh made;
    made.array = makeVertexArray();
    made.positions = attach(made, attribute::position, arrays.positions, made.bytes);
    made.normals = attach(made, attribute::normal, arrays.normals, made.bytes);
    made.textureCoordinates = attach(made, attribute::textureCoordinates, arrays.textureCoordinates, made.bytes);
    made.colours = attach(made, attribute::colour, arrays.colours, made.bytes);
    made.faces = filled(arrays.faces, made.bytes);
    glVertexArrayElementBuffer(made.array, made.faces);
    attachCopies(made, ring);
    made.parts = std::move(arrays.parts);
    made.faceCount = mesh.faces.size();
    return made;
}

GlTexture upload(const Image &image)
{
    GLint longest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
    if (image.width < 1 || image.height < 1 || std::max(image.width, image.height) > longest) {
        return {};
    }
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    GlTexture texture(name);
    const auto side = static_cast<unsigned>(std::max(image.width, image.height));
    glTextureStorage2D(name, std::bit_width(side), GL_SRGB8_ALPHA8, image.width, image.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(name, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}
