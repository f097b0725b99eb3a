// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <string>
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

    /// The document's position of a byte; inside a character, the character's. Beyond the end it is the end. Cost: a
    /// binary search and the length of the line.
    [[nodiscard]] int position(std::size_t offset) const;

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
