// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>

#include "core/language/fdodocument.h"
#include "core/text/sourcerange.h"

/// Texts with their cursors and ranges drawn into them.
namespace romanesco::test {

/// A text with a `|` where the cursor stands.
struct MarkedText {
    std::string text;
    std::size_t offset = 0;

    explicit MarkedText(std::string marked)
        : text(std::move(marked))
        , offset(text.find('|'))
    {
        text.erase(offset, 1);
    }
};

/// An .fdo text with a `|` where the cursor stands.
struct MarkedDocument {
    explicit MarkedDocument(std::string marked)
        : MarkedDocument(MarkedText(std::move(marked)))
    {
    }

    FdoDocument document;
    std::size_t offset;

private:
    explicit MarkedDocument(MarkedText marked)
        : document(std::move(marked.text))
        , offset(marked.offset)
    {
    }
};

/// The text with { } round each range; they ascend and do not overlap.
inline std::string withRanges(std::string text, const std::vector<SourceRange> &ranges)
{
    for (std::size_t i = ranges.size(); i-- > 0;) {
        text.insert(ranges[i].end, "}").insert(ranges[i].begin, "{");
    }
    return text;
}

/// A text as the name of a test's row.
inline QByteArray oneLine(QByteArray text)
{
    return text.replace('\r', "").replace('\n', " / ");
}

/// Every place where a cursor may be asked for, and some beyond the text.
inline std::size_t endOfOffsets(std::string_view text)
{
    return text.size() + 4;
}

}
