// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

class QTextDocument;

namespace romanesco {

/// A document's text at one moment as the core reads it, in UTF-8 with an LF between the lines, and the way from its
/// bytes back to the document's positions (which count UTF-16 units). A value that is cheap to copy and may go to other
/// threads.
class TextSnapshot
{
public:
    /// An empty text.
    TextSnapshot();
    /// Cost linear in the text.
    explicit TextSnapshot(const QTextDocument &document);

    [[nodiscard]] const std::string &bytes() const { return m_content->bytes; }

    /// As many as the document has blocks.
    [[nodiscard]] std::size_t lineCount() const { return m_content->lines.size(); }
    /// Without its end, from 0.
    [[nodiscard]] std::string_view line(std::size_t number) const;

    /// The document's position of a byte; inside a character, the character's. Beyond the end it is the end. Cost: a
    /// binary search and the length of the line.
    [[nodiscard]] int position(std::size_t offset) const;

    /// The way back: the first byte of the character at a position, also in the middle of a surrogate pair. Beyond the
    /// end it is the end. Cost as of position().
    [[nodiscard]] std::size_t offset(int position) const;

private:
    struct LineStart {
        std::size_t offset;
        int position;
    };
    struct Content {
        std::string bytes;
        std::vector<LineStart> lines;
    };
    std::shared_ptr<const Content> m_content;
};

}
