// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <bit>
#include <cstdint>

#include <glm/vec3.hpp>

namespace romanesco {

/// Makes one number of many, by which states of a world are told apart: FNV-1a of their bits, in 64 bits.
class StateHash
{
public:
    void add(std::uint64_t word)
    {
        for (int i = 0; i < 8; ++i) {
            m_value = (m_value ^ (word & 0xff)) * 0x100000001b3u;
            word >>= 8;
        }
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const glm::dvec3 &v)
    {
        add(v.x);
        add(v.y);
        add(v.z);
    }

    [[nodiscard]] std::uint64_t value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325u;
};

}
