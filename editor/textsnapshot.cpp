// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textsnapshot.h"

#include <algorithm>
#include <cassert>

#include <QTextDocument>

namespace romanesco {

namespace {

/// How many UTF-16 units a character takes, by its first byte; a continuation takes none.
int unitsOf(char byte)
{
    const auto value = static_cast<unsigned char>(byte);
    return (value & 0xC0) == 0x80 ? 0 : value >= 0xF0 ? 2 : 1;
}

}

TextSnapshot::TextSnapshot()
    : m_content(std::make_shared<const Content>(Content{{}, {LineStart{0, 0}}}))
{
}

TextSnapshot::TextSnapshot(const QTextDocument &document)
{
    // Not QTextDocument::toPlainText(), which turns no-break spaces into spaces.
    const QString text = document.toRawText().replace(QChar::ParagraphSeparator, u'\n');
    const QByteArray bytes = text.toUtf8();
    auto content = std::make_shared<Content>();
    content->bytes.assign(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    content->lines.reserve(static_cast<std::size_t>(document.blockCount()));
    content->lines.push_back({0, 0});
    // The same line ends in both.
    qsizetype offset = 0;
    for (qsizetype at = text.indexOf(u'\n'); at >= 0; at = text.indexOf(u'\n', at + 1)) {
        offset = bytes.indexOf('\n', offset) + 1;
        content->lines.push_back({static_cast<std::size_t>(offset), static_cast<int>(at) + 1});
    }
    m_content = std::move(content);
}

std::string_view TextSnapshot::line(std::size_t number) const
{
    const std::vector<LineStart> &lines = m_content->lines;
    assert(number < lines.size() && "there is such a line");
    const std::size_t begin = lines[number].offset;
    const std::size_t end = number + 1 < lines.size() ? lines[number + 1].offset - 1 : m_content->bytes.size();
    return std::string_view(m_content->bytes).substr(begin, end - begin);
}

int TextSnapshot::position(std::size_t offset) const
{
    const std::string &bytes = m_content->bytes;
    const auto next = std::ranges::upper_bound(m_content->lines, offset, {}, &LineStart::offset);
    const LineStart line = *std::prev(next);

    int position = line.position;
    const std::size_t end = std::min(offset, bytes.size());
    for (std::size_t at = line.offset; at < end; ++at) {
        position += unitsOf(bytes[at]);
    }
    const bool isInsideCharacter = end < bytes.size() && unitsOf(bytes[end]) == 0;
    if (isInsideCharacter) {
        std::size_t start = end;
        while (start > line.offset && unitsOf(bytes[start]) == 0) {
            --start;
        }
        position -= unitsOf(bytes[start]);
    }
    return position;
}

std::size_t TextSnapshot::offset(int position) const
{
    const std::string &bytes = m_content->bytes;
    const auto next = std::ranges::upper_bound(m_content->lines, std::max(position, 0), {}, &LineStart::position);
    std::size_t at = std::prev(next)->offset;
    for (int here = std::prev(next)->position; at < bytes.size(); ++at) {
        here += unitsOf(bytes[at]);
        if (here > position) {
            break;
        }
    }
    return at;
}

}
