// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "copyring.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace romanesco {

CopyRing::~CopyRing()
{
    for (GLsync fence : m_fences) {
        deleteFence(fence);
    }
}

template<typename T>
void CopyRing::Mapped<T>::make()
{
    constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    constexpr GLsizeiptr size = chunkCount * chunkSize * sizeof(T);
    buffer = makeBuffer();
    glNamedBufferStorage(buffer, size, nullptr, access);
    memory = static_cast<T *>(glMapNamedBufferRange(buffer, 0, size, access));
}

template<typename T>
void CopyRing::Mapped<T>::put(std::size_t at, std::span<const T> rows)
{
    std::ranges::copy(rows, memory + at);
}

bool CopyRing::make()
{
    m_copies.make();
    m_tints.make();
    return m_copies.memory && m_tints.memory;
}

GLuint CopyRing::put(std::span<const Instance> copies, std::span<const Tint> tints)
{
    assert(copies.size() <= chunkSize && (tints.empty() || tints.size() == copies.size()) && "they fit");
    m_chunk = (m_chunk + 1) % chunkCount;
    GLsync fence = std::exchange(m_fences[m_chunk], nullptr);
    while (fence && glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 1'000'000'000) == GL_TIMEOUT_EXPIRED) {
        // The card still reads this part of the ring.
    }
    deleteFence(fence);
    const std::size_t first = m_chunk * chunkSize;
    m_copies.put(first, copies);
    m_tints.put(first, tints);
    return static_cast<GLuint>(first);
}

void CopyRing::sent()
{
    assert(!m_fences[m_chunk] && "put() comes before sent()");
    m_fences[m_chunk] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

}
