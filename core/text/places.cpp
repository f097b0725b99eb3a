// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "places.h"

#include <algorithm>

#include "linemap.h"
#include "unicode.h"

namespace romanesco {

TextPosition Places::at(std::size_t offset)
{
    offset = std::min(offset, m_lines.text().size());
    if (offset >= m_lastOffset && m_lines.lineAt(offset) + 1 == m_last.line) {
        m_last.column += codePointCount(m_lines.text().substr(m_lastOffset, offset - m_lastOffset));
    } else {
        m_last = m_lines.position(offset);
    }
    m_lastOffset = offset;
    return m_last;
}

}
