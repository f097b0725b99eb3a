// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textsnapshot.h"

#include <algorithm>

#include <QTextBlock>
#include <QTextDocument>

namespace romanesco {

TextSnapshot::TextSnapshot()
    : m_content(std::make_shared<const Content>(Content{{}, {LineStart{0, 0}}}))
{
}

TextSnapshot::TextSnapshot(const QTextDocument &document)
{
    // Block by block: QTextDocument::toPlainText() turns no-break spaces into spaces.
    auto content = std::make_shared<Content>();
    content->bytes.reserve(static_cast<std::size_t>(document.characterCount()));
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockNumber() > 0) {
            content->bytes += '\n';
        }
        content->lines.push_back({content->bytes.size(), block.position()});
        const QByteArray line = block.text().toUtf8();
        content->bytes.append(line.constData(), static_cast<std::size_t>(line.size()));
    }
    m_content = std::move(content);
}

int TextSnapshot::position(std::size_t offset) const
{
    const std::string &bytes = m_content->bytes;
    const auto next = std::ranges::upper_bound(m_content->lines, offset, {}, &LineStart::offset);
    const LineStart line = *std::prev(next);

    // A character begins with a byte that is no continuation, and takes two units if it begins a sequence of four bytes.
    int position = line.position;
    const std::size_t end = std::min(offset, bytes.size());
    for (std::size_t at = line.offset; at < end; ++at) {
        const auto byte = static_cast<unsigned char>(bytes[at]);
        position += (byte & 0xC0) == 0x80 ? 0 : byte >= 0xF0 ? 2 : 1;
    }
    const bool isInsideCharacter = end < bytes.size() && (static_cast<unsigned char>(bytes[end]) & 0xC0) == 0x80;
    if (isInsideCharacter) {
        std::size_t start = end;
        while (start > line.offset && (static_cast<unsigned char>(bytes[start]) & 0xC0) == 0x80) {
            --start;
        }
        position -= static_cast<unsigned char>(bytes[start]) >= 0xF0 ? 2 : 1;
    }
    return position;
}

}
