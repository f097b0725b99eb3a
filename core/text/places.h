// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include "textposition.h"

namespace romanesco {

class LineMap;

/// Lines and columns of offsets into one text, asked one after another: an offset that follows the last one in its line
/// costs what lies between them. (A line may hold 200,000 words, each with a remark.)
class Places
{
public:
    /// lines must outlive it.
    explicit Places(const LineMap &lines)
        : m_lines(lines)
    {
    }

    TextPosition at(std::size_t offset);

private:
    const LineMap &m_lines;
    std::size_t m_lastOffset = 0;
    TextPosition m_last;
};

}
