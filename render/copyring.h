// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "cut.h"
#include "glresources.h"

namespace romanesco {

/// How copies travel to the card: in chunks, through buffers that the card has mapped all the time, 3 MB and a quarter.
class CopyRing
{
public:
    static constexpr std::size_t chunkSize = 8'192;

    CopyRing() = default;
    ~CopyRing();
    CopyRing(const CopyRing &) = delete;
    CopyRing &operator=(const CopyRing &) = delete;

    /// Whether the driver has room for it. Comes before all else.
    [[nodiscard]] bool make();

    /// Puts up to chunkSize copies into the next chunk, once the card has drawn what was there; the number of the first,
    /// as the base of the draw's instances. tints are beside them, or none.
    [[nodiscard]] GLuint put(std::span<const Instance> copies, std::span<const Tint> tints);
    /// The draws of what was put last are on their way.
    void sent();

    [[nodiscard]] GLuint copies() const { return m_copies.buffer; }
    [[nodiscard]] GLuint tints() const { return m_tints.buffer; }
    [[nodiscard]] static constexpr std::size_t bytes()
    {
        return chunkCount * chunkSize * (sizeof(Instance) + sizeof(Tint));
    }

private:
    static constexpr std::size_t chunkCount = 8;

    template<typename T>
    struct Mapped {
        GlBuffer buffer;
        T *memory = nullptr;

        void make();
        void put(std::size_t at, std::span<const T> rows);
    };

    Mapped<Instance> m_copies;
    Mapped<Tint> m_tints;
    std::array<GLsync, chunkCount> m_fences{};
    std::size_t m_chunk = 0;
};

}
